#pragma once

#include "polhode/arithmetic/end_point.hpp"
#include "polhode/expression/expression.hpp"

namespace polhode {

/// A formula without variables as an end of a range; exactly, where it is found to be q + r pi with rational q and r. Throws
/// input_error where it has a variable.
[[nodiscard]] end_point end_point_of(const expression& f);

}  // namespace polhode
