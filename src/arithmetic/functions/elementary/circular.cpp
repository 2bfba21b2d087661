// Sine, cosine and tangent, in radians and in half circles.

#include <utility>

#include "arithmetic/functions/elementary/carrying.hpp"
#include "arithmetic/functions/elementary/quadrants.hpp"
#include "polhode/arithmetic/elementary.hpp"

namespace polhode {

using namespace detail::elementary;
using detail::end_points;
using detail::mpfr_cell;
using detail::near_function;

namespace {

void set_unit_interval(ball& result, precision p) {
  mpfr_cell lower(p);
  mpfr_cell upper(p);
  mpfr_set_si(lower.get(), -1, MPFR_RNDN);
  mpfr_set_si(upper.get(), 1, MPFR_RNDN);
  ball_access::set_ends(result, lower, upper);
}

/// sin or cos of a set: 1 where it passes the quarter turn `top`, -1 half a circle later, and at
/// other places between the values at its ends.
void circular_range(ball& result, const end_points& x, precision p, mpfr_function f, unsigned top,
                    const quarter_turns& turns) {
  if (turns.whole_circle) return set_unit_interval(result, p);
  mpfr_cell lower(p);
  mpfr_cell upper(p);
  mpfr_cell other(p);
  if (turns.passed[(top + 2) % 4]) {
    mpfr_set_si(lower.get(), -1, MPFR_RNDN);
  } else {
    f(lower.get(), x.lower(), MPFR_RNDD);
    f(other.get(), x.upper(), MPFR_RNDD);
    if (mpfr_less_p(other.get(), lower.get()) != 0) lower.swap(other);
  }
  if (turns.passed[top]) {
    mpfr_set_si(upper.get(), 1, MPFR_RNDN);
  } else {
    f(upper.get(), x.lower(), MPFR_RNDU);
    f(other.get(), x.upper(), MPFR_RNDU);
    if (mpfr_greater_p(other.get(), upper.get()) != 0) upper.swap(other);
  }
  ball_access::set_ends(result, lower, upper);
}

/// |sin(m + h) - sin(m)| <= |cos m| |h| + h^2 / 2, and the same with sin and cos exchanged.
magnitude circular_error(mpfr_srcptr value, const magnitude& radius) {
  return add_up(multiply_up(cofunction_up(value), radius), scale(multiply_up(radius, radius), -1));
}

void circular(ball& result, const ball& x, mpfr_function f, near_function near, unsigned top) {
  const precision p = x.precision();
  if (x.is_undefined()) return ball_access::set_undefined(result, p);
  if (is_thin(x)) {
    if (too_large_to_reduce(ball_access::first(x), p)) return set_unit_interval(result, p);
    const magnitude radius = ball_access::radius(x);
    at_midpoint(
        result, x, f, [&](mpfr_srcptr value) { return circular_error(value, radius); }, near);
    return;
  }
  const end_points e(x, p + guard_bits);
  circular_range(result, e, p, f, top, turns_inside(e, p));
}

/// sin(pi x) or cos(pi x): the same with the slope pi < 355/113, and arguments reduced exactly.
void circular_of_half_circles(ball& result, const ball& x, mpfr_function f, unsigned top) {
  const precision p = x.precision();
  if (x.is_undefined()) return ball_access::set_undefined(result, p);
  if (is_thin(x)) {
    const magnitude radius =
        divide_up(multiply_up(magnitude::from_integer_up(355), ball_access::radius(x)),
                  magnitude::from_integer_down(113));
    at_midpoint(result, x, f, [&](mpfr_srcptr value) { return circular_error(value, radius); });
    return;
  }
  const end_points e(x, p + guard_bits);
  circular_range(result, e, p, f, top, turns_of_half_circles(e));
}

}  // namespace

void sin(ball& result, const ball& x) { circular(result, x, mpfr_sin, detail::near_sin, 1); }
void cos(ball& result, const ball& x) { circular(result, x, mpfr_cos, detail::near_cos, 0); }

void sinpi(ball& result, const ball& x) { circular_of_half_circles(result, x, mpfr_sinpi, 1); }
void cospi(ball& result, const ball& x) { circular_of_half_circles(result, x, mpfr_cospi, 0); }

void sin_cos(ball& sine, ball& cosine, const ball& x) {
  const precision p = x.precision();
  if (!is_thin(x) || too_large_to_reduce(ball_access::first(x), p)) {
    ball s;  // x may be one of the results
    sin(s, x);
    cos(cosine, x);
    sine = std::move(s);
    return;
  }
  const magnitude radius = ball_access::radius(x);
  mpfr_cell s(p);
  mpfr_cell c(p);
  const mpfr_srcptr m = ball_access::first(x);
  magnitude sine_distance;
  magnitude cosine_distance;
  int sine_ternary = 0;
  int cosine_ternary = 0;
  const detail::near_pair found =
      detail::near_sin_cos(s.get(), c.get(), m, sine_distance, cosine_distance);
  if (!found.sine && !found.cosine) {
    const int inexact = mpfr_sin_cos(s.get(), c.get(), m, MPFR_RNDN);
    // mpfr_sin_cos returns the ternary value of sin in its two low bits, that of cos above them.
    sine_ternary = inexact & 3;
    cosine_ternary = inexact >> 2;
  } else if (!found.sine) {
    sine_ternary = mpfr_sin(s.get(), m, MPFR_RNDN);
  } else if (!found.cosine) {
    cosine_ternary = mpfr_cos(c.get(), m, MPFR_RNDN);
  }
  if (!found.sine) sine_distance = {};
  if (!found.cosine) cosine_distance = {};
  const auto error_of = [&](mpfr_srcptr value, const magnitude& distance) {
    return radius.is_zero() ? distance : add_up(circular_error(value, radius), distance);
  };
  const magnitude sine_error = error_of(s.get(), sine_distance);
  const magnitude cosine_error = error_of(c.get(), cosine_distance);
  ball_access::first(sine) = std::move(s);
  ball_access::finish(sine, sine_ternary, sine_error);
  ball_access::first(cosine) = std::move(c);
  ball_access::finish(cosine, cosine_ternary, cosine_error);
}

void tan(ball& result, const ball& x) {
  const precision p = x.precision();
  if (!x.is_bounded()) return ball_access::set_undefined(result, p);
  const magnitude radius = ball_access::radius(x);
  if (is_thin(x) && !too_large_to_reduce(ball_access::first(x), p)) {
    // tan(m+h) - t = tan h (1 + t^2) / (1 - t tan h), and cos(m+h) = cos m cos h (1 - t tan h):
    // no pole while |t| tan r < 1. tan r <= r + r^3 for r <= 1/2.
    mpfr_cell value(p);
    const int ternary = mpfr_tan(value.get(), ball_access::first(x), MPFR_RNDN);
    if (radius.is_zero()) {
      ball_access::first(result) = std::move(value);
      return ball_access::finish(result, ternary, {});
    }
    const magnitude t = true_value_up(value.get());
    const magnitude tan_r = multiply_up(radius, add_up(one, multiply_up(radius, radius)));
    const magnitude product = multiply_up(t, tan_r);
    if (product <= small_radius) {
      const magnitude error = divide_up(multiply_up(tan_r, add_up(one, multiply_up(t, t))),
                                        subtract_down(one, product));
      ball_access::first(result) = std::move(value);
      return ball_access::finish(result, ternary, error);
    }
  }
  const end_points e(x, p + guard_bits);
  const quarter_turns turns = turns_inside(e, p);
  if (turns.whole_circle || turns.passed[1] || turns.passed[3]) {
    return ball_access::set_undefined(result, p);
  }
  at_ends(result, e, p, mpfr_tan, true);
}

}  // namespace polhode
