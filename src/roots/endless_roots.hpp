#pragma once

// Proofs that a formula of one variable has infinitely many roots. Theorem: endless_roots.cpp.

#include "polhode/arithmetic/exact.hpp"
#include "polhode/expression/expression.hpp"

namespace polhode::detail {

/// Proved: f has infinitely many roots x > a for every a; for side = -1, infinitely many x < a.
[[nodiscard]] bool has_endless_roots(const expression& f, int side);
/// Proved: f has infinitely many roots in [lower, upper], in every neighbourhood of a point. Looks
/// at the points where f seems to be singular.
[[nodiscard]] bool has_endless_roots_in(const expression& f, const rational& lower,
                                        const rational& upper);

}  // namespace polhode::detail
