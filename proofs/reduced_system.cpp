// The equations of motion in the paper's Euler angles, from Euler's equations. The argument:
// proofs/arguments/reduced_system.md.

#include "statements/reduced_system.hpp"
#include "proofs/claims.hpp"
#include "proofs/exact_polynomial.hpp"

namespace polhode::proofs {
namespace {

certificate prove_system(const request&) {
  certificate c;
  add_steps(c, statements::reduced_system().steps);
  c.conclude();
  return c;
}

}  // namespace

claim reduced_system_claim() { return {statements::reduced_system(), prove_system}; }

}  // namespace polhode::proofs
