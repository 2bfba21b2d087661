// c0 decreases as a increases: the paper's lemma 4. The proof is in parameter_a.hpp.

#include "proofs/body_facts.hpp"
#include "proofs/claims.hpp"
#include "proofs/parameter_a.hpp"
#include "proofs/rotating_phase.hpp"

namespace polhode::proofs {
namespace {

certificate prove_c0(const request& wanted) {
  certificate c;
  c.formula = "a < a'  =>  c0(a', b) < c0(a, b), where c0(a, b) exists";
  c.method =
      "For all a > 0, 0 < b < 1 with J < 2: the integrand of F(c,0) decreases strictly in a and in "
      "c. At c0(a) the integral for a' > a is below 2 pi, so its root c0(a') is smaller; it "
      "exists, "
      "as J decreases in a. Computed: the polynomial steps.";
  add_steps(c, decrease_in_a_steps());
  add_steps(
      c,
      {slope('c', "(1-b*x)^2", "(a+b*x)*(c+b*x)", "-(1-b*x)^2*(a+b*x)",
             "the derivative in c of the square of the integrand, negative"),
       slope('a', "(a+1)^2", "a*(a+b)", "-(a+1)*(a*(2-b)+b)", "the derivative in a of (J+1)^2"),
       positive("a*(2-b)+b", "a + a*q + b", "a > 0, b > 0, q = 1-b > 0", "so J decreases in a")});
  const body rigid = requested_body(c, wanted);
  const body other = with_double_a(rigid);
  const auto first = bracket_rotating_phase_root(rigid, 2);
  const auto second = bracket_rotating_phase_root(other, 2);
  if (first && second) {
    c.facts.push_back(
        {"at the given b, by the AGM: c0 for 2a is below c0 for the given a, c0/a lying "
         "between " +
             in_decimals(*first),
         passes_rotating_phase(rigid, 2, *first) && passes_rotating_phase(other, 2, *second) &&
             other.a().exact() * second->upper < rigid.a().exact() * first->lower,
         step_kind::enclosed});
    c.witness["c0_over_a"] = as_json(*first);
    c.witness["c0_over_a_for_2a"] = as_json(*second);
  } else if (exceeds_second_geometric_constant(2, rigid)) {
    note_missing_witness(c, "a bracket of c0");
  } else {
    c.method += " (At the given a, b J >= 2: there is no c0.)";
  }
  c.conclude();
  return c;
}

}  // namespace

claim c0_decreases_claim() {
  return {"lemma 4",
          "The perfect twist c0(a, b) decreases as a increases.",
          "exact derivatives of the integrand and their signs",
          prove_c0,
          proof_tier::by_kernel,
          {{step_kind::kernel, "DecreaseInA.lemma_4"}, bartky_transformation()}};
}

}  // namespace polhode::proofs
