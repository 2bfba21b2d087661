// The four implicit equations.

#include "statements/implicit_equations.hpp"
#include "list.hpp"
#include "shapes.hpp"

namespace polhode::checker {

claim implicit_equations_claim() { return {statements::implicit_equations(), check_steps_only}; }

}  // namespace polhode::checker
