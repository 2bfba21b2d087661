// Exponentials and logarithms in exact_field: exp(c log v) = v^c, and log of a product is the sum
// of the logarithms of its factors.

#include <optional>

#include "expression/exact/factors.hpp"
#include "expression/exact/terms.hpp"
#include "expression/exact_number.hpp"
#include "polhode/arithmetic/elementary.hpp"

namespace polhode::detail {

using namespace exact_parts;

/// exp(c log v) = v^c, and exp(c m) = exp(m)^c.
exact_sum exact_field::exp(const exact_sum& x) {
  exact_sum result = exactly(1);
  for (const auto& [m, c] : x) {
    if (m.size() == 1 && m.front().second == 1 && generators_[m.front().first].what == kind::log) {
      result = product(result, power(exact_sum(generators_[m.front().first].of), c));
      continue;
    }
    const exact_sum argument = {{m, rational(1)}};
    const generator_id g = make(kind::exp, argument, polhode::exp(enclosure(argument)));
    result = product(result, generated(g, c));
  }
  return result;
}

exact_sum exact_field::log_of_number(const rational& c) {
  spend(cost_of_factors(c));
  exact_sum result;
  for (const bool above : {true, false}) {
    for (const factor& f : factors_of(above ? numerator(c) : denominator(c))) {
      const exact_sum base = exactly(rational(f.base));
      const generator_id g = make(kind::log, base, polhode::log(ball(f.base, bits)));
      add_to(result, monomial{{g, rational(1)}}, above ? f.multiplicity : -f.multiplicity);
    }
  }
  return result;
}

/// log v of a positive sum with coprime integer coefficients: -log(1/v) where v < 1 and 1/v is such
/// a sum, 2 log sqrt(v) where the root has a form without nested roots.
exact_sum exact_field::log_of_sum(const exact_sum& v) {
  if (const auto q = plain_number(v)) return log_of_number(*q);
  if (sign(difference(exactly(1), v)) > 0) {
    std::optional<exact_sum> inverse;
    try {
      inverse = rationalised_reciprocal(v);
    } catch (const not_decided&) {
      spend(1);
    }
    if (inverse) return scaled(log(*inverse), -1);
  }
  if (const auto root = denested_root(v, deepest_root)) return scaled(log(*root), 2);
  return generated(make(kind::log, v, polhode::log(enclosure(v))));
}

exact_sum exact_field::log(const exact_sum& x) {
  if (sign(x) != 1) throw not_decided();
  const auto [first, c] = *x.begin();
  if (x.size() > 1) {
    const rational whole = content(x);
    return sum(log_of_number(whole), log_of_sum(scaled(x, 1 / whole)));
  }
  if (c < 0 || !is_positive(first)) {
    return generated(make(kind::log, x, polhode::log(enclosure(x))));
  }
  exact_sum result = log_of_number(c);
  for (const auto& [g, exponent] : first) {
    const exact_sum of = generators_[g].of;
    exact_sum part;
    if (generators_[g].what == kind::base) {
      part = log_of_sum(of);
    } else if (generators_[g].what == kind::exp) {
      part = of;
    } else {
      part = generated(make(kind::log, generated(g), polhode::log(ball(generators_[g].enclosure))));
    }
    result = sum(result, scaled(part, exponent));
  }
  return result;
}

}  // namespace polhode::detail
