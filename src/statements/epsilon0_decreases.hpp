#pragma once

#include "statements/shared.hpp"

namespace polhode::statements {

// Its facts.
inline constexpr const char* smaller_for_double_a =
    "at the given b, by interval Newton: epsilon0 for 2a is below epsilon0 for the given a";
inline constexpr const char* order_for_double_a = "the order of epsilon0 for a and 2a";

[[nodiscard]] inline claim_text epsilon0_decreases() {
  return {
      .name = "epsilon0_decreases",
      .reference = "lemma 5",
      .statement = "The twist defect on the separatrix, epsilon0(a, b), decreases as a increases.",
      .technique = "exact derivatives of the integrand and their signs",
      .formula = "a < a'  =>  epsilon0(a', b) < epsilon0(a, b)",
      .method =
          "For all a > 0, 0 < b < 1: the integrand of F(0,u) decreases strictly in a, and F(0,u) "
          "decreases in u. At epsilon0(a) the integral for a' > a is below 2 pi, so its root is "
          "smaller. Computed: the polynomial steps.",
      .steps = {integrand_decreases_in_a, integrand_is_positive},
      .tier = by_kernel,
      .argument = {in_coq("DecreaseInA.lemma_5")}};
}

}  // namespace polhode::statements
