#pragma once

#include <optional>

#include "polhode/arithmetic/end_point.hpp"
#include "polhode/expression/expression.hpp"

namespace polhode {

/// A formula without variables as an end of a range; exactly, where it is found to be q + r pi with
/// rational q and r. Throws input_error where it has a variable.
[[nodiscard]] end_point end_point_of(const expression& f);

/// A formula without variables of the number that x is: of q + r pi, or the one that end_point_of
/// was given. None for an infinity, and for a number of which enclosures alone are known.
[[nodiscard]] std::optional<expression> formula_of(const end_point& x);

}  // namespace polhode
