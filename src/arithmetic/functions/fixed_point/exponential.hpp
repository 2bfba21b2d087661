#pragma once

// e^t - 1 in fixed point, which the exponential, the hyperbolic functions and the logarithm rest
// on.

#include <cstdint>

#include "arithmetic/functions/fixed_point/fraction.hpp"

namespace polhode::detail::fixed_point {

/// m = e^t - 1 for a fraction t < log 2. Returns the error, in units.
///
/// m is computed at y = t / 2^r, and e^(2y) - 1 = 2 m + m^2. Cutting y off changes m by less than 2
/// units, the series by 34. If m is wrong by e then 2 m + m^2 is by 2 e (1 + m) and one more; over
/// all steps the factors 1 + m = e^y, e^(2y), ... have a product below e^t < 2. So the error is
/// below
///     2 * 2^r (36 + 1/2 + 1/4 + ...) < 2^(r + 7).
/// An error above e^t - 1 <= 1 - 2^-64 w would be one of a sum that overflows: but the steps are
/// cut off downwards, as is the series, whose terms are positive, so that m stays below its true
/// value.
std::uint64_t expm1_of_fraction(fraction& m, const limb* t, long w);

}  // namespace polhode::detail::fixed_point
