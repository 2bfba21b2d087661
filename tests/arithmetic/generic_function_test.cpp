// How generic functions are called: which function object, and constants as values.

#include "polhode/arithmetic/generic_function.hpp"

#include <gtest/gtest.h>

#include "polhode/arithmetic/exact.hpp"
#include "polhode/arithmetic/interval.hpp"

namespace polhode::detail {
namespace generic_function_test {

struct with_evaluator {
  template <class T>
  [[nodiscard]] auto evaluator(precision p) const {
    return [p](const T&) { return p; };
  }
};

TEST(GenericFunctions, AreAskedForAnEvaluatorWhereTheyHaveOne) {
  EXPECT_EQ(evaluator_of<ball>(with_evaluator(), 300)(ball(0, 64)), 300);
  const auto square_of = [](const auto& x) { return square(x); };
  EXPECT_EQ(lower_rational(evaluator_of<ball>(square_of, 300)(ball(3, 64))), 9);
}

TEST(GenericFunctions, MayAnswerWithANumber) {
  const rational third(1, 3);
  const ball as_ball = value_as<ball>(third, ball(0, 200));
  EXPECT_EQ(as_ball.precision(), 200);
  EXPECT_TRUE(contains(as_ball, third));
  EXPECT_LE(as_ball.radius(), magnitude::power_of_two(-199));

  const auto like = jet<ball, dynamic_order>::variable(ball(5, 100), 3);
  const auto series = value_as<jet<ball, dynamic_order>>(third, like);
  ASSERT_EQ(series.order(), 3);
  EXPECT_TRUE(contains(series[0], third));
  EXPECT_EQ(series[0].precision(), 100);
  for (int k = 1; k <= 3; ++k) EXPECT_EQ(sign_of(series[k]), certain_sign::zero) << k;
  // A ball is a coefficient as it is.
  EXPECT_TRUE(
      contains(value_as<jet<ball, 1>>(as_ball, jet<ball, 1>::variable(ball(5, 64)))[0], third));

  const region in_hardware(double_interval(1, 2), double_interval(0, 1));
  EXPECT_TRUE(value_as<region>(third, in_hardware).is_in_hardware());
  const region in_balls = region::in_balls(complex_ball(ball(1, 128)));
  EXPECT_FALSE(value_as<region>(third, in_balls).is_in_hardware());
}

TEST(GenericFunctions, GiveTheirOwnValueOtherwise) {
  const ball x(7, 64);
  EXPECT_EQ(value_as<ball>(x, ball(0, 500)).precision(), 64);
}

}  // namespace generic_function_test
}  // namespace polhode::detail
