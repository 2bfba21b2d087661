// Hyperbolic functions and their inverses.

#include "arithmetic/functions/elementary/carrying.hpp"
#include "polhode/arithmetic/elementary.hpp"

namespace polhode {

using namespace detail::elementary;
using detail::end_points;
using detail::mpfr_cell;

void sinh(ball& result, const ball& x) {
  const magnitude radius = ball_access::radius(x);
  // |sinh(m+h) - s| <= |s| (cosh r - 1) + cosh m sinh r, with cosh m = sqrt(1 + s^2),
  // cosh r - 1 <= r^2 and sinh r <= r + r^3 for r <= 1.
  monotone(
      result, x, mpfr_sinh, true,
      [&](mpfr_srcptr value) {
        const magnitude s = true_value_up(value);
        const magnitude r2 = multiply_up(radius, radius);
        const magnitude cosh_m = sqrt_up(add_up(one, multiply_up(s, s)));
        return add_up(multiply_up(s, r2),
                      multiply_up(cosh_m, multiply_up(radius, add_up(one, r2))));
      },
      detail::near_sinh);
}

void cosh(ball& result, const ball& x) {
  const precision p = x.precision();
  if (x.is_undefined()) return ball_access::set_undefined(result, p);
  if (is_thin(x) && is_moderate(x)) {
    const magnitude radius = ball_access::radius(x);
    const magnitude m = magnitude::abs_up(ball_access::first(x));
    // |cosh(m+h) - c| <= c (cosh r - 1) + |sinh m| sinh r, and |sinh m| is the lesser of |m| c and
    // sqrt((c - 1)(c + 1)).
    at_midpoint(
        result, x, mpfr_cosh,
        [&](mpfr_srcptr value) {
          const magnitude c = true_value_up(value);
          const magnitude r2 = multiply_up(radius, radius);
          const magnitude sinh_m =
              min(multiply_up(m, c), sqrt_up(multiply_up(subtract_up(c, one), add_up(c, one))));
          return add_up(multiply_up(c, r2),
                        multiply_up(sinh_m, multiply_up(radius, add_up(one, r2))));
        },
        detail::near_cosh);
    return;
  }
  const ball size = abs(x);  // cosh is even, and increasing on [0, inf)
  at_ends(result, end_points(size, p + guard_bits), p, mpfr_cosh, true);
}

void tanh(ball& result, const ball& x) {
  const magnitude radius = ball_access::radius(x);
  // tanh(m+h) - t = tanh h (1 - t^2) / (1 + t tanh h), and |tanh h| <= r.
  monotone(result, x, mpfr_tanh, true, [&](mpfr_srcptr value) {
    const magnitude one_minus_t2 =
        multiply_up(one_minus_abs_up(value), add_up(one, min(magnitude::abs_up(value), one)));
    return divide_up(multiply_up(radius, one_minus_t2), subtract_down(one, radius));
  });
}

void asinh(ball& result, const ball& x) {
  const magnitude radius = ball_access::radius(x);
  const magnitude nearest = x.magnitude_lower();
  // |asinh'| = 1 / sqrt(1 + x^2), greatest where |x| is least.
  monotone(result, x, mpfr_asinh, true, [&](mpfr_srcptr) {
    return divide_up(radius, sqrt_down(add_down(one, multiply_down(nearest, nearest))));
  });
}

void acosh(ball& result, const ball& x) {
  const precision p = x.precision();
  if (x.is_undefined()) return ball_access::set_undefined(result, p);
  const magnitude radius = ball_access::radius(x);
  if (is_thin(x)) {
    // acosh' = 1 / sqrt((x - 1)(x + 1)), greatest where x is least.
    mpfr_cell gap(64);
    mpfr_sub_ui(gap.get(), ball_access::first(x), 1, MPFR_RNDD);
    const magnitude excess = mpfr_sgn(gap.get()) > 0 ? magnitude::abs_down(gap.get()) : magnitude{};
    if (radius.is_zero() || scale(radius, 10) <= excess) {
      const magnitude least = subtract_down(excess, radius);
      const magnitude slope_divisor =
          sqrt_down(multiply_down(least, add_down(least, magnitude::power_of_two(1))));
      at_midpoint(result, x, mpfr_acosh,
                  [&](mpfr_srcptr) { return divide_up(radius, slope_divisor); });
      return;
    }
  }
  at_ends(result, end_points(x, p + guard_bits), p, mpfr_acosh, true);
}

void atanh(ball& result, const ball& x) {
  const precision p = x.precision();
  if (x.is_undefined()) return ball_access::set_undefined(result, p);
  const magnitude radius = ball_access::radius(x);
  if (is_thin(x)) {
    const mpfr_srcptr m = ball_access::first(x);
    // atanh(m+h) - atanh(m) = atanh(h / (1 - m^2 - m h)); atanh q <= q + q^2 for q <= 1/2.
    const magnitude one_minus_m2 =
        multiply_down(one_minus_abs_down(m), add_down(one, magnitude::abs_down(m)));
    const magnitude divisor =
        subtract_down(one_minus_m2, multiply_up(magnitude::abs_up(m), radius));
    if (!one_minus_m2.is_zero() && (radius.is_zero() || scale(radius, 10) <= divisor)) {
      const magnitude q = divide_up(radius, divisor);
      at_midpoint(result, x, mpfr_atanh, [&](mpfr_srcptr) { return plus_square_up(q); });
      return;
    }
  }
  const end_points e(x, p + guard_bits);
  if (mpfr_cmp_si(e.lower(), -1) <= 0 || mpfr_cmp_si(e.upper(), 1) >= 0) {
    return ball_access::set_undefined(result, p);
  }
  at_ends(result, e, p, mpfr_atanh, true);
}

}  // namespace polhode
