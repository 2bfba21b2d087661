// The tennis racket effect on the separatrix.

#include "statements/separatrix_twist.hpp"
#include "constants.hpp"
#include "list.hpp"
#include "shapes.hpp"

namespace polhode::checker {
namespace {

void check_separatrix_twist(examination& e) {
  const body rigid = check_body_and_steps(e);
  if (!e.is_missing(statements::fill(statements::enclosure_of, {"epsilon0"}))) {
    e.root_number("epsilon0", true, separatrix_equation(rigid));
  }
}

}  // namespace

claim separatrix_twist_claim() { return {statements::separatrix_twist(), check_separatrix_twist}; }

}  // namespace polhode::checker
