#pragma once

// Integrals with their digits.

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "polhode/arithmetic/exact.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/expression/parse.hpp"
#include "polhode/quadrature/integrate.hpp"

namespace polhode::test {

struct known_to_digits {
  std::string formula;
  std::string lower;
  std::string upper;
  std::string value;  // forty digits, rounded
};

inline end_point limit_of(const std::string& text) {
  if (text == "-inf") return -end_point::infinity();
  if (text == "inf") return end_point::infinity();
  return end_point_of(parse(text, {}));
}

/// Certified with the digits asked for, beside the value, and with at most so many evaluations of
/// all kinds.
inline void expect_known(const std::vector<known_to_digits>& all, long most_evaluations) {
  constexpr long digits = 30;
  for (const known_to_digits& k : all) {
    SCOPED_TRACE(k.formula + " from " + k.lower + " to " + k.upper);
    const integral found =
        integrate(parse(k.formula), limit_of(k.lower), limit_of(k.upper), {.digits = digits});
    EXPECT_EQ(found.verdict, status::certified) << to_text(found.why) << ": " << found.obstacle;
    const ball value = parse(k.value, {}).value(200);
    const magnitude size = value.magnitude_upper();
    const ball rounded =
        value.enlarged(multiply_up(size, pow(ball(10, 64), -39).magnitude_upper()));
    EXPECT_TRUE(overlaps(found.enclosure, rounded)) << to_decimal(found.enclosure, 40);
    EXPECT_LE(found.enclosure.radius(),
              multiply_up(size, pow(ball(10, 64), -digits).magnitude_upper()));
    EXPECT_LE(found.account.evaluations + found.account.region_evaluations, most_evaluations);
  }
}

}  // namespace polhode::test
