#pragma once

#include "statements/shared.hpp"

namespace polhode::statements {

// Its facts.
inline constexpr const char* increasing_chain =
    "at the given a, b: epsilon(c) increases as c goes down a chain of {} points towards -b, and "
    "is below pi/2, its limit there; as it is monotone by the proof, the boxes between "
    "neighbouring points cover the curve between them";
inline constexpr const char* two_c_with_one_epsilon =
    "at the given a, b: epsilon = {} (one exact number) is passed between c = {} and {}, and again "
    "between {} and {}: two c with the same epsilon";
inline constexpr const char* injective_or_not =
    "at the given a, b, exactly: I {} 1, {}: epsilon(c) is {}";
inline constexpr const char* chain_of_points = "a chain of points with certainly different epsilon";
inline constexpr const char* pair_of_c = "a pair of c with one epsilon";

[[nodiscard]] inline claim_text injectivity() {
  return {
      .name = "injectivity",
      .reference = "theorem 3, proposition 4",
      .statement =
          "The twist defect epsilon(c) is an injective function of c if and only if I >= 1, that "
          "is, if and only if the body is physical.",
      .technique =
          "monotone parts by exact signs; a chain of enclosures, or two c with one epsilon, for a "
          "body",
      .formula = "c -> epsilon(c) is injective on (-b, a)  <=>  I >= 1  <=>  the body is physical",
      .method =
          "For all a > 0, 0 < b < 1. I >= 1: G > pi, so that pi is reached before the first "
          "turning point, where epsilon decreases by first_equation, or between it and the return "
          "to psi = 0, where T(c, psi_c(pi)) = G - pi; as c decreases G decreases and T increases "
          "for every psi, so psi_c(pi) decreases: epsilon decreases strictly throughout. I < 1: "
          "epsilon is pi/2 at c* by the claim crossing and tends to pi/2 as c -> -b; a continuous "
          "injective function would have different limits. Computed: the polynomial steps, I "
          "against 1 exactly, and enclosures for the given body.",
      .steps = with_more(half_phase_steps,
                         {slope("(1-b*x)^2", "(a+b*x)*(c+b*x)", "c", "-(1-b*x)^2*(a+b*x)",
                                "the derivative in c of the square of T's integrand, negative")}),
      .tier = by_kernel,
      .argument = {in_coq("Theorem3.theorem_3"), in_coq("Prop1.proposition_1"),
                   bartky_transformation}};
}

}  // namespace polhode::statements
