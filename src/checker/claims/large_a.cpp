// What remains as a grows.

#include "statements/large_a.hpp"
#include "list.hpp"
#include "shapes.hpp"

namespace polhode::checker {

claim large_a_claim() { return {statements::large_a(), check_steps_only}; }

}  // namespace polhode::checker
