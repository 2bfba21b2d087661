#pragma once

#include <vector>

#include "polhode/arithmetic/polynomial.hpp"

namespace polhode::detail {

/// All rational roots, in ascending order, and the polynomial divided by their linear factors: it
/// has integer coefficients and no rational root. Hypothesis: it is not 0 and has no multiple
/// root.
struct rational_roots {
  std::vector<rational> roots;
  std::vector<integer> rest;
};
[[nodiscard]] rational_roots rational_roots_of(const rational_polynomial& given);

}  // namespace polhode::detail
