#pragma once

// One function a claim, each in a file of its own; registry.cpp lists them.

#include "proofs/claim.hpp"

namespace polhode::proofs {

[[nodiscard]] claim epsilon0_min_claim();
[[nodiscard]] claim delta_psi_max_claim();
[[nodiscard]] claim beta_claim();
[[nodiscard]] claim sign_dF_du_claim();

}  // namespace polhode::proofs
