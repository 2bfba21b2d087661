// Roots of formulas.

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/expression/parse.hpp"
#include "polhode/quadrature/integrate.hpp"
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

TEST(FormulaRoots, BesideJumps) {
  struct known {
    const char* f;
    std::vector<rational> isolated;
    std::size_t all;
  };
  // Roots at a jump count once; the limit on one side of a jump is no root.
  const std::vector<known> functions{
      {"sign(x)", {0}, 1},
      {"sign(x - 1/3) + x", {}, 0},
      {"floor(x) - x/2", {0}, 1},
      {"ceil(x) - x/2", {0}, 1},
      {"x - floor(x)", {-4, -3, -2, -1, 0, 1, 2, 3, 4}, 9},
      {"x - floor(x) - 1/2", {}, 8},
      {"floor(floor(x)/2) - x/3", {0, 3}, 2},
      {"floor(sin(x)) + 1/2", {}, 0},
      {"floor(exp(x)) - x - 1", {0}, 3},
      {"exp(floor(x)) - x", {}, 0},
      {"floor(abs(x)) - abs(x)/2", {0}, 1},
      {"(x + 1)^2*(floor(x) + 7/2)", {-1}, 1},
      // A root beside a jump, of the branch on that side alone.
      {"floor(x) + 1 + x + 1/1000", {}, 1},
      {"ceil(x) - 1 + x - 1/1000", {}, 1},
      // More values than two, or a jump and back, beside a jump.
      {"floor(300*x - 100*sin(x)) + 5 - 40*x - 9/10", {}, 1},
      {"floor(4*x*(x - 1/100)) + 1 + x - 1/200", {}, 1},
      // Another slope on each side.
      {"x*min(floor(x) + 9, 17/2)", {0}, 1},
      {"x*max(ceil(x) + 9, 19/2)", {0}, 1},
      {"x*floor(floor(x) + 19/2)", {0}, 1},
      {"x*ceil(floor(x) + 19/2)", {0}, 1},
  };
  for (const known& k : functions) {
    const root_set found = isolate_roots(parse(k.f), -4, 4);
    EXPECT_TRUE(found.is_resolved()) << k.f;
    EXPECT_EQ(found.regions.size(), k.all) << k.f;
    std::vector<rational> isolated;
    for (const root_region& r : found.regions) {
      if (r.verdict == root_verdict::isolated) isolated.push_back(r.exact.value_or(1000));
    }
    EXPECT_EQ(isolated, k.isolated) << k.f;
  }
  // At 0 it is 0, which no rule decides here.
  const expression f = parse("sign(x) + sqrt(3)*gamma(1/3)*gamma(2/3)/(2*pi) - 1");
  EXPECT_FALSE(isolate_roots(f, -1, 1).is_resolved());
  const root_set decided = isolate_roots(parse("sign(x) + sin(1)^2 + cos(1)^2 - 1"), -1, 1);
  ASSERT_TRUE(decided.is_resolved());
  ASSERT_EQ(decided.regions.size(), 1U);
  EXPECT_EQ(decided.regions[0].exact, rational(0));
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

/// Towards an end where the function grows as a logarithm, which is no root, on one side or both.
TEST(FormulaRoots, BesideLogarithmicEndsAreFound) {
  const auto count = [](const char* text, const end_point& lower, const end_point& upper) {
    const root_set found = isolate_roots(parse(text), lower, upper, {.most_boxes = 3000});
    EXPECT_TRUE(found.is_resolved()) << text;
    return found.regions.size();
  };
  EXPECT_EQ(count("ellipticK(x)-2", 0, 1), 1U);
  EXPECT_EQ(count("ellipticK(x)-20", 0, 1), 1U);
  EXPECT_EQ(count("ellipticK(x)-1", 0, 1), 0U);
  EXPECT_EQ(count("ellipticK(1-x)-3", 0, 1), 1U);
  EXPECT_EQ(count("ellipticK(x^2)-3", -1, 1), 2U);
  EXPECT_EQ(count("ellipticK(cos(x)^2)-3", -2, 2), 2U);
  EXPECT_EQ(count("1/agm(1,x)-2", 0, 1), 1U);
  EXPECT_EQ(count("x*ellipticK(1-x)-1/2", 0, 1), 1U);
  EXPECT_EQ(count("ellipticK(x)-ellipticE(x)-1", 0, 1), 1U);
}

}  // namespace formula_roots_test
}  // namespace polhode::test
