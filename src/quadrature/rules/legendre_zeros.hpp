#pragma once

// The zeros of a Legendre polynomial of which a start of 64 bits is known, in fixed point with few limbs: what most
// integrals take their Gauss and Legendre rules from. With many limbs, or from bad starts, gauss_legendre.cpp does without.

#include <cstdint>
#include <optional>
#include <vector>

#include <gmp.h>

#include "polhode/arithmetic/ball.hpp"
#include "polhode/arithmetic/exact.hpp"

namespace polhode::detail {

/// P_n(x) = x^odd q(x^2), q of degree `degree`.
struct legendre_shape {
  explicit legendre_shape(long of_n) : n(of_n), degree(of_n / 2), odd(of_n % 2) {}
  long n;
  long degree;
  long odd;
};

/// The coefficients of q, the highest first, in units of 2^-fraction_bits, rounded downward, in two's complement with
/// `size` limbs each.
///
/// Room: 2^(64 size - 3) is at least the sum of i |c_i|, and of |c_i|, in units, c_i being the coefficient of y^i; and
/// that sum is at least 2^(fraction_bits - 1).
struct legendre_coefficients {
  legendre_coefficients(const legendre_shape& s, precision bits);
  precision fraction_bits;
  mp_size_t size = 0;
  std::vector<mp_limb_t> limbs;
};

/// A zero y of q in `square`, and q'(y) in slope / scale.
struct legendre_zero {
  ball square;
  ball slope;
  ball scale;
};

/// Proves zeros of q near given numbers.
class few_limbed_zeros {
 public:
  /// Of greater degree n, or with more bits, there is none.
  static constexpr long greatest_n = 1024;
  static constexpr precision most_bits = 1024;

  /// q with at least so many bits behind the point, 2 <= n <= greatest_n, 1 <= bits <= most_bits.
  few_limbed_zeros(const legendre_shape& s, precision bits);

  /// A zero near Y/2^64, Y > 0, enclosed; nothing where the start is too far from one.
  [[nodiscard]] std::optional<legendre_zero> near(std::uint64_t start) const;

 private:
  legendre_shape shape_;
  precision bits_;
  legendre_coefficients polynomial_;
  long limbs_;                      // behind the point
  std::vector<double> log2_terms_;  // of the bound of the k-th term but for the power of |y - y_0|
  std::vector<std::uint64_t> errors_;  // of e_k, in units
};

}  // namespace polhode::detail
