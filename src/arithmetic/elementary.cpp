#include "polhode/arithmetic/elementary.hpp"

#include <algorithm>
#include <utility>

#include "ball_access.hpp"

namespace polhode {

using detail::end_points;
using detail::mpfr_cell;
using form = ball_access::form;

namespace {

using mpfr_function = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);

const magnitude one = magnitude::power_of_two(0);
// Radii up to this are carried through a bound of first order; wider balls by their end points.
const magnitude small_radius = magnitude::power_of_two(-10);

/// f at the midpoint. error(value) bounds |f(x) - f(midpoint)| over the ball, given an MPFR number
/// within half a unit in the last place of f(midpoint); it is not asked when x is exact.
template <class Error>
void at_midpoint(ball& result, const ball& x, mpfr_function f, Error&& error) {
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
  const int ternary = f(value, ball_access::first(x), MPFR_RNDN);
  const magnitude e = exact ? magnitude{} : error(value);
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
void monotone(ball& result, const ball& x, mpfr_function f, bool increasing, Error&& error) {
  if (is_thin(x) && is_moderate(x)) {
    at_midpoint(result, x, f, std::forward<Error>(error));
  } else if (x.is_undefined()) {
    ball_access::set_undefined(result, x.precision());
  } else {
    const precision p = x.precision();
    at_ends(result, end_points(x, p), p, f, increasing);
  }
}

/// An upper bound of |y| for the number whose MPFR value in round-to-nearest is y.
magnitude true_value_up(mpfr_srcptr y) {
  return add_up(magnitude::abs_up(y), detail::rounding_error(y));
}

/// An upper bound of 1 - |y| for the number whose MPFR value in round-to-nearest is y.
magnitude one_minus_abs_up(mpfr_srcptr y) {
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
  return add_up(rounded, detail::rounding_error(y));
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
  if (mpfr_zero_p(x) != 0) {
    mpz_set_ui(result, 0);
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

quarter_turns turns_inside(const end_points& x, precision p) {
  quarter_turns result;
  mpfr_cell width(32);
  mpfr_sub(width.get(), x.upper(), x.lower(), MPFR_RNDU);
  if (mpfr_cmp_ui(width.get(), 7) >= 0 || too_large_to_reduce(x.lower(), p) ||
      too_large_to_reduce(x.upper(), p)) {
    result.whole_circle = true;
    return result;
  }
  mpz_t first;
  mpz_t last;
  mpz_init(first);
  mpz_init(last);
  quadrant(first, x.lower());
  quadrant(last, x.upper());
  const auto start = mpz_fdiv_ui(first, 4);
  mpz_sub(last, last, first);  // at most 5, since the width is below 7
  const auto count = mpz_get_ui(last);
  for (unsigned long j = 1; j <= count; ++j) result.passed[(start + j) % 4] = true;
  mpz_clear(last);
  mpz_clear(first);
  return result;
}

void set_unit_interval(ball& result, precision p) {
  mpfr_cell lower(p);
  mpfr_cell upper(p);
  mpfr_set_si(lower.get(), -1, MPFR_RNDN);
  mpfr_set_si(upper.get(), 1, MPFR_RNDN);
  ball_access::set_ends(result, lower, upper);
}

/// sin or cos of a set: 1 where it passes the quarter turn `top`, -1 half a circle later, and at
/// other places between the values at its ends.
void circular_range(ball& result, const end_points& x, precision p, mpfr_function f, unsigned top) {
  const quarter_turns turns = turns_inside(x, p);
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

void circular(ball& result, const ball& x, mpfr_function f, unsigned top) {
  const precision p = x.precision();
  if (x.is_undefined()) return ball_access::set_undefined(result, p);
  if (is_thin(x)) {
    if (too_large_to_reduce(ball_access::first(x), p)) return set_unit_interval(result, p);
    const magnitude radius = ball_access::radius(x);
    at_midpoint(result, x, f, [&](mpfr_srcptr value) { return circular_error(value, radius); });
    return;
  }
  circular_range(result, end_points(x, p), p, f, top);
}

}  // namespace

// ---------------------------------------------------------------------------------------------

ball abs(const ball& x) {
  const sign s = sign_of(x);
  if (x.is_undefined() || s == sign::positive || s == sign::zero) return x;
  if (s == sign::negative) return -x;
  const precision p = x.precision();
  const end_points e(x, p);
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
  monotone(result, x, mpfr_exp, true, [&](mpfr_srcptr value) {
    return multiply_up(true_value_up(value), plus_square_up(radius));
  });
}

void log(ball& result, const ball& x) {
  if (sign_of(x) != sign::positive) return ball_access::set_undefined(result, x.precision());
  if (!ball_access::is_midpoint_radius(x)) {
    const precision p = x.precision();
    return at_ends(result, end_points(x, p), p, mpfr_log, true);
  }
  // |log(m+h) - log(m)| <= -log(1 - q) <= q + q^2 for q = r / m <= 1/2 (here q < 2^-22).
  const magnitude q = divide_up(ball_access::radius(x), magnitude::abs_down(ball_access::first(x)));
  at_midpoint(result, x, mpfr_log, [&](mpfr_srcptr) { return plus_square_up(q); });
}

void sin(ball& result, const ball& x) { circular(result, x, mpfr_sin, 1); }
void cos(ball& result, const ball& x) { circular(result, x, mpfr_cos, 0); }

void sin_cos(ball& sine, ball& cosine, const ball& x) {
  const precision p = x.precision();
  if (!is_thin(x) || too_large_to_reduce(ball_access::first(x), p)) {
    const ball kept = x;  // x may be one of the results
    sin(sine, kept);
    cos(cosine, kept);
    return;
  }
  const magnitude radius = ball_access::radius(x);
  mpfr_cell s(p);
  mpfr_cell c(p);
  const int inexact = mpfr_sin_cos(s.get(), c.get(), ball_access::first(x), MPFR_RNDN);
  // mpfr_sin_cos returns the ternary value of sin in its two low bits, that of cos above them.
  const int sine_ternary = inexact & 3;
  const int cosine_ternary = inexact >> 2;
  const magnitude sine_error = radius.is_zero() ? radius : circular_error(s.get(), radius);
  const magnitude cosine_error = radius.is_zero() ? radius : circular_error(c.get(), radius);
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
  const end_points e(x, p);
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
  monotone(result, x, mpfr_atan, true, [&](mpfr_srcptr) {
    return divide_up(radius, add_down(one, multiply_down(nearest, nearest)));
  });
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
  at_ends(result, end_points(x, p), p, f, increasing);
}
}  // namespace

void asin(ball& result, const ball& x) { inverse_circular(result, x, mpfr_asin, true); }
void acos(ball& result, const ball& x) { inverse_circular(result, x, mpfr_acos, false); }

void sinh(ball& result, const ball& x) {
  const magnitude radius = ball_access::radius(x);
  // |sinh(m+h) - s| <= |s| (cosh r - 1) + cosh m sinh r, with cosh m = sqrt(1 + s^2),
  // cosh r - 1 <= r^2 and sinh r <= r + r^3 for r <= 1.
  monotone(result, x, mpfr_sinh, true, [&](mpfr_srcptr value) {
    const magnitude s = true_value_up(value);
    const magnitude r2 = multiply_up(radius, radius);
    const magnitude cosh_m = sqrt_up(add_up(one, multiply_up(s, s)));
    return add_up(multiply_up(s, r2), multiply_up(cosh_m, multiply_up(radius, add_up(one, r2))));
  });
}

void cosh(ball& result, const ball& x) {
  const precision p = x.precision();
  if (x.is_undefined()) return ball_access::set_undefined(result, p);
  if (is_thin(x) && is_moderate(x)) {
    const magnitude radius = ball_access::radius(x);
    const magnitude m = magnitude::abs_up(ball_access::first(x));
    // |cosh(m+h) - c| <= c (cosh r - 1) + |sinh m| sinh r, and |sinh m| is the lesser of |m| c and
    // sqrt((c - 1)(c + 1)).
    at_midpoint(result, x, mpfr_cosh, [&](mpfr_srcptr value) {
      const magnitude c = true_value_up(value);
      const magnitude r2 = multiply_up(radius, radius);
      const magnitude sinh_m =
          min(multiply_up(m, c), sqrt_up(multiply_up(subtract_up(c, one), add_up(c, one))));
      return add_up(multiply_up(c, r2), multiply_up(sinh_m, multiply_up(radius, add_up(one, r2))));
    });
    return;
  }
  const ball size = abs(x);  // cosh is even, and increasing on [0, inf)
  at_ends(result, end_points(size, p), p, mpfr_cosh, true);
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
  at_ends(result, end_points(x, p), p, mpfr_acosh, true);
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
  const end_points e(x, p);
  if (mpfr_cmp_si(e.lower(), -1) <= 0 || mpfr_cmp_si(e.upper(), 1) >= 0) {
    return ball_access::set_undefined(result, p);
  }
  at_ends(result, e, p, mpfr_atanh, true);
}

ball hypot(const ball& x, const ball& y) {
  const precision p = std::max(x.precision(), y.precision());
  if (x.is_undefined() || y.is_undefined()) return ball::undefined(p);
  const ball ax = abs(x);
  const ball ay = abs(y);
  const end_points ex(ax, p);
  const end_points ey(ay, p);
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
      const magnitude size =
          add_up(magnitude::abs_up(value.get()),
                 ternary == 0 ? magnitude{} : detail::rounding_error(value.get()));
      const magnitude error = multiply_up(size, divide_up(kq, subtract_down(one, kq)));
      ball_access::first(r) = std::move(value);
      ball_access::finish(r, ternary, error);
      return r;
    }
  }
  // An even power is a power of |x|; x^n is then monotone on each side of 0, decreasing for n < 0.
  const ball base = n % 2 == 0 ? abs(x) : x;
  const end_points e(base, p);
  mpfr_cell lower(p);
  mpfr_cell upper(p);
  mpfr_pow_si(lower.get(), n > 0 ? e.lower() : e.upper(), n, MPFR_RNDD);
  mpfr_pow_si(upper.get(), n > 0 ? e.upper() : e.lower(), n, MPFR_RNDU);
  ball_access::set_ends(r, lower, upper);
  return r;
}

void agm(ball& result, const ball& x, const ball& y) {
  const precision p = std::max(x.precision(), y.precision());
  const sign sx = sign_of(x);
  const sign sy = sign_of(y);
  if (x.is_undefined() || y.is_undefined() || sx == sign::negative || sy == sign::negative) {
    return ball_access::set_undefined(result, p);
  }
  if (ball_access::is_midpoint_radius(x) && ball_access::is_midpoint_radius(y)) {
    // The mean M is increasing in both arguments and homogeneous: for x = mx (1 + s),
    // y = my (1 + t) with |s|, |t| <= q, (1 - q) M(mx, my) <= M(x, y) <= (1 + q) M(mx, my).
    // A zero argument is exact here, and so is the mean 0.
    const auto relative = [](const ball& z, sign s) {
      return s == sign::zero
                 ? magnitude{}
                 : divide_up(ball_access::radius(z), magnitude::abs_down(ball_access::first(z)));
    };
    const magnitude q = max(relative(x, sx), relative(y, sy));
    mpfr_cell value(p);
    const int ternary =
        mpfr_agm(value.get(), ball_access::first(x), ball_access::first(y), MPFR_RNDN);
    magnitude error;
    if (!q.is_zero()) {
      error = multiply_up(q, true_value_up(value.get()));
    }
    ball_access::first(result) = std::move(value);
    return ball_access::finish(result, ternary, error);
  }
  const end_points ex(x, p);
  const end_points ey(y, p);
  mpfr_cell lower(p);
  mpfr_cell upper(p);
  mpfr_agm(lower.get(), ex.lower(), ey.lower(), MPFR_RNDD);  // a NaN where an end is negative
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
