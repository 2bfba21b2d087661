#pragma once

#include "statements/shared.hpp"

namespace polhode::statements {

// Its facts.
inline constexpr const char* derivative_identity =
    "the u-derivative of the integrand of eq. (43) is the integrand of eq. (44): d(h^2)/du = -a (1 "
    "- bX)(a + (a+2) b X)/(X (a + bX))^2, equal in exact rationals at {} points";
inline constexpr const char* too_near_0 =
    "u is so near 0 that the rule would need more than {} nodes: this route is left out, and the "
    "AGM stands alone";
inline constexpr const char* slope_is_negative =
    "at the given a, b, u: dF(-bu,u)/du < 0 (elliptic integrals by AGM)";
inline constexpr const char* slope_by_quadrature =
    "the paper's eq. (44) by certified quadrature, to {} digits, overlaps the value by AGM and is "
    "negative";
inline constexpr const char* factors_are_positive =
    "for all a > 0, 0 < b < 1, 0 < u <= 1: on 0 < y < 1 every factor of the integrand of eq. (44) "
    "is positive (X = u + (1-u) y^2 lies in (0, 1], 1 - y^2 > 0), and its sign is minus";
inline constexpr const char* sweep_of_all_parameters =
    "interval sweep: -u sqrt(b(a+b)) dF/du > 3/4 on all of [0,1]^3 in the variables a/(a+b), "
    "b(1+a)/(a+b), u ({} boxes)";
inline constexpr const char* sweep_holds_value =
    "the sweep's integral at the given a, b, u holds the value above";
inline constexpr const char* degrees_of_identity =
    "cleared of denominators both sides are polynomials of degree at most 2 in a, 3 in b, 3 in u "
    "and 10 in y; they agree on a grid of 3 x 4 x 4 x 11 points, hence everywhere";

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
