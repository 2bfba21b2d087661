// Jets against independent derivatives: closed forms, the chain of difference quotients in exact
// rationals for polynomials, and each other.

#include "polhode/arithmetic/jet.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "polhode/arithmetic/boost_bridge.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "support/random.hpp"

namespace polhode {
namespace jet_test {

constexpr precision bits = 200;
using jet5 = jet<ball, 5>;

ball number(const char* text) { return parse_ball(text, bits); }
jet5 at(const char* text) { return jet5::variable(number(text)); }

/// Every coefficient of x overlaps that of y: two routes to the same numbers.
template <int Order>
void expect_same(const jet<ball, Order>& x, const jet<ball, Order>& y) {
  ASSERT_EQ(x.order(), y.order());
  for (int k = 0; k <= x.order(); ++k) {
    EXPECT_TRUE(x[k].is_bounded() && y[k].is_bounded()) << k;
    EXPECT_TRUE(overlaps(x[k], y[k])) << "coefficient " << k << ": " << x[k] << " and " << y[k];
  }
}

TEST(Jet, HasTheDerivativesOfAPolynomialExactly) {
  // x^3 - 2x at 3/2: value 3/8, then 19/4, 9, 6, 0, 0.
  const jet5 x = at("3/2");
  const jet5 y = x * x * x - 2 * x;
  const char* derivatives[] = {"3/8", "19/4", "9", "6", "0", "0"};
  for (int k = 0; k <= 5; ++k) {
    EXPECT_TRUE(y.derivative(k).is_exact());
    EXPECT_TRUE(contains(y.derivative(k), parse_rational(derivatives[k]))) << k;
  }
}

TEST(Jet, HasTheCoefficientsOfKnownSeries) {
  // At 0: e^x has 1/k!, 1/(1-x) has 1, log(1+x) has (-1)^(k+1)/k, sin has 0, 1, 0, -1/6, 0, 1/120.
  const jet5 x = jet5::variable(ball(0, bits));
  const jet5 e = exp(x);
  const jet5 geometric = 1 / (1 - x);
  const jet5 logarithm = log(1 + x);
  const jet5 sine = sin(x);
  const char* sines[] = {"0", "1", "0", "-1/6", "0", "1/120"};
  long factorial = 1;
  for (int k = 0; k <= 5; ++k) {
    if (k > 0) factorial *= k;
    EXPECT_TRUE(contains(e[k], rational(1, factorial)));
    EXPECT_TRUE(contains(geometric[k], rational(1)));
    if (k > 0) {
      EXPECT_TRUE(contains(logarithm[k], rational(k % 2 == 1 ? 1 : -1, k)));
    }
    EXPECT_TRUE(contains(sine[k], parse_rational(sines[k])));
  }
}

TEST(Jet, KeepsIdentitiesOfFunctions) {
  const jet5 x = at("0.3");
  expect_same(sin(x) * sin(x) + cos(x) * cos(x), jet5::constant(ball(1, bits)));
  expect_same(cosh(x) * cosh(x) - sinh(x) * sinh(x), jet5::constant(ball(1, bits)));
  expect_same(tan(x), sin(x) / cos(x));
  expect_same(tanh(x), sinh(x) / cosh(x));
  expect_same(exp(log(x)), x);
  expect_same(square(sqrt(x)), x);
  expect_same(tan(atan(x)), x);
  expect_same(sin(asin(x)), x);
  expect_same(cos(acos(x)), x);
  expect_same(sinh(asinh(x)), x);
  expect_same(tanh(atanh(x)), x);
  expect_same(cosh(acosh(x + 2)), x + 2);
  expect_same(pow(x, -3), 1 / (x * x * x));
  expect_same(pow(x, 0), jet5::constant(ball(1, bits)));
  expect_same(exp(2 * x), square(exp(x)));
}

TEST(Jet, OfEveryOrderAgrees) {
  const auto f = [](auto x) { return atan(x * x) + exp(x) / (x + 2); };
  const ball x = number("0.7");
  const auto five = f(jet5::variable(x));
  const auto run_time = f(jet<ball, dynamic_order>::variable(x, 7));
  const auto none = f(jet<ball, 0>::variable(x));
  EXPECT_TRUE(overlaps(none[0], five[0]));
  for (int k = 0; k <= 5; ++k) EXPECT_TRUE(overlaps(five[k], run_time[k]));
  EXPECT_TRUE(overlaps(derivative(f, x), five[1]));
}

TEST(Jet, WorksOverTheUncertifiedScalars) {
  const auto f = [](auto x) { return sin(x) * exp(x) / sqrt(x + 1); };
  const jet5 enclosures = f(at("1/2"));
  const auto doubles = f(jet<double, 5>::variable(0.5));
  const auto floats = f(jet<mpfr_float, 5>::variable(midpoint(number("1/2"))));
  for (int k = 0; k <= 5; ++k) {
    const double value = midpoint(enclosures[k]).convert_to<double>();
    EXPECT_NEAR(doubles[k], value, 1e-13 * (1 + std::abs(value)));
    EXPECT_TRUE(
        contains(enclosures[k].enlarged(magnitude::power_of_two(-bits / 2)), ball(floats[k])));
  }
}

TEST(Jet, OverABallHoldsTheDerivativesAtItsMembers) {
  support::random_source random(7);
  const auto f = [](auto x) { return log(x) * cos(x * x) - 1 / x; };
  for (int trial = 0; trial < static_cast<int>(20 * support::effort()) + 1; ++trial) {
    const ball wide = hull(ball(3, 64) / 2, ball(3, 64) / 2 + scale(ball(1 + trial, 64), -6));
    const auto over = f(jet<ball, 3>::variable(wide));
    for (int i = 0; i <= 4; ++i) {
      const ball member =
          ball(lower_rational(wide) + (upper_rational(wide) - lower_rational(wide)) * i / 4, bits);
      const auto there = f(jet<ball, 3>::variable(member));
      for (int k = 0; k <= 3; ++k) EXPECT_TRUE(overlaps(over[k], there[k])) << k;
    }
  }
}

TEST(Jet, IsUndefinedWhereAFunctionHasNoDerivative) {
  const auto x = jet<ball, 2>::variable(hull(ball(-1, bits), ball(1, bits)));
  EXPECT_FALSE(abs(x)[0].is_undefined());
  EXPECT_TRUE(abs(x)[1].is_undefined());
  EXPECT_TRUE((1 / x)[0].is_undefined());
  EXPECT_TRUE(sqrt(jet<ball, 2>::variable(ball(0, bits)))[1].is_undefined());
  EXPECT_TRUE(overlaps(abs(jet<ball, 2>::variable(ball(-3, bits)))[1], ball(-1, bits)));
}

TEST(TaylorRange, IsTighterAndStillHoldsTheRange) {
  // x^2 - x on [1, 1.1] has the range [0, 0.11].
  const auto f = [](const auto& x) { return x * x - x; };
  const ball x = hull(ball(1, bits), ball(11, bits) / 10);
  const ball plain = f(x);
  for (int n = 1; n <= 4; ++n) {
    const ball range = taylor_range(f, x, n);
    EXPECT_TRUE(contains(plain, range));
    EXPECT_TRUE(contains(range, rational(0)));
    EXPECT_TRUE(contains(range, rational(11, 100)));
    EXPECT_TRUE(certainly_less(range, parse_ball("0.1126", bits)));
  }
  EXPECT_FALSE(certainly_less(plain, parse_ball("0.2", bits)));
  // Where the derivative is not defined, plain evaluation.
  const auto g = [](const auto& y) { return abs(y); };
  const ball across = hull(ball(-1, bits), ball(2, bits));
  EXPECT_TRUE(contains(taylor_range(g, across), rational(2)));
  EXPECT_TRUE(contains(taylor_range(g, across), rational(0)));
}

TEST(Jet, PowersWithBallExponents) {
  const jet5 x = at("5/3");
  expect_same(pow(x, number("1/2")), sqrt(x));
  expect_same(pow(x, number("7/2")), x * x * x * sqrt(x));
  expect_same(pow(x, number("-1/2")), 1 / sqrt(x));
  expect_same(pow(x, number("3")), x * x * x);
  expect_same(pow(-x, number("3")), -x * x * x);
  expect_same(pow(x, pi(bits)), exp(pi(bits) * log(x)));
  expect_same(pow(x, x), exp(x * log(x)));
  const jet5 two = jet5::constant(number("2"));
  expect_same(pow(two, x), exp(x * log_2(bits)));
  // Not differentiable where the base may be 0, and not defined where it may be negative.
  const ball wide = hull(number("0"), number("1"));
  const jet5 root = pow(jet5::variable(wide), number("1/2"));
  EXPECT_TRUE(root[0].is_bounded());
  for (int k = 1; k <= 5; ++k) EXPECT_TRUE(root[k].is_undefined());
  EXPECT_TRUE(pow(jet5::variable(-wide), number("1/2"))[0].is_undefined());
}

TEST(Jet, ErrorFunction) {
  // erf' = (2/sqrt(pi)) e^(-x^2), and erf'' = -2 x erf'; erfc is 1 - erf.
  const jet5 x = at("0.7");
  const jet5 y = erf(x);
  const ball slope = 2 / sqrt(pi(bits)) * exp(-square(number("0.7")));
  EXPECT_TRUE(overlaps(y[0], erf(number("0.7"))));
  EXPECT_TRUE(overlaps(y.derivative(1), slope));
  EXPECT_TRUE(overlaps(y.derivative(2), -2 * number("0.7") * slope));
  EXPECT_TRUE(overlaps(y.derivative(3), (4 * square(number("0.7")) - 2) * slope));
  EXPECT_LT(y[5].radius(), magnitude::power_of_two(-150));
  expect_same(erfc(x), 1 - y);
}

TEST(Jet, FunctionsWithBreaks) {
  const jet5 x = at("5/3");
  const jet5 y = x * x;
  expect_same(min(x, y), x);
  expect_same(max(x, y), y);
  expect_same(min(y, x), x);
  expect_same(max(y, x), y);
  expect_same(floor(x), jet5::constant(number("1")));
  expect_same(ceil(x), jet5::constant(number("2")));
  expect_same(floor(-y), jet5::constant(number("-3")));
  const auto only_a_value = [](const jet5& z, const char* low, const char* high) {
    EXPECT_TRUE(contains(z[0], hull(number(low), number(high)))) << z[0];
    EXPECT_LT(z[0].radius(), magnitude::power_of_two(1));
    for (int k = 1; k <= 5; ++k) EXPECT_TRUE(z[k].is_undefined()) << k;
  };
  const jet5 around = jet5::variable(hull(number("1/2"), number("3/2")));
  const jet5 one = jet5::constant(number("1"));
  only_a_value(min(around, one), "1/2", "1");
  only_a_value(max(around, one), "1", "3/2");
  only_a_value(max(one, around), "1", "3/2");
  only_a_value(abs(around - 1), "0", "1/2");
  only_a_value(floor(around), "0", "1");
  only_a_value(ceil(around), "1", "2");
  only_a_value(floor(at("2")), "2", "2");
  only_a_value(ceil(at("2")), "2", "2");
  only_a_value(floor(jet5::variable(hull(number("1/2"), number("1")))), "0", "1");
}

TEST(Jet, OrdersThatDiffer) {
  using series = jet<ball, dynamic_order>;
  const series x = series::variable(number("5/3"), 3);
  const series y = series::variable(number("7/3"), 5);
  EXPECT_THROW(static_cast<void>(x + y), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(y - x), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(x * y), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(y / x), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(min(x, y)), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(max(x, y)), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(pow(x, y)), std::invalid_argument);
  EXPECT_EQ((x + series::variable(number("7/3"), 3)).order(), 3);
  // An order that is none, or not the type's.
  EXPECT_THROW(static_cast<void>(series(-2)), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(series::constant(number("1"))), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(series::variable(number("1"))), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(jet5::variable(number("1"), 6)), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(jet5::variable(number("1"), 4)), std::invalid_argument);
}

}  // namespace jet_test
}  // namespace polhode
