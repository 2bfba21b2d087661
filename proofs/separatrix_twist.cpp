// The tennis racket effect on the separatrix: the paper's proposition 3, part 1. The argument:
// proofs/arguments/separatrix_twist.md.

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
  const exact_real product = rigid.a() * rigid.b();
  const exact_real ratio = rigid.b() / rigid.a();
  const exact_real share = rigid.a() / (rigid.a() + rigid.b());
  const auto f = [&](const ball& y) {
    const precision q = y.precision();
    return y / sqrt(product.at(q)) - atan(sqrt(ratio.at(q)) * tanh(y)) - pi(q);
  };
  const auto derivative = [&](const ball& y) {
    const precision q = y.precision();
    const ball s = 1 / square(cosh(y));
    return (1 - rigid.b().at(q) * s / (1 + ratio.at(q) * square(tanh(y)))) / sqrt(product.at(q));
  };
  const ball scale = sqrt(product.at(p));
  const ball box = hull(scale * pi(p), scale * (pi(p) + atan(sqrt(ratio.at(p)))));
  const root_enclosure y = refine_root(f, derivative, box, p);
  if (y.verdict != root_verdict::unique) return ball::undefined(p);
  return atan(sqrt(share.at(p)) / sinh(y.root));
}

claim separatrix_twist_claim() { return {statements::separatrix_twist(), prove_separatrix}; }

}  // namespace polhode::proofs
