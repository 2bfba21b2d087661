#pragma once

#include "statements/shared.hpp"

namespace polhode::statements {

[[nodiscard]] inline claim_text printed_numbers() {
  return {.name = "printed_numbers",
          .reference = "figs. 6, 7, eqs. (39), (40), section 8",
          .statement =
              "The numbers in the captions, in section 7 and in the conclusion are those of their "
              "formulas, to the last digit printed, but for those in errata.",
          .technique = "enclosures against the printed decimals",
          .formula = "|printed - value| <= half a unit of the last place printed",
          .method =
              "Each number is enclosed from its formula in ball arithmetic (beta by interval "
              "Newton), and compared with the printed decimal as an exact rational. Those that are "
              "wrong are in the claim errata.",
          .steps = {},
          .tier = by_machine,
          .argument = {gauss_mean, gudermannian}};
}

}  // namespace polhode::statements
