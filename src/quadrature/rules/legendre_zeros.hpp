#pragma once

// The zeros of a Legendre polynomial of which a start of 64 bits is known, in fixed point with few limbs: what most
// integrals take their Gauss and Legendre rules from (legendre_zeros.cpp). With many limbs, or from bad starts, balls are
// taken instead (gauss_legendre.cpp).

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

/// Proves zeros of q near given numbers, with few limbs.
class few_limbed_zeros {
 public:
  /// Of greater degree n, or with more bits, there is none.
  static constexpr long greatest_n = 1024;
  static constexpr precision most_bits = 1024;
  /// The greatest order of a Taylor polynomial.
  static constexpr long greatest_order = 40;

  /// q with at least so many bits behind the point, 2 <= n <= greatest_n, 1 <= bits <= most_bits. Taylor polynomials have at most
  /// the order `most`, 1 <= most <= greatest_order: with a smaller one only starts that are very near find their zeros.
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

/// q and q' at Y/2^64, in fixed point with any number of limbs: by Horner's scheme as in legendre_zeros.cpp, where its errors are
/// counted.
class legendre_values {
 public:
  legendre_values(const legendre_shape& s, precision fraction_bits)
      : degree_(s.degree), coefficients_(s, fraction_bits) {}

  struct pair {
    ball value;
    ball slope;
  };
  /// For each Y, an enclosure of q and q' with `fraction_bits` bits. The coefficients are read once for a
  /// few Y together.
  [[nodiscard]] std::vector<pair> at(const std::vector<std::uint64_t>& arguments) const;

 private:
  void evaluate(const std::uint64_t* arguments, std::size_t count,
                std::vector<pair>& results) const;

  long degree_;
  legendre_coefficients coefficients_;
};

/// A zero of q near y_0 = Y/2^64, Y = `start`, enclosed by a Taylor polynomial of balls with about so many bits; `at` are q and q' there.
/// Nothing where no zero is found. It should be within 2^log2_reach of y_0: that decides how many terms the polynomial has, not
/// what is true.
std::optional<legendre_zero> zero_by_taylor(const legendre_shape& s, std::uint64_t start,
                                            const legendre_values::pair& at, double log2_reach,
                                            precision bits);

/// x with `bits` bits and a radius of 2^-bits, or of 2^-bits times the power of two above x: nothing where that is
/// no enclosure. All that distinguishes the balls of a rule is then their midpoints.
std::optional<ball> with_radius(const ball& x, precision bits, bool relative);

}  // namespace polhode::detail
