// epsilon0 decreases as a increases: the paper's lemma 5. The argument:
// proofs/arguments/epsilon0_decreases.md.

#include "statements/epsilon0_decreases.hpp"
#include "proofs/body_facts.hpp"
#include "proofs/claims.hpp"
#include "proofs/parameter_a.hpp"
#include "proofs/separatrix.hpp"

namespace polhode::proofs {
namespace {

certificate prove_epsilon0(const request& wanted) {
  certificate c;
  add_steps(c, statements::epsilon0_decreases().steps);
  const body rigid = requested_body(c, wanted);
  const body other = with_double_a(rigid);
  add_number_or_note(
      c, "epsilon0", [&](precision p) { return separatrix_defect(rigid, p); }, wanted.digits,
      rigid);
  add_number_or_note(
      c, "epsilon0 for 2a", [&](precision p) { return separatrix_defect(other, p); }, wanted.digits,
      other);
  part_last_numbers(
      c, "epsilon0", [&](precision p) { return separatrix_defect(rigid, p); }, "epsilon0 for 2a",
      [&](precision p) { return separatrix_defect(other, p); });
  add_comparisons(
      c, statements::smaller_for_double_a, statements::order_for_double_a, [&](precision p) {
        return std::vector<comparison>{{separatrix_defect(other, p), separatrix_defect(rigid, p)}};
      });
  c.conclude();
  return c;
}

}  // namespace

claim epsilon0_decreases_claim() { return {statements::epsilon0_decreases(), prove_epsilon0}; }

}  // namespace polhode::proofs
