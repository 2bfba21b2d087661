// The perfect twist: the paper's proposition 3, part 2; and the full turn. The argument:
// proofs/arguments/perfect_twist.md.

#include "statements/perfect_twist.hpp"
#include "polhode/rigid_body/montgomery_phase.hpp"
#include "proofs/claims.hpp"
#include "proofs/rotating_phase.hpp"

namespace polhode::proofs {
namespace {

std::string in_pi(const rational& q) { return q == 1 ? "pi" : to_text(q) + " pi"; }

/// Whether (q+1)^2 a (a+b) - (a+1)^2 > 0. Where (J+1)^2 is rational without a and b, it is not
/// asked of these: it is a (a + b)((q+1)^2 - (J+1)^2).
bool has_positive_excess(const body& rigid, const exact_real& polynomial, const rational& q) {
  const exact_real square = rigid.square_of_second_constant();
  return square.is_rational() ? square < rational((q + 1) * (q + 1)) : polynomial.sign() > 0;
}

/// F(c,0) = q pi: has a root where the polynomial is positive, shown by a bracket, and else none.
void add_root(certificate& c, const body& rigid, const rational& q, const exact_real& polynomial,
              const std::string& what, const std::string& key) {
  const exact_real& a = rigid.a();
  const bool exists = exceeds_second_geometric_constant(q, rigid);
  c.facts.push_back({statements::fill(statements::root_exists_or_not,
                                      {std::string(exists ? "< " : ">= "), to_text(q),
                                       (exists ? "a " : "no "), what}),
                     exists == has_positive_excess(rigid, polynomial, q), step_kind::exact});
  if (!exists) {
    c.facts.push_back({statements::fill(statements::rotating_phase_stays_above, {to_text(q)}),
                       is_decided([&](precision p) {
                         const ball value = 2 * q * pi(p);
                         return certainly_less(value, montgomery_phase(rigid, a / 2, p)) &&
                                certainly_less(value, montgomery_phase(rigid, 3 * a / 4, p));
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
  const exact_real& a = rigid.a();
  const exact_real ab = a * rigid.b();
  add_root(c, rigid, 2, 8 * a * a + 9 * ab - 2 * a - 1, "perfect twist", "c0_over_a");
  add_root(c, rigid, 1, 3 * a * a + 4 * ab - 2 * a - 1, "full turn", "full_turn_c_over_a");
  c.conclude();
  return c;
}

}  // namespace

claim perfect_twist_claim() { return {statements::perfect_twist(), prove_perfect_twist}; }

}  // namespace polhode::proofs
