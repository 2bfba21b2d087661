// The limit a -> infinity for one b: the paper's section 7, "C is tangent to S in c = epsilon = 0", and its remark 2.
//
// For X = cos^2 psi > 0: 1 - b X < 1, a + b X > a, c + b X > c.
//   (1) F(0,u) < (ab)^(-1/2) integral from u to 1 of dx/(x sqrt(1-x)) = 2 artanh(sqrt(1-u))/sqrt(ab). At u = sin^2 epsilon0 it is 2 pi:
//       artanh(cos epsilon0) > pi sqrt(ab), and artanh(cos epsilon) = log cot(epsilon/2): epsilon0 < 2 arctan(e^(-pi sqrt(ab))).
//   (2) F(c,0) = 2 integral over (0, pi/2) of (1 - b X)/sqrt((a + b X)(c + b X)) dpsi < pi/sqrt(a c). At c0 it is 2 pi: c0 < 1/(4a).
//   (3) G(u) = b^(-1/2) integral over (0, pi) of g(x) dt (half_phase.hpp), g(x) = (1 - b x)/sqrt(x (a + b x)) < 1/sqrt(a u), as x >= u:
//       G(u) < pi/sqrt(a b u). Where C first meets S it is 2 pi: u1 < 1/(4ab), and c1 = -b u1 > -1/(4a).
// So for one b the points (c0, 0), (0, epsilon0) and (c1, epsilon1), sin^2 epsilon1 = u1, of C tend to (0, 0) as a -> infinity. epsilon0 > 0 for every
// body (separatrix_twist.cpp).

#include "proofs/claims.hpp"
#include "proofs/exact_polynomial.hpp"

namespace polhode::proofs {
namespace {

certificate prove_large_a(const request&) {
  certificate c;
  c.formula =
      "0 < epsilon0 < 2 arctan(e^(-pi sqrt(ab))), c0 < 1/(4a) where there is a c0, u1 < 1/(4ab) "
      "and -c1 < 1/(4a) where C meets S first";
  c.method =
      "For all a > 0, 0 < b < 1: 1 - bX < 1 and a + bX > a for X > 0, so that F(0,u) < 2 "
      "artanh(sqrt(1-u))/sqrt(ab), F(c,0) < pi/sqrt(ac) and G(u) < pi/sqrt(abu); each is 2 pi at "
      "epsilon0, c0 and u1. epsilon0 > 0 by the claim separatrix_twist. Computed: the polynomial "
      "steps.";
  add_steps(c, {positive("1 - (1-b*x)", "b*x", "b > 0, x > 0", "1 - bX < 1"),
                positive("(a+b*x) - a", "b*x", "b > 0, x > 0", "a + bX > a"),
                positive("(c+b*x) - c", "b*x", "b > 0, x > 0", "c + bX > c, for c > 0"),
                not_negative("(u+(1-u)*k) - u", "k*v", "k >= 0, v = 1-u >= 0",
                             "x = u + (1-u) k >= u in the integral G(u): g(x) < 1/sqrt(a u)")});
  c.conclude();
  return c;
}

}  // namespace

claim large_a_claim() {
  return {
      "section 7: after lemma 5, remark 2",
      "As a -> infinity for one b, epsilon0 -> 0, c0 -> 0 and the first point where C meets S "
      "tends to c = epsilon = 0; for no body is epsilon0 = 0: a perfect twist on the separatrix "
      "there is in this limit only.",
      "explicit bounds, by exact signs",
      prove_large_a,
      proof_tier::with_words,
      {{step_kind::kernel, "LargeA.perfect_twist_vanishes"},
       {step_kind::kernel, "LargeA.defect_vanishes"},
       {step_kind::argued,
        "An integral is below that of a greater integrand: that of 1/(sqrt(ab) x sqrt(1-x)) from u "
        "to 1 is 2 artanh(sqrt(1-u))/sqrt(ab), and artanh(cos epsilon) = log cot(epsilon/2)."},
       {step_kind::argued,
        "F(c,0) is twice the integral over 0 < psi < pi/2, and G is b^(-1/2) times that of g over "
        "0 < t < pi: bounds of their integrands give those of the integrals."},
       {step_kind::argued,
        "F(0,u) is 2 pi at one u in (0, 1), never at u = 0 (claim separatrix_twist): epsilon0 > "
        "0."}}};
}

}  // namespace polhode::proofs
