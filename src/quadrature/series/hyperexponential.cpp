#include "hyperexponential.hpp"

#include "polhode/arithmetic/elementary.hpp"

namespace polhode::detail {

ball hyperexponential::constant(const formula_graph& f, precision p) const {
  ball result(coefficient, p);
  for (const constant_power& c : constants) {
    ball base;
    switch (c.what) {
      case constant_power::kind::rational:
        base = ball(c.value, p);
        break;
      case constant_power::kind::pi:
        base = pi(p);
        break;
      case constant_power::kind::node: {
        const choices none(f.size());
        base = abs(evaluate(f, p, ball(0, p), none, c.node)[c.node]);
        break;
      }
    }
    result = result * power_of_positive(base, c.exponent);
  }
  return result;
}

ball power_of_positive(const ball& x, const rational& e) {
  constexpr long greatest = 1L << 30;
  const bool is_short = abs(numerator(e)) < greatest;
  if (is_short && denominator(e) == 1) return pow(x, static_cast<long>(numerator(e)));
  if (is_short && denominator(e) == 2) return pow(sqrt(x), static_cast<long>(numerator(e)));
  return pow(x, e);
}

}  // namespace polhode::detail
