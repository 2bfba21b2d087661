#pragma once

// Integrals in other variables, in which a function turns or steps at one pace, and of a function's
// limits apart.

#include <vector>

#include "polhode/expression/expression.hpp"
#include "quadrature/formula/integrand.hpp"

namespace polhode::detail {

/// The integral of f over [a, b], a <= 0 <= b, as that of f(1/u)/u^2 beyond some u on each side of
/// 0 where f has steps, kinks or waves at ever smaller distances (expression::by_reciprocal), and
/// what is left. None for other formulas and ranges.
[[nodiscard]] std::vector<part> parts_in_reciprocal(const expression& f, const end_point& a,
                                                    const end_point& b);

/// The integral of f over a finite [a, b] in u = tan(x), between any two odd multiples of pi/2 for
/// itself, where f has sines or cosines of tan(x) (expression::by_tangent). None for other
/// formulas, for ranges that reach no such point or many, and for ends that are no formulas.
[[nodiscard]] std::vector<part> parts_in_tangent(const expression& f, const end_point& a,
                                                 const end_point& b);

/// The integral of f over an infinite [a, b] as that over a finite part, and beyond it those of a
/// steady part and of what decays beside it (expression::by_steady_factor). None for other
/// formulas.
[[nodiscard]] std::vector<part> parts_with_limits(const expression& f, const end_point& a,
                                                  const end_point& b);

/// The integral of f over an infinite [a, b] as that over a finite part, and beyond it that of the
/// same function by scaled ones (expression::with_scaled_functions). None for other formulas.
[[nodiscard]] std::vector<part> parts_with_scaled_functions(const expression& f, const end_point& a,
                                                            const end_point& b);

}  // namespace polhode::detail
