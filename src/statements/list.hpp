#pragma once

// The claims, in the order of the paper: each with its name, and with what its numbers depend on
// (proofs::claim_subject). The list is written here and nowhere else. A claim is its text beside
// this file, name_claim() in proofs/ and in src/checker/claims/, and its theorem in proofs/coq
// where there is one.

// clang-format off
#define POLHODE_CLAIMS(claim_about) \
  claim_about(physical, body) \
  claim_about(reduced_system, none) \
  claim_about(montgomery_oscillating, body) \
  claim_about(montgomery_rotating, body) \
  claim_about(first_equation, body) \
  claim_about(separatrix_twist, body) \
  claim_about(perfect_twist, body) \
  claim_about(intersection, body) \
  claim_about(crossing, body) \
  claim_about(injectivity, body) \
  claim_about(count, body) \
  claim_about(c0_decreases, body) \
  claim_about(epsilon0_decreases, body) \
  claim_about(large_a, none) \
  claim_about(limit_formula, none) \
  claim_about(limit_minimum, body) \
  claim_about(epsilon0_min, none) \
  claim_about(delta_psi_max, none) \
  claim_about(beta, none) \
  claim_about(sign_dF_du, motion) \
  claim_about(half_phase_limits, body) \
  claim_about(implicit_equations, none) \
  claim_about(printed_numbers, none) \
  claim_about(errata, none)
// clang-format on
