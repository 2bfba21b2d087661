#pragma once

// Integrals that are known exactly, by an antiderivative.

#include <optional>

#include "polhode/arithmetic/end_point.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "polhode/arithmetic/polynomial.hpp"
#include "polhode/expression/expression.hpp"

namespace polhode {

/// The integral of p from a to b: F(b) - F(a) for F = the sum of p_n x^(n+1)/(n+1) (negative of
/// that from b to a). None where the number would be too long: where the coefficients, or the
/// powers of the ends, have more than about 2^20 bits.
[[nodiscard]] std::optional<rational> exact_integral(const rational_polynomial& p,
                                                     const rational& a, const rational& b);

/// The integral of f from a to b where it is found to be a rational number, for f that is, between
/// rational points (of abs, min, max, floor and ceil), a rational function whose antiderivative is
/// one, such a function of the root of a linear form, or a sum of x^n exp(k x), x^n sin(k x) and
/// x^n cos(k x), or one of x^k log(x)^n over x >= 0; and for f that is 0 but for isolated points.
/// Ends may be infinite. None for other f, for integrals that diverge, where an end is not shown to
/// be a number, and where the result would be long.
[[nodiscard]] std::optional<rational> exact_integral(const expression& f, const end_point& a,
                                                     const end_point& b);

}  // namespace polhode
