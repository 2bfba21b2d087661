#pragma once

// The segments of a range near its ends: x as a function of t or w, and the bounds that are known
// from the series there.

#include "quadrature/pieces/end_plan.hpp"

namespace polhode::detail::ends {

/// x = p + s t^q for 0 < t <= 1, with the series' bound near t = 0.
[[nodiscard]] segment power_segment(const integrand& f, const end_of_range& end,
                                    const end_plan& plan);

/// x = p + s t^q for r0 <= t <= 1: t = r0 + (1 - r0) v.
[[nodiscard]] segment segment_beyond(double r0, const integrand& f, const end_of_range& end,
                                     end_plan plan);

/// x = p + s t^q with t = r0 e^(-w), 0 <= w <= W, w = W v: what lies within t <= r0 of the end, for
/// functions with logarithms or odd powers there. Beyond W = length, tail_beyond.
[[nodiscard]] segment exponential_segment(const integrand& f, const end_of_range& end,
                                          const end_plan& plan, double r0, double length);

/// Holds the integral over w > W = length, by the series' bounds.
[[nodiscard]] ball tail_beyond(const end_of_range& end, const end_plan& plan, double r0,
                               double length);

/// From a to b, as f is there.
[[nodiscard]] segment affine_segment(const integrand& f, const end_point& a, const end_point& b);

/// From a to b, where f is regular at both; a symmetry of f is used.
[[nodiscard]] segment regular_segment(const integrand& f, const end_point& a, const end_point& b);

}  // namespace polhode::detail::ends
