#pragma once

// Where an integral is proved to diverge: at a pole, also at a point that is no rational number.

#include "quadrature/formula/integrand.hpp"

namespace polhode::detail {

/// A set in x that holds a pole of f, for which f is proved not to be integrable over any range
/// that holds x. There is
///
///   f = P/(D^k C),  k >= 1,
///
/// with functions P, D and C of which P and C are not 0 in x, and D is continuously differentiable,
/// with opposite signs at x's ends and a slope of one sign. So D has exactly one zero r in x,
/// |D(t)| <= L |t - r| for t in x with a bound L of
/// |D'|, and |f(t)| >= c/|t - r|^k with some c > 0, while f has one sign on either side of r.
/// Nothing where this is not found, which says nothing.
[[nodiscard]] std::optional<ball> pole_in(const integrand& f, const ball& x);

}  // namespace polhode::detail
