// The limits of F(-bu,u): the paper's lemma 7. The proof is in half_phase.hpp.

#include "polhode/arithmetic/elementary.hpp"
#include "proofs/claims.hpp"
#include "proofs/half_phase.hpp"

namespace polhode::proofs {
namespace {

certificate prove_limits(const request& wanted) {
  certificate c;
  c.formula = "F(-bu,u) -> pi (1-b)/sqrt(b(a+b)) as u -> 1, F(-bu,u) -> infinity as u -> 0";
  c.method =
      "For all a > 0, 0 < b < 1, by the bounds pi I <= F(-bu,u) <= pi I g(u)/g(1) and F(-bu,u) >= "
      "2 I arsinh(pi/(2 sqrt(u))), g(x) = (1-bx)/sqrt(x(a+bx)): their steps are questions about "
      "polynomials, decided by expansion.";
  add_steps(c, half_phase_steps());
  const body rigid = requested_body(c, wanted);
  add_number(
      c, "limit", [&](precision p) { return pi(p) * rigid.geometric_constant(p); }, wanted.digits,
      rigid);
  c.facts.push_back(
      {"at the given a, b both bounds hold at u = 1/4, 1/2, 3/4 for the value by the "
       "AGM",
       half_phase_obeys_its_bounds(rigid), step_kind::enclosed});
  c.conclude();
  return c;
}

}  // namespace

claim half_phase_limits_claim() {
  return {"appendix A, lemma 7, eqs. (45)-(46)",
          "F(-bu,u) tends to pi I as u tends to 1, and to infinity as u tends to 0.",
          "explicit bounds on both sides, by exact signs",
          prove_limits,
          proof_tier::with_words,
          {{step_kind::argued,
            "As u tends to 1 both bounds tend to pi I; as u tends to 0 the lower one grows without "
            "bound."},
           bartky_transformation()}};
}

}  // namespace polhode::proofs
