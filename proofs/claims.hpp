#pragma once

// One function a claim, each in a file of its own; registry.cpp lists them.

#include "proofs/claim.hpp"

namespace polhode::proofs {

[[nodiscard]] claim physical_claim();
[[nodiscard]] claim montgomery_oscillating_claim();
[[nodiscard]] claim montgomery_rotating_claim();
[[nodiscard]] claim first_equation_claim();
[[nodiscard]] claim separatrix_twist_claim();
[[nodiscard]] claim perfect_twist_claim();
[[nodiscard]] claim intersection_claim();
[[nodiscard]] claim crossing_claim();
[[nodiscard]] claim injectivity_claim();
[[nodiscard]] claim count_claim();
[[nodiscard]] claim c0_decreases_claim();
[[nodiscard]] claim epsilon0_decreases_claim();
[[nodiscard]] claim large_a_claim();
[[nodiscard]] claim limit_formula_claim();
[[nodiscard]] claim limit_minimum_claim();
[[nodiscard]] claim epsilon0_min_claim();
[[nodiscard]] claim delta_psi_max_claim();
[[nodiscard]] claim beta_claim();
[[nodiscard]] claim sign_dF_du_claim();
[[nodiscard]] claim half_phase_limits_claim();
[[nodiscard]] claim implicit_equations_claim();
[[nodiscard]] claim printed_numbers_claim();
[[nodiscard]] claim errata_claim();

}  // namespace polhode::proofs
