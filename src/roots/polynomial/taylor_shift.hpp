#pragma once

#include <vector>

#include "polhode/arithmetic/exact.hpp"

namespace polhode::detail {

/// The coefficients of p(x + 1), for those of p(x), in the order 1, x, x^2, ...
[[nodiscard]] std::vector<integer> shifted_by_one(const std::vector<integer>& p);

/// The number of sign changes in the coefficients, those that are 0 left out. By Descartes' rule it
/// is the number of positive roots, counted with multiplicities, or greater by an even number.
[[nodiscard]] long sign_changes(const std::vector<integer>& p);

}  // namespace polhode::detail
