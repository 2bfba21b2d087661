#pragma once

// Values from elsewhere, as decimals, and how a ball is held against them.

#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "polhode/arithmetic/ball.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "support/exact_set.hpp"

namespace polhode::support {

/// 10^n, exactly.
inline rational power_of_ten(long n) { return parse_rational("1e" + std::to_string(n)); }

/// What a decimal from another program says: the true value is within one unit of its last digit.
inline exact_set within_one_unit(std::string_view decimal) {
  const auto mantissa = decimal.substr(0, decimal.find('e'));
  const auto exponent = decimal.find('e') == std::string_view::npos
                            ? 0L
                            : std::stol(std::string(decimal.substr(decimal.find('e') + 1)));
  const auto point = mantissa.find('.');
  const long decimals =
      point == std::string_view::npos ? 0 : static_cast<long>(mantissa.size() - point - 1);
  const rational value = parse_rational(decimal);
  const rational unit = power_of_ten(exponent - decimals);
  return {value - unit, value + unit};
}

/// The ball can hold the number that the decimal stands for, and it is so narrow that this says
/// something: its width is at most 10^-digits of its size.
inline ::testing::AssertionResult agrees(const ball& x, std::string_view decimal, long digits) {
  if (!x.is_bounded()) return ::testing::AssertionFailure() << "the ball is not bounded";
  const exact_set set = exact(x);
  const exact_set reference = within_one_unit(decimal);
  if (*set.upper < *reference.lower || *reference.upper < *set.lower) {
    return ::testing::AssertionFailure() << described(x) << " excludes " << decimal;
  }
  if (set.width() > set.greatest_size() * power_of_ten(-digits)) {
    return ::testing::AssertionFailure()
           << described(x) << " is wider than " << digits << " digits";
  }
  return ::testing::AssertionSuccess();
}

/// Both balls can hold one and the same number. Undefined balls do not.
inline ::testing::AssertionResult meet(const ball& x, const ball& y) {
  if (x.is_undefined() || y.is_undefined()) {
    return ::testing::AssertionFailure() << "undefined: " << x << " and " << y;
  }
  if (overlaps(x, y)) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure()
         << described(x) << " and " << described(y) << " are disjoint";
}

/// The ball is bounded and its radius is at most 2^-bits of its size.
inline ::testing::AssertionResult as_narrow_as(const ball& x, long bits) {
  if (!x.is_bounded()) return ::testing::AssertionFailure() << "the ball is not bounded";
  if (x.radius() <= scale(x.magnitude_upper(), -bits)) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << described(x) << " is wider than " << bits << " bits";
}

}  // namespace polhode::support
