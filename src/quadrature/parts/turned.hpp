#pragma once

// Integrals whose oscillations are taken over rays on which they decay.

#include <optional>

#include "quadrature/formula/integrand.hpp"

namespace polhode::detail {

/// The integral over [a, b], a < b, by turned_rays at its infinite ends, and by
/// `integrate_function` between them. Returns nullopt where an end is not known by such rays, or
/// the sum is not found to the goal.
[[nodiscard]] std::optional<integral> integrate_over_turned_rays(const integrand& f,
                                                                 const end_point& a,
                                                                 const end_point& b,
                                                                 const integrate_options& options);

/// The integral over [a, b] of an f that turns more often than `least_turns` there, by rays from a
/// and from b. Returns nullopt where there are none, or the sum is not found to the goal.
[[nodiscard]] std::optional<integral> integrate_between_turned_rays(
    const integrand& f, const end_point& a, const end_point& b, double least_turns,
    const integrate_options& options);

/// The integral over [a, b], a < b, of an f with sines or cosines of exponentials, taken in such an
/// exponential u: over a finite range of u if f turns more often than `least_turns` there. Returns
/// nullopt for other f, and where the goal is not met.
[[nodiscard]] std::optional<integral> integrate_by_exponential(const integrand& f,
                                                               const end_point& a,
                                                               const end_point& b,
                                                               double least_turns,
                                                               const integrate_options& options);

}  // namespace polhode::detail
