#pragma once

#include "statements/shared.hpp"

namespace polhode::statements {

// Its facts.
inline constexpr const char* bounds_are_for_physical_bodies =
    " (The given body is not physical: the bounds are not for it.)";
inline constexpr const char* mean_at_epsilon0_min =
    "agm(1, sin epsilon0_min) < 1/2 with sin epsilon0_min = 1/cosh(pi), so that K(cos^2 "
    "epsilon0_min) > pi: for beta < 0, chi <= 1 the limit's motion has either -beta > sin^2 "
    "epsilon0_min, and epsilon >= epsilon* > epsilon0_min, or is still before its first turning "
    "point";
inline constexpr const char* epsilon0_is_above =
    "at the given a, b, {}: epsilon0, by interval Newton, is above epsilon0_min";
inline constexpr const char* order_of_epsilon0_and_least = "the order of epsilon0 and epsilon0_min";
inline constexpr const char* bracket_of_c0_on_one_side =
    "a bracket of c0 that lies on one side of b beta";
inline constexpr const char* c0_is_above =
    "at the given a, b: c0/b is above beta (c0/a between {})";

[[nodiscard]] inline claim_text limit_minimum() {
  return {
      .name = "limit_minimum",
      .reference = "section 7, eqs. (39), (40)",
      .statement =
          "Over all physical bodies the greatest lower bound of epsilon0 is epsilon0_min; over all "
          "physical bodies that have a c0 (J < 2) that of c0/b is beta; neither is attained. For "
          "beta < 0, chi <= 1 the limit's epsilon is above epsilon0_min, and tends to it as chi -> "
          "1, beta -> 0.",
      .technique = "one polynomial inequality over all physical bodies; the limit formula",
      .formula =
          "ab + 2b <= 1  =>  epsilon0 > epsilon0_min = 2 arctan(e^-pi) and, where J < 2, c0/b > "
          "beta; both are greatest lower bounds",
      .method =
          "For all physical bodies: (1-bX)^2 > b(a+bX) for 0 <= X < 1, so that the integrand of "
          "the implicit equation exceeds (beta + cos^2 psi)^(-1/2), that of the limit for chi = 1, "
          "at every c = b beta; so epsilon0 and, where there is a c0, c0/b exceed their limits. "
          "Planar bodies a = 1/b - 2 approach them for b -> 0 by the limit formula. Computed: the "
          "polynomial step and both numbers.",
      .steps = {positive(
                    "(1-b*x)^2 - b*(a+b*x)", "p + b*y*(1+q+b*y)",
                    "b > 0, p = 1-a*b-2*b >= 0, q = 1-b > 0, y = 1-x > 0",
                    "p >= 0 for physical bodies: the integrand exceeds the limit's where X < 1"),
                identity("(1-2*b) + 2*b", "1", "a = 1/b - 2 is planar: ab + 2b = 1")},
      .tier = by_argument,
      .argument = {in_coq("Infima.epsilon0_infimum"), in_coq("Infima.beta_infimum"),
                   argued("The integrand exceeds the limit's at every psi > 0, so that the "
                          "integral does, and epsilon0 and c0/b exceed their limits."),
                   argued("Planar bodies approach both limits, by the claim limit_formula."),
                   argued("Before the first turning point the limit's integral is greater for beta "
                          "< 0 than for beta = 0 at every psi, and its value pi sqrt(chi) is at "
                          "most pi: psi is below that of beta = 0, chi = 1."),
                   gauss_mean, bartky_transformation}};
}

}  // namespace polhode::statements
