#pragma once

// A real number as a formula in exact numbers, for a room above that can decide more of it than
// enclosures do: log(2), 1/2 - 1/exp(log(2)).

#include <memory>
#include <string_view>
#include <vector>

#include "polhode/arithmetic/pi_combination.hpp"

namespace polhode {

/// A function of exact numbers, or the number q + r pi.
struct exact_formula {
  using pointer = std::shared_ptr<const exact_formula>;
  /// Longer formulas are not made: what a series does to its coefficients would double them at each
  /// step.
  static constexpr std::size_t longest = 64;  // nodes of the tree

  [[nodiscard]] static pointer of(const pi_combination& x);
  /// By the name that formulas have for the function ("+", "-", "*", "/", "pow", "exp", ...), or
  /// for a constant. Null where an operand is null, and where the formula would be too long.
  [[nodiscard]] static pointer of(std::string_view function, std::vector<pointer> operands = {});

  std::string_view function;  // empty for a number
  std::vector<pointer> operands;
  pi_combination number;
  std::size_t size = 1;
};

}  // namespace polhode
