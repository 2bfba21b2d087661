#pragma once

#include "statements/shared.hpp"

namespace polhode::statements {

// Its facts.
inline constexpr const char* one_root_in_box =
    "interval Newton maps its box into itself with a derivative that is not 0: exactly one root in "
    "the box";
inline constexpr const char* signs_by_quadrature =
    "by certified quadrature, which uses no AGM: the integral over (0, pi/2) of (x + cos^2 "
    "t)^(-1/2) exceeds pi at the first {} digits of beta and is below pi one unit of the last "
    "place higher";

[[nodiscard]] inline claim_text beta() {
  return {
      .name = "beta",
      .reference = "eq. (40)",
      .statement =
          "beta is the one positive root of K(1/(1+beta)) = pi sqrt(1+beta). What it says of "
          "bodies, that it is the greatest lower bound of c0/b over all physical ones, is the "
          "claim limit_minimum. The paper prints 0.028973.",
      .technique =
          "interval Newton on the AGM; signs by certified quadrature as an independent route",
      .formula =
          "agm(sqrt(1+beta), sqrt(beta)) = 1/2, equivalent to K(1/(1+beta)) = pi sqrt(1+beta)",
      .method =
          "K(1/(1+x)) = sqrt(1+x) I(x) with I(x) the integral over (0, pi/2) of (x + cos^2 "
          "t)^(-1/2), and I(x) = pi/(2 agm(sqrt(1+x), sqrt(x))) by Gauss: pi cancels. The mean "
          "increases strictly in x > 0 from 0 without bound, so there is exactly one root; "
          "interval Newton with f' from the same AGM steps proves it in its box and encloses it.",
      .steps = {},
      .tier = by_kernel,
      .argument = {in_coq("Beta.beta_exists_unique"),
                   cited("K(m) = pi/(2 agm(1, sqrt(1-m))) (Gauss; DLMF 19.8(i)); the mean is "
                         "continuous, increases in both its arguments and is homogeneous.")}};
}

}  // namespace polhode::statements
