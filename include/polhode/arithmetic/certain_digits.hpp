#pragma once

// Precision raised until the digits asked for are certain.

#include <functional>

#include "polhode/arithmetic/exact.hpp"

namespace polhode {

/// Encloses one and the same real number with about so many bits; its radius shrinks with them.
using enclosing_function = std::function<ball(precision)>;

/// f(p) for growing p = bits_for_digits(digits) + guard bits, guard = 32, 64, 128, ... up to most_guard: the first
/// enclosure of which all members share `digits` significant digits, or that is exact, or, from 128 guard bits on, whose radius is
/// at most one unit of the last of so many (1.999... or 2.000...: a number that may be a short decimal); or the undefined ball
/// where none is.
[[nodiscard]] ball enclose_to_digits(const enclosing_function& f, long digits,
                                     precision most_guard);

/// Bits that the numerator and the denominator of q have together: a measure of how near a number made from q may come to
/// another, and so of the guard bits that it may need.
[[nodiscard]] precision size_in_bits(const rational& q);

}  // namespace polhode
