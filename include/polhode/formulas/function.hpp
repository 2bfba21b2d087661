#pragma once

#include "polhode/expression/expression.hpp"
#include "polhode/roots/real_function.hpp"

namespace polhode {

/// A formula of one variable as the search for roots needs it.
[[nodiscard]] real_function function_of(const expression& f);

}  // namespace polhode
