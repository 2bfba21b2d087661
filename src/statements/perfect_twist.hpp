#pragma once

#include "statements/shared.hpp"

namespace polhode::statements {

// Its facts.
inline constexpr const char* root_exists_or_not =
    "at the given a, b, exactly: J {}{}, so there is {}{}";
inline constexpr const char* rotating_phase_stays_above =
    "at the given a, b, by the AGM: F(c,0) > {} pi at c = a/2 and 3a/4";
inline constexpr const char* rotating_phase_passes =
    "at the given a, b, by the AGM: F(c,0) passes {} between c/a = {}";
inline constexpr const char* bracket_of_root = "a bracket of the {}";

[[nodiscard]] inline claim_text perfect_twist() {
  return {
      .name = "perfect_twist",
      .reference = "proposition 3, part 2",
      .statement =
          "A perfect twist, epsilon = 0, occurs if and only if J < 2, at exactly one c0, which "
          "lies in (0, a).",
      .technique = "one-to-one map onto (pi J, infinity), by exact signs; J < 2 decided exactly",
      .formula = "F(c0,0) = 2 pi for some c0  <=>  J < 2; then c0 is in (0, a) and the only one",
      .method =
          "For all a > 0, 0 < b < 1, by the proof of montgomery_rotating: F(c,0) maps 0 < c < a "
          "one to one onto the values above pi J, and F(c,u) is defined at u = 0 for c > 0 only. "
          "So 2 pi is a value exactly where J < 2 (and the phase 2 F(c,0) has the value 2 pi, a "
          "full turn, exactly where J < 1). For a given body J < 2 is decided exactly.",
      .steps = with_more(
          rotating_phase_steps,
          {identity("9*a*(a+b) - (a+1)^2", "8*a^2 + 9*a*b - 2*a - 1",
                    "J < 2 exactly where this is positive, as (J+1)^2 = (a+1)^2/(a(a+b))"),
           identity("4*a*(a+b) - (a+1)^2", "3*a^2 + 4*a*b - 2*a - 1",
                    "J < 1 exactly where this is positive")}),
      .tier = by_kernel,
      .argument = {in_coq("Separatrix.proposition_3_2"), in_coq("Theorems.rotating_phase_at"),
                   in_coq("Theorems.rotating_phase_decreases"), bartky_transformation}};
}

}  // namespace polhode::statements
