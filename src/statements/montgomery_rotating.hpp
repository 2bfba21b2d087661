#pragma once

#include "statements/shared.hpp"

namespace polhode::statements {

// Its facts.
inline constexpr const char* rotating_phase_keeps_its_bounds =
    "at the given a, b the phase by the AGM at c = a/4, a/2, 3a/4 decreases, is above 2 pi J and 4 "
    "I arsinh((pi/2) sqrt(b/c)), and below 2 pi J sqrt(a/c)";

[[nodiscard]] inline claim_text montgomery_rotating() {
  return {.name = "montgomery_rotating",
          .reference = "theorem 2, eq. (17)",
          .statement =
              "The Montgomery phase of rotating motion decreases in c, and its greatest lower "
              "bound is 2 pi J.",
          .technique =
              "exact derivative and signs; two-sided bounds and an antiderivative for the limit",
          .formula = "dphi(c) = 2 F(c,0): decreasing in c, inf = lim (c -> a) = 2 pi J",
          .method =
              "For all a > 0, 0 < b < 1: the integrand decreases strictly in c; (a+bX)/(c+bX) lies "
              "between 1 and a/c, so that P < F(c,0) <= P sqrt(a/c) with P the integral at c = a, "
              "which is pi J by an antiderivative. So pi J is the limit for c -> a and the "
              "greatest lower bound, which is not attained for c < a. Computed: the polynomial "
              "steps; the rest is monotonicity of the integral.",
          .steps = with_more(rotating_phase_steps),
          .tier = by_kernel,
          .argument = {in_coq("Theorems.rotating_phase_at"),
                       in_coq("Theorems.rotating_phase_decreases"),
                       in_coq("Theorems.theorem_2_infimum"),
                       in_coq("Theorems.theorem_2_not_attained"), bartky_transformation}};
}

}  // namespace polhode::statements
