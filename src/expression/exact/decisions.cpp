// What exact_field decides of a number: its sign, its integer part, and whether it is rational.
// Enclosures decide the first two, but for numbers that they do not tell from 0 or from an integer,
// which have to be shown to be rational.

#include <algorithm>
#include <map>
#include <optional>

#include "expression/exact/rationals.hpp"
#include "expression/exact/terms.hpp"
#include "expression/exact_number.hpp"

namespace polhode::detail {

using namespace exact_parts;

int exact_field::sign(const exact_sum& x) {
  if (x.empty()) return 0;
  if (x.size() == 1 && is_positive(x.begin()->first)) return x.begin()->second > 0 ? 1 : -1;
  switch (sign_of(enclosure(x))) {
    case polhode::certain_sign::positive:
      return 1;
    case polhode::certain_sign::negative:
      return -1;
    case polhode::certain_sign::zero:
      return 0;
    default:
      break;
  }
  const auto q = as_rational(x);
  if (!q) throw not_decided();
  return q->sign();
}

exact_sum exact_field::abs(const exact_sum& x) { return scaled(x, sign(x)); }

exact_sum exact_field::floor(const exact_sum& x) {
  if (const auto q = as_rational(x)) return exactly(rational(floor_of(*q)));
  const ball around = enclosure(x);
  if (!around.is_bounded()) throw not_decided();
  const integer n = floor_of(lower_rational(around));
  if (n != floor_of(upper_rational(around))) throw not_decided();
  return exactly(rational(n));
}

std::optional<rational> exact_field::as_rational(const exact_sum& x) {
  if (auto q = plain_number(x)) return q;
  if (auto q = rational_by_roots_of_unity(x)) return q;
  return further_ ? rational_by_further_rules(x) : rational_by_common_denominator(x);
}

/// Where x has the reciprocals of sums v_i: q with N = q D, for D the product of their powers and N
/// = x D.
std::optional<rational> exact_field::rational_by_common_denominator(const exact_sum& x) {
  std::map<generator_id, rational> reciprocals;  // the least exponents
  for (const auto& [m, c] : x) {
    for (const auto& [g, exponent] : m) {
      if (generators_[g].what != kind::base || exponent >= 0) continue;
      rational& least = reciprocals[g];
      least = std::min(least, rational(floor_of(exponent)));
    }
  }
  if (reciprocals.empty()) return std::nullopt;
  try {
    monomial powers;
    exact_sum below = exactly(1);
    for (const auto& [g, exponent] : reciprocals) {
      powers.emplace_back(g, -exponent);
      below = product(below, integer_power(exact_sum(generators_[g].of),
                                           as_long(numerator(rational(-exponent)))));
    }
    exact_sum above;
    for (const auto& [m, c] : x) above = sum(above, scaled(expanded(merged(m, powers)), c));
    if (above.empty()) return rational(0);
    if (above.size() != below.size() || above.begin()->first != below.begin()->first) {
      return std::nullopt;
    }
    const rational q = above.begin()->second / below.begin()->second;
    if (scaled(below, q) == above) return q;
  } catch (const not_decided&) {
    return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace polhode::detail
