#pragma once

// Balls as decimal text. Every decimal printed by this library comes from here.

#include <string>
#include <string_view>

#include "polhode/arithmetic/ball.hpp"

namespace polhode {

/// Bits that hold `digits` significant decimal digits: ceil(digits * log2(10)), rounded up.
[[nodiscard]] precision bits_for_digits(long digits);

/// A bounded ball in decimals.
struct decimal_enclosure {
  std::string lower;  // a decimal <= every member, rounded downward
  std::string upper;  // a decimal >= every member, rounded upward
  /// The leading digits that all members share, cut off (never rounded): each of them is a digit
  /// of the true value's decimal expansion. Empty where they share none.
  std::string value;
  long digits = 0;     // how many significant digits `value` has
  bool exact = false;  // the ball is one number and `value` is all of it
};

/// `value` has at most `most_digits` significant digits, and fewer where the ball is wider;
/// `lower` and `upper` have three more than that, or than the ball's width gives a meaning. Throws std::domain_error where x is not bounded,
/// std::invalid_argument where most_digits < 1.
[[nodiscard]] decimal_enclosure to_decimal_enclosure(const ball& x, long most_digits);

/// For reading: the certain digits, at most so many, followed by "..." where more would follow
/// ("1.41421..."); "[lower, upper]" where the members share no digit; "undefined".
[[nodiscard]] std::string to_decimal(const ball& x, long most_digits);

/// The ball itself as text, without loss: its precision, its form, and hexadecimal integers with a power
/// of two, "128:0x5a8279p-22+-0x1p-130", "64:[0x1p+0, inf]", "64:undefined".
[[nodiscard]] std::string to_exact_text(const ball& x);

/// Reads what to_exact_text wrote: the same set, at the same precision, in the same form. Throws
/// input_error, which says what is accepted, for anything else: a precision outside 2 ... 2^26, a mantissa
/// of more bits than the precision (or than 31 for a radius), ends in the wrong order, a NaN, an infinite end
/// on the wrong side.
[[nodiscard]] ball parse_exact_text(std::string_view text);

}  // namespace polhode
