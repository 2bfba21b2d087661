#pragma once

// e^x, sin x and cos x for numbers of few bits beside those of the result, by sums in halves (R. P.
// Brent, The complexity of multiple-precision arithmetic, 1976): a longer argument is the sum of
// such numbers, each with twice as many bits as the one before it.

#include <cstdint>

#include "polhode/arithmetic/exact.hpp"

namespace polhode::detail::fixed_point {

/// 2^bits (e^x - 1) for x = a/2^scale, |x| <= 2^-small <= 1/2, within 2 units.
integer expm1_of_short(const integer& a, long scale, long small, long bits);

/// 2^bits sin(x) for such an x, within 2 units.
integer sine_of_short(const integer& a, long scale, long small, long bits);

}  // namespace polhode::detail::fixed_point
