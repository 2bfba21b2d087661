#pragma once

// Integrals up to infinity of functions that have a period but for decaying factors.

#include <optional>

#include "quadrature/formula/integrand.hpp"

namespace polhode::detail {

/// The integral over [a, b], a < b, by folded_at_infinity at its infinite ends, and by
/// `integrate_function` between them. Returns nullopt where an end is not known so, or the sum is
/// not found to the goal.
[[nodiscard]] std::optional<integral> integrate_over_periods(const integrand& f, const end_point& a,
                                                             const end_point& b,
                                                             const integrate_options& options);

}  // namespace polhode::detail
