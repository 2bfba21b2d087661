#pragma once

// Numbers with a sign, a limb before the point and some behind it, in arrays of a fixed size: with
// few limbs, fetching memory would take longer than the arithmetic.

#include <cmath>

#include <gmp.h>

#include "quadrature/rules/gauss_legendre/few_limbs/few_limbed_zeros.hpp"

namespace polhode::detail::legendre {

static_assert(GMP_NUMB_BITS == 64, "limbs of 64 bits without nails");

using limb = mp_limb_t;
__extension__ using uint128 = unsigned __int128;

constexpr long most_limbs = few_limbed_zeros::most_bits / 64;
constexpr long greatest_order = few_limbed_zeros::greatest_order;
// |g| < 2^-least_gap, |e_k| < 2^6: what the counts of errors below rest on.
constexpr long least_gap = 32;
constexpr limb least_too_large = 64;

/// A number with w limbs behind the point and one before it, the least significant first.
struct number {
  limb limbs[most_limbs + 1];
  bool is_negative = false;
};

/// Limbs of {x, n} without zeros at the top.
[[nodiscard]] inline long used(const limb* x, long n) {
  while (n > 0 && x[n - 1] == 0) --n;
  return n;
}

/// From the two highest limbs that are not 0.
[[nodiscard]] inline double to_double(const number& x, long w) {
  const long n = used(x.limbs, w + 1);
  if (n == 0) return 0;
  const auto high = static_cast<double>(x.limbs[n - 1]);
  const double low = n > 1 ? static_cast<double>(x.limbs[n - 2]) : 0;
  const double size = std::ldexp(high + low * 0x1p-64, static_cast<int>(64 * (n - 1 - w)));
  return x.is_negative ? -size : size;
}

/// {x, n} += or -= {y, n} as their signs are; sums have room.
inline void add_to(limb* x, bool& x_is_negative, const limb* y, bool y_is_negative, long n) {
  if (x_is_negative == y_is_negative) {
    mpn_add_n(x, x, y, n);
  } else if (mpn_cmp(x, y, n) >= 0) {
    mpn_sub_n(x, x, y, n);
  } else {
    mpn_sub_n(x, y, x, n);
    x_is_negative = y_is_negative;
  }
}

}  // namespace polhode::detail::legendre
