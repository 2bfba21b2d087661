// The limit a -> infinity, b -> 0: the paper's section 7, eqs. (33) to (38).
//
// With X = cos^2 psi, c = b beta: sqrt(ab) h = v (beta + X)^(-1/2), where v^2 = a (1 - b X)^2/(a + b X) and
// a (1-b)^2/(a+b) <= v^2 <= 1. Along the motion let xi grow by (beta + X)^(-1/2) |dpsi|, from 0 at phi = 0. As dphi = h |dpsi|,
//   dxi = sqrt(ab)/v dphi,  so that  pi sqrt(ab) <= xi(pi) <= pi sqrt(ab) sqrt((a+b)/a)/(1-b),
// through turning points as well: the integral of (beta + X)^(-1/2) up to one is finite.
//
// psi as a function of xi is the same for all bodies. beta >= 0: psi increases, xi = F(psi | 1/(1+beta))/sqrt(1+beta), since
// beta + cos^2 = (1+beta)(1 - sin^2/(1+beta)). -1 < beta < 0: with sin psi = sqrt(1+beta) s, beta + X = (1+beta)(1-s^2), and
// cos psi psi' = sqrt(1+beta) s' with psi'^2 = beta + X gives s'^2 = (1-s^2)(1-(1+beta)s^2), s = 0 at xi = 0: s = sn(xi | 1+beta) up to
// the turning point s = 1, xi = K. There phi = G/2. For the phi beyond: psi_c is odd and psi_c(phi + G) = -psi_c(phi)
// (turning_points.hpp), so that the growth of xi has the period G and is even in phi: xi(phi + G) = xi(phi) + 2K, xi is odd. sn is odd, and
// sn(xi + 2K) = -sn xi: both sides of sin psi_c = sqrt(1+beta) sn(xi | 1+beta) change in the same way, and it holds for every phi.
//
// In the limit xi(pi) -> pi sqrt(chi), and epsilon = pi/2 - psi_c(pi) tends to pi/2 - am(pi sqrt(chi (1+beta)) | 1/(1+beta)), the paper's
// eq. (38), or for beta < 0 to pi/2 - arcsin(sqrt(1+beta) sn(pi sqrt(chi) | 1+beta)), which is the same up to the turning point and what
// sn gives beyond it (sn(x | m) = sn(x sqrt(m) | 1/m)/sqrt(m), DLMF 22.17.2). This is how figure 8 is drawn, to beta = -0.2.

#include "proofs/claims.hpp"
#include "proofs/exact_polynomial.hpp"

namespace polhode::proofs {
namespace {

polynomial_step upper_step() {
  return not_negative("(a+b*x) - a*(1-b*x)^2", "b*x + a*b*x*(1+q+b*y)",
                      "a > 0, b > 0, x >= 0, q = 1-b > 0, y = 1-x >= 0",
                      "v^2 = a(1-bX)^2/(a+bX) <= 1");
}

certificate prove_limit(const request&) {
  certificate c;
  c.formula =
      "sin psi_c(pi) = sqrt(1+beta) sn(xi | 1+beta) for -1 < beta < 0, psi_c(pi) = am(sqrt(1+beta) "
      "xi | 1/(1+beta)) for beta >= 0, with pi sqrt(ab) <= xi <= pi sqrt(ab) sqrt((a+b)/a)/(1-b), "
      "c = b beta; epsilon = pi/2 - psi_c(pi)";
  c.method =
      "For all a > 0, 0 < b < 1, beta > -1: sqrt(ab) times the integrand is v (beta + cos^2 "
      "psi)^(-1/2) with (1-b) sqrt(a/(a+b)) <= v <= 1, so that xi, which grows by (beta + cos^2 "
      "psi)^(-1/2) |dpsi| along the motion, lies at phi = pi between the bounds; they have the "
      "limit pi sqrt(chi). In xi the motion is that of the limit: an elliptic function of xi. "
      "Computed: the polynomial steps.";
  add_steps(c, {upper_step(),
                not_negative("(1-b*x) - (1-b)", "b*y", "b > 0, y = 1-x >= 0", "1 - bX >= 1 - b"),
                not_negative("(a+b) - (a+b*x)", "b*y", "b > 0, y = 1-x >= 0",
                             "a + bX <= a + b, so that v^2 >= a(1-b)^2/(a+b)"),
                identity("d + (1-s)", "(1+d) - s",
                         "beta + cos^2 = (1+beta)(1 - sin^2/(1+beta)): the limit form is "
                         "F(psi | 1/(1+beta))/sqrt(1+beta)"),
                identity("d + (1-(1+d)*s^2)", "(1+d)*(1-s^2)",
                         "with sin psi = sqrt(1+beta) s: beta + cos^2 = (1+beta)(1-s^2), so that "
                         "(ds/dxi)^2 = (1-s^2)(1-(1+beta)s^2), the equation of sn(xi | 1+beta)")});
  c.conclude();
  return c;
}

}  // namespace

claim limit_formula_claim() {
  return {
      "eqs. (33)-(38)",
      "As a -> infinity, b -> 0 with ab -> chi > 0 and c/b = beta > -1, epsilon tends to pi/2 - "
      "am(pi sqrt(chi(1+beta)) | 1/(1+beta)), where for beta < 0 the amplitude is the psi with sin "
      "psi = sqrt(1+beta) sn(pi sqrt(chi) | 1+beta), |psi| < pi/2, before the first turning point "
      "and beyond it.",
      "two-sided bound of the integrand, by exact signs; symmetries of the motion",
      prove_limit,
      proof_tier::by_argument,
      {{step_kind::argued,
        "Along the motion sqrt(ab) dphi = v dxi at every psi between the turning points, which are "
        "passed in finite time, so that the bounds of v are those of xi(pi) against pi sqrt(ab)."},
       {step_kind::argued,
        "For beta < 0: sin psi = sqrt(1+beta) sn(xi | 1+beta) up to the first turning point, xi = "
        "K(1+beta), by the equation of sn; beyond it, as psi_c(phi + G) = -psi_c(phi) and psi_c is "
        "odd, xi grows by 2K in every G, and sn is odd with sn(xi + 2K) = -sn xi. For beta >= 0 "
        "psi increases, and xi = F(psi | 1/(1+beta))/sqrt(1+beta) defines am."},
       {step_kind::argued,
        "sn and am are continuous in xi, so that psi_c(pi) tends to its value at pi sqrt(chi)."},
       {step_kind::kernel, "Symmetry.psi_odd"},
       {step_kind::kernel, "Symmetry.half_phase_symmetry"},
       {step_kind::kernel, "LimitFormula.limit_formula"},
       {step_kind::cited, "sn(x + 2K | m) = -sn(x | m) (DLMF 22.4(iii))."},
       {step_kind::cited,
        "Solutions of ordinary differential equations exist, are unique (Picard and Lindeloef) and "
        "depend continuously on their data."}}};
}

}  // namespace polhode::proofs
