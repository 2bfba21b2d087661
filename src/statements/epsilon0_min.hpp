#pragma once

#include "statements/shared.hpp"

namespace polhode::statements {

// Its facts.
inline constexpr const char* root_of_log_tan =
    "log(tan(x/2)) + pi has exactly one root in [0.086, 0.087] (interval Newton), and its "
    "enclosure overlaps the one by the formula";

[[nodiscard]] inline claim_text epsilon0_min() {
  return {.name = "epsilon0_min",
          .reference = "eq. (39)",
          .statement =
              "epsilon0_min = pi/2 - am(pi | 1) = pi - 2 arctan(e^pi). What it says of bodies, "
              "that it is the greatest lower bound of the twist defect on the separatrix over all "
              "physical ones, is the claim limit_minimum. The paper prints 0.086374.",
          .technique = "ball arithmetic; interval Newton on log tan as a second route",
          .formula = "epsilon0_min = pi - 2 arctan(e^pi) = 2 arctan(e^-pi)",
          .method =
              "On the separatrix of the limit the amplitude is the Gudermannian, am(pi|1) = 2 "
              "arctan(e^pi) - pi/2, so that pi/2 - am(pi|1) is the formula above; it is evaluated "
              "in ball arithmetic. The second route encloses the one root of log(tan(x/2)) + pi in "
              "[0.086, 0.087] by interval Newton.",
          .steps = {},
          .tier = by_machine,
          .argument = {gudermannian}};
}

}  // namespace polhode::statements
