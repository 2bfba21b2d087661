// What the limit a -> infinity, b -> 0 says of physical bodies: the paper's section 7, eqs. (39)
// and (40). The argument: proofs/arguments/limit_minimum.md.

#include "statements/limit_minimum.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "proofs/beta.hpp"
#include "proofs/claims.hpp"
#include "proofs/half_phase.hpp"
#include "proofs/rotating_phase.hpp"
#include "proofs/separatrix.hpp"

namespace polhode::proofs {
namespace {

void add_physical_body(certificate& c, const body& rigid, const ball& beta) {
  if (rigid.kind() == body_kind::non_physical) {
    c.method += statements::bounds_are_for_physical_bodies;
    return;
  }
  const precision p = beta.precision();
  add_comparisons(
      c, statements::fill(statements::epsilon0_is_above, {to_text(rigid.kind())}),
      statements::order_of_epsilon0_and_least, [&](precision q) {
        return std::vector<comparison>{{2 * atan(exp(-pi(q))), separatrix_defect(rigid, q)}};
      });
  if (!exceeds_second_geometric_constant(2, rigid)) {
    c.method += statements::there_is_no_c0;
    return;
  }
  const auto bracket = bracket_rotating_phase_root(rigid, 2);
  if (!bracket) {
    note_missing_witness(c, statements::bracket_of_c0);
    return;
  }
  const auto over_b = [&](const rational& s) { return (rigid.a() * s / rigid.b()).at(p); };
  const bool above = certainly_less(beta, over_b(bracket->lower));
  if (!above && !certainly_less(over_b(bracket->upper), beta)) {
    note_missing_witness(c, statements::bracket_of_c0_on_one_side);
    return;
  }
  c.witness["c0_over_a"] = as_json(*bracket);
  c.facts.push_back({statements::fill(statements::c0_is_above, {in_decimals(*bracket)}),
                     above && passes_rotating_phase(rigid, 2, *bracket), step_kind::enclosed});
}

certificate prove_minimum(const request& wanted) {
  certificate c;
  add_steps(c, statements::limit_minimum().steps);
  c.numbers.push_back({"epsilon0_min",
                       enclose_to_digits(*find_constant("epsilon0_min"), wanted.digits),
                       wanted.digits});
  const ball beta = enclose_to_digits(*find_constant("beta"), wanted.digits);
  c.numbers.push_back({"beta", beta, wanted.digits});
  add_physical_body(c, requested_body(c, wanted), enclose_beta(256).root);
  c.conclude();
  return c;
}

}  // namespace

claim limit_minimum_claim() { return {statements::limit_minimum(), prove_minimum}; }

}  // namespace polhode::proofs
