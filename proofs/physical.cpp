// A body is physical exactly where I >= 1: the paper's proposition 1. The argument:
// proofs/arguments/physical.md.

#include "statements/physical.hpp"
#include "proofs/body_facts.hpp"
#include "proofs/claims.hpp"
#include "proofs/exact_polynomial.hpp"

namespace polhode::proofs {
namespace {

int sign_of_rational(const rational& q) { return q > 0 ? 1 : q < 0 ? -1 : 0; }

void add_physical_body(certificate& c, const request& wanted) {
  const body rigid = requested_body(c, wanted);
  add_geometric_constant(c, rigid, wanted.digits);
  const rational& a = rigid.a().exact();
  const rational& b = rigid.b().exact();
  const rational x(1 / (1 - b));
  const rational z(1 / (1 + a));
  const rational excess(1 + z - x);
  const rational square((1 - b) * (1 - b) / (b * (a + b)));
  c.facts.push_back(
      {statements::fill(statements::kind_of_body,
                        {to_text(excess), to_text(rational(square - 1)), to_text(rigid.kind())}),
       sign_of_rational(excess) == sign_of_rational(square - 1) &&
           (rigid.kind() == body_kind::planar) == (excess == 0) &&
           (rigid.kind() == body_kind::physical) == (excess > 0),
       step_kind::exact});
}

certificate prove_physical(const request& wanted) {
  certificate c;
  add_steps(c, statements::physical().steps);
  add_physical_body(c, wanted);
  c.conclude();
  return c;
}

}  // namespace

claim physical_claim() { return {statements::physical(), prove_physical}; }

}  // namespace polhode::proofs
