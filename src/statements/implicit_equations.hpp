#pragma once

#include "statements/shared.hpp"

namespace polhode::statements {

[[nodiscard]] inline claim_text implicit_equations() {
  return {
      .name = "implicit_equations",
      .reference = "appendix B, eqs. (48)-(53)",
      .statement =
          "After n intersections of C and S the curve C is given by one of four implicit "
          "equations, by the parity of n and the side of pi/2 on which epsilon is.",
      .technique = "symmetries of the motion; sums of the sweeps",
      .formula =
          "2n G - F(c,u') = 2 pi (n odd, epsilon < pi/2; n even, epsilon > pi/2), 2n G + F(c,u') = "
          "2 pi (n odd, epsilon >= pi/2; n even, epsilon <= pi/2), G = F(c,-c/b), u' = sin^2 "
          "epsilon",
      .method =
          "For all a > 0, 0 < b < 1, -b < c < 0: by the symmetries of the reduced system psi_c(phi "
          "+ G) = -psi_c(phi) and psi_c is odd; with pi = nG + r, |r| <= G/2, psi_c(pi) = (-1)^n "
          "psi_c(r) and |r| = F(c,u')/2, and the four cases are those of the signs of (-1)^n and "
          "r. The integral forms consist of 2n-1 whole sweeps G and two end pieces (G +- F)/2. "
          "Computed: the sums below.",
      .steps = {identity("2*(n*g+r)", "2*n*g + 2*r", "2 pi = 2nG + 2r, with 2r = F or 2r = -F"),
                identity("2*(2*n-1)*g + 2*(g-f)", "2*(2*n*g - f)",
                         "eq. (48), epsilon < pi/2, gives eq. (50); eq. (49), epsilon > pi/2, "
                         "gives eq. (52) (twice both sides)"),
                identity("2*(2*n-1)*g + 2*(g+f)", "2*(2*n*g + f)",
                         "eq. (48), epsilon >= pi/2, gives eq. (51); eq. (49), epsilon <= pi/2, "
                         "gives eq. (53)"),
                identity("2*(2*1-1)*g + 2*(g-f)", "2*(2*g - f)",
                         "n = 1: the second equation, eq. (28)"),
                identity("2*(2*1-1)*g + 2*(g+f)", "2*(2*g + f)", "n = 1: eq. (29)")},
      .tier = by_kernel,
      .argument = {in_coq("Branches.equation_50"), in_coq("Branches.equation_51"),
                   in_coq("Branches.equation_52"), in_coq("Branches.equation_53")}};
}

}  // namespace polhode::statements
