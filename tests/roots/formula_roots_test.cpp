// Roots of formulas.

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/expression/parse.hpp"
#include "polhode/quadrature/formula_end.hpp"
#include "polhode/roots/isolate.hpp"
#include "support/exact_set.hpp"

namespace polhode::test {
namespace formula_roots_test {

/// The enclosure holds the number, and is narrow.
void expect_number(const ball& found, const ball& known, long digits) {
  EXPECT_TRUE(overlaps(found, known));
  EXPECT_LE(found.radius(), pow(ball(10, 64), -digits).magnitude_upper());
}

TEST(FormulaRoots, AreThoseOfTheFormula) {
  const root_set found =
      isolate_roots(parse("(x-1)*(x^2-2)^3"), -end_point::infinity(), end_point::infinity());
  ASSERT_TRUE(found.is_resolved());
  ASSERT_EQ(found.regions.size(), 3U);
  EXPECT_EQ(found.regions[0].multiplicity, 3);
  EXPECT_EQ(found.regions[1].exact, 1);
  expect_number(refine(found.regions[2], 30).enclosure, sqrt(ball(2, 200)), 29);
}

TEST(FormulaRoots, AtAnEndThatIsAMultipleOfPiAreInside) {
  const root_set found = isolate_roots(parse("sin(x)"), 1, end_point_of(parse("3*pi", {})));
  EXPECT_TRUE(found.is_resolved());
  EXPECT_EQ(found.regions.size(), 3U);
}

/// A lambda and its formula's text are one function: the same regions, bit for bit.
TEST(FormulaRoots, AreTheSameOfALambdaAndOfItsText) {
  const auto check = [](const auto& f, const end_point& a, const end_point& b) {
    const std::string text = formula_of(f).to_text();
    const root_set of_lambda = isolate_roots(f, a, b);
    const root_set of_text = isolate_roots(parse(text), a, b);
    EXPECT_EQ(of_lambda.complete, of_text.complete) << text;
    ASSERT_EQ(of_lambda.regions.size(), of_text.regions.size()) << text;
    for (std::size_t i = 0; i < of_text.regions.size(); ++i) {
      const root_region& x = of_lambda.regions[i];
      const root_region& y = of_text.regions[i];
      EXPECT_EQ(x.verdict, y.verdict) << text;
      EXPECT_EQ(x.multiplicity, y.multiplicity) << text;
      EXPECT_EQ(x.exact, y.exact) << text;
      EXPECT_TRUE(support::identical(x.enclosure, y.enclosure)) << text;
    }
  };
  const end_point infinity = end_point::infinity();
  check([](const auto& x) { return cos(x) - x; }, 0, 1);
  check([](const auto& x) { return square(sin(x)) * exp(x); }, -4, 4);
  check([](const auto& x) { return sqrt(abs(x)) - rational(1, 2); }, -infinity, infinity);
  check([](const auto& x) { return tan(x) * (x - 1) / (square(x) - 2); }, -5, 5);
  check([](const auto& x) { return pow(x, 5) - 3 * x + 1; }, -infinity, infinity);
  check([](const auto& x) { return erf(x) - rational(1, 2); }, -2, 2);
  check([](const auto& x) { return floor(x) - rational(1, 2); }, 0, 3);
  check([](const auto& x) { return max(x, 1 - x) - rational(3, 4); }, 0, 1);
}

/// Where numerator and divisor vanish at a number q + r pi, a series there has a sign beside it, or
/// a root is beside it.
TEST(FormulaRoots, BesidePointsWithoutValue) {
  const root_set none = isolate_roots(parse("sin(pi*x)/(x-1)"), rational(1, 2), rational(3, 2));
  EXPECT_TRUE(none.is_resolved());
  EXPECT_TRUE(none.regions.empty());
  for (const char* const offset : {"1e-3", "1e-6", "1e-12"}) {
    const std::string near = std::string("sin(pi*x)/(x-1)*(x-1-") + offset + ")";
    const root_set one = isolate_roots(parse(near), rational(1, 2), rational(3, 2));
    ASSERT_EQ(one.regions.size(), 1U) << offset;
    EXPECT_TRUE(contains(one.regions[0].enclosure, 1 + parse_rational(offset))) << offset;
  }
  const root_set ends = isolate_roots(parse("sin(pi*x)/(x^2-1)"), -3, 3);
  EXPECT_TRUE(ends.is_resolved());
  EXPECT_EQ(ends.regions.size(), 5U);
}

TEST(FormulaRoots, OfPowersAtRationalNumbers) {
  const root_set twice = isolate_roots(parse("x^x-x"), rational(1, 2), 2);
  ASSERT_TRUE(twice.is_resolved());
  ASSERT_EQ(twice.regions.size(), 1U);
  EXPECT_EQ(twice.regions[0].multiplicity, 2);
  EXPECT_EQ(twice.regions[0].exact, 1);
  // (x^x - 1)^2
  const root_set square = isolate_roots(parse("x^(2*x)-2*x^x+1"), rational(1, 2), 2);
  ASSERT_EQ(square.regions.size(), 1U);
  EXPECT_EQ(square.regions[0].multiplicity, 2);
  // A kink, where the function is not defined on one side.
  const root_set kink = isolate_roots(parse("x^(1/3)-x"), -2, 2);
  EXPECT_TRUE(kink.is_resolved());
  ASSERT_EQ(kink.regions.size(), 2U);
  EXPECT_EQ(kink.regions[0].exact, 0);
  // 0^0 and powers of 0 with negative exponents have no value.
  for (const char* const f : {"x^x", "x^(x-1)", "x^(-1/3)"}) {
    for (const root_region& r : isolate_roots(parse(f), -1, 1).regions) {
      EXPECT_NE(r.exact, 0) << f;
    }
  }
}

}  // namespace formula_roots_test
}  // namespace polhode::test
