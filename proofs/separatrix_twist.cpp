// The tennis racket effect on the separatrix: the paper's proposition 3, part 1.
//
// F(0,u) = integral from u to 1 of f(x) dx, f(x) = (1 - b x)/(sqrt(b) x sqrt((1-x)(a + b x))), 0 <
// u < 1.
//   (1) f > 0: F(0,u) decreases strictly, and it is continuous.
//   (2) f(x) >= I/x, since 1 - b x >= 1 - b, a + b x <= a + b, 1 - x <= 1: F(0,u) >= I log(1/u),
//       without bound as u -> 0.
//   (3) F(0,u) = 2 artanh(sqrt(a) w)/sqrt(ab) - 2 arctan(sqrt(b) w) with w^2 = (1-u)/(a + b u),
//       which tends to 0 as u -> 1: w' = -(a+b)/(2 w (a + b x)^2), 1 - a w^2 = (a+b) x/(a + b x), 1
//       + b w^2 = (a+b)/(a + b x), so that 2 (1/(sqrt(b)(1 - a w^2)) - sqrt(b)/(1 + b w^2)) w' =
//       -(1 - b x)/(sqrt(b) x w (a + b x)) = -f(x).
// So F(0,u) = 2 pi has exactly one root u in (0, 1), for every body.
//
// The number: with tanh y = sqrt(a) w the equation is y/sqrt(ab) - arctan(sqrt(b/a) tanh y) = pi,
// whose left side has the derivative (1 - b s/(1 + (b/a) tanh^2 y))/sqrt(ab) >= (1 - b)/sqrt(ab) >
// 0, s = 1/cosh^2 y, and whose arctan lies in (0, arctan sqrt(b/a)). u/(1-u) = s/((1 + b/a) tanh^2
// y), and so tan epsilon0 = sqrt(a/(a+b))/sinh y: nothing cancels.

#include "statements/separatrix_twist.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/rigid_body/montgomery_phase.hpp"
#include "polhode/roots/newton.hpp"
#include "proofs/body_facts.hpp"
#include "proofs/claims.hpp"
#include "proofs/exact_polynomial.hpp"
#include "proofs/separatrix.hpp"

namespace polhode::proofs {
namespace {

certificate prove_separatrix(const request& wanted) {
  certificate c;
  add_steps(c, statements::separatrix_twist().steps);
  const body rigid = requested_body(c, wanted);
  add_number_or_note(
      c, "epsilon0", [&](precision p) { return separatrix_defect(rigid, p); }, wanted.digits,
      rigid);
  c.conclude();
  return c;
}

}  // namespace

ball separatrix_defect(const body& rigid, precision p) {
  const rational product(rigid.a().exact() * rigid.b().exact());
  const rational ratio(rigid.b().exact() / rigid.a().exact());
  const rational share(rigid.a().exact() / (rigid.a().exact() + rigid.b().exact()));
  const auto f = [&](const ball& y) {
    const precision q = y.precision();
    return y / sqrt(ball(product, q)) - atan(sqrt(ball(ratio, q)) * tanh(y)) - pi(q);
  };
  const auto derivative = [&](const ball& y) {
    const precision q = y.precision();
    const ball s = 1 / square(cosh(y));
    return (1 - ball(rigid.b().exact(), q) * s / (1 + ball(ratio, q) * square(tanh(y)))) /
           sqrt(ball(product, q));
  };
  const ball scale = sqrt(ball(product, p));
  const ball box = hull(scale * pi(p), scale * (pi(p) + atan(sqrt(ball(ratio, p)))));
  const root_enclosure y = refine_root(f, derivative, box, p);
  if (y.verdict != root_verdict::unique) return ball::undefined(p);
  return atan(sqrt(ball(share, p)) / sinh(y.root));
}

claim separatrix_twist_claim() { return {statements::separatrix_twist(), prove_separatrix}; }

}  // namespace polhode::proofs
