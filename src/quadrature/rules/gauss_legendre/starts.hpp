#pragma once

// Where the search for each zero begins: estimates in floating point, which no proof rests on. A
// rule from bad ones takes longer, or is not proved.

#include <cstdint>
#include <vector>

#include "quadrature/rules/gauss_legendre/polynomial.hpp"

namespace polhode::detail::legendre {

/// The squares of the positive zeros, increasing, in units of 2^-64, as well as a long double tells
/// them. None is 0.
[[nodiscard]] std::vector<std::uint64_t> estimated_squares(const legendre_shape& s);

/// The same to some 50 bits, in less time.
[[nodiscard]] std::vector<std::uint64_t> roughly_estimated_squares(const legendre_shape& s);

}  // namespace polhode::detail::legendre
