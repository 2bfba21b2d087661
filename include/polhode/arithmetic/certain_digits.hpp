#pragma once

// Precision raised until the digits asked for are certain.

#include <functional>

#include "polhode/arithmetic/exact.hpp"

namespace polhode {

/// Encloses one and the same real number with about so many bits; its radius shrinks with them.
using enclosing_function = std::function<ball(precision)>;

/// Whether all members share `digits` significant digits, or x is exact; or x is so narrow that
/// they do not only for being about a short decimal: some number is within one unit of the last
/// digit of 30 digits more (1.999... or 2.000...), and more precision would show no other.
[[nodiscard]] bool shows_digits(const ball& x, long digits);

/// Guard bits that are enough where nothing cancels: once the radius is small enough, only a run of
/// 0s or 9s can hide a digit.
[[nodiscard]] precision ample_guard(long digits);

/// f(p) for growing p = bits_for_digits(digits) + guard bits, guard = 32, 64, 128, ... up to
/// most_guard: the first enclosure that shows_digits, or the undefined ball where none does.
[[nodiscard]] ball enclose_to_digits(const enclosing_function& f, long digits,
                                     precision most_guard);

/// Bits that the numerator and the denominator of q have together: a measure of how near a number
/// made from q may come to another, and so of the guard bits that it may need.
[[nodiscard]] precision size_in_bits(const rational& q);

}  // namespace polhode
