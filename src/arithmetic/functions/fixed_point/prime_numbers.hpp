#pragma once

// The logarithms of the first primes and the arguments of Gaussian primes, to any number of limbs.

#include <cstddef>
#include <memory>

#include "arithmetic/functions/fixed_point/fraction.hpp"
#include "arithmetic/functions/fixed_point/prime_formulas.hpp"

namespace polhode::detail::fixed_point {

/// Thirteen positive numbers, each cut off behind its last limb, and so too small by less than a
/// unit.
class prime_numbers {
 public:
  prime_numbers(long w, std::unique_ptr<limb[]> values) : w_(w), values_(std::move(values)) {}

  [[nodiscard]] long limbs_of_fraction() const { return w_; }
  /// Number j with w limbs behind the point, at most as many as there are, and one before it.
  [[nodiscard]] const limb* number(std::size_t j, long w) const {
    return values_.get() + (static_cast<long>(j) + 1) * (w_ + 1) - (w + 1);
  }

 private:
  long w_;
  std::unique_ptr<limb[]> values_;
};

/// log p_j for the first primes, with w limbs or more. They are kept; any thread may ask.
[[nodiscard]] std::shared_ptr<const prime_numbers> logarithms_of_primes(long w);

/// 2 arg(pi_j) modulo 2 pi for the Gaussian primes pi_j, the same way.
[[nodiscard]] std::shared_ptr<const prime_numbers> angles_of_primes(long w);

}  // namespace polhode::detail::fixed_point
