#pragma once

#include "statements/shared.hpp"

namespace polhode::statements {

// Its facts.
inline constexpr const char* bounds_are_for_physical_bodies =
    " (The given body is not physical: the bounds are not for it.)";
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
          "physical bodies that have a c0 (J < 2) that of c0/b is beta; neither is attained.",
      .technique = "two-sided bounds of the integrand, by exact signs",
      .formula =
          "ab + 2b <= 1  =>  epsilon0 > epsilon0_min = 2 arctan(e^-pi) and, where J < 2, c0/b > "
          "beta; ab + 2b = 1  =>  epsilon0 < 2 arctan(e^(-pi sqrt(1-2b))), and agm(sqrt(1+t), "
          "sqrt(t)) < 1/(2 sqrt(1-2b)) at t = c0/b",
      .method =
          "For all physical bodies: (1-bX)^2 > b(a+bX) for 0 <= X < 1, so that the integrand of "
          "the implicit equation exceeds (x + cos^2 psi)^(-1/2) at every c = b x; at c = 0 its "
          "integral is the inverse Gudermannian, and up to pi/2 it is pi/(2 agm(sqrt(1+x), "
          "sqrt(x))). For all bodies it is below (x + cos^2 psi)^(-1/2)/sqrt(ab), and planar "
          "bodies a = 1/b - 2 have ab = 1 - 2b: as b -> 0 both bounds meet. Computed: the "
          "polynomial steps and both numbers.",
      .steps = {positive(
                    "(1-b*x)^2 - b*(a+b*x)", "p + b*y*(1+q+b*y)",
                    "b > 0, p = 1-a*b-2*b >= 0, q = 1-b > 0, y = 1-x > 0",
                    "p >= 0 for physical bodies: the integrand exceeds (x + cos^2)^(-1/2) where X "
                    "< 1"),
                not_negative("(a+b*x) - a*(1-b*x)^2", "b*x + a*b*x*(1+q+b*y)",
                             "a > 0, b > 0, x >= 0, q = 1-b > 0, y = 1-x >= 0",
                             "a(1-bX)^2 <= a+bX: sqrt(ab) times the integrand is at most (x + "
                             "cos^2)^(-1/2)"),
                identity("(1-2*b) + 2*b", "1", "a = 1/b - 2 is planar: ab + 2b = 1")},
      .tier = by_kernel,
      .argument = {in_coq("Infima.epsilon0_infimum"), in_coq("Infima.defect_above_minimum"),
                   in_coq("Infima.planar_defect_below"), in_coq("Infima.beta_infimum"),
                   in_coq("Infima.perfect_twist_above_beta"),
                   in_coq("Infima.planar_perfect_twist_below"), gauss_mean, bartky_transformation}};
}

}  // namespace polhode::statements
