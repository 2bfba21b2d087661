// The limit a -> infinity, b -> 0: the paper's section 7, eqs. (33) to (38).
//
// With X = cos^2 psi, c = b beta: sqrt(ab) h = v (beta + X)^(-1/2), where v^2 = a (1 - b X)^2/(a +
// b X) and a (1-b)^2/(a+b) <= v^2 <= 1. Along the motion let xi grow by (beta + X)^(-1/2) |dpsi|,
// from 0 at phi = 0. As dphi = h |dpsi|,
//   dxi = sqrt(ab)/v dphi,  so that  pi sqrt(ab) <= xi(pi) <= pi sqrt(ab) sqrt((a+b)/a)/(1-b),
// through turning points as well: the integral of (beta + X)^(-1/2) up to one is finite.
//
// psi as a function of xi is the same for all bodies. beta >= 0: psi increases, xi = F(psi |
// 1/(1+beta))/sqrt(1+beta), since beta + cos^2 = (1+beta)(1 - sin^2/(1+beta)). -1 < beta < 0: with
// sin psi = sqrt(1+beta) s, beta + X = (1+beta)(1-s^2), and cos psi psi' = sqrt(1+beta) s' with
// psi'^2 = beta + X gives s'^2 = (1-s^2)(1-(1+beta)s^2), s = 0 at xi = 0: s = sn(xi | 1+beta) up to
// the turning point s = 1, xi = K. There phi = G/2. For the phi beyond: psi_c is odd and psi_c(phi
// + G) = -psi_c(phi) (turning_points.hpp), so that the growth of xi has the period G and is even in
// phi: xi(phi + G) = xi(phi) + 2K, xi is odd. sn is odd, and sn(xi + 2K) = -sn xi: both sides of
// sin psi_c = sqrt(1+beta) sn(xi | 1+beta) change in the same way, and it holds for every phi.
//
// In the limit xi(pi) -> pi sqrt(chi), and epsilon = pi/2 - psi_c(pi) tends to pi/2 - am(pi
// sqrt(chi (1+beta)) | 1/(1+beta)), the paper's eq. (38), or for beta < 0 to pi/2 -
// arcsin(sqrt(1+beta) sn(pi sqrt(chi) | 1+beta)), which is the same up to the turning point and
// what sn gives beyond it (sn(x | m) = sn(x sqrt(m) | 1/m)/sqrt(m), DLMF 22.17.2). This is how
// figure 8 is drawn, to beta = -0.2.

#include "statements/limit_formula.hpp"
#include "proofs/claims.hpp"
#include "proofs/exact_polynomial.hpp"

namespace polhode::proofs {
namespace {

certificate prove_limit(const request&) {
  certificate c;
  add_steps(c, statements::limit_formula().steps);
  c.conclude();
  return c;
}

}  // namespace

claim limit_formula_claim() { return {statements::limit_formula(), prove_limit}; }

}  // namespace polhode::proofs
