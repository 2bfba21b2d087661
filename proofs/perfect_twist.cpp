// The perfect twist: the paper's proposition 3, part 2; and the full turn. The argument:
// proofs/arguments/perfect_twist.md.

#include "statements/perfect_twist.hpp"
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
  c.facts.push_back({statements::fill(statements::root_exists_or_not,
                                      {std::string(exists ? "< " : ">= "), to_text(q),
                                       (exists ? "a " : "no "), what}),
                     exists == (polynomial > 0), step_kind::exact});
  if (!exists) {
    c.facts.push_back(
        {statements::fill(statements::rotating_phase_stays_above, {to_text(q)}),
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
    note_missing_witness(c, statements::fill(statements::bracket_of_root, {what}));
    return;
  }
  c.facts.push_back(
      {statements::fill(statements::rotating_phase_passes, {in_pi(q), in_decimals(*bracket)}),
       passes_rotating_phase(rigid, q, *bracket), step_kind::enclosed});
  c.witness[key] = as_json(*bracket);
}

certificate prove_perfect_twist(const request& wanted) {
  certificate c;
  add_steps(c, statements::perfect_twist().steps);
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

claim perfect_twist_claim() { return {statements::perfect_twist(), prove_perfect_twist}; }

}  // namespace polhode::proofs
