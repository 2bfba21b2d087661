// The limit a -> infinity, b -> 0: the paper's section 7, eqs. (33) to (38). The argument:
// proofs/arguments/limit_formula.md.

#include "statements/limit_formula.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/elliptic/complete.hpp"
#include "proofs/body_facts.hpp"
#include "proofs/claims.hpp"
#include "proofs/exact_polynomial.hpp"

namespace polhode::proofs {
namespace {

certificate prove_limit(const request&) {
  certificate c;
  add_steps(c, statements::limit_formula().steps);
  // For beta < 0 the turning point is epsilon*, sin^2 epsilon* = -beta, at xi = K(1+beta) = K(cos^2
  // epsilon*).
  c.facts.push_back({statements::mean_at_epsilon0_min, is_decided([](precision p) {
                       return certainly_less(agm(ball(1, p), 1 / cosh(pi(p))),
                                             ball(rational(1, 2), p));
                     }),
                     step_kind::enclosed});
  c.conclude();
  return c;
}

}  // namespace

claim limit_formula_claim() { return {statements::limit_formula(), prove_limit}; }

}  // namespace polhode::proofs
