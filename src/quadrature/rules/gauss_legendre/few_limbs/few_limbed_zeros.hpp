#pragma once

// The zeros of a Legendre polynomial of which a start of 64 bits is known, in fixed point with few
// limbs: what most integrals take their Gauss and Legendre rules from. With many limbs, or from bad
// starts, ../proved_zero.cpp does without.

#include <cstdint>
#include <optional>
#include <vector>

#include "polhode/arithmetic/ball.hpp"
#include "quadrature/rules/gauss_legendre/polynomial.hpp"
#include "quadrature/rules/gauss_legendre/zero.hpp"

namespace polhode::detail {

/// Proves zeros of q near given numbers, with few limbs.
class few_limbed_zeros {
 public:
  /// Of greater degree n, or with more bits, there is none.
  static constexpr long greatest_n = 1024;
  static constexpr precision most_bits = 1024;
  /// The greatest order of a Taylor polynomial.
  static constexpr long greatest_order = 40;

  /// q with at least so many bits behind the point, 2 <= n <= greatest_n, 1 <= bits <= most_bits.
  /// Taylor polynomials have at most the order `most`, 1 <= most <= greatest_order: with a smaller
  /// one only starts that are very near find their zeros.
  few_limbed_zeros(const legendre_shape& s, precision bits, long most = greatest_order);

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
