#pragma once

// c0 and epsilon0 decrease as a increases, b being fixed: the paper's lemmas 4 and 5.
//
// The integrand h = (1 - b X)/sqrt((a + b X)(c + b X)), X = cos^2 psi, is positive and decreases
// strictly in a, and in c. c0: F(c,0) = 2 integral of h over (0, pi/2) is 2 pi at c = c0(a). For a'
// > a it is below 2 pi at c0(a), which is in (0, a'); it decreases in c without bound at 0, so its
// root c0(a') exists and is below c0(a). (J decreases in a too: J < 2 for a gives it for a'.)
// epsilon0: F(0,u) = 2 integral of h over (0, psi), u = cos^2 psi, at c = 0, is 2 pi at u = sin^2
// epsilon0(a). For a' > a it is below 2 pi there, and decreases in u: epsilon0(a') < epsilon0(a).

#include <vector>

#include "polhode/rigid_body/body.hpp"
#include "proofs/exact_polynomial.hpp"

namespace polhode::proofs {

/// The body with a doubled.
[[nodiscard]] body with_double_a(const body& rigid);

}  // namespace polhode::proofs
