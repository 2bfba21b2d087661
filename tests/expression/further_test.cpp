// Functions that are added to a formula's own: in every arithmetic, in text, and refused where they
// must be.

#include <cmath>

#include <gtest/gtest.h>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/expression/expression.hpp"
#include "support/reference.hpp"

namespace polhode {
namespace further_test {

using support::meet;

/// volume(x, y, z) = x y z, and volume(x) = x^3.
expression_names names(std::vector<std::string> variables) {
  const auto table = std::make_shared<const further_functions>(
      further_functions{{{"volume", "x, y, z", "of a box", "x > 0"},
                         3,
                         [](std::span<const ball> x) { return x[0] * x[1] * x[2]; },
                         [](std::span<const ball> x) {
                           return std::vector<ball>{x[1] * x[2], x[2] * x[0], x[0] * x[1]};
                         },
                         [](known_arguments x) { return !x[0] || x[0]->r != 0 || x[0]->q > 0; }},
                        {{"volume", "x", "of a cube", "all x"}, 1, [](std::span<const ball> x) {
                           return pow(x[0], 3);
                         }}});
  return {std::move(variables), {{"two", "volume(1, 2, 1)"}}, table};
}

TEST(FurtherFunctions, HaveValuesInEveryArithmetic) {
  const expression f("volume(x + 1, x, two) - x", names({"x"}));  // 2x^2 + x
  EXPECT_TRUE(meet(f(ball(3, 90)), ball(21, 90)));
  EXPECT_TRUE(contains(to_ball(f(double_interval(3)), 64), 21));
  EXPECT_NEAR(f(3.0), 21, 1e-12);
  EXPECT_NEAR(f(midpoint(ball(3, 90))).convert_to<double>(), 21, 1e-12);
  EXPECT_TRUE(meet(f(complex_ball(3, 90)).re, ball(21, 90)));
  EXPECT_TRUE(f(complex_ball::i(90)).is_undefined());
  EXPECT_EQ(f(region(double_interval(1, 2))).why(), obstacle::unknown);
  const auto slope = f(jet<ball, 2>::variable(ball(3, 90)));
  EXPECT_TRUE(meet(slope[1], ball(13, 90)));
  EXPECT_TRUE(slope[2].is_undefined());
  // Without a gradient there is no derivative.
  const expression cube("volume(x)", names({"x"}));
  EXPECT_TRUE(cube(jet<ball, 1>::variable(ball(3, 90)))[1].is_undefined());
  EXPECT_TRUE(meet(cube(jet<ball, 1>::variable(ball(3, 90)))[0], ball(27, 90)));
  // Nothing else is kept in the place of an operand that is read twice.
  const expression twice("volume(x, x, y) + volume(y, x, x) + x*y", names({"x", "y"}));
  const std::vector<ball> at{ball(2, 90), ball(5, 90)};
  EXPECT_TRUE(meet(twice.evaluate<ball>(at), ball(50, 90)));
  EXPECT_EQ(expression("volume(two) + volume(two)", names({})).operation_count(), 3U);
}

TEST(FurtherFunctions, AreWrittenAndReadAgain) {
  const expression f("volume(x - 1, 2*x, x)^2", names({"x"}));
  const expression g(f.to_text(), names({"x"}));
  EXPECT_EQ(f.to_text(), g.to_text());
  EXPECT_TRUE(meet(f(ball(3, 90)), g(ball(3, 90))));
  EXPECT_TRUE(meet(f(ball(3, 90)), ball(1296, 90)));
}

TEST(FurtherFunctions, AreRefusedWhereTheyAreNotDefined) {
  const auto message = [](const std::string& text) {
    try {
      static_cast<void>(expression(text, names({"x"})));
    } catch (const expression_error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(message("1 + volume(-1, 2, 3)")
                .find("column 5: volume(-1, 2, 3) is not defined: it needs x > 0"),
            std::string::npos);
  EXPECT_NE(message("volume(1, 2)").find("write volume(x, y, z) or volume(x)"), std::string::npos);
  EXPECT_NE(message("volume").find("is a function"), std::string::npos);
  EXPECT_NE(message("volum(1)").find("the nearest is volume"), std::string::npos);
  EXPECT_EQ(message("volume(x, 2, 3)"), "");
  EXPECT_THROW(static_cast<void>(expression("1", names({"volume"}))), input_error);
}

}  // namespace further_test
}  // namespace polhode
