#include <algorithm>
#include <utility>

#include "parts_by_variable.hpp"

namespace polhode::detail {

void append(hyperexponential_integrals& all, const hyperexponential_sum& form,
            const hyperexponential& factor, const hyperexponential_integral& range) {
  for (const hyperexponential& term : form) {
    hyperexponential_integral part = range;
    part.function = product(term, factor);
    const std::vector<polynomial_power>& powers = part.function.powers;
    const bool has_conditions = std::any_of(
        powers.begin(), powers.end(), [](const polynomial_power& p) { return p.must_be_positive; });
    if (part.function.coefficient == 0 && !has_conditions) continue;
    const auto same = [&](const hyperexponential_integral& other) {
      return other.lower.is_same_as(part.lower) && other.upper.is_same_as(part.upper) &&
             other.function == part.function;
    };
    const auto found = std::find_if(all.begin(), all.end(), same);
    if (found == all.end()) {
      all.push_back(std::move(part));
    } else {
      found->function.coefficient *= 2;  // one more of the same
    }
  }
}

bool add_in_argument(const formula_range& of, std::size_t node,
                     hyperexponential_integrals& result) {
  const bool from_infinity = of.a.infinite_sign() != 0;
  const bool to_infinity = of.b.infinite_sign() != 0;
  const auto piece = [&](const end_point& from, const end_point& to, int sign) {
    const bool is_long = to.infinite_sign() != 0;
    const ball start = from.at(128);
    const std::optional<rational> inside = is_long ? beyond(start) : between(start, to.at(128));
    if (!inside) return false;
    const substitution by = argument_itself(of.f, sign, *inside, of.plain);
    const forms found(of.f, node, by);
    if (!found[node]) return false;
    hyperexponential_integral range;
    range.lower = from;
    range.upper = to;
    append(result, *found[node], number(1), range);
    return true;
  };
  if (from_infinity && to_infinity) return piece(0, of.b, 1) && piece(0, of.b, -1);
  if (from_infinity) return piece(-of.b, -of.a, -1);
  return piece(of.a, of.b, 1);
}

}  // namespace polhode::detail
