#pragma once

// What the standard library asks of a number type, for balls. (Text: operator<< in
// arithmetic/ball.hpp, fmt in arithmetic/format.hpp.)
//
// A ball is no floating-point number: it has no epsilon, no greatest number and no precision of its
// type. numeric_limits says so; algorithms that ask for these, as Boost.Math's do to end an
// iteration, do not compile with a ball, or say that they cannot. docs/boost.md says which ones may
// be given balls, and why others may not.

#include <cstddef>
#include <functional>
#include <limits>

#include "polhode/arithmetic/ball.hpp"

template <>
class std::numeric_limits<polhode::ball> {
 public:
  static constexpr bool is_specialized = true;
  static constexpr bool is_signed = true;
  static constexpr bool is_integer = false;
  static constexpr bool is_exact = false;  // of a sum, say
  static constexpr bool is_bounded = false;
  static constexpr bool is_modulo = false;
  static constexpr bool is_iec559 = false;
  static constexpr bool has_infinity =
      false;  // the ball of all reals has infinite ends, and is no infinity
  static constexpr bool has_quiet_NaN = true;  // an undefined ball
  static constexpr bool has_signaling_NaN = false;
  static constexpr std::float_denorm_style has_denorm = std::denorm_absent;
  static constexpr bool has_denorm_loss = false;
  static constexpr std::float_round_style round_style = std::round_indeterminate;  // outward
  static constexpr bool traps = false;
  static constexpr bool tinyness_before = false;
  static constexpr int radix = 2;
  // Each ball has a precision of its own.
  static constexpr int digits = 0;
  static constexpr int digits10 = 0;
  static constexpr int max_digits10 = 0;
  static constexpr int min_exponent = 0;
  static constexpr int min_exponent10 = 0;
  static constexpr int max_exponent = 0;
  static constexpr int max_exponent10 = 0;

  static polhode::ball quiet_NaN() { return polhode::ball::undefined(64); }
  // What a ball has not.
  static polhode::ball epsilon() = delete;
  static polhode::ball round_error() = delete;
  static polhode::ball min() = delete;
  static polhode::ball max() = delete;
  static polhode::ball lowest() = delete;
  static polhode::ball denorm_min() = delete;
  static polhode::ball infinity() = delete;
  static polhode::ball signaling_NaN() = delete;
};

/// Of the set: balls with the same ends have the same hash. There is no operator== that would go
/// with it, since balls may overlap: a container needs a predicate, such as is_equal
/// (arithmetic/interval.hpp).
template <>
struct std::hash<polhode::ball> {
  [[nodiscard]] std::size_t operator()(const polhode::ball& x) const noexcept;
};
