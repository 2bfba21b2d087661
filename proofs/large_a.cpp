// The limit a -> infinity for one b: the paper's section 7, "C is tangent to S in c = epsilon = 0",
// and its remark 2.
//
// For X = cos^2 psi > 0: 1 - b X < 1, a + b X > a, c + b X > c.
//   (1) F(0,u) < (ab)^(-1/2) integral from u to 1 of dx/(x sqrt(1-x)) = 2
//       artanh(sqrt(1-u))/sqrt(ab). At u = sin^2 epsilon0 it is 2 pi: artanh(cos epsilon0) > pi
//       sqrt(ab), and artanh(cos epsilon) = log cot(epsilon/2): epsilon0 < 2 arctan(e^(-pi
//       sqrt(ab))).
//   (2) F(c,0) = 2 integral over (0, pi/2) of (1 - b X)/sqrt((a + b X)(c + b X)) dpsi < pi/sqrt(a
//       c). At c0 it is 2 pi: c0 < 1/(4a).
//   (3) G(u) = b^(-1/2) integral over (0, pi) of g(x) dt (half_phase.hpp), g(x) = (1 - b x)/sqrt(x
//       (a + b x)) < 1/sqrt(a u), as x >= u: G(u) < pi/sqrt(a b u). Where C first meets S it is 2
//       pi: u1 < 1/(4ab), and c1 = -b u1 > -1/(4a).
// So for one b the points (c0, 0), (0, epsilon0) and (c1, epsilon1), sin^2 epsilon1 = u1, of C tend
// to (0, 0) as a -> infinity. epsilon0 > 0 for every body (separatrix_twist.cpp).

#include "statements/large_a.hpp"
#include "proofs/claims.hpp"
#include "proofs/exact_polynomial.hpp"

namespace polhode::proofs {
namespace {

certificate prove_large_a(const request&) {
  certificate c;
  add_steps(c, statements::large_a().steps);
  c.conclude();
  return c;
}

}  // namespace

claim large_a_claim() { return {statements::large_a(), prove_large_a}; }

}  // namespace polhode::proofs
