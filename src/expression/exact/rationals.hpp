#pragma once

// Rational numbers as coefficients and exponents of exact_sum: their size, their parts, and those
// of their powers that are short enough to be written out.

#include <cstddef>

#include "polhode/arithmetic/exact.hpp"

namespace polhode::detail::exact_parts {

/// Of a coefficient. Beyond these a number is left to its enclosures.
constexpr std::size_t most_bits = 1U << 14;

inline const rational half(1, 2);

/// The bits of the numerator or of the denominator, whichever is longer.
[[nodiscard]] std::size_t bits_of(const rational& q);
[[nodiscard]] bool is_integer(const rational& q);
/// Throws not_decided where n is too long.
[[nodiscard]] long as_long(const integer& n);
/// c^n for c != 0. Throws not_decided where that has more than about most_bits bits.
[[nodiscard]] rational integer_power_of(const rational& c, const integer& n);

}  // namespace polhode::detail::exact_parts
