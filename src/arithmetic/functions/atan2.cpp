// The angle of a point of the plane.

#include <algorithm>

#include "arithmetic/ball/ball_access.hpp"
#include "atan2.hpp"
#include "polhode/arithmetic/elementary.hpp"

namespace polhode {

using detail::end_points;
using detail::mpfr_cell;

namespace {

constexpr precision atan2_guard_bits = 64;

/// The angle of the corner (x, y), where at least one is not 0 and at most one is infinite.
void corner(mpfr_ptr r, mpfr_srcptr y, mpfr_srcptr x, mpfr_rnd_t rounding) {
  if (mpfr_zero_p(y) != 0) {
    // On the negative axis the angle is +pi, whatever sign MPFR's zero has.
    mpfr_cell zero(2);
    mpfr_atan2(r, zero.get(), x, rounding);
  } else {
    mpfr_atan2(r, y, x, rounding);
  }
}

/// The angles of the points with y = 0: 0 for x > 0, pi for x < 0.
void angles_on_axis(ball& result, const end_points& x, precision p) {
  mpfr_cell lower(p);
  mpfr_cell upper(p);
  if (mpfr_sgn(x.upper()) <= 0) mpfr_const_pi(lower.get(), MPFR_RNDD);
  if (mpfr_sgn(x.lower()) < 0) mpfr_const_pi(upper.get(), MPFR_RNDU);
  ball_access::set_ends(result, lower, upper);
}

/// The angles of [a, b] x [c, d] with 0 <= c, d > 0, the origin left out. The angle's derivatives
/// are -y / (x^2 + y^2) in x and x / (x^2 + y^2) in y: it falls as x grows (jumping from pi to 0
/// through the origin where y = 0), and with y it grows where x > 0 and falls where x < 0. So it is
/// least at x = b, for the least y where b > 0 and the greatest y where b <= 0, and greatest at x =
/// a likewise. None of these corners is the origin, for d > 0, and none has two infinite
/// coordinates: where b or a is infinite, y is c.
void angles_above(ball& result, const end_points& x, mpfr_srcptr c, mpfr_srcptr d, precision p) {
  mpfr_cell lower(p);
  mpfr_cell upper(p);
  corner(lower.get(), mpfr_sgn(x.upper()) > 0 ? c : d, x.upper(), MPFR_RNDD);
  corner(upper.get(), mpfr_sgn(x.lower()) < 0 ? c : d, x.lower(), MPFR_RNDU);
  ball_access::set_ends(result, lower, upper);
}

void all_angles(ball& result, precision p) {
  mpfr_cell lower(p);
  mpfr_cell upper(p);
  mpfr_const_pi(upper.get(), MPFR_RNDU);
  mpfr_neg(lower.get(), upper.get(), MPFR_RNDN);
  ball_access::set_ends(result, lower, upper);
}

}  // namespace

void detail::angles(ball& result, const end_points& y, const end_points& x, precision p) {
  const mpfr_srcptr c = y.lower();
  const mpfr_srcptr d = y.upper();
  if (mpfr_sgn(c) >= 0) {
    if (mpfr_sgn(d) == 0) return angles_on_axis(result, x, p);
    return angles_above(result, x, c, d, p);
  }
  // There are points below the x axis.
  if (mpfr_sgn(d) >= 0 && mpfr_sgn(x.lower()) < 0) return all_angles(result, p);
  if (mpfr_sgn(d) <= 0) {
    // The mirror image, whose points on the axis, if any, have x >= 0 and the angle 0.
    mpfr_cell least(mpfr_get_prec(d));
    mpfr_cell most(mpfr_get_prec(c));
    mpfr_neg(least.get(), d, MPFR_RNDN);
    mpfr_neg(most.get(), c, MPFR_RNDN);
    angles_above(result, x, least.get(), most.get(), p);
    return negate(result, result);
  }
  // c < 0 < d and x >= 0: the angle grows with y, and is greatest in size for the least x.
  mpfr_cell lower(p);
  mpfr_cell upper(p);
  corner(lower.get(), c, x.lower(), MPFR_RNDD);
  corner(upper.get(), d, x.lower(), MPFR_RNDU);
  ball_access::set_ends(result, lower, upper);
}

ball atan2(const ball& y, const ball& x) {
  const precision p = std::max(x.precision(), y.precision());
  if (x.is_undefined() || y.is_undefined() || (contains_zero(x) && contains_zero(y))) {
    return ball::undefined(p);
  }
  ball r;
  if (x.is_exact() && y.is_exact()) {
    detail::set_midpoint(r, p, {}, [&](mpfr_ptr value) {
      mpfr_cell zero(2);
      const mpfr_srcptr ordinate = ball_access::first(y);
      return mpfr_atan2(value, mpfr_zero_p(ordinate) != 0 ? zero.get() : ordinate,
                        ball_access::first(x), MPFR_RNDN);
    });
    return r;
  }
  const end_points ex(x, p + atan2_guard_bits);
  const end_points ey(y, p + atan2_guard_bits);
  // A radius below the least positive number is rounded up to it: an end may come to 0 only here.
  const auto has_zero = [](const end_points& e) {
    return mpfr_sgn(e.lower()) <= 0 && mpfr_sgn(e.upper()) >= 0;
  };
  if (has_zero(ex) && has_zero(ey)) return ball::undefined(p);
  detail::angles(r, ey, ex, p);
  return r;
}

}  // namespace polhode
