#include "polhode/arithmetic/special_functions.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "arithmetic/ball/ball_access.hpp"
#include "erf_series.hpp"
#include "gamma_series.hpp"

namespace polhode {

using detail::end_points;
using detail::mpfr_cell;

namespace {

// The ends of a thin ball, computed, must not add to its width.
constexpr precision special_guard_bits = 64;

/// The range of a function that is monotone between these ends.
ball monotone_between(const end_points& e, precision p, int (*f)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t),
                      bool increasing) {
  mpfr_cell lower(p);
  mpfr_cell upper(p);
  f(lower.get(), increasing ? e.lower() : e.upper(), MPFR_RNDD);
  f(upper.get(), increasing ? e.upper() : e.lower(), MPFR_RNDU);
  ball r;
  ball_access::set_ends(r, lower, upper);
  return r;
}

/// A monotone function on R: thin balls by the values at their ends too, for these functions'
/// slopes would cost as much as a second value.
ball monotone_at_ends(const ball& x, int (*f)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t), bool increasing) {
  const precision p = x.precision();
  if (x.is_undefined()) return x;
  if (x.is_exact()) {
    ball r;
    detail::set_midpoint(
        r, p, {}, [&](mpfr_ptr value) { return f(value, ball_access::first(x), MPFR_RNDN); });
    return r;
  }
  return monotone_between(end_points(x, p + special_guard_bits), p, f, increasing);
}

/// The precision in which a ball's ends hardly move outward. Beside a pole Gamma magnifies what its
/// argument loses by up to 2^(2p), and log Gamma does so relatively beside its zeros: so a radius
/// far below the midpoint's last place is kept, up to where it is below notice, but for sets about
/// a zero of log Gamma that are narrower still.
precision precision_of_ends(const ball& x) {
  const precision p = x.precision();
  if (!ball_access::is_midpoint_radius(x) || ball_access::radius(x).is_zero())
    return p + special_guard_bits;
  const mpfr_srcptr m = ball_access::first(x);
  const std::int64_t exactly = mpfr_get_exp(m) - ball_access::radius(x).exponent() + 2;
  return std::clamp<std::int64_t>(exactly, p + special_guard_bits, 3 * p + 1024);
}

/// |Gamma| or log|Gamma|, which is convex between poles.
using convex_function = void (*)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);

void abs_gamma(mpfr_ptr r, mpfr_srcptr x, mpfr_rnd_t rounding) {
  // Away from the sign first: |.| of a number rounded towards or away from 0.
  mpfr_gamma(r, x, rounding == MPFR_RNDD ? MPFR_RNDZ : MPFR_RNDA);
  mpfr_abs(r, r, MPFR_RNDN);
}
void log_abs_gamma(mpfr_ptr r, mpfr_srcptr x, mpfr_rnd_t rounding) {
  int sign = 0;
  mpfr_lgamma(r, &sign, x, rounding);
}

bool has_pole(const end_points& x) {
  // A pole is an integer <= 0 in [lower, upper]: the ceiling of the lower end is the first integer.
  if (mpfr_sgn(x.lower()) > 0) return false;
  mpfr_cell first(mpfr_get_prec(x.lower()));
  mpfr_rint_ceil(first.get(), x.lower(), MPFR_RNDU);
  return mpfr_lessequal_p(first.get(), x.upper()) != 0 && mpfr_sgn(first.get()) <= 0;
}

/// The sign of the digamma function at a point that is no pole; correctly rounded, so the sign is
/// right.
int digamma_sign(mpfr_srcptr x) {
  mpfr_cell value(32);
  mpfr_digamma(value.get(), x, MPFR_RNDN);
  return mpfr_sgn(value.get());
}

