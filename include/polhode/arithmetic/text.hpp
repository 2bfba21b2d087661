#pragma once

// Balls as decimal text. Every decimal printed by this library comes from here.

#include <string>
#include <string_view>

#include "polhode/arithmetic/ball.hpp"

namespace polhode {

/// Bits that hold `digits` significant decimal digits: ceil(digits * log2(10)), rounded up.
[[nodiscard]] precision bits_for_digits(long digits);

/// A bounded ball in decimals: what every command, table, page and figure prints of it. A value,
/// its error, and two ends; value - radius <= lower <= every member <= upper <= value + radius,
/// exactly, as decimals.
struct decimal_enclosure {
  /// Where all members share the digits asked for, these digits, cut off (never rounded): each is
  /// one of the true value's decimal expansion. Elsewhere the middle, rounded to nearest at the
  /// second digit of the error, or at the last digit asked for. Never empty.
  std::string value;
  std::string radius;  // two significant digits, rounded up; "0" where exact
  std::string lower;   // rounded downward
  std::string upper;   // rounded upward
  /// To so many significant digits the value is right: they are shared by all members, or the
  /// radius is at most one unit of the last of them. At most as many as were asked for; 0 where the
  /// error may be as large as the value.
  long digits = 0;
  long shared = 0;     // so many leading digits are the same for all members
  bool cut = false;    // `value` is cut off from what all members share, and not rounded
  bool exact = false;  // the ball is one number and `value` is all of it

  /// As many digits as were asked for, or all that there are.
  [[nodiscard]] bool has(long asked) const { return exact || digits >= asked; }
  /// The same, where each printed digit is one of the true value's expansion.
  [[nodiscard]] bool has_cut(long asked) const { return exact || (cut && digits >= asked); }
};

/// `value` has at most `most_digits` significant digits; `lower` and `upper` have three more than
/// that, or than the ball's width gives a meaning. Throws std::domain_error where x is not bounded,
/// std::invalid_argument where most_digits < 1.
[[nodiscard]] decimal_enclosure to_decimal_enclosure(const ball& x, long most_digits);

/// For reading: "1.5" where exact; the certain digits, followed by "...", where all members share
/// them ("1.41421..."); "0.5 ± 1e-53" where they do not.
[[nodiscard]] std::string to_text(const decimal_enclosure& d);

/// For reading what may be a number or a range: to_text of a narrow ball; "[lower, upper]" of one
/// that is wider than three digits tell, or that holds 0, and of an unbounded one, with "inf";
/// "undefined".
[[nodiscard]] std::string to_decimal(const ball& x, long most_digits);

/// The ball itself as text, without loss: its precision, its form, and hexadecimal integers with a
/// power of two, "128:0x5a8279p-22+-0x1p-130", "64:[0x1p+0, inf]", "64:undefined".
[[nodiscard]] std::string to_exact_text(const ball& x);

/// Reads what to_exact_text wrote: the same set, at the same precision, in the same form. Throws
/// input_error, which says what is accepted, for anything else: a precision outside 2 ... 2^26, a
/// mantissa of more bits than the precision (or than 31 for a radius), ends in the wrong order, a
/// NaN, an infinite end on the wrong side.
[[nodiscard]] ball parse_exact_text(std::string_view text);

}  // namespace polhode
