#pragma once

// e^t, sin t and cos t with many limbs: t becomes small by whole multiples of the logarithms of
// primes, or of the arguments of Gaussian primes, as a product of their powers is a rational number
// (F. Johansson, Computing elementary functions using multi-prime argument reduction, 2022).

#include <cstdint>

#include "arithmetic/functions/fixed_point/fraction.hpp"

namespace polhode::detail::fixed_point {

/// value = e^t for a fraction t < log 2. Returns the error, in units.
std::uint64_t exponential_by_primes(number& value, const limb* t, long w);

/// s = sin t and c = cos t for a fraction t <= pi/4, cut off from above at the last fraction below
/// 1. Returns the error of each, in units.
std::uint64_t sine_and_cosine_by_primes(limb* s, limb* c, const limb* t, long w);

}  // namespace polhode::detail::fixed_point
