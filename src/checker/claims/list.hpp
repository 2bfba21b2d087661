#pragma once

// The claims that the checker knows, in the order of the paper. A claim is a file here, which defines its function, and a row below.

#include "checker/claim.hpp"

// clang-format off
#define POLHODE_CHECKER_CLAIMS(claim_named) \
  claim_named(physical) \
  claim_named(reduced_system) \
  claim_named(montgomery_oscillating) \
  claim_named(montgomery_rotating) \
  claim_named(first_equation) \
  claim_named(separatrix_twist) \
  claim_named(perfect_twist) \
  claim_named(intersection) \
  claim_named(crossing) \
  claim_named(injectivity) \
  claim_named(count) \
  claim_named(c0_decreases) \
  claim_named(epsilon0_decreases) \
  claim_named(large_a) \
  claim_named(limit_formula) \
  claim_named(limit_minimum) \
  claim_named(epsilon0_min) \
  claim_named(delta_psi_max) \
  claim_named(beta) \
  claim_named(sign_dF_du) \
  claim_named(half_phase_limits) \
  claim_named(implicit_equations) \
  claim_named(printed_numbers) \
  claim_named(errata)
// clang-format on

namespace polhode::checker {

#define POLHODE_CHECKER_DECLARATION(name) [[nodiscard]] claim name##_claim();
POLHODE_CHECKER_CLAIMS(POLHODE_CHECKER_DECLARATION)
#undef POLHODE_CHECKER_DECLARATION

}  // namespace polhode::checker
