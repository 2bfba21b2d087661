#pragma once

// How the radius of a ball is carried through a function: a thin ball's by a bound of first order
// around the value at its midpoint, a wide ball's by the values at its ends. The bounds of first
// order are put together from those of magnitudes at the end of this file.

#include <utility>

#include <mpfr.h>

#include "arithmetic/ball/ball_access.hpp"
#include "arithmetic/functions/fixed_point_functions.hpp"
#include "polhode/arithmetic/ball.hpp"
#include "polhode/arithmetic/magnitude.hpp"

namespace polhode::detail::elementary {

using mpfr_function = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);

inline constexpr magnitude one = magnitude::power_of_two(0);
// Radii up to this are carried through a bound of first order; wider balls by their end points.
inline constexpr magnitude small_radius = magnitude::power_of_two(-10);
// The ends of a ball by midpoint and radius are computed to so many bits beyond the result's: a
// radius far below the midpoint's last place is not lost in them, and a steep function does not
// magnify their rounding into sight.
constexpr precision guard_bits = 64;

/// f at the midpoint, by `near` where that is given and can. error(value) bounds |f(x) -
/// f(midpoint)| over the ball, given an MPFR number within value_error of f(midpoint); it is not
/// asked when x is exact.
template <class Error>
void at_midpoint(ball& result, const ball& x, mpfr_function f, Error&& error,
                 near_function near = nullptr) {
  const precision p = x.precision();
  const bool exact = x.is_exact();
  mpfr_cell fresh;
  mpfr_ptr value = nullptr;
  mpfr_cell& own = ball_access::first(result);
  if (mpfr_get_prec(own.get()) == p && &result != &x) {
    value = own.get();
  } else {
    fresh.reset(p);
    value = fresh.get();
  }
  magnitude distance;
  int ternary = 0;
  if (near == nullptr || !near(value, ball_access::first(x), distance)) {
    distance = {};
    ternary = f(value, ball_access::first(x), MPFR_RNDN);
  }
  const magnitude e = exact ? distance : add_up(error(value), distance);
  if (!fresh.is_empty()) own = std::move(fresh);
  ball_access::finish(result, ternary, e);
}

/// f, which is monotone, at the ends of x, rounded outward.
void at_ends(ball& result, const end_points& x, precision p, mpfr_function f, bool increasing);

/// The first-order path is taken for balls by midpoint with a radius up to 2^-10.
inline bool is_thin(const ball& x) {
  return ball_access::is_midpoint_radius(x) && ball_access::radius(x) <= small_radius;
}

/// |x| < 2^20: exp and its kin are far from overflow there.
inline bool is_moderate(const ball& x) {
  const mpfr_srcptr m = ball_access::first(x);
  return mpfr_regular_p(m) == 0 || mpfr_get_exp(m) < 20;
}

/// A monotone function on the whole of R, or one that MPFR answers with NaN off its closed domain.
template <class Error>
void monotone(ball& result, const ball& x, mpfr_function f, bool increasing, Error&& error,
              near_function near = nullptr) {
  if (is_thin(x) && is_moderate(x)) {
    at_midpoint(result, x, f, std::forward<Error>(error), near);
  } else if (x.is_undefined()) {
    ball_access::set_undefined(result, x.precision());
  } else {
    const precision p = x.precision();
    at_ends(result, end_points(x, p + guard_bits), p, f, increasing);
  }
}

/// How far a computed value y is from the number that it stands for: half a unit in the last place,
/// as MPFR rounds, and 2^-10 units more for what a near_function grants itself.
[[nodiscard]] inline magnitude value_error(mpfr_srcptr y) {
  const magnitude half_unit = rounding_error(y);
  return add_up(half_unit, scale(half_unit, -9));
}

/// An upper bound of |v| for the number v whose computed value is y.
[[nodiscard]] inline magnitude true_value_up(mpfr_srcptr y) {
  return add_up(magnitude::abs_up(y), value_error(y));
}

/// An upper bound of 1 - |v| for the number v whose computed value is y.
[[nodiscard]] magnitude one_minus_abs_up(mpfr_srcptr y);

/// A lower bound of 1 - |x| for the number x itself; 0 where |x| >= 1.
[[nodiscard]] magnitude one_minus_abs_down(mpfr_srcptr x);

/// sqrt(1 - y^2), rounded up: |cos| from |sin| and the other way round.
[[nodiscard]] magnitude cofunction_up(mpfr_srcptr y);

/// q + q^2, rounded up.
[[nodiscard]] inline magnitude plus_square_up(const magnitude& q) {
  return multiply_up(q, add_up(one, q));
}

/// factor * x, rounded up, for the positive rational factor numerator / denominator.
[[nodiscard]] magnitude times_ratio_up(const magnitude& x, unsigned numerator,
                                       unsigned denominator);

}  // namespace polhode::detail::elementary
