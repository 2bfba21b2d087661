#pragma once

// A body by its inertia tensor: the principal moments are the roots of its characteristic
// polynomial.

#include <array>
#include <memory>
#include <optional>

#include "real.hpp"

namespace polhode::checker {

class tensor {
 public:
  /// By the entries xx, yy, zz, xy, xz, yz. Throws std::invalid_argument, which says why, unless
  /// the principal moments are positive and different.
  tensor(const std::array<rational, 6>& entries, budget& work);

  /// I_y/I_z - 1 and 1 - I_y/I_x.
  [[nodiscard]] real a() const;
  [[nodiscard]] real b() const;
  /// The sign of I_y + I_z - I_x.
  [[nodiscard]] int kind() const;
  /// I^2 = I_y I_z/((I_x - I_y)(I_x - I_z)) and (J+1)^2 = I_x I_y/((I_y - I_z)(I_x - I_z)), where
  /// they are rational.
  [[nodiscard]] std::optional<rational> squared_I() const;
  [[nodiscard]] std::optional<rational> squared_J_plus_1() const;

 private:
  struct roots;
  /// D/(r chi'(r)) for the i-th root r.
  [[nodiscard]] std::optional<rational> rational_quotient(std::size_t i) const;
  /// (r_i - r_j)/r_unit of the roots, where unit is i or j.
  [[nodiscard]] real difference(std::size_t i, std::size_t j, std::size_t unit) const;

  std::shared_ptr<roots> roots_;
};

}  // namespace polhode::checker
