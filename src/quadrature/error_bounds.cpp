#include "polhode/quadrature/error_bounds.hpp"

#include "polhode/arithmetic/elementary.hpp"

namespace polhode {

ball periodic_trapezoid_error(const strip_bound& bound, long nodes) {
  const precision p = bound.half_width.precision();
  if (nodes < 1 || !certainly_positive(bound.half_width)) return ball::undefined(p);
  return 4 * pi(p) * bound.supremum / (exp(bound.half_width * nodes) - 1);
}

}  // namespace polhode
