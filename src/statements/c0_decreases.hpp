#pragma once

#include "statements/shared.hpp"

namespace polhode::statements {

// Its facts.
inline constexpr const char* smaller_c0_for_double_a =
    "at the given b, by the AGM: c0 for 2a is below c0 for the given a, c0/a lying between {}";

[[nodiscard]] inline claim_text c0_decreases() {
  return {
      .name = "c0_decreases",
      .reference = "lemma 4",
      .statement = "The perfect twist c0(a, b) decreases as a increases.",
      .technique = "exact derivatives of the integrand and their signs",
      .formula = "a < a'  =>  c0(a', b) < c0(a, b), where c0(a, b) exists",
      .method =
          "For all a > 0, 0 < b < 1 with J < 2: the integrand of F(c,0) decreases strictly in a "
          "and in c. At c0(a) the integral for a' > a is below 2 pi, so its root c0(a') is "
          "smaller; it exists, as J decreases in a. Computed: the polynomial steps.",
      .steps = {integrand_decreases_in_a, integrand_is_positive, integrand_decreases_in_c,
                slope("(a+1)^2", "a*(a+b)", "a", "-(a+1)*(a*(2-b)+b)",
                      "the derivative in a of (J+1)^2"),
                positive("a*(2-b)+b", "a + a*q + b", "a > 0, b > 0, q = 1-b > 0",
                         "so J decreases in a")},
      .tier = by_kernel,
      .argument = {in_coq("DecreaseInA.lemma_4"), bartky_transformation}};
}

}  // namespace polhode::statements
