// Arc tangent, arc sine and arc cosine: by their derivatives, greatest at one end.

#include "arithmetic/functions/elementary/carrying.hpp"
#include "polhode/arithmetic/elementary.hpp"

namespace polhode {

using namespace detail::elementary;
using detail::end_points;

void atan(ball& result, const ball& x) {
  const magnitude radius = ball_access::radius(x);
  const magnitude nearest = x.magnitude_lower();
  // |atan'| = 1 / (1 + x^2), greatest where |x| is least.
  monotone(
      result, x, mpfr_atan, true,
      [&](mpfr_srcptr) {
        return divide_up(radius, add_down(one, multiply_down(nearest, nearest)));
      },
      detail::near_atan);
}

namespace {

/// asin and acos: |f'| = 1 / sqrt((1 - |x|)(1 + |x|)), greatest where |x| is.
void inverse_circular(ball& result, const ball& x, mpfr_function f, bool increasing) {
  const precision p = x.precision();
  if (x.is_undefined()) return ball_access::set_undefined(result, p);
  const magnitude radius = ball_access::radius(x);
  if (is_thin(x)) {
    const mpfr_srcptr m = ball_access::first(x);
    const magnitude gap = one_minus_abs_down(m);
    // Nearer than 1024 radii to an end of the domain the end points do better.
    if (radius.is_zero() || scale(radius, 10) <= gap) {
      const magnitude m_down = magnitude::abs_down(m);
      const magnitude slope_divisor = sqrt_down(
          multiply_down(subtract_down(gap, radius), add_down(one, subtract_down(m_down, radius))));
      at_midpoint(result, x, f, [&](mpfr_srcptr) { return divide_up(radius, slope_divisor); });
      return;
    }
  }
  at_ends(result, end_points(x, p + guard_bits), p, f, increasing);
}

}  // namespace

void asin(ball& result, const ball& x) { inverse_circular(result, x, mpfr_asin, true); }
void acos(ball& result, const ball& x) { inverse_circular(result, x, mpfr_acos, false); }

}  // namespace polhode
