#pragma once

#include "statements/shared.hpp"

namespace polhode::statements {

// Its facts.
inline constexpr const char* second_route_overlaps =
    "pi - 2 epsilon0_min with epsilon0_min from log and tan overlaps the formula in exp and arctan";

[[nodiscard]] inline claim_text delta_psi_max() {
  return {.name = "delta_psi_max",
          .reference = "section 7, after eq. (40)",
          .statement =
              "delta_psi_max = pi - 2 epsilon0_min. What it says of bodies, that it is the least "
              "upper bound of the twist on the separatrix over all physical ones, follows by the "
              "claim limit_minimum. The paper prints 2.96884.",
          .technique = "ball arithmetic; interval Newton on log tan as a second route",
          .formula = "delta_psi_max = pi - 2 epsilon0_min = 4 arctan(e^pi) - pi",
          .method =
              "The formula in ball arithmetic; the second route takes epsilon0_min from interval "
              "Newton on log(tan(x/2)) + pi.",
          .steps = {},
          .tier = by_machine,
          .argument = {gudermannian}};
}

}  // namespace polhode::statements
