// Points that the search for roots guesses, and double roots there.

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/expression/parse.hpp"
#include "polhode/roots/isolate.hpp"
#include "roots/search/exact_points.hpp"

namespace polhode {
namespace guessed_points_test {

using detail::exact_box;
using detail::exact_point;
using detail::guessed_points;

bool is_guessed(const std::string& f, const exact_box& b, const std::string& point) {
  const ball value = parse(point).value(400);
  for (const exact_point& at : guessed_points(parse(f, {"x"}), b, 200)) {
    if (overlaps(at.at(400), value)) return true;
  }
  return false;
}

/// The box of this relative half width around a number.
exact_box around(const std::string& number, const char* half_width) {
  const ball value = parse(number).value(400);
  const rational half = parse_rational(half_width);
  return {lower_rational(value) - half, upper_rational(value) + half};
}

TEST(GuessedPoints, AreMultiplesOfConstantsAndSimpleFunctions) {
  for (const char* number : {"sqrt(2)", "3/4*sqrt(2)", "-sqrt(2)", "sqrt(7)", "-sqrt(7)", "log(5)",
                             "-log(5)", "exp(2)", "exp(-1/3)", "e", "2*e/3"}) {
    const exact_box b = around(number, "1e-40");
    const std::string f = std::string(number).find("2*e/3") == 0 ? "x*e+1" : "x^2-2*sqrt(2)*x+2";
    EXPECT_TRUE(is_guessed(f, b, number)) << number;
  }
  EXPECT_FALSE(is_guessed("x^2-2*sqrt(2)*x+2", around("cos(1)", "1e-40"), "cos(1)"));
  EXPECT_TRUE(guessed_points(parse("x^2-2", {"x"}), around("cos(1)", "1e-40"), 200).empty());
  EXPECT_TRUE(is_guessed("x-cos(1)", around("cos(1)", "1e-40"), "cos(1)"));
}

/// A point beside the box is none in it, however near.
TEST(GuessedPoints, AreInTheBox) {
  const ball value = parse("sqrt(2)").value(1000);
  const rational tiny = parse_rational("1e-200");
  const rational below = lower_rational(value);
  const rational above = upper_rational(value);
  EXPECT_FALSE(is_guessed("x*sqrt(2)", {above + tiny, above + 1}, "sqrt(2)"));
  EXPECT_FALSE(is_guessed("x*sqrt(2)", {below - 1, below - tiny}, "sqrt(2)"));
  EXPECT_TRUE(
      is_guessed("x*sqrt(2)", {below - tiny * pow(integer(10), 160), above + 1}, "sqrt(2)"));
}

root_set roots_of(const char* f, const rational& from, const rational& to) {
  return isolate_roots(parse(f, {"x"}), from, to);
}

TEST(GuessedPoints, MakeDoubleRootsExact) {
  struct given {
    const char* f;
    const char* root;
    long multiplicity;
  };
  for (const given& g : {given{"x^2-2*sqrt(2)*x+2", "sqrt(2)", 2}, given{"log(x)-x/e", "e", 2},
                         given{"x^3-3*sqrt(3)*x^2+9*x-3*sqrt(3)", "sqrt(3)", 3},
                         given{"exp(2*x)-6*exp(x)+9", "log(3)", 2}, given{"x*log(x)+1/e", "1/e", 2},
                         given{"(x^2-2*sqrt(5)*x+5)*(2+sin(x))*exp(x)", "sqrt(5)", 2},
                         given{"(x^2-2*sqrt(5)*x+5)/(1+x^2)", "sqrt(5)", 2},
                         given{"cosh(x)-5/3-4/3*(x-log(3))", "log(3)", 2}}) {
    const root_set s = roots_of(g.f, rational(1, 10), 5);
    ASSERT_TRUE(s.is_resolved() && s.complete) << g.f;
    ASSERT_EQ(s.regions.size(), 1U) << g.f;
    EXPECT_EQ(s.regions[0].multiplicity, g.multiplicity) << g.f;
    EXPECT_TRUE(overlaps(s.regions[0].enclosure, parse(g.root).value(300))) << g.f;
  }
}

/// What has no double root has none, and two roots that are near are two.
TEST(GuessedPoints, ProveNothingByThemselves) {
  EXPECT_EQ(roots_of("x^2-2*sqrt(2)*x+2+1e-40", 0, 3).regions.size(), 0U);
  const root_set two = roots_of("x^2-2*sqrt(2)*x+2-1e-40", 0, 3);
  ASSERT_EQ(two.regions.size(), 2U);
  for (const root_region& r : two.regions) EXPECT_EQ(r.verdict, root_verdict::unique);
  // sqrt(2) is a root, and another is beside it.
  const root_set beside = roots_of("(x-sqrt(2))*(x-sqrt(2)-1e-40)", 0, 3);
  EXPECT_TRUE(beside.is_resolved());
  EXPECT_EQ(beside.regions.size(), 2U);
}

}  // namespace guessed_points_test
}  // namespace polhode
