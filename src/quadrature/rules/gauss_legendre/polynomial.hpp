#pragma once

// The polynomial q whose zeros are the squares of the positive nodes: P_n(x) = x^e q(x^2), e = 0
// for even n and 1 for odd n. Its coefficients are integers over a power of two; Horner's scheme
// reads them in fixed point.

#include <vector>

#include <gmp.h>

#include "polhode/arithmetic/ball.hpp"

namespace polhode::detail {

/// P_n(x) = x^odd q(x^2), q of degree `degree`.
struct legendre_shape {
  explicit legendre_shape(long of_n) : n(of_n), degree(of_n / 2), odd(of_n % 2) {}
  long n;
  long degree;
  long odd;
};

/// The coefficients of q, the highest first, in units of 2^-fraction_bits, rounded downward, in
/// two's complement with `size` limbs each.
///
/// Room: 2^(64 size - 3) is at least the sum of i |c_i|, and of |c_i|, in units, c_i being the
/// coefficient of y^i; and that sum is at least 2^(fraction_bits - 1).
struct legendre_coefficients {
  legendre_coefficients(const legendre_shape& s, precision bits);
  precision fraction_bits;
  mp_size_t size = 0;
  std::vector<mp_limb_t> limbs;
};

}  // namespace polhode::detail
