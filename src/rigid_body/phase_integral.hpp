#pragma once

// The integral of the Montgomery phase, for bodies with equal moments, too.

#include "polhode/arithmetic/exact.hpp"

namespace polhode::detail {

/// F(c,u) by the formula of montgomery_phase.hpp, which holds for a >= 0, 0 <= b < 1 with a + b > 0 and -b < c. Hypothesis: these,
/// 0 <= u < 1, b u + c >= 0, and a + b u > 0, c + b u > 0 but for one of X, Y, Z.
[[nodiscard]] ball phase_integral_of(const rational& a, const rational& b, const rational& c,
                                     const rational& u, precision p);

}  // namespace polhode::detail
