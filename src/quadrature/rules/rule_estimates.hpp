#pragma once

#include <algorithm>
#include <cmath>

namespace polhode::detail {

/// About how many nodes Gauss and Legendre's rule needs for an error of 2^log2_goal of the mean of
/// an F that is at most 2^log2_supremum in the ellipse with parameter rho: gauss_legendre_error
/// solved for n. To search with.
[[nodiscard]] inline double estimated_gauss_nodes(double rho, double log2_supremum,
                                                  double log2_goal) {
  const double excess = log2_supremum + 2.1 - std::log2(1 - 1 / (rho * rho)) - log2_goal;
  return std::max(1.0, std::ceil(excess / (2 * std::log2(rho))));
}

}  // namespace polhode::detail
