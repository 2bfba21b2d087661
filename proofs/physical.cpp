// A body is physical exactly where I >= 1: the paper's proposition 1. The argument:
// proofs/arguments/physical.md.

#include "statements/physical.hpp"
#include "proofs/body_facts.hpp"
#include "proofs/claims.hpp"
#include "proofs/exact_polynomial.hpp"

namespace polhode::proofs {
namespace {

void add_physical_body(certificate& c, const request& wanted) {
  const body rigid = requested_body(c, wanted);
  add_geometric_constant(c, rigid, wanted.digits);
  const exact_real x = 1 / (1 - rigid.b());
  const exact_real z = 1 / (1 + rigid.a());
  const exact_real above = rigid.square_of_geometric_constant() - 1;
  // Of a planar body with irrational a and b it is 0 as well: the tensor says so, and I^2.
  const bool is_planar = rigid.kind() == body_kind::planar;
  const exact_real excess = is_planar && !rigid.a().is_rational() ? 0 : 1 + z - x;
  c.facts.push_back({statements::fill(statements::kind_of_body,
                                      {to_text(excess), to_text(above), to_text(rigid.kind())}),
                     excess.sign() == above.sign() && is_planar == (excess.sign() == 0) &&
                         (rigid.kind() == body_kind::physical) == (excess.sign() > 0),
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
