// The limit a -> infinity, b -> 0: the paper's section 7, eqs. (33) to (38). The argument:
// proofs/arguments/limit_formula.md.

#include "statements/limit_formula.hpp"
#include "proofs/claims.hpp"
#include "proofs/exact_polynomial.hpp"

namespace polhode::proofs {
namespace {

certificate prove_limit(const request&) {
  certificate c;
  add_steps(c, statements::limit_formula().steps);
  c.conclude();
  return c;
}

}  // namespace

claim limit_formula_claim() { return {statements::limit_formula(), prove_limit}; }

}  // namespace polhode::proofs
