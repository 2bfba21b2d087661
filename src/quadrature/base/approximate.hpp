#pragma once

// Numbers in doubles, to search with: what is chosen by them proves itself, or fails to.

#include <complex>
#include <limits>
#include <vector>

#include "polhode/arithmetic/ball.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "polhode/arithmetic/polynomial.hpp"

namespace polhode::detail {

[[nodiscard]] double approximately(const ball& x);
[[nodiscard]] double approximately(const rational& q);
/// 2^-bits of about r; 1 where r is no positive number.
[[nodiscard]] double unit_of(double r, int bits);
/// 0 where x is no number.
[[nodiscard]] rational exact_double(double x);

/// log2 of 0, and the size of what is not found.
inline constexpr double infinite = std::numeric_limits<double>::infinity();

/// Beyond log2 of every number of this library.
inline constexpr double greatest_log2 = 0x1p+60;

/// By Aberth's iteration: a guess at where the function is singular.
[[nodiscard]] std::vector<std::complex<double>> approximate_roots(const rational_polynomial& p);

}  // namespace polhode::detail
