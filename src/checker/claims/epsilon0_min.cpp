// epsilon0_min, by its formula and as a root.

#include "answers.hpp"
#include "checker/examination.hpp"
#include "checker/facts.hpp"
#include "checker/functions.hpp"
#include "constants.hpp"
#include "list.hpp"

namespace polhode::checker {
namespace {

void check_epsilon0_min(examination& e) {
  e.read_no_inputs();
  e.number("epsilon0_min", epsilon0_min);
  e.fact(
      "log(tan(x/2)) + pi has exactly one root in [0.086, 0.087] (interval Newton), and its "
      "enclosure overlaps the one by the formula",
      // log(tan(x/2)) increases on (0, pi), so that the root is where the signs differ, and tan(x/2) = e^-pi is the formula.
      [&](precision bits) {
        const auto value = [&](const rational& x) {
          const sine_and_cosine at = sin_cos(exactly(rational(x / 2), bits));
          return log(at.sine / at.cosine) + pi(bits);
        };
        const interval zero = exactly(0, bits);
        return all_of(
            {below(value(rational(86, 1000)), zero), below(zero, value(rational(87, 1000)))});
      });
  examination::decimals(e.witness("second_route"), epsilon0_min);
}

}  // namespace

claim epsilon0_min_claim() {
  return {.name = "epsilon0_min",
          .reference = "eq. (39)",
          .statement =
              "epsilon0_min = pi/2 - am(pi | 1) = pi - 2 arctan(e^pi). What it says of bodies, "
              "that it is the greatest lower bound of the twist defect on the separatrix over all "
              "physical ones, is the claim limit_minimum. The paper prints 0.086374.",
          .formula = "epsilon0_min = pi - 2 arctan(e^pi) = 2 arctan(e^-pi)",
          .method =
              "On the separatrix of the limit the amplitude is the Gudermannian, am(pi|1) = 2 "
              "arctan(e^pi) - pi/2, so that pi/2 - am(pi|1) is the formula above; it is evaluated "
              "in ball arithmetic. The second route encloses the one root of log(tan(x/2)) + pi in "
              "[0.086, 0.087] by interval Newton.",
          .steps = {},
          .tier = by_machine,
          .argument = {facts::gudermannian},
          .check = check_epsilon0_min};
}

}  // namespace polhode::checker
