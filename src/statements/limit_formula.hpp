#pragma once

#include "statements/shared.hpp"

namespace polhode::statements {

// Its facts.
inline constexpr const char* mean_at_epsilon0_min =
    "agm(1, sin epsilon0_min) < 1/2 with sin epsilon0_min = 1/cosh(pi), so that K(cos^2 "
    "epsilon0_min) > pi: for beta < 0, chi <= 1 the limit's motion has either -beta > sin^2 "
    "epsilon0_min, and epsilon >= epsilon* > epsilon0_min, or is still before its first turning "
    "point";

[[nodiscard]] inline claim_text limit_formula() {
  return {
      .name = "limit_formula",
      .reference = "eqs. (33)-(38)",
      .statement =
          "As a -> infinity, b -> 0 with ab -> chi > 0 and c/b = beta > -1, epsilon tends to pi/2 "
          "- am(pi sqrt(chi(1+beta)) | 1/(1+beta)), where for beta < 0 the amplitude is the psi "
          "with sin psi = sqrt(1+beta) sn(pi sqrt(chi) | 1+beta), |psi| < pi/2, before the first "
          "turning point and beyond it. At c = b beta < a they differ for every body by at most "
          "sqrt(1+beta) pi times the greater of |sqrt(ab) - sqrt(chi)| and |sqrt(ab) "
          "sqrt((a+b)/a)/(1-b) - sqrt(chi)|. For beta < 0, chi <= 1 the limit is above "
          "epsilon0_min, and tends to it as chi -> 1, beta -> 0.",
      .technique = "two-sided bound of the integrand, by exact signs; symmetries of the motion",
      .formula =
          "sin psi_c(pi) = sqrt(1+beta) sn(xi | 1+beta) for -1 < beta < 0, psi_c(pi) = "
          "am(sqrt(1+beta) xi | 1/(1+beta)) for beta >= 0, with pi sqrt(ab) <= xi <= pi sqrt(ab) "
          "sqrt((a+b)/a)/(1-b), c = b beta; epsilon = pi/2 - psi_c(pi)",
      .method =
          "For all a > 0, 0 < b < 1, beta > -1: sqrt(ab) times the integrand is v (beta + cos^2 "
          "psi)^(-1/2) with (1-b) sqrt(a/(a+b)) <= v <= 1, so that xi, which grows by (beta + "
          "cos^2 psi)^(-1/2) |dpsi| along the motion, lies at phi = pi between the bounds; they "
          "have the limit pi sqrt(chi). In xi the motion is that of the limit: an elliptic "
          "function of xi, whose rate is sqrt(beta + cos^2 psi) <= sqrt(1+beta). Computed: the "
          "polynomial steps, and that K(cos^2 epsilon0_min) > pi.",
      .steps = {not_negative("(a+b*x) - a*(1-b*x)^2", "b*x + a*b*x*(1+q+b*y)",
                             "a > 0, b > 0, x >= 0, q = 1-b > 0, y = 1-x >= 0",
                             "v^2 = a(1-bX)^2/(a+bX) <= 1"),
                not_negative("(1-b*x) - (1-b)", "b*y", "b > 0, y = 1-x >= 0", "1 - bX >= 1 - b"),
                not_negative("(a+b) - (a+b*x)", "b*y", "b > 0, y = 1-x >= 0",
                             "a + bX <= a + b, so that v^2 >= a(1-b)^2/(a+b)"),
                not_negative("(1+d) - (d+x)", "y", "y = 1-x >= 0",
                             "(dpsi/dxi)^2 = beta + X <= 1 + beta: the rate"),
                identity("d + (1-s)", "(1+d) - s",
                         "beta + cos^2 = (1+beta)(1 - sin^2/(1+beta)): the limit form is F(psi | "
                         "1/(1+beta))/sqrt(1+beta)"),
                identity("d + (1-(1+d)*s^2)", "(1+d)*(1-s^2)",
                         "with sin psi = sqrt(1+beta) s: beta + cos^2 = (1+beta)(1-s^2), so that "
                         "(ds/dxi)^2 = (1-s^2)(1-(1+beta)s^2), the equation of sn(xi | 1+beta)")},
      .tier = by_argument,
      .argument = {argued("Along the motion sqrt(ab) dphi = v dxi at every psi between the turning "
                          "points, which are passed in finite time, so that the bounds of v are "
                          "those of xi(pi) against pi sqrt(ab)."),
                   argued("For beta < 0: sin psi = sqrt(1+beta) sn(xi | 1+beta) up to the first "
                          "turning point, xi = K(1+beta), by the equation of sn; beyond it, as "
                          "psi_c(phi + G) = -psi_c(phi) and psi_c is odd, xi grows by 2K in every "
                          "G, and sn is odd with sn(xi + 2K) = -sn xi. For beta >= 0 psi "
                          "increases, and xi = F(psi | 1/(1+beta))/sqrt(1+beta) defines am."),
                   argued("psi changes by at most sqrt(1+beta) for each unit of xi, through "
                          "turning points as well: so much is between xi(pi) and pi sqrt(chi), "
                          "where psi_c(pi) tends to."),
                   argued("For beta < 0, before the first turning point, the limit's integral is "
                          "greater than for beta = 0 at every psi, and its value pi sqrt(chi) is "
                          "at most pi: psi is below that of beta = 0, chi = 1."),
                   psi_is_odd, half_phase_symmetry, in_coq("LimitFormula.limit_formula"),
                   gauss_mean, cited("sn(x + 2K | m) = -sn(x | m) (DLMF 22.4(iii))."),
                   cited("Solutions of ordinary differential equations exist, are unique (Picard "
                         "and Lindeloef) and depend continuously on their data.")}};
}

}  // namespace polhode::statements
