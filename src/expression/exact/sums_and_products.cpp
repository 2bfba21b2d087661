// Sums, products and integer powers in exact_field. A product of powers is kept with exponents
// below 1 of the natural numbers and sums in it: what is above is multiplied out.

#include <algorithm>
#include <optional>

#include "expression/exact/rationals.hpp"
#include "expression/exact/terms.hpp"
#include "expression/exact_number.hpp"

namespace polhode::detail {

using namespace exact_parts;

namespace {

constexpr long most_factors_at_once = 64;  // of a power of a sum

}  // namespace

exact_sum exact_field::sum(const exact_sum& x, const exact_sum& y) {
  exact_sum result = x;
  for (const auto& [m, c] : y) add_to(result, m, c);
  return result;
}

exact_sum exact_field::scaled(const exact_sum& x, const rational& q) {
  exact_sum result;
  for (const auto& [m, c] : x) add_to(result, m, rational(c * q));
  return result;
}

exact_sum exact_field::difference(const exact_sum& x, const exact_sum& y) {
  return sum(x, scaled(y, -1));
}

/// The product of powers m, in which g^q = g^floor(q) g^(q - floor(q)) is done for those g that are
/// a natural number or a sum.
exact_sum exact_field::expanded(const monomial& m) {
  if (has_waves_to_reduce(m)) return with_waves_reduced(m);
  monomial kept;
  rational coefficient = 1;
  exact_sum whole = exactly(1);
  for (const auto& [g, exponent] : m) {
    const generator& x = generators_[g];
    const bool is_base = x.what == kind::base;
    const std::optional<rational> number = is_base ? plain_number(x.of) : std::nullopt;
    if (!is_base || (exponent < 1 && (exponent >= 0 || !number))) {
      kept.emplace_back(g, exponent);
      continue;
    }
    const integer n = floor_of(exponent);
    if (const rational rest = exponent - rational(n); rest != 0) kept.emplace_back(g, rest);
    if (number) {
      coefficient *= integer_power_of(*number, n);
    } else {
      whole = product(whole, integer_power(exact_sum(x.of), as_long(n)));
    }
  }
  const exact_sum rest = {{kept, coefficient}};
  return whole == exactly(1) ? rest : product(whole, rest);
}

exact_sum exact_field::product(const exact_sum& x, const exact_sum& y) {
  exact_sum result;
  for (const auto& [m, c] : x) {
    for (const auto& [n, d] : y) {
      spend(1);
      const monomial both = merged(m, n);
      const bool is_plain = !has_waves_to_reduce(both) &&
                            std::none_of(both.begin(), both.end(), [this](const auto& part) {
                              const generator& g = generators_[part.first];
                              return g.what == kind::base &&
                                     (part.second >= 1 || (part.second < 0 && plain_number(g.of)));
                            });
      if (is_plain) {
        add_to(result, both, rational(c * d));
      } else {
        for (const auto& [e, f] : expanded(both)) add_to(result, e, rational(c * d * f));
      }
    }
  }
  return result;
}

exact_sum exact_field::integer_power(const exact_sum& x, long n) {
  if (n == 0) return exactly(1);
  if (n < 0) {
    if (n < -(1L << 62)) throw not_decided();
    return integer_power(reciprocal(x), -n);
  }
  if (x.empty()) return x;
  if (x.size() == 1) {
    monomial m = x.begin()->first;
    for (auto& part : m) part.second *= n;
    return scaled(expanded(m), integer_power_of(x.begin()->second, n));
  }
  if (n > most_factors_at_once) throw not_decided();
  exact_sum result = exactly(1);
  exact_sum square = x;
  for (;; n /= 2) {
    if (n % 2 == 1) result = product(result, square);
    if (n == 1) return result;
    square = product(square, square);
  }
}

}  // namespace polhode::detail
