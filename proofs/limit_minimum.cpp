// What the limit a -> infinity, b -> 0 says of physical bodies: the paper's section 7, eqs. (39)
// and (40). T and t are those of limit_formula.cpp.
//
// Physical bodies: (1 - b X)^2 - b (a + b X) = (1 - ab - 2b) + b (1 - X)(2 - b X). For ab + 2b <= 1
// and X < 1 it is positive, that is,
//   h > (beta + X)^(-1/2):  T(c, psi) > t(beta, psi),
// the limit's integral for chi = 1. So at every c = b beta the twist falls short of the limit's,
// and
//   - epsilon0 > epsilon0_min, the limit's defect at beta = 0, chi = 1: t(0, psi) is the inverse
//     Gudermannian function;
//   - c0/b > beta_min, the paper's beta, where 2 t(beta, pi/2) = 2 pi: F(b beta_min, 0) > 2 pi, and
//     F(c,0) decreases in c (for bodies with a c0: J < 2).
// beta < 0, chi <= 1, in the limit: sin^2 epsilon* = -beta at the turning points, |psi| <= pi/2 -
// epsilon*. By the fact below K(1 - s) > pi for s = sin^2 epsilon0_min = 1/cosh(pi)^2. If -beta >
// s: epsilon >= epsilon* > epsilon0_min. Else K(1+beta) >= K(1-s) > pi >= pi sqrt(chi): the turning
// point is not reached, and t(beta, psi) > t(0, psi), t = pi sqrt(chi) <= pi: epsilon >
// epsilon0_min. Both bounds are approached, by planar bodies a = 1/b - 2 with b -> 0, and not
// attained: they are the greatest lower bounds. The paper argues by the decrease in a only.

#include "statements/limit_minimum.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/elliptic/complete.hpp"
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
  const auto over_b = [&](const rational& s) {
    return ball(rational(rigid.a().exact() * s / rigid.b().exact()), p);
  };
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
  // For beta < 0 the turning point is epsilon*, sin^2 epsilon* = -beta, at xi = K(1+beta) = K(cos^2
  // epsilon*).
  c.facts.push_back({statements::mean_at_epsilon0_min, is_decided([](precision p) {
                       return certainly_less(agm(ball(1, p), 1 / cosh(pi(p))),
                                             ball(rational(1, 2), p));
                     }),
                     step_kind::enclosed});
  add_physical_body(c, requested_body(c, wanted), enclose_beta(256).root);
  c.conclude();
  return c;
}

}  // namespace

claim limit_minimum_claim() { return {statements::limit_minimum(), prove_minimum}; }

}  // namespace polhode::proofs
