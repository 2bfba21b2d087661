#include "polhode/arithmetic/elementary.hpp"

#include <algorithm>
#include <utility>

#include "arithmetic/ball/ball_access.hpp"
#include "fixed_point_functions.hpp"

namespace polhode {

using detail::end_points;
using detail::mpfr_cell;
using detail::near_function;
using form = ball_access::form;

namespace {

using mpfr_function = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);

const magnitude one = magnitude::power_of_two(0);
// Radii up to this are carried through a bound of first order; wider balls by their end points.
const magnitude small_radius = magnitude::power_of_two(-10);
// The ends of a ball by midpoint and radius are computed to so many bits beyond the result's: a
// radius far below the midpoint's last place is not lost in them, and a steep function does not
// magnify their rounding into sight.
constexpr precision guard_bits = 64;

/// f at the midpoint, by `near` where that is given and can. error(value) bounds |f(x) - f(midpoint)| over
/// the ball, given an MPFR number within value_error of f(midpoint); it is not asked when x is exact.
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

void at_ends(ball& result, const end_points& x, precision p, mpfr_function f, bool increasing) {
  mpfr_cell lower(p);
  mpfr_cell upper(p);
  f(lower.get(), increasing ? x.lower() : x.upper(), MPFR_RNDD);
  f(upper.get(), increasing ? x.upper() : x.lower(), MPFR_RNDU);
  ball_access::set_ends(result, lower, upper);
}

/// The first-order path is taken for balls by midpoint with a radius up to 2^-10.
bool is_thin(const ball& x) {
  return ball_access::is_midpoint_radius(x) && ball_access::radius(x) <= small_radius;
}

/// |x| < 2^20: exp and its kin are far from overflow there.
bool is_moderate(const ball& x) {
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

/// How far a computed value y is from the number that it stands for: half a unit in the last place, as MPFR
/// rounds, and 2^-10 units more for what a near_function grants itself.
magnitude value_error(mpfr_srcptr y) {
  const magnitude half_unit = detail::rounding_error(y);
  return add_up(half_unit, scale(half_unit, -9));
}

/// An upper bound of |v| for the number v whose computed value is y.
magnitude true_value_up(mpfr_srcptr y) { return add_up(magnitude::abs_up(y), value_error(y)); }

/// An upper bound of 1 - |v| for the number v whose computed value is y.
magnitude one_minus_abs_up(mpfr_srcptr y) {
  if (mpfr_regular_p(y) != 0 && mpfr_get_exp(y) <= 0 && mpfr_get_exp(y) > -64) {
    // In units of 2^-64, rounded up; where that is too coarse, as MPFR subtracts.
    const auto* significand = static_cast<const mp_limb_t*>(mpfr_custom_get_significand(y));
    const mp_limb_t top = significand[(mpfr_get_prec(y) - 1) / GMP_NUMB_BITS];
    const std::uint64_t rest = 0 - (std::uint64_t{top} >> -mpfr_get_exp(y));
    if (rest >> 40 != 0) return add_up(magnitude::from_bits_up(rest, -64), value_error(y));
  }
  mpfr_cell difference(64);
  mpfr_cell unit(2);
  mpfr_set_ui(unit.get(), 1, MPFR_RNDN);
  if (mpfr_sgn(y) >= 0) {
    mpfr_sub(difference.get(), unit.get(), y, MPFR_RNDU);
  } else {
    mpfr_add(difference.get(), unit.get(), y, MPFR_RNDU);
  }
  const magnitude rounded =
      mpfr_sgn(difference.get()) > 0 ? magnitude::abs_up(difference.get()) : magnitude{};
  return add_up(rounded, value_error(y));
}

/// A lower bound of 1 - |x| for the number x itself; 0 where |x| >= 1.
magnitude one_minus_abs_down(mpfr_srcptr x) {
  mpfr_cell difference(64);
  mpfr_cell unit(2);
  mpfr_set_ui(unit.get(), 1, MPFR_RNDN);
  if (mpfr_sgn(x) >= 0) {
    mpfr_sub(difference.get(), unit.get(), x, MPFR_RNDD);
  } else {
    mpfr_add(difference.get(), unit.get(), x, MPFR_RNDD);
  }
  return mpfr_sgn(difference.get()) > 0 ? magnitude::abs_down(difference.get()) : magnitude{};
}

/// sqrt(1 - y^2), rounded up: |cos| from |sin| and the other way round.
magnitude cofunction_up(mpfr_srcptr y) {
  return sqrt_up(multiply_up(one_minus_abs_up(y), add_up(one, min(magnitude::abs_up(y), one))));
}

/// q + q^2, rounded up.
magnitude plus_square_up(const magnitude& q) { return multiply_up(q, add_up(one, q)); }

// ---------------------------------------------------------------------------------------------
// Quadrants, for wide arguments of the circular functions.

/// floor(2 x / pi) for a number x. 2 x / pi is irrational for x != 0, so raising the precision
/// of pi always decides it in the end.
void quadrant(mpz_ptr result, mpfr_srcptr x) {
  if (mpfr_zero_p(x) != 0 || mpfr_get_exp(x) <= 0) {  // |x| < 1: also where x / pi underflows
    mpz_set_si(result, mpfr_sgn(x) < 0 ? -1 : 0);
    return;
  }
  mpz_t other;
  mpz_init(other);
  precision p = std::max<precision>(mpfr_get_exp(x), 0) + 64;
  while (true) {
    mpfr_cell ratio(p);
    mpfr_cell half_pi(p);
    const bool positive = mpfr_sgn(x) > 0;
    // A lower bound of x / (pi / 2), then an upper bound.
    mpfr_const_pi(half_pi.get(), positive ? MPFR_RNDU : MPFR_RNDD);
    mpfr_div_2ui(half_pi.get(), half_pi.get(), 1, MPFR_RNDN);
    mpfr_div(ratio.get(), x, half_pi.get(), MPFR_RNDD);
    mpfr_get_z(result, ratio.get(), MPFR_RNDD);
    mpfr_const_pi(half_pi.get(), positive ? MPFR_RNDD : MPFR_RNDU);
    mpfr_div_2ui(half_pi.get(), half_pi.get(), 1, MPFR_RNDN);
    mpfr_div(ratio.get(), x, half_pi.get(), MPFR_RNDU);
    mpfr_get_z(other, ratio.get(), MPFR_RNDD);
    if (mpz_cmp(result, other) == 0) break;
    p *= 2;
  }
  mpz_clear(other);
}

bool too_large_to_reduce(mpfr_srcptr x, precision p) {
  return mpfr_regular_p(x) != 0 &&
         mpfr_get_exp(x) > static_cast<mpfr_exp_t>(std::max<precision>(precision{1} << 20, 4 * p));
}

/// The multiples j of pi/2 inside (lower, upper], by their residues modulo 4.
struct quarter_turns {
  bool passed[4] = {false, false, false, false};
  bool whole_circle = false;
};

/// For a set no wider than `widest`, given what sets an integer to the number of quarter turns up to a point;
/// points that are too large to say so may be anywhere on the circle.
template <class TooLarge, class Quadrant>
quarter_turns turns_between(const end_points& x, unsigned long widest, TooLarge&& too_large,
                            Quadrant&& set_quadrant) {
  quarter_turns result;
  mpfr_cell width(32);
  mpfr_sub(width.get(), x.upper(), x.lower(), MPFR_RNDU);
  if (mpfr_cmp_ui(width.get(), widest) >= 0 || too_large(x.lower()) || too_large(x.upper())) {
    result.whole_circle = true;
    return result;
  }
  mpz_t first;
  mpz_t last;
  mpz_init(first);
  mpz_init(last);
  set_quadrant(first, x.lower());
  set_quadrant(last, x.upper());
  const auto start = mpz_fdiv_ui(first, 4);
  mpz_sub(last, last, first);  // small, since the width is
  const auto count = mpz_get_ui(last);
  for (unsigned long j = 1; j <= count; ++j) result.passed[(start + j) % 4] = true;
  mpz_clear(last);
  mpz_clear(first);
  return result;
}

quarter_turns turns_inside(const end_points& x, precision p) {
  return turns_between(
      x, 7, [p](mpfr_srcptr end) { return too_large_to_reduce(end, p); }, quadrant);
}

void set_unit_interval(ball& result, precision p) {
  mpfr_cell lower(p);
  mpfr_cell upper(p);
  mpfr_set_si(lower.get(), -1, MPFR_RNDN);
  mpfr_set_si(upper.get(), 1, MPFR_RNDN);
  ball_access::set_ends(result, lower, upper);
}

/// The same for arguments counted in half circles: quarter turns lie at multiples of 1/2.
quarter_turns turns_of_half_circles(const end_points& x) {
  const auto too_large = [](mpfr_srcptr end) {
    return mpfr_regular_p(end) != 0 && mpfr_get_exp(end) > (mpfr_exp_t{1} << 24);
  };
  const auto floor_of_double = [](mpz_ptr r, mpfr_srcptr end) {
    mpfr_cell twice(mpfr_get_prec(end));
    mpfr_mul_2ui(twice.get(), end, 1, MPFR_RNDN);
    mpfr_get_z(r, twice.get(), MPFR_RNDD);
  };
  return turns_between(x, 2, too_large, floor_of_double);
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

// ---------------------------------------------------------------------------------------------

ball abs(const ball& x) {
  const sign s = sign_of(x);
  if (x.is_undefined() || s == sign::positive || s == sign::zero) return x;
  if (s == sign::negative) return -x;
  const precision p = x.precision();
  const end_points e(x, p + guard_bits);
  mpfr_cell lower(p);
  mpfr_cell upper(p);
  mpfr_abs(upper.get(), mpfr_cmpabs(e.lower(), e.upper()) <= 0 ? e.upper() : e.lower(), MPFR_RNDU);
  ball r;
  ball_access::set_ends(r, lower, upper);
  return r;
}

void exp(ball& result, const ball& x) {
  const magnitude radius = ball_access::radius(x);
  // |e^(m+h) - e^m| <= e^m (e^r - 1), and e^r - 1 <= r + r^2 for r <= 1.
  monotone(
      result, x, mpfr_exp, true,
      [&](mpfr_srcptr value) { return multiply_up(true_value_up(value), plus_square_up(radius)); },
      detail::near_exp);
}

namespace {
/// factor * x, rounded up, for the positive rational factor numerator / denominator.
magnitude times_ratio_up(const magnitude& x, unsigned numerator, unsigned denominator) {
  return divide_up(multiply_up(magnitude::from_integer_up(numerator), x),
                   magnitude::from_integer_down(denominator));
}
}  // namespace

void exp2(ball& result, const ball& x) {
  // 2^x = e^(x log 2): as exp, with the radius r log 2, and log 2 < 61/88 = 0.69318...
  const magnitude radius = times_ratio_up(ball_access::radius(x), 61, 88);
  monotone(result, x, mpfr_exp2, true, [&](mpfr_srcptr value) {
    return multiply_up(true_value_up(value), plus_square_up(radius));
  });
}

void exp10(ball& result, const ball& x) {
  // As exp, with the radius r log 10 <= 1, and log 10 < 175/76 = 2.30263...
  const magnitude radius = times_ratio_up(ball_access::radius(x), 175, 76);
  monotone(result, x, mpfr_exp10, true, [&](mpfr_srcptr value) {
    return multiply_up(true_value_up(value), plus_square_up(radius));
  });
}

void expm1(ball& result, const ball& x) {
  const magnitude radius = ball_access::radius(x);
  // |e^(m+h) - e^m| <= e^m (r + r^2), and e^m = 1 + v.
  monotone(result, x, mpfr_expm1, true, [&](mpfr_srcptr value) {
    const magnitude exp_m =
        mpfr_sgn(value) < 0 ? one_minus_abs_up(value) : add_up(one, true_value_up(value));
    return multiply_up(exp_m, plus_square_up(radius));
  });
}

void log1p(ball& result, const ball& x) {
  const precision p = x.precision();
  if (x.is_undefined()) return ball_access::set_undefined(result, p);
  if (is_thin(x)) {
    // As log, with the argument 1 + m: q = r / (1 + m).
    const magnitude radius = ball_access::radius(x);
    mpfr_cell sum(64);
    mpfr_add_ui(sum.get(), ball_access::first(x), 1, MPFR_RNDD);
    if (mpfr_sgn(sum.get()) > 0) {
      const magnitude q = divide_up(radius, magnitude::abs_down(sum.get()));
      if (q <= small_radius) {
        return at_midpoint(result, x, mpfr_log1p, [&](mpfr_srcptr) { return plus_square_up(q); });
      }
    }
  }
  const end_points e(x, p + guard_bits);
  if (mpfr_cmp_si(e.lower(), -1) <= 0) return ball_access::set_undefined(result, p);
  at_ends(result, e, p, mpfr_log1p, true);
}

namespace {
/// A logarithm that is log x / log b, given an upper bound of 1 / log b as a quotient of integers.
void logarithm(ball& result, const ball& x, mpfr_function f, unsigned numerator,
               unsigned denominator, near_function near = nullptr) {
  if (sign_of(x) != sign::positive) return ball_access::set_undefined(result, x.precision());
  if (!ball_access::is_midpoint_radius(x)) {
    const precision p = x.precision();
    return at_ends(result, end_points(x, p + guard_bits), p, f, true);
  }
  // |log(m+h) - log(m)| <= -log(1 - q) <= q + q^2 for q = r / m <= 1/2 (here q < 2^-22).
  const magnitude q = divide_up(ball_access::radius(x), magnitude::abs_down(ball_access::first(x)));
  at_midpoint(
      result, x, f,
      [&](mpfr_srcptr) { return times_ratio_up(plus_square_up(q), numerator, denominator); }, near);
}
}  // namespace

void log(ball& result, const ball& x) { logarithm(result, x, mpfr_log, 1, 1, detail::near_log); }
// 1 / log 2 < 101/70 = 1.44285... and 1 / log 10 < 43/99 = 0.43434...
void log2(ball& result, const ball& x) { logarithm(result, x, mpfr_log2, 101, 70); }
void log10(ball& result, const ball& x) { logarithm(result, x, mpfr_log10, 43, 99); }

void rsqrt(ball& result, const ball& x) {
  if (sign_of(x) != sign::positive) return ball_access::set_undefined(result, x.precision());
  if (!ball_access::is_midpoint_radius(x)) {
    const precision p = x.precision();
    return at_ends(result, end_points(x, p + guard_bits), p, mpfr_rec_sqrt, false);
  }
  // |(m+h)^(-1/2) - m^(-1/2)| <= m^(-1/2) ((1 - q)^(-1/2) - 1) with q = r / m < 2^-22. In the power series
  // of (1 - q)^(-1/2) the coefficients from q^2 on are at most 3/8, so it is at most
  // 1 + q/2 + (3/8) q^2 / (1 - q) <= 1 + (q + q^2) / 2 for q <= 1/4.
  const magnitude q = divide_up(ball_access::radius(x), magnitude::abs_down(ball_access::first(x)));
  at_midpoint(result, x, mpfr_rec_sqrt, [&](mpfr_srcptr value) {
    return multiply_up(true_value_up(value), scale(plus_square_up(q), -1));
  });
}

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

ball hypot(const ball& x, const ball& y) {
  const precision p = std::max(x.precision(), y.precision());
  if (x.is_undefined() || y.is_undefined()) return ball::undefined(p);
  if (ball_access::is_midpoint_radius(x) && ball_access::is_midpoint_radius(y)) {
    // The derivatives are x / |(x, y)| and y / |(x, y)|: at most 1 in size, and at most the greatest |x|, or |y|, over the
    // least |(x, y)|.
    const magnitude least_x = x.magnitude_lower();
    const magnitude least_y = y.magnitude_lower();
    const magnitude least =
        sqrt_down(add_down(multiply_down(least_x, least_x), multiply_down(least_y, least_y)));
    const auto change = [&](const ball& s) {
      const magnitude& radius = ball_access::radius(s);
      if (radius.is_zero()) return magnitude{};
      return multiply_up(radius, min(one, divide_up(s.magnitude_upper(), least)));
    };
    ball r;
    detail::set_midpoint(r, p, add_up(change(x), change(y)), [&](mpfr_ptr value) {
      return mpfr_hypot(value, ball_access::first(x), ball_access::first(y), MPFR_RNDN);
    });
    return r;
  }
  const ball ax = abs(x);
  const ball ay = abs(y);
  const end_points ex(ax, p + guard_bits);
  const end_points ey(ay, p + guard_bits);
  mpfr_cell lower(p);
  mpfr_cell upper(p);
  mpfr_hypot(lower.get(), ex.lower(), ey.lower(), MPFR_RNDD);
  mpfr_hypot(upper.get(), ex.upper(), ey.upper(), MPFR_RNDU);
  ball r;
  ball_access::set_ends(r, lower, upper);
  return r;
}

ball pow(const ball& x, long n) {
  const precision p = x.precision();
  if (n == 0 && !x.is_undefined()) return {1, p};
  if (n == 1) return x;
  if (n == 2) return square(x);
  if (x.is_undefined() || (n < 0 && contains_zero(x))) return ball::undefined(p);
  ball r;
  if (ball_access::is_midpoint_radius(x)) {
    const auto k = n < 0 ? 0 - static_cast<std::uint64_t>(n) : static_cast<std::uint64_t>(n);
    const magnitude kq = x.is_exact()
                             ? magnitude{}
                             : multiply_up(magnitude::from_integer_up(k),
                                           divide_up(ball_access::radius(x),
                                                     magnitude::abs_down(ball_access::first(x))));
    if (kq <= small_radius) {
      // With q = r/|m| and k = |n|: (1 + q)^k - 1 <= kq / (1 - kq) and (1 - q)^(-k) - 1 <=
      // kq / (1 - kq), both by Bernoulli's (1 - q)^k >= 1 - kq and (1 + q)^k (1 - q)^k <= 1.
      mpfr_cell value(p);
      const int ternary = mpfr_pow_si(value.get(), ball_access::first(x), n, MPFR_RNDN);
      if (mpfr_number_p(value.get()) != 0) {  // else it overflowed: the ends keep its sign
        const magnitude size =
            add_up(magnitude::abs_up(value.get()),
                   ternary == 0 ? magnitude{} : detail::rounding_error(value.get()));
        const magnitude error = multiply_up(size, divide_up(kq, subtract_down(one, kq)));
        ball_access::first(r) = std::move(value);
        ball_access::finish(r, ternary, error);
        return r;
      }
    }
  }
  // An even power is a power of |x|; x^n is then monotone on each side of 0, decreasing for n < 0.
  const ball base = n % 2 == 0 ? abs(x) : x;
  const end_points e(base, p + guard_bits);
  // A radius below the least positive number is rounded up to it: an end may come to 0 only here.
  if (n < 0 && (mpfr_zero_p(e.lower()) != 0 || mpfr_zero_p(e.upper()) != 0)) {
    return ball::undefined(p);
  }
  mpfr_cell lower(p);
  mpfr_cell upper(p);
  mpfr_pow_si(lower.get(), n > 0 ? e.lower() : e.upper(), n, MPFR_RNDD);
  mpfr_pow_si(upper.get(), n > 0 ? e.upper() : e.lower(), n, MPFR_RNDU);
  ball_access::set_ends(r, lower, upper);
  return r;
}

ball root(const ball& x, unsigned long n) {
  const precision p = x.precision();
  if (n == 0) return ball::undefined(p);
  if (n == 1) return x;
  if (n == 2) return sqrt(x);
  if (x.is_undefined()) return x;
  if (ball_access::is_midpoint_radius(x) && (n % 2 != 0 || sign_of(x) == sign::positive)) {
    // |(m+h)^(1/n) - m^(1/n)| <= |m|^(1/n) (1 - (1 - q)^(1/n)) for q = r/|m| < 2^-22: the root is concave. By the mean
    // value theorem that is at most (q/n) (1 - q)^(1/n - 1) <= (q/n) / (1 - q) <= (q + 2 q^2) / n.
    const mpfr_srcptr m = ball_access::first(x);
    const magnitude q =
        x.is_exact() ? magnitude{} : divide_up(ball_access::radius(x), magnitude::abs_down(m));
    mpfr_cell value(p);
    const int ternary = mpfr_rootn_ui(value.get(), m, n, MPFR_RNDN);
    const magnitude relative =
        divide_up(multiply_up(q, add_up(one, scale(q, 1))), magnitude::from_integer_down(n));
    const magnitude error =
        q.is_zero() ? magnitude{} : multiply_up(true_value_up(value.get()), relative);
    ball r;
    ball_access::first(r) = std::move(value);
    ball_access::finish(r, ternary, error);
    return r;
  }
  const end_points e(
      x, p + guard_bits);  // increasing; MPFR answers a NaN for even roots of negative numbers
  mpfr_cell lower(p);
  mpfr_cell upper(p);
  mpfr_rootn_ui(lower.get(), e.lower(), n, MPFR_RNDD);
  mpfr_rootn_ui(upper.get(), e.upper(), n, MPFR_RNDU);
  ball r;
  ball_access::set_ends(r, lower, upper);
  return r;
}

namespace {
/// The integer that an exact ball is, where it is one that fits.
bool is_machine_integer(const ball& y, long& n) {
  if (!y.is_exact()) return false;
  const mpfr_srcptr m = ball_access::first(y);
  if (mpfr_integer_p(m) == 0 || mpfr_fits_slong_p(m, MPFR_RNDN) == 0) return false;
  n = mpfr_get_si(m, MPFR_RNDN);
  return true;
}

/// x^y over a rectangle with x >= 0. d/dx has the sign of y and d/dy that of log x, constant along each
/// side, so the extremes lie at the corners and, where the rectangle crosses x = 1 or y = 0, the
/// values there are 1, which lies between corner values on both sides.
ball power_at_corners(const end_points& x, const end_points& y, precision p) {
  mpfr_cell lower(p);
  mpfr_cell upper(p);
  mpfr_cell other(p);
  bool first = true;
  for (const mpfr_srcptr base : {x.lower(), x.upper()}) {
    for (const mpfr_srcptr exponent : {y.lower(), y.upper()}) {
      mpfr_pow(other.get(), base, exponent, MPFR_RNDD);
      if (first || mpfr_less_p(other.get(), lower.get()) != 0) {
        mpfr_set(lower.get(), other.get(), MPFR_RNDD);
      }
      mpfr_pow(other.get(), base, exponent, MPFR_RNDU);
      if (first || mpfr_greater_p(other.get(), upper.get()) != 0) {
        mpfr_set(upper.get(), other.get(), MPFR_RNDU);
      }
      first = false;
    }
  }
  ball r;
  ball_access::set_ends(r, lower, upper);
  return r;
}
}  // namespace

ball pow(const ball& x, const ball& y) {
  const precision p = std::max(x.precision(), y.precision());
  if (x.is_undefined() || y.is_undefined()) return ball::undefined(p);
  long n = 0;
  if (is_machine_integer(y, n)) return pow(x.with_precision(p), n);
  const end_points ex(x, p + guard_bits);
  const end_points ey(y, p + guard_bits);
  const bool zero_base = mpfr_zero_p(ex.lower()) != 0;
  if (mpfr_sgn(ex.lower()) < 0 || (zero_base && mpfr_sgn(ey.lower()) <= 0)) {
    return ball::undefined(p);
  }
  // An infinite end is a limit, and MPFR gives that of the power at each corner.
  if (zero_base && !(x.is_bounded() && y.is_bounded())) return ball::undefined(p);
  if (ball_access::is_midpoint_radius(x) && ball_access::is_midpoint_radius(y) && !zero_base) {
    // The exponent y log x changes by at most d = |y| (q + q^2) + ry |log x|, q = rx / mx, and the power
    // by a factor within e^(+-d): |change| <= value (d + d^2) for d <= 1.
    const mpfr_srcptr mx = ball_access::first(x);
    const mpfr_srcptr my = ball_access::first(y);
    const magnitude q = divide_up(ball_access::radius(x), magnitude::abs_down(mx));
    const magnitude drift = plus_square_up(q);
    magnitude change = multiply_up(magnitude::abs_up(my), drift);
    if (!ball_access::radius(y).is_zero()) {
      mpfr_cell logarithm(32);
      mpfr_log(logarithm.get(), mx, MPFR_RNDA);
      change = add_up(change, multiply_up(ball_access::radius(y),
                                          add_up(magnitude::abs_up(logarithm.get()), drift)));
    }
    if (change <= small_radius) {
      mpfr_cell value(p);
      const int ternary = mpfr_pow(value.get(), mx, my, MPFR_RNDN);
      if (mpfr_regular_p(value.get()) != 0) {
        const magnitude error =
            change.is_zero() ? magnitude{}
                             : multiply_up(true_value_up(value.get()), plus_square_up(change));
        ball r;
        ball_access::first(r) = std::move(value);
        ball_access::finish(r, ternary, error);
        return r;
      }
    }
  }
  return power_at_corners(ex, ey, p);
}

namespace {
ball step_function(const ball& x, int (*f)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t)) {
  const precision p = x.precision();
  if (x.is_undefined()) return x;
  const end_points e(x, p + guard_bits);
  mpfr_cell lower(p);
  mpfr_cell upper(p);
  f(lower.get(), e.lower(), MPFR_RNDD);
  f(upper.get(), e.upper(), MPFR_RNDU);
  ball r;
  ball_access::set_exact_ends(r, lower, upper);
  return r;
}

ball lattice_operation(const ball& x, const ball& y,
                       int (*f)(mpfr_ptr, mpfr_srcptr, mpfr_srcptr, mpfr_rnd_t)) {
  const precision p = std::max(x.precision(), y.precision());
  if (x.is_undefined() || y.is_undefined()) return ball::undefined(p);
  const end_points ex(x, p + guard_bits);
  const end_points ey(y, p + guard_bits);
  mpfr_cell lower(p);
  mpfr_cell upper(p);
  f(lower.get(), ex.lower(), ey.lower(), MPFR_RNDD);
  f(upper.get(), ex.upper(), ey.upper(), MPFR_RNDU);
  ball r;
  ball_access::set_exact_ends(r, lower, upper);
  return r;
}
}  // namespace

ball floor(const ball& x) { return step_function(x, mpfr_rint_floor); }
ball ceil(const ball& x) { return step_function(x, mpfr_rint_ceil); }
ball trunc(const ball& x) { return step_function(x, mpfr_rint_trunc); }
ball round_ties_to_even(const ball& x) { return step_function(x, mpfr_rint_roundeven); }
ball round_ties_to_away(const ball& x) { return step_function(x, mpfr_rint_round); }
ball signum(const ball& x) {
  return step_function(x, [](mpfr_ptr r, mpfr_srcptr end, mpfr_rnd_t rounding) {
    return mpfr_set_si(r, (mpfr_sgn(end) > 0) - (mpfr_sgn(end) < 0), rounding);
  });
}
ball min(const ball& x, const ball& y) { return lattice_operation(x, y, mpfr_min); }
ball max(const ball& x, const ball& y) { return lattice_operation(x, y, mpfr_max); }

namespace {
// mpfr_agm goes to the heap at every precision.
constexpr precision most_bits_of_near_agm = 256;
constexpr precision agm_guard_bits = 24;

/// As a near_function, for two positive numbers of up to r's precision.
///
/// The mean M is increasing in both arguments, homogeneous, and the same for (a + b) / 2 and sqrt(a b).
/// Let u = 2^-wp. A step rounds the first with a relative error of u at most, and the second with u/2
/// from the product and u, so that it changes M by a factor within 1 +- 2 u (1 + u). Where |a - b| <= a u^(1/2)
/// the rest is below (a + b) / 2 - sqrt(a b) <= (a - b)^2 / (8 min(a, b)) <= u a / 2, and the sum is
/// rounded once more.
bool near_agm(mpfr_ptr r, mpfr_srcptr x, mpfr_srcptr y, magnitude& error) {
  const precision p = mpfr_get_prec(r);
  // Products and differences stay far inside MPFR's range, which a caller may have narrowed.
  const mpfr_exp_t least = mpfr_get_emin() / 4;
  const mpfr_exp_t most = mpfr_get_emax() / 4;
  constexpr mpfr_exp_t wide = 1024;
  const auto is_moderate = [=](mpfr_srcptr z) {
    return mpfr_get_exp(z) > least && mpfr_get_exp(z) < most;
  };
  if (p > most_bits_of_near_agm || least > -wide || most < wide || !is_moderate(x) ||
      !is_moderate(y) || mpfr_equal_p(x, y) != 0) {
    return false;
  }
  const precision wp = std::max<precision>(p + agm_guard_bits, 96);
  mp_limb_t limbs[3][(most_bits_of_near_agm + agm_guard_bits) / GMP_NUMB_BITS + 1];
  mpfr_t a;
  mpfr_t b;
  mpfr_t t;
  mpfr_custom_init_set(a, MPFR_ZERO_KIND, 0, wp, limbs[0]);
  mpfr_custom_init_set(b, MPFR_ZERO_KIND, 0, wp, limbs[1]);
  mpfr_custom_init_set(t, MPFR_ZERO_KIND, 0, wp, limbs[2]);
  mpfr_set(a, x, MPFR_RNDN);  // exact
  mpfr_set(b, y, MPFR_RNDN);
  std::uint64_t steps = 0;
  while (true) {
    mpfr_sub(t, a, b, MPFR_RNDN);
    // |a - b| <= 2^(exp t) <= 2^(exp a - 1 - wp/2) <= a u^(1/2).
    if (mpfr_zero_p(t) != 0 || mpfr_get_exp(t) < mpfr_get_exp(a) - 1 - wp / 2) break;
    mpfr_mul(t, a, b, MPFR_RNDN);
    mpfr_add(a, a, b, MPFR_RNDN);
    mpfr_div_2ui(a, a, 1, MPFR_RNDN);
    mpfr_sqrt(b, t, MPFR_RNDN);
    ++steps;
  }
  mpfr_add(a, a, b, MPFR_RNDN);
  const bool inexact = mpfr_div_2ui(r, a, 1, MPFR_RNDN) != 0;
  // The error is below (2 steps + 2) u (1 + 2^-80) times a number below 2^(exp r). `steps` is about
  // log2(wp) and log2 of log2(x / y), at most 63: this is below 2^-10 units in r's last place.
  error = magnitude::from_bits_up(2 * steps + 3, std::int64_t{mpfr_get_exp(r)} - wp);
  if (inexact) error = add_up(error, detail::rounding_error(r));
  return true;
}
}  // namespace

void agm(ball& result, const ball& x, const ball& y) {
  const precision p = std::max(x.precision(), y.precision());
  const sign sx = sign_of(x);
  const sign sy = sign_of(y);
  // In either form a set has a negative member where its first number is negative.
  if (x.is_undefined() || y.is_undefined() || mpfr_sgn(ball_access::first(x)) < 0 ||
      mpfr_sgn(ball_access::first(y)) < 0) {
    return ball_access::set_undefined(result, p);
  }
  if (sx == sign::zero || sy == sign::zero) {  // the mean with 0 is 0, however great the other is
    result = ball(0, p);
    return;
  }
  if (ball_access::is_midpoint_radius(x) && ball_access::is_midpoint_radius(y)) {
    // The mean M is increasing in both arguments and homogeneous: for x = mx (1 + s),
    // y = my (1 + t) with |s|, |t| <= q, (1 - q) M(mx, my) <= M(x, y) <= (1 + q) M(mx, my).
    const auto relative = [](const ball& z) {
      return divide_up(ball_access::radius(z), magnitude::abs_down(ball_access::first(z)));
    };
    const magnitude q = max(relative(x), relative(y));
    mpfr_cell value(p);
    magnitude error;
    int ternary = 0;
    if (!near_agm(value.get(), ball_access::first(x), ball_access::first(y), error)) {
      error = {};
      ternary = mpfr_agm(value.get(), ball_access::first(x), ball_access::first(y), MPFR_RNDN);
    }
    if (!q.is_zero()) error = add_up(error, multiply_up(q, true_value_up(value.get())));
    ball_access::first(result) = std::move(value);
    return ball_access::finish(result, ternary, error);
  }
  const end_points ex(x, p + guard_bits);
  const end_points ey(y, p + guard_bits);
  mpfr_cell lower(p);
  mpfr_cell upper(p);
  mpfr_agm(lower.get(), ex.lower(), ey.lower(), MPFR_RNDD);
  mpfr_agm(upper.get(), ex.upper(), ey.upper(), MPFR_RNDU);
  ball_access::set_ends(result, lower, upper);
}

namespace {
ball constant(int (*f)(mpfr_ptr, mpfr_rnd_t), precision p) {
  ball r;
  detail::set_midpoint(r, checked_precision(p), {},
                       [&](mpfr_ptr value) { return f(value, MPFR_RNDN); });
  return r;
}
}  // namespace

ball pi(precision p) { return constant(mpfr_const_pi, p); }
ball log_2(precision p) { return constant(mpfr_const_log2, p); }

}  // namespace polhode
