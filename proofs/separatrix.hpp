#pragma once

#include "polhode/rigid_body/body.hpp"

namespace polhode::proofs {

/// epsilon0, the twist defect on the separatrix, to about p bits: F(0, sin^2 epsilon0) = 2 pi. The
/// proof is in proofs/arguments/separatrix_twist.md. Undefined where interval Newton did not
/// contract, or e^sqrt(ab) is beyond the range of exponents.
[[nodiscard]] ball separatrix_defect(const body& rigid, precision p);

}  // namespace polhode::proofs
