// The arithmetic-geometric mean of two positive numbers.

#include <algorithm>
#include <cstdint>
#include <utility>

#include "arithmetic/functions/elementary/carrying.hpp"
#include "polhode/arithmetic/elementary.hpp"

namespace polhode {

using namespace detail::elementary;
using detail::end_points;
using detail::mpfr_cell;

namespace {

// mpfr_agm goes to the heap at every precision.
constexpr precision most_bits_of_near_agm = 256;
constexpr precision agm_guard_bits = 24;

/// As a near_function, for two positive numbers of up to r's precision.
///
/// The mean M is increasing in both arguments, homogeneous, and the same for (a + b) / 2 and sqrt(a
/// b). Let u = 2^-wp. A step rounds the first with a relative error of u at most, and the second
/// with u/2 from the product and u, so that it changes M by a factor within 1 +- 2 u (1 + u). Where
/// |a - b| <= a u^(1/2) the rest is below (a + b) / 2 - sqrt(a b) <= (a - b)^2 / (8 min(a, b)) <= u
/// a / 2, and the sum is rounded once more.
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
  const certain_sign sx = sign_of(x);
  const certain_sign sy = sign_of(y);
  // In either form a set has a negative member where its first number is negative.
  if (x.is_undefined() || y.is_undefined() || mpfr_sgn(ball_access::first(x)) < 0 ||
      mpfr_sgn(ball_access::first(y)) < 0) {
    return ball_access::set_undefined(result, p);
  }
  if (sx == certain_sign::zero ||
      sy == certain_sign::zero) {  // the mean with 0 is 0, however great the other is
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

}  // namespace polhode
