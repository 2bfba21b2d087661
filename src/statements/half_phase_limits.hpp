#pragma once

#include "statements/shared.hpp"

namespace polhode::statements {

// Its facts.
inline constexpr const char* both_bounds_hold =
    "at the given a, b both bounds hold at u = 1/4, 1/2, 3/4 for the value by the AGM";

[[nodiscard]] inline claim_text half_phase_limits() {
  return {.name = "half_phase_limits",
          .reference = "appendix A, lemma 7, eqs. (45)-(46)",
          .statement = "F(-bu,u) tends to pi I as u tends to 1, and to infinity as u tends to 0.",
          .technique = "explicit bounds on both sides, by exact signs",
          .formula = "F(-bu,u) -> pi (1-b)/sqrt(b(a+b)) as u -> 1, F(-bu,u) -> infinity as u -> 0",
          .method =
              "For all a > 0, 0 < b < 1, by the bounds pi I <= F(-bu,u) <= pi I g(u)/g(1) and "
              "F(-bu,u) >= 2 I arsinh(pi/(2 sqrt(u))), g(x) = (1-bx)/sqrt(x(a+bx)): their steps "
              "are questions about polynomials, decided by expansion.",
          .steps = with_more(half_phase_steps),
          .tier = by_kernel,
          .argument = {in_coq("Values.lemma_7_at_1"), in_coq("Values.lemma_7_at_0"),
                       bartky_transformation}};
}

}  // namespace polhode::statements
