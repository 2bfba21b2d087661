// Powers with rational exponents in exact_field: of a product, those of its factors; of a natural
// number, those of its prime factors; of a sum, those of its content and of the sum that is left,
// which becomes a generator where its root is no simpler (roots_of_sums.cpp).

#include <optional>

#include "expression/exact/factors.hpp"
#include "expression/exact/rationals.hpp"
#include "expression/exact/terms.hpp"
#include "expression/exact_number.hpp"

namespace polhode::detail {

using namespace exact_parts;

exact_sum exact_field::number_power(const rational& c, const rational& q) {
  if (c == 1) return exactly(1);
  spend(cost_of_factors(c));
  exact_sum result = exactly(1);
  for (const bool above : {true, false}) {
    for (const factor& f : factors_of(above ? numerator(c) : denominator(c))) {
      const rational exponent = (above ? q : rational(-q)) * f.multiplicity;
      result = product(result, base_power(exactly(rational(f.base)), exponent));
    }
  }
  return result;
}

/// v^q for a natural number v > 1 that is no power, or a sum v > 0 with coprime integer
/// coefficients.
exact_sum exact_field::base_power(const exact_sum& v, const rational& q) {
  const integer n = floor_of(q);
  const rational rest = q - rational(n);
  const std::optional<rational> number = plain_number(v);
  if (number && *number == 1) return v;
  exact_sum whole = exactly(1);
  if (number) {
    whole = exactly(integer_power_of(*number, n));
  } else if (n > 0) {
    whole = integer_power(v, as_long(n));
  } else if (n < 0) {
    try {
      whole = integer_power(rationalised_reciprocal(v), as_long(integer(-n)));
    } catch (const not_decided&) {
      return generated(make(kind::base, v, enclosure(v)), q);
    }
  }
  if (rest == 0) return whole;
  if (!number && rest == half && !find(kind::base, v)) {
    if (const auto known = times_known_root(whole, v)) return *known;
  }
  return product(whole, generated(make(kind::base, v, enclosure(v)), rest));
}

exact_sum exact_field::power(const exact_sum& x, const rational& q) {
  if (is_integer(q)) return integer_power(x, as_long(numerator(q)));
  if (x.empty()) {
    if (q < 0) throw not_decided();
    return x;
  }
  if (x.size() == 1 && x.begin()->second > 0 && is_positive(x.begin()->first)) {
    const auto [m, c] = *x.begin();
    exact_sum result = number_power(c, q);
    for (const auto& [g, exponent] : m) {
      const bool is_base = generators_[g].what == kind::base;
      const rational e = exponent * q;
      result =
          product(result, is_base ? base_power(exact_sum(generators_[g].of), e) : generated(g, e));
    }
    return result;
  }
  if (sign(x) != 1) throw not_decided();
  if (denominator(q) == 2) {
    if (const auto root = denested_root(x, deepest_root)) {
      return integer_power(*root, as_long(numerator(q)));
    }
  }
  const rational c = content(x);
  return product(number_power(c, q), base_power(scaled(x, 1 / c), q));
}

exact_sum exact_field::root(const exact_sum& x, long n) {
  if (n % 2 == 0 || x.empty()) return power(x, rational(1, n));
  const int s = sign(x);
  return scaled(power(scaled(x, s), rational(1, n)), s);
}

}  // namespace polhode::detail
