#pragma once

// The elliptic room's functions under the names that formulas call them by.

#include <memory>

#include "polhode/expression/functions.hpp"

namespace polhode {

[[nodiscard]] std::shared_ptr<const further_functions> elliptic_functions();

}  // namespace polhode
