// The limits of F(-bu,u): the paper's lemma 7. The argument: proofs/arguments/
// half_phase_limits.md.

#include "statements/half_phase_limits.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "proofs/claims.hpp"
#include "proofs/half_phase.hpp"

namespace polhode::proofs {
namespace {

certificate prove_limits(const request& wanted) {
  certificate c;
  add_steps(c, statements::half_phase_limits().steps);
  const body rigid = requested_body(c, wanted);
  add_number(
      c, "limit", [&](precision p) { return pi(p) * rigid.geometric_constant(p); }, wanted.digits,
      rigid);
  c.facts.push_back(
      {statements::both_bounds_hold, half_phase_obeys_its_bounds(rigid), step_kind::enclosed});
  c.conclude();
  return c;
}

}  // namespace

claim half_phase_limits_claim() { return {statements::half_phase_limits(), prove_limits}; }

}  // namespace polhode::proofs
