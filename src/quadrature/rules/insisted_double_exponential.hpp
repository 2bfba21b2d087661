#pragma once

// The double exponential rule where it was insisted on.

#include "polhode/quadrature/integrate.hpp"

namespace polhode::detail {

/// The integral of f from a to b, a < b as far as is known, by integrate_double_exponential.
/// not_applicable where the limits are not two rational numbers, where f has no series at one of
/// them, or where f after the substitution is not proved analytic in a rectangle.
[[nodiscard]] integral integrate_by_double_exponential(const integrand& f, const end_point& a,
                                                       const end_point& b,
                                                       const integrate_options& options);

}  // namespace polhode::detail
