#pragma once

#include <optional>

#include "polhode/expression/expression.hpp"
#include "quadrature/formula/integrand.hpp"

namespace polhode::detail {

/// The integral of f over [a, b] as one in u = exp(c (x - e)), where f has sines or cosines of
/// exponentials (expression::by_exponential); e is the finite end with the greatest u, or 0. None
/// for other formulas, and for ends that are no formulas.
[[nodiscard]] std::optional<substituted> in_exponential_variable(const expression& f,
                                                                 const end_point& a,
                                                                 const end_point& b);

}  // namespace polhode::detail
