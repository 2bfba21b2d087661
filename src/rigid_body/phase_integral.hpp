#pragma once

// The integral of the Montgomery phase, for bodies with equal moments, too.

#include "polhode/arithmetic/exact_real.hpp"

namespace polhode::detail {

/// F(c,u) by the formula of montgomery_phase.hpp, which holds for a >= 0, 0 <= b < 1 with a + b > 0
/// and -b < c; `last` is c + b u. Hypothesis: these, 0 <= u < 1, last >= 0, and a + b u > 0, last >
/// 0 but for one of X, Y, Z.
[[nodiscard]] ball phase_integral_of(const exact_real& a, const exact_real& b, const exact_real& c,
                                     const exact_real& u, const exact_real& last, precision p);

}  // namespace polhode::detail
