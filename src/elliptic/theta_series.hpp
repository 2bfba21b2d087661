#pragma once

// The two series of the theta functions, apart: their terms are added until the next ones are below
// 2^-p of the sum, and what is left out is in the results.

#include "polhode/elliptic/theta.hpp"

namespace polhode::detail {

/// By the definition, for 0 < q <= 1/20.
[[nodiscard]] theta_values theta_by_definition(int j, const ball& z, const ball& q, precision p);

/// By Poisson's formula, for 1/25 < q < 1.
[[nodiscard]] theta_values theta_by_poisson(int j, const ball& z, const ball& q, precision p);

}  // namespace polhode::detail
