// The implicit equations of the curve C on every branch: the paper's eqs. (26) to (29) and its
// appendix B.
//
// psi_c and G as in turning_points.hpp, for -b < c < 0, u' = sin^2 epsilon = cos^2 psi_c(pi). After
// n intersections with S, that is for (n - 1/2) G < pi < (n + 1/2) G, let pi = n G + r, |r| < G/2.
// From psi_c(phi + G) = -psi_c(phi): psi_c(pi) = (-1)^n psi_c(r), where psi_c(r) has the sign of r
// and |r| = F(c,u')/2, since |r| is below the turning point G/2. So 2 pi = 2 n G + F(c,u') for r >=
// 0 and 2 n G - F(c,u') for r < 0; and epsilon <= pi/2 exactly where psi_c(pi) >= 0:
//   n odd:  r < 0 is epsilon < pi/2 (eq. 50), r >= 0 is epsilon >= pi/2 (eq. 51);
//   n even: r < 0 is epsilon > pi/2 (eq. 52), r >= 0 is epsilon <= pi/2 (eq. 53).
// n = 0, r = pi is the first equation, n = 1 the second, eqs. (28) and (29). The integral forms
// (48), (49) are the same: a sweep between the turning points is G, from one to psi = 0 it is G/2,
// and from psi = 0 to pi/2 - epsilon it is F/2 in absolute value. n odd: both end pieces are (G -
// F)/2 for epsilon < pi/2 and (G + F)/2 else; n even: (G + F)/2 for epsilon <= pi/2 and (G - F)/2
// else; the whole is (2n - 1) G and both.

#include "statements/implicit_equations.hpp"
#include "proofs/claims.hpp"
#include "proofs/exact_polynomial.hpp"

namespace polhode::proofs {
namespace {

certificate prove_equations(const request&) {
  certificate c;
  add_steps(c, statements::implicit_equations().steps);
  c.conclude();
  return c;
}

}  // namespace

claim implicit_equations_claim() { return {statements::implicit_equations(), prove_equations}; }

}  // namespace polhode::proofs
