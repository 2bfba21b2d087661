#pragma once

// Integrals that are known exactly, by an antiderivative.

#include <optional>

#include "polhode/arithmetic/exact.hpp"
#include "polhode/arithmetic/polynomial.hpp"

namespace polhode {

/// The integral of p from a to b: F(b) - F(a) for F = the sum of p_n x^(n+1)/(n+1) (negative of that from b to a). None
/// where the number would be too long: where the coefficients, or the powers of the ends, have more than about 2^20
/// bits.
[[nodiscard]] std::optional<rational> exact_integral(const rational_polynomial& p,
                                                     const rational& a, const rational& b);

}  // namespace polhode
