#pragma once

#include "statements/shared.hpp"

namespace polhode::statements {

[[nodiscard]] inline claim_text sign_dF_du() {
  return {
      .name = "sign_dF_du",
      .reference = "appendix A, lemma 6, eq. (44)",
      .statement =
          "F(-bu,u), half the Montgomery phase of oscillating motion, decreases in u: its "
          "derivative is negative at the given a, b, u, and for all a > 0, 0 < b < 1, 0 < u <= 1.",
      .technique =
          "two enclosures of the value; exact identity and signs; interval sweep over all "
          "parameters",
      .formula =
          "dF(-bu,u)/du = -(b/(ab)^(3/2)) integral over (0,1) of sqrt(1-y^2) (a + (a+2) b X)/(X (1 "
          "+ bX/a))^(3/2) dy < 0, X = u + (1-u) y^2",
      .method =
          "At the given a, b, u the value is enclosed by two routes that share no formula. For all "
          "a, b, u: after y = sin s the integrand of eq. (43) and its u-derivative are continuous "
          "in (s, u) on [0, pi/2] x [u_0, 1] for every u_0 > 0, so differentiation under the "
          "integral is allowed; the derivative of the integrand is the paper's, an exact identity "
          "of rational functions; its sign is read off its factors. The sweep bounds the same "
          "quantity over the whole compactified box of parameters in interval arithmetic.",
      .steps = {},
      .tier = by_kernel,
      .argument = {in_coq("HalfPhase.G_derive"), in_coq("HalfPhase.G_derive_negative"),
                   gauss_mean}};
}

}  // namespace polhode::statements
