#pragma once

// c0 and epsilon0 decrease as a increases, b being fixed: the paper's lemmas 4 and 5. The argument:
// proofs/arguments/c0_decreases.md and epsilon0_decreases.md.

#include <vector>

#include "polhode/rigid_body/body.hpp"
#include "proofs/exact_polynomial.hpp"

namespace polhode::proofs {

/// The body with a doubled.
[[nodiscard]] body with_double_a(const body& rigid);

}  // namespace polhode::proofs
