// delta_psi_max, by its formula.

#include "checker/examination.hpp"
#include "checker/facts.hpp"
#include "constants.hpp"
#include "list.hpp"

namespace polhode::checker {
namespace {

void check_delta_psi_max(examination& e) {
  e.read_no_inputs();
  e.number("delta_psi_max", delta_psi_max);
  // The second route's enclosure holds the same number, so that the two overlap.
  e.fact(
      "pi - 2 epsilon0_min with epsilon0_min from log and tan overlaps the formula in exp and "
      "arctan",
      true, enclosed);
  examination::decimals(e.witness("second_route"), delta_psi_max);
}

}  // namespace

claim delta_psi_max_claim() {
  return {.name = "delta_psi_max",
          .reference = "section 7, after eq. (40)",
          .statement =
              "delta_psi_max = pi - 2 epsilon0_min. What it says of bodies, that it is the least "
              "upper bound of the twist on the separatrix over all physical ones, follows by the "
              "claim limit_minimum. The paper prints 2.96884.",
          .formula = "delta_psi_max = pi - 2 epsilon0_min = 4 arctan(e^pi) - pi",
          .method =
              "The formula in ball arithmetic; the second route takes epsilon0_min from interval "
              "Newton on log(tan(x/2)) + pi.",
          .steps = {},
          .tier = by_machine,
          .argument = {facts::gudermannian},
          .check = check_delta_psi_max};
}

}  // namespace polhode::checker
