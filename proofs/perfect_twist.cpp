// The perfect twist: the paper's proposition 3, part 2; and the full turn.
//
// epsilon = 0 is u = 0, where F(c,u) = 2 pi needs b u + c >= 0: c >= 0, and c > 0 since F(0,0) is infinite. F(c,0) maps (0, a) one to
// one onto (pi J, infinity) (rotating_phase.hpp). So c0 with F(c0,0) = 2 pi exists in (0, a) exactly where J < 2, and is the only
// one; at J = 2 the value 2 pi is the limit at c = a, an equilibrium. (The paper says "in (-b, a)": it is in (0, a).) In the same way the
// phase 2 F(c,0) of rotating motion takes the value 2 pi, a full turn, exactly where J < 1.

#include "polhode/rigid_body/montgomery_phase.hpp"
#include "proofs/claims.hpp"
#include "proofs/rotating_phase.hpp"

namespace polhode::proofs {
namespace {

std::string in_pi(const rational& q) { return q == 1 ? "pi" : to_text(q) + " pi"; }

/// F(c,0) = q pi: has a root where the polynomial is positive, shown by a bracket, and else none.
void add_root(certificate& c, const body& rigid, const rational& q, const rational& polynomial,
              const std::string& what, const std::string& key) {
  const rational& a = rigid.a().exact();
  const bool exists = exceeds_second_geometric_constant(q, rigid);
  c.facts.push_back({"at the given a, b, in rationals: J " + std::string(exists ? "< " : ">= ") +
                         to_text(q) + ", so there is " + (exists ? "a " : "no ") + what,
                     exists == (polynomial > 0), step_kind::exact});
  if (!exists) {
    c.facts.push_back(
        {"at the given a, b, by the AGM: F(c,0) > " + to_text(q) + " pi at c = a/2 and 3a/4",
         is_decided([&](precision p) {
           const ball value = 2 * q * pi(p);
           return certainly_less(value, montgomery_phase(rigid, rational(a / 2), p)) &&
                  certainly_less(value, montgomery_phase(rigid, rational(3 * a / 4), p));
         }),
         step_kind::enclosed});
    return;
  }
  const auto bracket = bracket_rotating_phase_root(rigid, q);
  if (!bracket) {
    c.witness[key] = nullptr;
    note_missing_witness(c, "a bracket of the " + what);
    return;
  }
  c.facts.push_back({"at the given a, b, by the AGM: F(c,0) passes " + in_pi(q) +
                         " between c/a = " + in_decimals(*bracket),
                     passes_rotating_phase(rigid, q, *bracket), step_kind::enclosed});
  c.witness[key] = as_json(*bracket);
}

certificate prove_perfect_twist(const request& wanted) {
  certificate c;
  c.formula = "F(c0,0) = 2 pi for some c0  <=>  J < 2; then c0 is in (0, a) and the only one";
  c.method =
      "For all a > 0, 0 < b < 1, by the proof of montgomery_rotating: F(c,0) maps 0 < c < a one to "
      "one onto the values above pi J, and F(c,u) is defined at u = 0 for c > 0 only. So 2 pi is a "
      "value exactly where J < 2 (and the phase 2 F(c,0) has the value 2 pi, a full turn, exactly "
      "where J < 1). For a given body J < 2 is decided in rationals.";
  add_steps(c, rotating_phase_steps());
  add_steps(c, {identity("9*a*(a+b) - (a+1)^2", "8*a^2 + 9*a*b - 2*a - 1",
                         "J < 2 exactly where this is positive, as (J+1)^2 = (a+1)^2/(a(a+b))"),
                identity("4*a*(a+b) - (a+1)^2", "3*a^2 + 4*a*b - 2*a - 1",
                         "J < 1 exactly where this is positive")});
  const body rigid = requested_body(c, wanted);
  add_second_geometric_constant(c, rigid, wanted.digits);
  const rational& a = rigid.a().exact();
  const rational ab(a * rigid.b().exact());
  add_root(c, rigid, 2, rational(8 * a * a + 9 * ab - 2 * a - 1), "perfect twist", "c0_over_a");
  add_root(c, rigid, 1, rational(3 * a * a + 4 * ab - 2 * a - 1), "full turn",
           "full_turn_c_over_a");
  c.conclude();
  return c;
}

}  // namespace

claim perfect_twist_claim() {
  return {
      "proposition 3, part 2",
      "A perfect twist, epsilon = 0, occurs if and only if J < 2, at exactly one c0, which lies "
      "in (0, a).",
      "one-to-one map onto (pi J, infinity), by exact signs; J < 2 in rationals",
      prove_perfect_twist,
      proof_tier::by_kernel,
      {{step_kind::kernel, "Separatrix.proposition_3_2"},
       {step_kind::kernel, "Theorems.rotating_phase_at"},
       {step_kind::kernel, "Theorems.rotating_phase_decreases"},
       bartky_transformation()}};
}

}  // namespace polhode::proofs
