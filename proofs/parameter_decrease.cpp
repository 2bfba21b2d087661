// c0 and epsilon0 decrease as a increases, b being fixed: the paper's lemmas 4 and 5.
//
// The integrand h = (1 - b X)/sqrt((a + b X)(c + b X)), X = cos^2 psi, is positive and decreases strictly in a, and in c.
// c0: F(c,0) = 2 integral of h over (0, pi/2) is 2 pi at c = c0(a). For a' > a it is below 2 pi at c0(a), which is in (0, a'); it
// decreases in c without bound at 0, so its root c0(a') exists and is below c0(a). (J decreases in a too: J < 2 for a gives it
// for a'.)
// epsilon0: F(0,u) = 2 integral of h over (0, psi), u = cos^2 psi, at c = 0, is 2 pi at u = sin^2 epsilon0(a). For a' > a it is below 2 pi
// there, and decreases in u: epsilon0(a') < epsilon0(a).

#include "proofs/claims.hpp"
#include "proofs/rotating_phase.hpp"
#include "proofs/separatrix.hpp"

namespace polhode::proofs {
namespace {

std::vector<polynomial_step> integrand_steps() {
  return {slope('a', "(1-b*x)^2", "(a+b*x)*(c+b*x)", "-(1-b*x)^2*(c+b*x)",
                "the derivative in a of the square of the integrand, negative"),
          positive("1-b*x", "q + b*y", "q = 1-b, y = 1-x",
                   "1 - bX > 0 for 0 <= X <= 1: the integrand is positive")};
}

/// The body with a doubled.
body with_double_a(const body& rigid) { return {rational(2 * rigid.a()), rigid.b()}; }

certificate prove_c0(const request& wanted) {
  certificate c;
  c.formula = "a < a'  =>  c0(a', b) < c0(a, b), where c0(a, b) exists";
  c.method =
      "For all a > 0, 0 < b < 1 with J < 2: the integrand of F(c,0) decreases strictly in a and in "
      "c. At c0(a) the integral for a' > a is below 2 pi, so its root c0(a') is smaller; it "
      "exists, "
      "as J decreases in a. Computed: the polynomial steps.";
  add_steps(c, integrand_steps());
  add_steps(
      c, {slope('c', "(1-b*x)^2", "(a+b*x)*(c+b*x)", "-(1-b*x)^2*(a+b*x)",
                "the derivative in c of the square of the integrand, negative"),
          slope('a', "(a+1)^2", "a*(a+b)", "-(a+1)*(a*(2-b)+b)", "the derivative in a of (J+1)^2"),
          positive("a*(2-b)+b", "a + a*q + b", "q = 1-b", "so J decreases in a")});
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
             other.a() * second->upper < rigid.a() * first->lower});
  } else if (exceeds_second_geometric_constant(2, rigid)) {
    note_missing_witness(c, "a bracket of c0");
  } else {
    c.method += " (At the given a, b J >= 2: there is no c0.)";
  }
  c.conclude();
  return c;
}

certificate prove_epsilon0(const request& wanted) {
  certificate c;
  c.formula = "a < a'  =>  epsilon0(a', b) < epsilon0(a, b)";
  c.method =
      "For all a > 0, 0 < b < 1: the integrand of F(0,u) decreases strictly in a, and F(0,u) "
      "decreases in u. At epsilon0(a) the integral for a' > a is below 2 pi, so its root is "
      "smaller. Computed: the polynomial steps.";
  add_steps(c, integrand_steps());
  const body rigid = requested_body(c, wanted);
  const body other = with_double_a(rigid);
  add_number(
      c, "epsilon0", [&](precision p) { return separatrix_defect(rigid, p); }, wanted.digits,
      rigid);
  add_number(
      c, "epsilon0 for 2a", [&](precision p) { return separatrix_defect(other, p); }, wanted.digits,
      other);
  c.facts.push_back(
      {"at the given b, by interval Newton: epsilon0 for 2a is below epsilon0 for the "
       "given a",
       is_decided([&](precision p) {
         return certainly_less(separatrix_defect(other, p), separatrix_defect(rigid, p));
       })});
  c.conclude();
  return c;
}

}  // namespace

claim c0_decreases_claim() {
  return {"c0_decreases",
          "lemma 4",
          "The perfect twist c0(a, b) decreases as a increases.",
          "exact derivatives of the integrand and their signs",
          claim_subject::body,
          prove_c0};
}

claim epsilon0_decreases_claim() {
  return {"epsilon0_decreases",
          "lemma 5",
          "The twist defect on the separatrix, epsilon0(a, b), decreases as a increases.",
          "exact derivatives of the integrand and their signs",
          claim_subject::body,
          prove_epsilon0};
}

}  // namespace polhode::proofs
