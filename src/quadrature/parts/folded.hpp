#pragma once

// Integrals up to infinity of functions that have a period but for decaying factors, and up to 0 of
// functions that have one as functions of 1/x.

#include <optional>

#include "quadrature/formula/integrand.hpp"

namespace polhode::detail {

/// The integral over [a, b], a < b, by folded_at_infinity at its infinite ends, and by
/// `integrate_function` between them. Returns nullopt where an end is not known so, or the sum is
/// not found to the goal.
[[nodiscard]] std::optional<integral> integrate_over_periods(const integrand& f, const end_point& a,
                                                             const end_point& b,
                                                             const integrate_options& options);

/// The integral over [a, b], a <= 0 <= b, of an f with steps or kinks at ever smaller distances of
/// 0, by that of f(1/u)/u^2 beyond some u. Returns nullopt for other f, and where the goal is not
/// met.
[[nodiscard]] std::optional<integral> integrate_by_reciprocal(const integrand& f,
                                                              const end_point& a,
                                                              const end_point& b,
                                                              const integrate_options& options);

}  // namespace polhode::detail
