// Logarithms, by log(m+h) - log m = log(1 + h/m).

#include "arithmetic/functions/elementary/carrying.hpp"
#include "polhode/arithmetic/elementary.hpp"

namespace polhode {

using namespace detail::elementary;
using detail::end_points;
using detail::mpfr_cell;
using detail::near_function;

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
  if (sign_of(x) != certain_sign::positive)
    return ball_access::set_undefined(result, x.precision());
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

}  // namespace polhode
