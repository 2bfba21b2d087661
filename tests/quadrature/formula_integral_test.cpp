// Integrals of formulas.

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "polhode/expression/parse.hpp"
#include "polhode/quadrature/contour.hpp"
#include "polhode/quadrature/integrate.hpp"
#include "polhode/quadrature/integrate_box.hpp"

namespace polhode::test {
namespace formula_integral_test {

/// The enclosure holds the number, and is narrow.
void expect_number(const ball& found, const ball& known, long digits) {
  EXPECT_TRUE(overlaps(found, known));
  EXPECT_LE(found.radius(), pow(ball(10, 64), -digits).magnitude_upper());
}

TEST(FormulaIntegral, IsThatOfTheFormula) {
  const end_point infinity = end_point::infinity();
  const integral bell = integrate(parse("exp(-x^2)"), -infinity, infinity, {.digits = 40});
  ASSERT_EQ(bell.verdict, status::certified) << bell.obstacle;
  expect_number(bell.enclosure, sqrt(pi(300)), 39);
  // Singular at an end, and a limit that is a multiple of pi.
  const integral root = integrate(parse("1/sqrt(y)", {"y"}), 0, 4, {.digits = 30});
  ASSERT_EQ(root.verdict, status::certified) << root.obstacle;
  expect_number(root.enclosure, ball(4, 300), 28);
  const integral sine =
      integrate(parse("sin(x)"), 0, end_point_of(parse("pi", {})), {.digits = 30});
  expect_number(sine.enclosure, ball(2, 300), 28);
  // A formula without variables.
  expect_number(integrate(parse("3", {}), 1, 2).enclosure, ball(3, 300), 14);
}

TEST(FormulaIntegral, DivergentOnesAreRefused) {
  EXPECT_EQ(integrate(parse("1/x"), -1, 1).verdict, status::not_certified);
  EXPECT_EQ(integrate(parse("1/x"), 1, end_point::infinity()).verdict, status::not_certified);
}

TEST(FormulaIntegral, EndlessPanelsAreGivenUpWithThePoint) {
  for (const char* formula : {"sqrt(exp(2*x)-6*exp(x)+9)", "sqrt(sinh(x)^2-8/3*sinh(x)+16/9)"}) {
    const integral found = integrate(parse(formula), 0, 3, {.digits = 30});
    EXPECT_EQ(found.why, reason::not_analytic) << formula;
    EXPECT_NE(found.obstacle.find("the branch cut of sqrt near x = 1.09"), std::string::npos)
        << found.obstacle;
  }
}

TEST(FormulaIntegral, LimitsAreAsExactAsTheirFormulas) {
  EXPECT_EQ(end_point_of(parse("1/3 + 1/6", {})).exact(), rational(1, 2));
  const end_point combination = end_point_of(parse("1 - 2*pi/3", {}));
  ASSERT_TRUE(combination.form().has_value());
  EXPECT_EQ(combination.form()->q, 1);
  EXPECT_EQ(combination.form()->r, rational(-2, 3));
  EXPECT_FALSE(end_point_of(parse("sqrt(2)", {})).form().has_value());
  EXPECT_TRUE(overlaps(end_point_of(parse("sqrt(2)", {})).at(200), sqrt(ball(2, 200))));
  EXPECT_EQ(end_point_of(parse("pi/2", {})).form()->r, rational(1, 2));
}

TEST(FormulaIntegral, AlongAPathWithAndWithoutTheImaginaryUnit) {
  const path circle = path::circle(0, 1);
  for (const expression& f : {parse("exp(z)/z^3", {"z"}), parse("-i^2*exp(z)/z^3", {"z", "i"})}) {
    const contour_integral found = integrate_along(f, circle, {.digits = 25});
    ASSERT_EQ(found.verdict, status::certified) << found.obstacle;
    expect_number(found.enclosure.re, ball(0, 200), 24);
    expect_number(found.enclosure.im, pi(200), 24);
  }
  const contour_integral turned = integrate_along(parse("i/z", {"z", "i"}), circle);
  expect_number(turned.enclosure.re, -2 * pi(200), 14);
}

TEST(FormulaIntegral, AlongAPathFunctionsThatAreNotAnalyticAreRefused) {
  const contour_integral found = integrate_along(parse("abs(z)", {"z"}), path::circle(0, 1));
  EXPECT_EQ(found.verdict, status::not_certified);
  EXPECT_EQ(found.why, reason::not_analytic);
  EXPECT_EQ(found.obstacle, "abs is not analytic in the complex plane");
  EXPECT_TRUE(found.enclosure.re.is_undefined());
}

TEST(FormulaIntegral, OverABoxOfParameters) {
  const box_integral found = integrate_box(parse("k*x", {"x", "k"}), 0, 2, {{1, 3}});
  ASSERT_EQ(found.verdict, status::certified) << found.obstacle;
  EXPECT_LE(lower_rational(found.enclosure), 2);
  EXPECT_GE(upper_rational(found.enclosure), 6);
  EXPECT_LT(upper_rational(found.enclosure), 7);
}

TEST(FormulaIntegral, AnotherNumberOfVariablesIsRefused) {
  const expression two = parse("x*y", {"x", "y"});
  const expression three = parse("x*y*i", {"x", "y", "i"});
  EXPECT_THROW((void)integrate(two, 0, 1), input_error);
  EXPECT_THROW((void)end_point_of(parse("x")), input_error);
  EXPECT_THROW((void)integrate_along(three, path::circle(0, 1)), input_error);
  EXPECT_THROW((void)integrate_box(two, 0, 1, {}), input_error);
  EXPECT_THROW((void)integrate_box(two, 0, 1, {{1, 2}, {1, 2}}), input_error);
}

TEST(FormalZero, IsShownByExpansion) {
  for (const char* f :
       {"x-x", "sin(x)-sin(x)", "x*sin(x)-sin(x)*x", "(1+exp(x))^2-1-2*exp(x)-exp(x)^2",
        "sqrt(x)-sqrt(x)", "-(cos(x)-2)+cos(x)-2", "(x+sin(x))*(x-sin(x))-x^2+sin(x)^2",
        "(sin(x)+log(x))^3-sin(x)^3-3*sin(x)^2*log(x)-3*sin(x)*log(x)^2-log(x)^3", "0*sin(x)"}) {
    EXPECT_TRUE(parse(f).is_formally_zero()) << f;
  }
  for (const char* f : {"sin(x)-sin(2*x)", "sin(x)^2+cos(x)^2-1", "x", "1", "x-x+1e-300",
                        "sin(x)-cos(x)", "x*sin(x)-sin(x)", "exp(x)^2-exp(2*x)",
                        "(1+exp(x))^2-1-2*exp(x)-exp(x)^3", "sqrt(x)*sqrt(x)-x"}) {
    EXPECT_FALSE(parse(f).is_formally_zero()) << f;
  }
}

TEST(FormalZero, IntegralsAreZeroWhereTheFunctionIsDefined) {
  const integral zero = integrate(parse("sin(x)-sin(x)"), 0, 1, {.digits = 30});
  EXPECT_EQ(zero.verdict, status::certified);
  EXPECT_TRUE(zero.enclosure.is_exact() && contains_zero(zero.enclosure));
  EXPECT_EQ(integrate(parse("sqrt(x)-sqrt(x)"), -1, 1, {.digits = 30}).verdict,
            status::not_certified);
  EXPECT_EQ(integrate(parse("log(x)-log(x)"), -2, -1, {.digits = 30}).verdict,
            status::not_certified);
  const integral small = integrate(parse("sin(x)-sin(x)+1e-60"), 0, 1, {.digits = 30});
  EXPECT_EQ(small.verdict, status::certified);
  EXPECT_TRUE(certainly_positive(small.enclosure));
}

/// A value that cannot be told from 0: 10^-digits of the integral of |f| counts.
TEST(IntegralsOfZero, AreCertifiedRelativeToTheIntegralOfTheSize) {
  for (const char* end : {"2*pi", "6*pi", "20*pi", "64*pi"}) {
    for (const long digits : {5L, 30L, 100L}) {
      const integral i =
          integrate(parse("sin(x)*cos(2*x)"), 0, end_point_of(parse(end, {})), {.digits = digits});
      EXPECT_EQ(i.verdict, status::certified) << end << ", " << digits;
      EXPECT_TRUE(contains_zero(i.enclosure));
      // The integral of |f| over a period is above 1.
      EXPECT_LE(i.enclosure.radius(), scale(pow(ball(10, 64), -digits).magnitude_upper(), 7));
    }
  }
  // 0 everywhere, as the antiderivative shows, and where nothing does.
  EXPECT_EQ(integrate(parse("sin(x)^2+cos(x)^2-1"), 0, 1, {.digits = 30}).verdict,
            status::certified);
  EXPECT_EQ(integrate(parse("sin(exp(x))^2+cos(exp(x))^2-1"), 0, 1, {.digits = 30}).verdict,
            status::not_certified);
}

/// A ball in a lambda is a number that is known as far as the ball says, at singular points as
/// well: what is found holds the integral with every number in it, and what diverges for one of
/// them is not certified.
TEST(FormulaIntegral, OfNumbersInBallsHoldsThatOfTheNumber) {
  const end_point infinity = end_point::infinity();
  const precision p = 2000;
  const ball root = sqrt(ball(2, p));
  const auto holds = [](const integral& i, const ball& value) {
    return !i.enclosure.is_bounded() || overlaps(i.enclosure, value);
  };
  for (const precision bits : {2L, 53L, 200L, 4000L}) {
    const ball k = sqrt(ball(2, bits));
    const integrate_options few{.digits = 10, .most_evaluations = 100'000};
    const integral plain = integrate([k](const auto& x) { return k * x; }, 0, 1, {.digits = 30});
    EXPECT_TRUE(holds(plain, scale(root, -1)));
    EXPECT_EQ(plain.verdict == status::certified, bits >= 200) << bits;
    EXPECT_TRUE(holds(integrate([k](const auto& x) { return 1 / sqrt(k - x); }, 0, 1, few),
                      2 * (sqrt(root) - sqrt(root - 1))));
    EXPECT_TRUE(
        holds(integrate([k](const auto& x) { return 1 / sqrt(abs(square(x) - k * k)); }, 0, 2, few),
              scale(pi(p), -1) + acosh(2 / root)));
    EXPECT_TRUE(
        holds(integrate([k](const auto& x) { return exp(-k * x); }, 0, infinity, few), 1 / root));
    EXPECT_TRUE(holds(integrate([k](const auto& x) { return pow(x, -k / 2); }, 0, 1, few),
                      1 / (1 - scale(root, -1))));
    EXPECT_TRUE(
        holds(integrate([k](const auto& x) { return (square(x) - k * k) / (x - k); }, 0, 2, few),
              2 + 2 * root));
    EXPECT_TRUE(holds(integrate([k](const auto& x) { return floor(x + k); }, 0, 1, few), root));
    EXPECT_NE(integrate([k](const auto& x) { return 1 / (x - k); }, 0, 2, few).verdict,
              status::certified);
    EXPECT_NE(integrate([k](const auto& x) { return pow(x, -k * k / 2); }, 0, 1, few).verdict,
              status::certified);
  }
  // Two uses of a ball may be two numbers.
  const ball wide = hull(ball(1, 64), ball(2, 64));
  const integral difference = integrate([&](const auto& x) { return wide * x - wide * x; }, 0, 1);
  EXPECT_TRUE(
      contains(difference.enclosure, hull(ball(rational(-1, 2), 64), ball(rational(1, 2), 64))));
}

}  // namespace formula_integral_test
}  // namespace polhode::test
