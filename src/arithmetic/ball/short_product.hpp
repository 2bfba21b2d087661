#pragma once

// The product of numbers of two limbs. mpfr_mul spends most of its time finding out what is to be
// done, and has no way of its own for 128 bits, which is the most usual precision of two limbs.

#include <cstdint>

#include <mpfr.h>

namespace polhode::detail {

__extension__ using uint128 = unsigned __int128;
static_assert(GMP_NUMB_BITS == 64, "polhode: limbs of 64 bits are assumed");

inline const mp_limb_t* limbs_of(mpfr_srcptr x) {
  return static_cast<const mp_limb_t*>(mpfr_custom_get_significand(x));
}

/// A regular number of two limbs.
inline bool has_two_limbs(mpfr_srcptr x) {
  const mpfr_prec_t p = mpfr_get_prec(x);
  return p > 64 && p <= 128 && mpfr_regular_p(x) != 0;
}

inline uint128 significand_of(mpfr_srcptr x) {
  return (uint128{limbs_of(x)[1]} << 64) | limbs_of(x)[0];
}

/// high * 2^128 + low.
struct long_product {
  uint128 high;
  uint128 low;
};

inline long_product full_product(uint128 x, uint128 y) {
  const auto x1 = static_cast<std::uint64_t>(x >> 64);
  const auto x0 = static_cast<std::uint64_t>(x);
  const auto y1 = static_cast<std::uint64_t>(y >> 64);
  const auto y0 = static_cast<std::uint64_t>(y);
  const uint128 low = uint128{x0} * y0;
  const uint128 cross = uint128{x0} * y1;
  const uint128 other = uint128{x1} * y0;
  // Below 3 * 2^64.
  const uint128 middle =
      (low >> 64) + static_cast<std::uint64_t>(cross) + static_cast<std::uint64_t>(other);
  return {uint128{x1} * y1 + (cross >> 64) + (other >> 64) + (middle >> 64),
          (middle << 64) | static_cast<std::uint64_t>(low)};
}

/// r = x y for numbers with two limbs, r having as many, rounded to nearest and ties to even: bit
/// for bit what mpfr_mul computes. Returns 0 where that is exact and 1 where it is not, without the
/// sign of mpfr_mul's answer.
inline int multiply_two_limbs(mpfr_ptr r, mpfr_srcptr x, mpfr_srcptr y) {
  long_product product = full_product(significand_of(x), significand_of(y));
  mpfr_exp_t exponent = mpfr_get_exp(x) + mpfr_get_exp(y);
  // Two significands in [2^127, 2^128) have a product in [2^254, 2^256).
  if ((product.high >> 127) == 0) {
    product = {(product.high << 1) | (product.low >> 127), product.low << 1};
    --exponent;
  }
  const mpfr_prec_t p = mpfr_get_prec(r);
  const uint128 unit = uint128{1} << (128 - p);
  const uint128 cut = product.high & (unit - 1);  // and product.low behind it
  constexpr uint128 top_bit = uint128{1} << 127;
  const bool odd = (product.high & unit) != 0;
  const bool up = p == 128 ? product.low > top_bit - odd
                           : cut > (unit >> 1) - ((product.low != 0 || odd) ? 1 : 0);
  uint128 rounded = product.high - cut;
  if (up) {
    rounded += unit;
    if (rounded == 0) {  // a carry out of the top
      rounded = top_bit;
      ++exponent;
    }
  }
  // Near the ends of the range of exponents, which the caller may have narrowed, MPFR decides.
  if (exponent <= mpfr_get_emin() || exponent >= mpfr_get_emax()) {
    return mpfr_mul(r, x, y, MPFR_RNDN);
  }
  auto* significand = static_cast<mp_limb_t*>(mpfr_custom_get_significand(r));
  const int kind = (mpfr_sgn(x) < 0) == (mpfr_sgn(y) < 0) ? MPFR_REGULAR_KIND : -MPFR_REGULAR_KIND;
  mpfr_custom_init_set(r, kind, exponent, p, significand);
  significand[1] = static_cast<mp_limb_t>(rounded >> 64);
  significand[0] = static_cast<mp_limb_t>(rounded);
  return (cut | product.low) != 0 ? 1 : 0;
}

/// mpfr_mul in round-to-nearest, but for the sign of the answer.
inline int multiply_to_nearest(mpfr_ptr r, mpfr_srcptr x, mpfr_srcptr y) {
  const mpfr_prec_t p = mpfr_get_prec(r);
  if (p > 64 && p <= 128 && has_two_limbs(x) && has_two_limbs(y)) {
    return multiply_two_limbs(r, x, y);
  }
  return mpfr_mul(r, x, y, MPFR_RNDN);
}

}  // namespace polhode::detail
