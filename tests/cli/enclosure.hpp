#pragma once

#include <string>

#include <gtest/gtest.h>

#include "polhode/arithmetic/exact.hpp"
#include "polhode/certificate/certificate.hpp"

namespace polhode::test {

/// One unit of the last place of a decimal without exponent: 1/1000 for "0.028".
inline rational last_place(const std::string& decimal) {
  const auto point = decimal.find('.');
  rational unit = 1;
  if (point == std::string::npos) return unit;
  for (std::size_t i = point + 1; i < decimal.size(); ++i) unit /= 10;
  return unit;
}

/// A printed enclosure is consistent: lower <= upper, and every number between them begins with
/// `value`.
inline void expect_enclosure(const json& number, long digits) {
  const auto text = number.at("value").get<std::string>();
  const rational value = parse_rational(text);
  const rational lower = parse_rational(number.at("lower").get<std::string>());
  const rational upper = parse_rational(number.at("upper").get<std::string>());
  EXPECT_LE(lower, upper);
  EXPECT_EQ(number.at("digits").get<long>(), digits);
  if (value > 0) {
    EXPECT_LE(value, lower);
    EXPECT_LE(upper, rational(value + last_place(text)));
  } else {
    EXPECT_GE(value, upper);
    EXPECT_GE(lower, rational(value - last_place(text)));
  }
}

}  // namespace polhode::test
