// The limit of epsilon as a grows and b tends to 0.

#include "statements/limit_formula.hpp"
#include "list.hpp"
#include "shapes.hpp"

namespace polhode::checker {

claim limit_formula_claim() { return {statements::limit_formula(), check_steps_only}; }

}  // namespace polhode::checker
