// c0 decreases as a increases: the paper's lemma 4. The argument: proofs/arguments/
// c0_decreases.md.

#include "statements/c0_decreases.hpp"
#include "proofs/body_facts.hpp"
#include "proofs/claims.hpp"
#include "proofs/parameter_a.hpp"
#include "proofs/rotating_phase.hpp"

namespace polhode::proofs {
namespace {

certificate prove_c0(const request& wanted) {
  certificate c;
  add_steps(c, statements::c0_decreases().steps);
  const body rigid = requested_body(c, wanted);
  const body other = with_double_a(rigid);
  const auto first = bracket_rotating_phase_root(rigid, 2);
  const auto second = bracket_rotating_phase_root(other, 2);
  if (first && second) {
    c.facts.push_back({statements::fill(statements::smaller_c0_for_double_a, {in_decimals(*first)}),
                       passes_rotating_phase(rigid, 2, *first) &&
                           passes_rotating_phase(other, 2, *second) &&
                           other.a() * second->upper < rigid.a() * first->lower,
                       step_kind::enclosed});
    c.witness["c0_over_a"] = as_json(*first);
    c.witness["c0_over_a_for_2a"] = as_json(*second);
  } else if (exceeds_second_geometric_constant(2, rigid)) {
    note_missing_witness(c, statements::bracket_of_c0);
  } else {
    c.method += statements::there_is_no_c0;
  }
  c.conclude();
  return c;
}

}  // namespace

claim c0_decreases_claim() { return {statements::c0_decreases(), prove_c0}; }

}  // namespace polhode::proofs
