#pragma once

// All zeros of q from their starts: in few limbs where that is possible (few_limbs/), otherwise by
// Taylor polynomials in balls (proved_zero.hpp).

#include <cstdint>
#include <optional>
#include <vector>

#include "quadrature/rules/gauss_legendre/few_limbs/few_limbed_zeros.hpp"
#include "quadrature/rules/gauss_legendre/fixed_point_values.hpp"
#include "quadrature/rules/gauss_legendre/polynomial.hpp"
#include "quadrature/rules/gauss_legendre/zero.hpp"

namespace polhode::detail::legendre {

/// The zeros of q near the starts, or better ones.
class zero_finder {
 public:
  zero_finder(const legendre_shape& s, precision bits_at_work)
      : shape_(s), bits_at_work_(bits_at_work) {
    if (s.n >= 2 && s.n <= few_limbed_zeros::greatest_n &&
        bits_at_work <= few_limbed_zeros::most_bits) {
      few_limbed_.emplace(s, bits_at_work);
    }
  }
  /// For each start the zero, or nothing.
  [[nodiscard]] std::vector<std::optional<legendre_zero>> near(
      const std::vector<std::uint64_t>& starts);

 private:
  [[nodiscard]] std::optional<legendre_zero> found(std::uint64_t start,
                                                   fixed_point_polynomial::values at) const;

  legendre_shape shape_;
  precision bits_at_work_;
  std::optional<few_limbed_zeros> few_limbed_;
  std::optional<fixed_point_polynomial> polynomial_;
};

}  // namespace polhode::detail::legendre
