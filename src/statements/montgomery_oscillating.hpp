#pragma once

#include "statements/shared.hpp"

namespace polhode::statements {

// Its facts.
inline constexpr const char* phase_keeps_its_bounds =
    "at the given a, b the phase by the AGM at u = 1/4, 1/2, 3/4 decreases, is above 2 pi I and 4 "
    "I arsinh(pi/(2 sqrt(u))), and below 2 pi I g(u)/g(1)";
inline constexpr const char* bound_of_body =
    "at the given a, b, exactly: the body is {}, and the greatest lower bound is {}";

[[nodiscard]] inline claim_text montgomery_oscillating() {
  return {
      .name = "montgomery_oscillating",
      .reference = "theorem 1",
      .statement =
          "The Montgomery phase of oscillating motion increases in c, and its greatest lower bound "
          "is 2 pi I; this is at least 2 pi if and only if the body is physical.",
      .technique = "exact derivative and signs; two-sided bounds for the limit",
      .formula =
          "dphi(c) = 2 G(u), u = -c/b: decreasing in u, inf = lim (u -> 1) = 2 pi I; inf >= 2 pi "
          "<=> I >= 1",
      .method =
          "For all a > 0, 0 < b < 1: G(u) = b^(-1/2) times the integral of g(x) over 0 < t < pi "
          "with x = u + (1-u) cos^2(t/2); g decreases strictly in x and x increases in u, so G "
          "decreases strictly in u (the phase increases in c); u <= x <= 1 gives pi I <= G(u) <= "
          "pi I g(u)/g(1), so that pi I is the limit for u -> 1 and the greatest lower bound, "
          "which is not attained. By the claim physical it is at least pi exactly for physical "
          "bodies. Computed: the polynomial steps; the rest is monotonicity of the integral.",
      .steps = with_more(half_phase_steps),
      .tier = by_kernel,
      .argument = {in_coq("Theorems.oscillating_phase_at"),
                   in_coq("Theorems.oscillating_phase_increases"),
                   in_coq("Theorems.theorem_1_infimum"), in_coq("Theorems.theorem_1_not_attained"),
                   in_coq("Theorems.theorem_1_physical"), bartky_transformation}};
}

}  // namespace polhode::statements
