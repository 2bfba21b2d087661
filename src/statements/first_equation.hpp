#pragma once

#include "statements/shared.hpp"

namespace polhode::statements {

// Its facts.
inline constexpr const char* decrease_at_given_body =
    "at the given a, b, by Carlson's integrals: F(c,u) decreases from c = -b/8 to 0 to a/2 to a at "
    "u = 1/2, and from u = 1/4 to 1/2 to 3/4 at c = a/2";
inline constexpr const char* order_of_values = "the order of some values of F(c,u)";

[[nodiscard]] inline claim_text first_equation() {
  return {
      .name = "first_equation",
      .reference = "proposition 2, eqs. (21)-(24)",
      .statement =
          "The twist defect given by the first implicit equation decreases strictly in c, and so "
          "is injective there.",
      .technique = "exact derivative of the integrand and its sign",
      .formula =
          "integral over (0, pi/2 - epsilon) of (1-bX)/sqrt((a+bX)(c+bX)) dpsi = pi, X = cos^2 "
          "psi: epsilon decreases in c",
      .method =
          "For all a > 0, 0 < b < 1: the integrand is positive and decreases strictly in c, so the "
          "integral increases strictly in its upper end and decreases strictly in c; where it is "
          "pi for c and for c' > c, the upper end for c' is the greater one. Computed: the "
          "polynomial steps.",
      .steps = {integrand_decreases_in_c, integrand_is_positive},
      .tier = by_kernel,
      .argument = {in_coq("FirstEquation.proposition_2"), in_coq("DefectFunction.equation_24"),
                   in_coq("DefectFunction.equation_24_negative")}};
}

}  // namespace polhode::statements
