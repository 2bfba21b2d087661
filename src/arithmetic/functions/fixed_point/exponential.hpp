#pragma once

// e^t - 1 in fixed point, which the exponential, the hyperbolic functions and the logarithm rest
// on.

#include <cstdint>

#include "arithmetic/functions/fixed_point/fraction.hpp"

namespace polhode::detail::fixed_point {

/// m = e^t - 1 for a fraction t < log 2, with w limbs. Returns the error, in units.
///
/// With few limbs by tables, with many by a reduction by primes. Between them t is the sum of its
/// first five digits of five bits, i/2^5 + j/2^10 + ..., and of a rest y < 2^-25, exactly: e^t is
/// the product of e^y, by its series, and of numbers from a table. There m stays below its true
/// value, as all products are cut off downwards and the series' terms are positive; so nothing
/// overflows.
///
/// For (1 + m)(1 + f) - 1 = m + f + m f, where m is too small by E and f by D, the result is too
/// small by E (1 + f) + D (1 + m) + 1 at most. All factors together are below e^t < 2: the series'
/// error of 34 units becomes at most 68, and each of the five steps adds 2 (2 D + 1) at most.
std::uint64_t expm1_of_fraction(limb* m, const limb* t, long w);

}  // namespace polhode::detail::fixed_point
