// The implicit equations of the curve C on every branch: the paper's eqs. (26) to (29) and its appendix B.
//
// psi_c and G as in turning_points.hpp, for -b < c < 0, u' = sin^2 epsilon = cos^2 psi_c(pi). After n intersections with S, that is for
// (n - 1/2) G < pi < (n + 1/2) G, let pi = n G + r, |r| < G/2. From psi_c(phi + G) = -psi_c(phi): psi_c(pi) = (-1)^n psi_c(r), where psi_c(r) has
// the sign of r and |r| = F(c,u')/2, since |r| is below the turning point G/2. So 2 pi = 2 n G + F(c,u') for r >= 0 and
// 2 n G - F(c,u') for r < 0; and epsilon <= pi/2 exactly where psi_c(pi) >= 0:
//   n odd:  r < 0 is epsilon < pi/2 (eq. 50), r >= 0 is epsilon >= pi/2 (eq. 51);
//   n even: r < 0 is epsilon > pi/2 (eq. 52), r >= 0 is epsilon <= pi/2 (eq. 53).
// n = 0, r = pi is the first equation, n = 1 the second, eqs. (28) and (29).
// The integral forms (48), (49) are the same: a sweep between the turning points is G, from one to psi = 0 it is G/2, and from psi = 0 to
// pi/2 - epsilon it is F/2 in absolute value. n odd: both end pieces are (G - F)/2 for epsilon < pi/2 and (G + F)/2 else;
// n even: (G + F)/2 for epsilon <= pi/2 and (G - F)/2 else; the whole is (2n - 1) G and both.

#include "proofs/claims.hpp"
#include "proofs/exact_polynomial.hpp"

namespace polhode::proofs {
namespace {

certificate prove_equations(const request&) {
  certificate c;
  c.formula =
      "2n G - F(c,u') = 2 pi (n odd, epsilon < pi/2; n even, epsilon > pi/2), 2n G + F(c,u') = 2 "
      "pi "
      "(n odd, epsilon >= pi/2; n even, epsilon <= pi/2), G = F(c,-c/b), u' = sin^2 epsilon";
  c.method =
      "For all a > 0, 0 < b < 1, -b < c < 0: by the symmetries of the reduced system psi_c(phi + "
      "G) = -psi_c(phi) and psi_c is odd; with pi = nG + r, |r| <= G/2, psi_c(pi) = (-1)^n "
      "psi_c(r) and |r| = F(c,u')/2, and the four cases are those of the signs of (-1)^n and r. "
      "The integral forms consist of 2n-1 whole sweeps G and two end pieces (G +- F)/2. Computed: "
      "the sums below.";
  add_steps(
      c,
      {identity("2*(n*g+r)", "2*n*g + 2*r", "2 pi = 2nG + 2r, with 2r = F or 2r = -F"),
       identity(
           "2*(2*n-1)*g + 2*(g-f)", "2*(2*n*g - f)",
           "eq. (48), epsilon < pi/2, gives eq. (50); eq. (49), epsilon > pi/2, gives eq. (52) "
           "(twice both sides)"),
       identity("2*(2*n-1)*g + 2*(g+f)", "2*(2*n*g + f)",
                "eq. (48), epsilon >= pi/2, gives eq. (51); eq. (49), epsilon <= pi/2, gives eq. "
                "(53)"),
       identity("2*(2*1-1)*g + 2*(g-f)", "2*(2*g - f)", "n = 1: the second equation, eq. (28)"),
       identity("2*(2*1-1)*g + 2*(g+f)", "2*(2*g + f)", "n = 1: eq. (29)")});
  c.conclude();
  return c;
}

}  // namespace

claim implicit_equations_claim() {
  return {
      "appendix B, eqs. (48)-(53)",
      "After n intersections of C and S the curve C is given by one of four implicit equations, "
      "by the parity of n and the side of pi/2 on which epsilon is.",
      "symmetries of the motion; sums of the sweeps",
      prove_equations,
      proof_tier::by_argument,
      {{step_kind::kernel, "Symmetry.psi_odd"},
       {step_kind::kernel, "Symmetry.half_phase_symmetry"},
       {step_kind::argued,
        "With pi = nG + r, |r| <= G/2: psi_c(pi) = (-1)^n psi_c(r), |r| = F(c,u')/2, and the four "
        "cases are those of the signs of (-1)^n and r."},
       {step_kind::kernel, "Uniqueness.motion_unique"}}};
}

}  // namespace polhode::proofs
