// The Montgomery phase of oscillating motion: the paper's theorem 1. The argument:
// proofs/arguments/montgomery_oscillating.md.

#include "statements/montgomery_oscillating.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "proofs/claims.hpp"
#include "proofs/half_phase.hpp"

namespace polhode::proofs {
namespace {

void add_oscillating_body(certificate& c, const request& wanted) {
  const body rigid = requested_body(c, wanted);
  add_number(
      c, "greatest_lower_bound",
      [&](precision p) { return 2 * pi(p) * rigid.geometric_constant(p); }, wanted.digits, rigid);
  c.facts.push_back({statements::phase_keeps_its_bounds, half_phase_obeys_its_bounds(rigid),
                     step_kind::enclosed});
  const bool below_one = exceeds_geometric_constant(1, rigid);
  c.facts.push_back(
      {statements::fill(statements::bound_of_body,
                        {to_text(rigid.kind()), (below_one ? "below 2 pi" : "2 pi or more")}),
       below_one == (rigid.kind() == body_kind::non_physical), step_kind::exact});
}

certificate prove_oscillating(const request& wanted) {
  certificate c;
  add_steps(c, statements::montgomery_oscillating().steps);
  add_oscillating_body(c, wanted);
  c.conclude();
  return c;
}

}  // namespace

claim montgomery_oscillating_claim() {
  return {statements::montgomery_oscillating(), prove_oscillating};
}

}  // namespace polhode::proofs
