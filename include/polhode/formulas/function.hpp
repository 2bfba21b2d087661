#pragma once

// The roots of formulas, as `polhode roots` finds them.
//
//   const root_set s = isolate_roots(parse("cos(x) - x"), 0, 1);
//   const root_set t = isolate_roots(parse("sin(x)"), 0, end_point_of(parse("3*pi", {})));

#include "polhode/expression/expression.hpp"
#include "polhode/formulas/end_point.hpp"
#include "polhode/roots/isolate.hpp"
#include "polhode/roots/real_function.hpp"

namespace polhode {

/// A formula of one variable, or none, as the search for roots needs it. Throws input_error where it has more.
[[nodiscard]] real_function function_of(const expression& f);

/// The roots of f with lower <= x <= upper, as isolate_roots of a real_function (isolate.hpp). Throws input_error where f has more
/// than one variable.
[[nodiscard]] root_set isolate_roots(const expression& f, const end_point& lower,
                                     const end_point& upper, const isolate_options& options = {});

}  // namespace polhode
