// The Montgomery phase of rotating motion: the paper's theorem 2. The argument:
// proofs/arguments/montgomery_rotating.md.

#include "statements/montgomery_rotating.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "proofs/claims.hpp"
#include "proofs/rotating_phase.hpp"

namespace polhode::proofs {
namespace {

certificate prove_rotating(const request& wanted) {
  certificate c;
  add_steps(c, statements::montgomery_rotating().steps);
  const body rigid = requested_body(c, wanted);
  add_number(
      c, "greatest_lower_bound",
      [&](precision p) { return 2 * pi(p) * rigid.second_geometric_constant(p); }, wanted.digits,
      rigid);
  c.facts.push_back({statements::rotating_phase_keeps_its_bounds,
                     rotating_phase_obeys_its_bounds(rigid), step_kind::enclosed});
  c.conclude();
  return c;
}

}  // namespace

claim montgomery_rotating_claim() { return {statements::montgomery_rotating(), prove_rotating}; }

}  // namespace polhode::proofs
