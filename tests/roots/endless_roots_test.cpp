// Infinitely many roots towards infinity and towards points, and functions that have none although
// they oscillate.

#include <algorithm>
#include <string>
#include <tuple>

#include <gtest/gtest.h>

#include "polhode/arithmetic/exact.hpp"
#include "polhode/expression/library_functions.hpp"
#include "polhode/expression/parse.hpp"
#include "polhode/roots/isolate.hpp"
#include "roots/endless_roots.hpp"

namespace polhode::test {
namespace endless_roots_test {

/// How many regions are said to hold infinitely many roots, and "open" where more is not resolved.
std::string found_by(const std::string& f, const end_point& lower, const end_point& upper) {
  const isolate_options few{.most_boxes = 3'000, .most_unresolved = 100, .most_towards_end = 10};
  const root_set found = isolate_roots(parse(f), lower, upper, few);
  const auto endless = std::ranges::count_if(found.regions, [](const root_region& r) {
    return r.verdict == root_verdict::infinitely_many;
  });
  return std::to_string(endless) + (found.is_resolved() ? "" : ", open");
}

class EndlessRoots : public ::testing::TestWithParam<const char*> {};

TEST_P(EndlessRoots, AreProvedTowardsInfinity) {
  EXPECT_EQ(found_by(GetParam(), 1, end_point::infinity()), "1");
}
INSTANTIATE_TEST_SUITE_P(
    Endless, EndlessRoots,
    ::testing::Values("x*sin(x)-1", "cos(x)-exp(-x)", "cos(x)*cosh(x)-1", "sin(x^2)",
                      "sin(sqrt(x))-1/x", "cos(log(x))-1/x", "sin(exp(x))", "gamma(x)*sin(x)-1",
                      "sqrt(x+sin(x))*cos(x)-1", "log(x+2*sin(x)^2+1)*sin(x)-1", "x*(1+sin(x))",
                      "sin(x)+sin(pi*x)/2", "sin(x+sin(x))-1/x", "3*sin(2*x+1)-4*cos(x/3)-log(x)/x",
                      "cos(3-2*x)-1/x", "sin(pi*x/7)-1/x", "sin(sqrt(2)*x)-1/x", "cos(x)-1+1/x",
                      // Between poles.
                      "tan(x)-x", "x*tan(x)-1", "tan(x)^2-x", "cot(x)-x", "1/sin(x)-x",
                      "tan(x)*cos(x)/x", "1/sin(x)^2-x", "tan(x)+tanh(x)", "1/(1+2*sin(x))-x"));

class NoEndlessRoots : public ::testing::TestWithParam<const char*> {};

/// Of these none has infinitely many roots; some are not followed.
TEST_P(NoEndlessRoots, AreNotClaimed) {
  EXPECT_FALSE(detail::has_endless_roots(parse(GetParam()), 1));
  const std::string found = found_by(GetParam(), 1, end_point::infinity());
  EXPECT_TRUE(found == "0" || found == "0, open") << found;
}
INSTANTIATE_TEST_SUITE_P(
    None, NoEndlessRoots,
    ::testing::Values(
        // The zeros are those of divisors.
        "x*sin(x)/sin(x)", "x/(2*sin(2*x))", "cos(2*x)/sin(4*x)*x", "x*(1-cos(x))/sin(x)^2",
        "tan(x)*cos(x)/sin(x)+1/x", "(x*sin(x)-1)/(x*sin(x)-1)", "x*sin(x)^2/sin(x)/sin(x)",
        // The sign jumps.
        "atan(1/sin(x))+exp(-x)", "floor(sin(x))+1/2+1/(x+2)", "x*(floor(sin(x))+1/2)",
        "sin(pi*floor(x)+pi/2)+1/2+1/x", "ceil(cos(x))-1/2+1/(4*x)",
        // Not defined where the sign would change.
        "x*sin(x)/(2+0*log(4*sin(x)^2-1))", "x*sin(x)/(x+sqrt(4*sin(x)^2-1))",
        "atan(sin(x)^-1)+exp(-x)", "x*sin(x)+0*root(4*sin(x)^2-1,4)", "(x-x)/cos(pi*floor(x)+pi/2)",
        "x*sin(x)+0*log1p(4*sin(x)^2-2)", "x*sin(x)+0*gamma(4*sin(x)^2-1)",
        "x*sin(x)+0*log(4*sin(x)^2-1)", "x*sin(x)+0*sqrt(4*sin(x)^2-1)",
        "x*sin(x)+0*(4*sin(x)^2-1)^(1/3)", "x*sin(x)+0*acosh(2*sin(x)^2+3/4)",
        // Not defined for some angles.
        "exp(1/sin(x))+x", "x+log(1/sin(x)^2)", "x*sin(x)+0*exp(1/sin(x))",
        // The waves cancel.
        "x*(sin(x^2-1)+sin(1-x^2))+1", "x*(sin(2*(x^2+1))-sin(2*x^2+2))+1",
        "x*(sin(2*(3*x^2))-sin(6*x^2))+1", "x*(sin(3*(x^2/2))-sin(3/2*x^2))+1",
        "x*(sin(-x^2)+sin(x^2))+1", "x*(cos(1-x^2)-cos(x^2-1))+1",
        // The angle comes to rest, or the amplitude is too small.
        "x*sin(1/x)-3", "x*sin(atan(x))-3", "sin(x)-1-1/x", "x+2*sin(x)", "cos(x)+1+exp(-x)",
        "sin(x)*exp(-x)+exp(-x/2)", "sin(x^2)/x+1/sqrt(x)", "x*(2+cos(x))-3*sin(x)"));

TEST(EndlessRoots, AreProvedOnBothSidesAndTowardsPoints) {
  const end_point end = end_point::infinity();
  EXPECT_EQ(found_by("x*cos(x)-1", -end, end), "2");
  EXPECT_EQ(found_by("sin(x)-exp(x)", -end, end), "1");
  EXPECT_EQ(found_by("sin(1/x)", 0, 1), "1");
  EXPECT_EQ(found_by("sin(1/x)", -1, 0), "1");
  EXPECT_EQ(found_by("sin(1/x)-x", -1, 1), "1");
  EXPECT_EQ(found_by("x*sin(1/(3*x-1))-x^2", 0, 1), "1");
  EXPECT_EQ(found_by("sin(1/(x^3-2))", 1, 2), "1");
  EXPECT_EQ(found_by("cos(log(x))", 0, 1), "1");
  EXPECT_EQ(found_by("cos(log(x-1))", 1, 2), "1");
  EXPECT_EQ(found_by("tan(1/x)-1/x", 0, 1), "1");
  // They are on the other side, elsewhere, or none.
  const auto is_endless = [](const char* f, const rational& lower, const rational& upper) {
    return detail::has_endless_roots_in(parse(f), lower, upper);
  };
  EXPECT_TRUE(is_endless("cos(log(-x))", -1, 0));
  EXPECT_FALSE(is_endless("cos(log(-x))", 0, 1));
  EXPECT_TRUE(is_endless("cos(log(x))", 0, 1));
  EXPECT_FALSE(is_endless("cos(log(x))", -1, 0));
  EXPECT_FALSE(is_endless("cos(log(x))", 0, 0));
  EXPECT_TRUE(is_endless("sin(1/(x-2))", 1, 3));
  EXPECT_FALSE(is_endless("sin(1/(x-2))", 0, 1));
  EXPECT_FALSE(is_endless("sin(1/(x-2))", 3, 4));
  EXPECT_EQ(found_by("sin(exp(1/x))-1/2", -1, 0), "0");
  EXPECT_EQ(found_by("1+x*sin(1/x)/2", -1, 1), "0");
}

TEST(EndlessRoots, AreProvedOfWavesOfLargeArguments) {
  const auto is_endless = [](const char* f) { return detail::has_endless_roots(parse(f), 1); };
  for (const char* f :
       {"besselJ(0,x)", "besselJ(7,x)", "besselJ(-1/3,x)", "besselY(0,x)", "besselY(5/2,x)",
        "airyAi(-x)", "airyBi(-x)", "airyAiPrime(-x)", "airyBiPrime(-x)", "besselJ(3,-x)",
        "besselJ(0,x)-1/x", "besselJ(0,x)-7/(9*sqrt(x))", "x*besselJ(1,x^2)-1/2",
        "besselJ(0,x)*besselY(0,x)", "cos(x)-besselJ(0,x)", "besselJ(0,x)+sin(x)/5",
        "besselJ(1/2,x)-sqrt(2/(pi*x))*sin(x)", "airyAi(-x)-1/x", "besselJ(0,x)/(1+x^2)"}) {
    EXPECT_TRUE(is_endless(f)) << f;
  }
  for (const char* f :
       {"besselJ(0,x)-9/(10*sqrt(x))", "airyAi(-x)-1", "besselJ(0,x)/besselJ(0,x)",
        "besselJ(0,x)+besselJ(0,-x)-2/sqrt(x)", "besselJ(1,x)+besselJ(1,-x)+exp(-x)",
        "besselJ(0,x)-sqrt(2/(pi*x))*(cos(x-pi/4)+sin(x-pi/4)/(8*x))+1/(20*x^(3/2))", "airyAi(x)",
        "besselK(0,x)", "besselJ(0,1/x)-2", "atan(1/besselJ(0,x))+exp(-x)"}) {
    EXPECT_FALSE(is_endless(f)) << f;
  }
  // Of small arguments nothing is known.
  const auto is_wave = [](const char* f, int sign_of_all) {
    return parse(f).by_waves(
        [=](const expression& u) { return u.operation_count() > 0 ? sign_of_all : 1; });
  };
  EXPECT_TRUE(is_wave("besselJ(0,x)", 1));
  EXPECT_FALSE(is_wave("besselJ(0,x)", -1));
  EXPECT_FALSE(is_wave("besselJ(0,x)", 0));
  EXPECT_FALSE(is_wave("airyAi(x)", 1));
  EXPECT_TRUE(detail::has_endless_roots(parse("airyAi(x)"), -1));
  EXPECT_TRUE(detail::has_endless_roots(parse("besselJ(1,x)"), -1));
  EXPECT_FALSE(detail::has_endless_roots(parse("airyAi(-x)"), -1));
  EXPECT_EQ(found_by("besselJ(0,1/x)", 0, 1), "1");
}

/// What is left out of the list is one region, and the answer counts as complete.
TEST(EndlessRoots, LeaveAListOfTheNearestOnes) {
  const isolate_options few{.most_towards_end = 10};
  const root_set found = isolate_roots(parse("x*sin(x)-1"), 0, end_point::infinity(), few);
  ASSERT_EQ(found.regions.size(), 11U);
  EXPECT_TRUE(found.complete);
  EXPECT_TRUE(found.is_resolved());
  const root_region& rest = found.regions.back();
  EXPECT_EQ(to_text(rest.verdict), "infinitely many");
  EXPECT_FALSE(rest.box.is_bounded());
  EXPECT_EQ(rest.multiplicity, 0);
  // A limit ends the search before: then nothing is said of the rest.
  root_search s(parse("x*sin(x)-1"), 0, end_point::infinity());
  s.run({.most_boxes = 20});
  EXPECT_FALSE(s.result().complete);
  EXPECT_EQ(s.result().regions.back().verdict, root_verdict::unresolved);
}

}  // namespace endless_roots_test
}  // namespace polhode::test
