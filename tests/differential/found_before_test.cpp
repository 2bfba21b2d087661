// Integrals of which wrong digits were once certified. Each is computed by every route, and held
// against its true value or refused.

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "integrals.hpp"
#include "support/reference.hpp"

namespace polhode::differential {
namespace found_before_test {

struct known_integral {
  std::string name;
  std::string integrand;
  std::string from;
  std::string to;
  /// Within a unit of its last digit; empty where the integral diverges.
  std::string value;
};

std::vector<known_integral> found_before() {
  return {
      {"steep_in_exp", "exp(x)*(1+exp(x))^400", "-1.4", "-1.3999", "4.83231007601602947e33"},
      {"steep_in_sin", "sin(x)*cos(x)*(1+sin(x)^2)^400", "0.5", "0.51", "1.96224333045310705e34"},
      {"logistic_power", "1/(1+exp(-x))^400", "-1.5", "-1.499", "3.21501712832247458e-299"},
      {"sines_and_cosines", "sin(x)^700*cos(x)^233", "1", "1.05", "4.12247083255237085e-116"},
      {"one_and_cosine", "(1+cos(x)^2)^400", "1", "1.1", "1.11162885750378317e42"},
      {"half_exponent", "(4+cos(x))^(2001/2)", "2", "2.05", "1.67173057245511802e552"},
      {"divergent_at_a_cube_root", "exp(-20*x^2)/(18-x^3)", "0", "cbrt(18)", ""},
      {"tiny_and_divergent", "1/(1+exp(x))+1e-40/(18-x^3)^2", "0", "cbrt(18)", ""},
      {"divergent_at_a_square_root", "exp(-16*x^2)/(x^2-4*x-6)", "0", "(4+sqrt(40))/2", ""}};
}

class found_before_integrals : public ::testing::TestWithParam<known_integral> {};

TEST_P(found_before_integrals, are_right_or_refused_now) {
  const known_integral& known = GetParam();
  for (const long digits : {5L, 20L, 60L}) {
    integral_case c{parsed(known.integrand), parsed(known.from), parsed(known.to), digits};
    c.diverges = known.value.empty();
    counts tally;
    examine_thoroughly(c, 1, tally);
    if (c.diverges) continue;
    const integral i = computed({c.integrand, c.from, c.to, digits});
    EXPECT_EQ(i.verdict, status::certified) << i.obstacle;
    EXPECT_TRUE(support::agrees(i.enclosure, known.value, std::min(digits, 15L)));
  }
}

INSTANTIATE_TEST_SUITE_P(each, found_before_integrals, ::testing::ValuesIn(found_before()),
                         [](const auto& drawn) { return drawn.param.name; });

/// A range so narrow that its panel is negligible, with an end that is not exact: the integral is
/// 1013/1000 times log(1 + exp(-7x))/(-7) plus 0.66e-308 x^2 between the limits.
TEST(found_before, a_negligible_panel_at_an_inexact_end) {
  const term f = parsed("1013/1000/(1+exp(7*x))+1.32e-308*x");
  for (const long digits : {20L, 300L}) {
    integral_case c{f, parsed("sqrt(2)"), parsed("sqrt(2)+4.29e-16"), digits};
    c.antiderivative = parsed("-1013/7000*log(1+exp(-7*x))+0.66e-308*x^2");
    counts tally;
    examine_thoroughly(c, 1, tally);
    EXPECT_GT(tally.certified, 0);
    EXPECT_GT(tally.checks, 0);
  }
}

}  // namespace found_before_test
}  // namespace polhode::differential
