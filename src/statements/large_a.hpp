#pragma once

#include "statements/shared.hpp"

namespace polhode::statements {

[[nodiscard]] inline claim_text large_a() {
  return {
      .name = "large_a",
      .reference = "section 7: after lemma 5, remark 2",
      .statement =
          "As a -> infinity for one b, epsilon0 -> 0, c0 -> 0 and the first point where C meets S "
          "tends to c = epsilon = 0; for no body is epsilon0 = 0: a perfect twist on the "
          "separatrix there is in this limit only.",
      .technique = "explicit bounds, by exact signs",
      .formula =
          "0 < epsilon0 < 2 arctan(e^(-pi sqrt(ab))), c0 < 1/(4a) where there is a c0, u1 < "
          "1/(4ab) and -c1 < 1/(4a) where C meets S first",
      .method =
          "For all a > 0, 0 < b < 1: 1 - bX < 1 and a + bX > a for X > 0, so that F(0,u) < 2 "
          "artanh(sqrt(1-u))/sqrt(ab), F(c,0) < pi/sqrt(ac) and G(u) < pi/sqrt(abu); each is 2 pi "
          "at epsilon0, c0 and u1. epsilon0 > 0 by the claim separatrix_twist. Computed: the "
          "polynomial steps.",
      .steps = {positive("1 - (1-b*x)", "b*x", "b > 0, x > 0", "1 - bX < 1"),
                positive("(a+b*x) - a", "b*x", "b > 0, x > 0", "a + bX > a"),
                positive("(c+b*x) - c", "b*x", "b > 0, x > 0", "c + bX > c, for c > 0"),
                not_negative("(u+(1-u)*k) - u", "k*v", "k >= 0, v = 1-u >= 0",
                             "x = u + (1-u) k >= u in the integral G(u): g(x) < 1/sqrt(a u)")},
      .tier = by_kernel,
      .argument = {in_coq("LargeA.perfect_twist_vanishes"), in_coq("LargeA.defect_vanishes"),
                   in_coq("LargeA.first_meeting_vanishes"), in_coq("Separatrix.proposition_3_1")}};
}

}  // namespace polhode::statements
