// Squares and square roots of balls.

#include <cstdint>
#include <utility>

#include "arithmetic/ball/ball_access.hpp"
#include "arithmetic/ball/raw_error.hpp"
#include "arithmetic/ball/short_product.hpp"
#include "polhode/arithmetic/ball.hpp"

namespace polhode {

using detail::finish_regular;
using detail::leading_bits;
using detail::mpfr_cell;
using detail::multiply_to_nearest;
using detail::raw;
using detail::raw_error;
using detail::raw_product;
using detail::set_regular;

void square(ball& result, const ball& x) {
  const precision p = x.precision();
  if (ball_access::is_midpoint_radius(x)) {
    // |x^2 - m^2| <= (2|m| + r) r, and r is below 64 units of m's 30 leading bits.
    raw_error error;
    if (!x.radius_.is_zero()) {
      const leading_bits m(x.first_.get());
      error = raw_product(m.bits + 33, m.exponent + 1, x.radius_);
    }
    set_regular(result, p, error, [&](mpfr_ptr r) {
      // At two limbs, where mpfr_sqr has no short way of its own.
      return p > 64 && p <= 128 ? multiply_to_nearest(r, x.first_.get(), x.first_.get())
                                : mpfr_sqr(r, x.first_.get(), MPFR_RNDN);
    });
    return;
  }
  if (x.is_undefined()) return ball_access::set_undefined(result, p);
  mpfr_cell lower(p);
  mpfr_cell upper(p);
  const mpfr_srcptr a = x.first_.get();
  const mpfr_srcptr b = x.second_.get();
  if (mpfr_cmpabs(a, b) <= 0) {
    mpfr_sqr(upper.get(), b, MPFR_RNDU);
  } else {
    mpfr_sqr(upper.get(), a, MPFR_RNDU);
  }
  if (mpfr_sgn(a) > 0) {
    mpfr_sqr(lower.get(), a, MPFR_RNDD);
  } else if (mpfr_sgn(b) < 0) {
    mpfr_sqr(lower.get(), b, MPFR_RNDD);
  }
  ball_access::set_ends(result, lower, upper);
}

void sqrt(ball& result, const ball& x) {
  const precision p = x.precision();
  if (x.is_undefined() || sign_of(x) == certain_sign::negative) {
    return ball_access::set_undefined(result, p);
  }
  if (ball_access::is_midpoint_radius(x)) {  // m > r, or exactly 0
    const magnitude radius = x.radius_;
    mpfr_cell fresh;
    mpfr_cell& own = result.first_;
    const bool in_place = mpfr_get_prec(own.get()) == p && &result != &x;
    if (!in_place) fresh.reset(p);
    mpfr_cell& target = in_place ? own : fresh;
    const int ternary = mpfr_sqrt(target.get(), x.first_.get(), MPFR_RNDN);
    // |sqrt(m + d) - sqrt(m)| = |d| / (sqrt(m + d) + sqrt(m)) <= r / (2 sqrt(m - r)), and for p >=
    // 32 sqrt(m - r) > s - 129 units of the 30 leading bits of s = sqrt(m) rounded: half a unit of
    // the last place is less than one of these, and sqrt(m) - sqrt(m - r) < 2^-23 sqrt(m).
    raw_error error;
    if (!radius.is_zero()) {
      const leading_bits s(target.get());
      if (p >= 32) {
        error = {(raw(radius).bits / (s.bits - 129) + 1) << 24,
                 radius.exponent() - s.exponent - 55};
      } else {
        const magnitude m = magnitude::abs_down(x.first_.get());
        error = raw(divide_up(scale(radius, -1), sqrt_down(subtract_down(m, radius))));
      }
    }
    if (!in_place) own = std::move(fresh);
    finish_regular(result, own.get(), ternary, error);
    return;
  }
  mpfr_cell lower(p);
  mpfr_cell upper(p);
  mpfr_sqrt(lower.get(), x.first_.get(), MPFR_RNDD);  // a NaN where the lower end is negative
  mpfr_sqrt(upper.get(), x.second_.get(), MPFR_RNDU);
  ball_access::set_ends(result, lower, upper);
}

}  // namespace polhode