/// A lower bound of the convex f over [l, u], in which f' changes sign: f(x) >= f(m) + s (x - m)
/// for the slope s of f at any point m. m is found by bisection on the digamma function (a search:
/// any m is sound).
void convex_minimum(mpfr_ptr r, const end_points& x, precision p, convex_function f,
                    bool logarithm) {
  mpfr_cell low(p);
  mpfr_cell high(p);
  mpfr_cell middle(p);
  mpfr_set(low.get(), x.lower(), MPFR_RNDN);
  mpfr_set(high.get(), x.upper(), MPFR_RNDN);
  mpfr_set(middle.get(), low.get(), MPFR_RNDN);
  // Half the bits suffice: the slope at m is multiplied by the distance to m, of the same order.
  for (precision i = 0; i < p / 2 + 8; ++i) {
    mpfr_add(middle.get(), low.get(), high.get(), MPFR_RNDN);
    mpfr_div_2ui(middle.get(), middle.get(), 1, MPFR_RNDN);
    (digamma_sign(middle.get()) < 0 ? low : high) = middle;
  }
  // |slope|: |digamma|, times |Gamma| for Gamma itself.
  mpfr_cell slope(64);
  mpfr_digamma(slope.get(), middle.get(), MPFR_RNDA);
  mpfr_abs(slope.get(), slope.get(), MPFR_RNDN);
  mpfr_cell value(64);
  if (!logarithm) {
    abs_gamma(value.get(), middle.get(), MPFR_RNDU);
    mpfr_mul(slope.get(), slope.get(), value.get(), MPFR_RNDU);
  }
  mpfr_cell distance(64);
  mpfr_sub(distance.get(), x.upper(), middle.get(), MPFR_RNDU);
  mpfr_sub(value.get(), middle.get(), x.lower(), MPFR_RNDU);
  mpfr_max(distance.get(), distance.get(), value.get(), MPFR_RNDU);
  mpfr_mul(distance.get(), distance.get(), slope.get(), MPFR_RNDU);
  f(r, middle.get(), MPFR_RNDD);
  mpfr_sub(r, r, distance.get(), MPFR_RNDD);
}

/// The range of the convex f over a bounded set without a pole.
ball convex_range(const end_points& x, precision p, convex_function f, bool logarithm) {
  mpfr_cell lower(p);
  mpfr_cell upper(p);
  const int left = digamma_sign(x.lower());
  const int right = digamma_sign(x.upper());
  if (right <= 0) {
    f(lower.get(), x.upper(), MPFR_RNDD);
    f(upper.get(), x.lower(), MPFR_RNDU);
  } else if (left >= 0) {
    f(lower.get(), x.lower(), MPFR_RNDD);
    f(upper.get(), x.upper(), MPFR_RNDU);
  } else {
    convex_minimum(lower.get(), x, p, f, logarithm);
    mpfr_cell other(p);
    f(upper.get(), x.lower(), MPFR_RNDU);
    f(other.get(), x.upper(), MPFR_RNDU);
    mpfr_max(upper.get(), upper.get(), other.get(), MPFR_RNDU);
  }
  ball r;
  ball_access::set_ends(r, lower, upper);
  return r;
}

/// Of a set that may be unbounded: above 2 Gamma, log Gamma and the digamma function increase to
/// infinity, as the digamma function is positive at 2.
bool increases_on(const ball& x) { return certainly_greater(x, 2); }

ball convex_over(const ball& x, convex_function f, bool logarithm) {
  const precision p = x.precision();
  if (!x.is_bounded() && !increases_on(x)) return ball::undefined(p);
  const end_points e(x, precision_of_ends(x));
  if (has_pole(e)) return ball::undefined(p);
  return convex_range(e, p, f, logarithm);
}

}  // namespace

ball erf(const ball& x) {
  if (const auto value = detail::erf_by_series(x)) return *value;
  return monotone_at_ends(x, mpfr_erf, true);
}
ball erfc(const ball& x) { return monotone_at_ends(x, mpfr_erfc, false); }

ball gamma(const ball& x) {
  if (const auto value = detail::gamma_by_series(x)) return *value;
  ball size = convex_over(x, abs_gamma, false);
  if (size.is_undefined() || certainly_positive(x)) return size;
  // Gamma is negative between -1 and 0, -3 and -2, ...: where the floor of x is odd.
  const end_points e(x, precision_of_ends(x));
  mpz_t floor;
  mpz_init(floor);
  mpfr_get_z(floor, e.lower(), MPFR_RNDD);
  const bool negative = mpz_sgn(floor) < 0 && mpz_odd_p(floor) != 0;
  mpz_clear(floor);
  return negative ? -size : size;
}

ball log_gamma(const ball& x) {
  if (const auto value = detail::log_gamma_by_series(x)) return *value;
  return convex_over(x, log_abs_gamma, true);
}

ball digamma(const ball& x) {
  const precision p = x.precision();
  if (!x.is_bounded() && !increases_on(x)) return ball::undefined(p);
  const end_points e(x, precision_of_ends(x));
  if (has_pole(e)) return ball::undefined(p);
  return monotone_between(e, p, mpfr_digamma, true);
}

ball zeta(unsigned long n, precision p) {
  if (n < 2) return ball::undefined(checked_precision(p));
  ball r;
  detail::set_midpoint(r, checked_precision(p), {},
                       [&](mpfr_ptr value) { return mpfr_zeta_ui(value, n, MPFR_RNDN); });
  return r;
}

}  // namespace polhode
