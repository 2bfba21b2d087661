#include "arithmetic/functions/elementary/carrying.hpp"

#include <cmath>
#include <cstdint>

#include "polhode/arithmetic/elementary.hpp"

namespace polhode::detail::elementary {

void at_ends(ball& result, const end_points& x, precision p, mpfr_function f, bool increasing) {
  mpfr_cell lower(p);
  mpfr_cell upper(p);
  f(lower.get(), increasing ? x.lower() : x.upper(), MPFR_RNDD);
  f(upper.get(), increasing ? x.upper() : x.lower(), MPFR_RNDU);
  ball_access::set_ends(result, lower, upper);
}

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

// In hardware doubles where y has p >= 53 bits. Let t <= |y| have y's first 53 bits, e <= 2^-52
// bound the error of y, and u = 2^-53. Then |v| >= t - e, so that 1 - v^2 <= 1 - t^2 + 2 e; the
// hardware's square and difference are each wrong by at most u, so that 1 - v^2 <= s + 2^-50 where
// s is what it computes. Adding 2^-49 to s <= 1 loses at most 2^-52 by rounding, and the square
// root at most 2^-53 of itself, fewer than 2^8 units of 2^-60. Below 2^-16 that would be coarse.
magnitude cofunction_up(mpfr_srcptr y) {
  const precision p = mpfr_get_prec(y);
  if (p >= 53 && mpfr_regular_p(y) != 0 && mpfr_get_exp(y) <= 0 && mpfr_get_exp(y) > -64) {
    const auto* significand = static_cast<const mp_limb_t*>(mpfr_custom_get_significand(y));
    const mp_limb_t top = significand[(p - 1) / GMP_NUMB_BITS];
    const auto t = std::ldexp(static_cast<double>(std::uint64_t{top} >> 11),
                              static_cast<int>(mpfr_get_exp(y)) - 53);
    const double square = 1 - t * t;
    if (square > 0x1p-16) {
      const double size = std::sqrt(square + 0x1p-49);
      return magnitude::from_bits_up(static_cast<std::uint64_t>(size * 0x1p60) + 256, -60);
    }
  }
  return sqrt_up(multiply_up(one_minus_abs_up(y), add_up(one, min(magnitude::abs_up(y), one))));
}

magnitude times_ratio_up(const magnitude& x, unsigned numerator, unsigned denominator) {
  return divide_up(multiply_up(magnitude::from_integer_up(numerator), x),
                   magnitude::from_integer_down(denominator));
}

}  // namespace polhode::detail::elementary
