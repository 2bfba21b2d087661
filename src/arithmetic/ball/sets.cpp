// Hulls and intersections of balls.

#include "arithmetic/ball/ball_access.hpp"
#include "arithmetic/ball/forms.hpp"
#include "polhode/arithmetic/ball.hpp"

namespace polhode {

using detail::common_precision;
using detail::end_points;
using detail::mpfr_cell;

ball hull(const ball& x, const ball& y) {
  const precision p = common_precision(x, y);
  if (x.is_undefined() || y.is_undefined()) return ball::undefined(p);
  const end_points ex(x, p);
  const end_points ey(y, p);
  mpfr_cell lower(p);
  mpfr_cell upper(p);
  mpfr_min(lower.get(), ex.lower(), ey.lower(), MPFR_RNDD);
  mpfr_max(upper.get(), ex.upper(), ey.upper(), MPFR_RNDU);
  ball r;
  ball_access::set_exact_ends(r, lower, upper);
  return r;
}

ball intersection(const ball& x, const ball& y) {
  const precision p = common_precision(x, y);
  if (x.is_undefined() || y.is_undefined()) return ball::undefined(p);
  if (x.precision() == p && detail::contains_by_midpoints(y, x)) return x;
  if (y.precision() == p && detail::contains_by_midpoints(x, y)) return y;
  if (!overlaps(x, y)) return ball::undefined(p);
  const end_points ex(x, p);
  const end_points ey(y, p);
  mpfr_cell lower(p);
  mpfr_cell upper(p);
  mpfr_max(lower.get(), ex.lower(), ey.lower(), MPFR_RNDD);
  mpfr_min(upper.get(), ex.upper(), ey.upper(), MPFR_RNDU);
  ball r;
  ball_access::set_exact_ends(r, lower, upper);
  return r;
}

}  // namespace polhode
