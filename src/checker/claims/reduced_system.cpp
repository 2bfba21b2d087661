// The equations of motion in Euler angles.

#include "statements/reduced_system.hpp"
#include "list.hpp"
#include "shapes.hpp"

namespace polhode::checker {

claim reduced_system_claim() { return {statements::reduced_system(), check_steps_only}; }

}  // namespace polhode::checker
