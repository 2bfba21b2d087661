#pragma once

// The Bernoulli numbers of even index, exact, and the coefficients of Stirling's series.

#include <memory>
#include <vector>

#include "polhode/arithmetic/ball.hpp"
#include "polhode/arithmetic/exact.hpp"

namespace polhode::detail {

/// B_2k, k >= 1: 1/6, -1/30, 1/42, ...
[[nodiscard]] rational bernoulli_number(std::size_t k);

/// B_2k/(2k (2k - 1)) for k = 1, 2, ..., at least `count` of them, and log(2 pi)/2.
struct stirling_constants {
  std::vector<ball> coefficients;
  ball half_log_two_pi;
};
/// With p bits or somewhat more. Kept for later calls; any thread may ask.
[[nodiscard]] std::shared_ptr<const stirling_constants> stirling_constants_for(std::size_t count,
                                                                               precision p);

}  // namespace polhode::detail
