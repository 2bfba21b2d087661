#pragma once

#include "statements/shared.hpp"

namespace polhode::statements {

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
          "sqrt((a+b)/a)/(1-b) - sqrt(chi)|. For beta < 0, chi <= 1 the limit exceeds "
          "epsilon0_min, by at most pi(1 - sqrt(chi)) + pi cosh(pi) sqrt(-beta chi).",
      .technique = "two-sided bound of the integrand, by exact signs",
      .formula =
          "sin psi_c(pi) = sqrt(1+beta) sn(xi | 1+beta) for -1 < beta < 0, psi_c(pi) = "
          "am(sqrt(1+beta) xi | 1/(1+beta)) for beta >= 0, with pi sqrt(ab) <= xi <= pi sqrt(ab) "
          "sqrt((a+b)/a)/(1-b), c = b beta; epsilon = pi/2 - psi_c(pi)",
      .method =
          "For all a > 0, 0 < b < 1, beta > -1: sqrt(ab) times the integrand is v (beta + cos^2 "
          "psi)^(-1/2) with (1-b) sqrt(a/(a+b)) <= v <= 1, so that xi, which grows by (beta + "
          "cos^2 psi)^(-1/2) |dpsi| along the motion, lies at phi = pi between the bounds; they "
          "have the limit pi sqrt(chi). In xi the motion is that of the limit: an elliptic "
          "function of xi, whose rate is sqrt(beta + cos^2 psi) <= sqrt(1+beta). For beta < 0 "
          "artanh(sin psi) grows by at most sqrt(1+beta), and where cos^2 psi >= 1/cosh^2(pi) by "
          "at least 1 - sqrt(-beta) cosh(pi), for each unit of xi. Computed: the polynomial "
          "steps.",
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
                         "(ds/dxi)^2 = (1-s^2)(1-(1+beta)s^2), the equation of sn(xi | 1+beta)"),
                not_negative(
                    "(1-u)*x - (x-u)", "u*y", "u > 0, y = 1-x >= 0",
                    "for beta = -u < 0 (d artanh(sin psi)/dxi)^2 = (beta + X)/X <= 1 + beta")},
      .tier = by_kernel,
      .argument = {in_coq("LimitFormula.limit_formula_oscillating"),
                   in_coq("LimitFormula.limit_formula_rotating"),
                   in_coq("LimitFormula.limit_equation_legendre"),
                   in_coq("LimitFormula.rate_vanishes"), in_coq("LimitFormula.limit_near_minimum"),
                   cited("sn(x | m) = sin am(x | m), where am is the inverse of F(phi | m) (DLMF "
                         "22.16(i)).")}};
}

}  // namespace polhode::statements
