// epsilon0 decreases as a increases: the paper's lemma 5. The proof is in parameter_a.hpp.

#include "proofs/body_facts.hpp"
#include "proofs/claims.hpp"
#include "proofs/parameter_a.hpp"
#include "proofs/separatrix.hpp"

namespace polhode::proofs {
namespace {

certificate prove_epsilon0(const request& wanted) {
  certificate c;
  c.formula = "a < a'  =>  epsilon0(a', b) < epsilon0(a, b)";
  c.method =
      "For all a > 0, 0 < b < 1: the integrand of F(0,u) decreases strictly in a, and F(0,u) "
      "decreases in u. At epsilon0(a) the integral for a' > a is below 2 pi, so its root is "
      "smaller. Computed: the polynomial steps.";
  add_steps(c, decrease_in_a_steps());
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
      c,
      "at the given b, by interval Newton: epsilon0 for 2a is below epsilon0 for the "
      "given a",
      "the order of epsilon0 for a and 2a", [&](precision p) {
        return std::vector<comparison>{{separatrix_defect(other, p), separatrix_defect(rigid, p)}};
      });
  c.conclude();
  return c;
}

}  // namespace

claim epsilon0_decreases_claim() {
  return {"lemma 5",
          "The twist defect on the separatrix, epsilon0(a, b), decreases as a increases.",
          "exact derivatives of the integrand and their signs",
          prove_epsilon0,
          proof_tier::by_kernel,
          {{step_kind::kernel, "DecreaseInA.lemma_5"}}};
}

}  // namespace polhode::proofs
