// The implicit equations of the curve C on every branch: the paper's appendix B. The argument:
// proofs/arguments/implicit_equations.md.

#include "statements/implicit_equations.hpp"
#include "proofs/claims.hpp"
#include "proofs/exact_polynomial.hpp"

namespace polhode::proofs {
namespace {

certificate prove_equations(const request&) {
  certificate c;
  add_steps(c, statements::implicit_equations().steps);
  c.conclude();
  return c;
}

}  // namespace

claim implicit_equations_claim() { return {statements::implicit_equations(), prove_equations}; }

}  // namespace polhode::proofs
