#pragma once

// q and q' at numbers of one limb, so that a step of Horner's scheme is one pass over the limbs.

#include <cstddef>
#include <cstdint>
#include <vector>

#include <gmp.h>

#include "polhode/arithmetic/ball.hpp"
#include "quadrature/rules/gauss_legendre/polynomial.hpp"

namespace polhode::detail::legendre {

/// q and q' at Y/2^64, in fixed point: with Horner's scheme as in few_limbs/few_limbed_zeros.cpp,
/// whose errors are counted there.
class fixed_point_polynomial {
 public:
  fixed_point_polynomial(const legendre_shape& s, precision fraction_bits)
      : degree_(s.degree), coefficients_(s, fraction_bits) {}

  struct values {
    ball value;
    ball slope;
  };
  /// For each Y, an enclosure of q and q' with `fraction_bits` bits. The coefficients are read once
  /// for a few Y together.
  [[nodiscard]] std::vector<values> at(const std::vector<std::uint64_t>& arguments) const;

 private:
  using limbs = std::vector<mp_limb_t>;

  void evaluate(const std::uint64_t* arguments, std::size_t count,
                std::vector<values>& results) const;

  long degree_;
  legendre_coefficients coefficients_;
};

}  // namespace polhode::detail::legendre
