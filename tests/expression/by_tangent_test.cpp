// Formulas in u = tan(x).

#include <gtest/gtest.h>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "polhode/expression/expression.hpp"

namespace polhode {
namespace by_tangent_test {

expression parse(const char* text) { return expression(text, {{"x"}, {}}); }

TEST(ByTangent, IsTheFunctionOfTheTangentOnEachBranch) {
  for (const char* text :
       {"cos(tan(x))", "x*sin(tan(x))", "cos(2*tan(x)^2 + 1)*sin(x)^3", "sin(tan(x))/cos(x)",
        "exp(-x)*cos(tan(x)/3) + sin(x)*cos(x)", "cos(tan(x))*tan(2*x)"}) {
    const expression f = parse(text);
    for (const long k : {0L, 1L, -2L, 5L}) {
      const std::optional<expression> g = f.by_tangent(k);
      ASSERT_TRUE(g) << text;
      for (const rational& at : {rational(1, 3), rational(-7, 2), rational(0), rational(12)}) {
        const ball u(at, 128);
        const ball x = atan(ball(at, 256)) + k * pi(256);
        const ball expected = f(x) / (1 + square(ball(at, 256)));
        const ball value = (*g)(u);
        EXPECT_TRUE(overlaps(value, expected)) << text << " at u = " << at << ", k = " << k;
        EXPECT_TRUE(value.radius() < magnitude::power_of_two(-80)) << text;
      }
    }
  }
}

TEST(ByTangent, IsForWavesOfTheTangentAlone) {
  for (const char* text : {"tan(x)", "sin(x)", "cos(tan(2*x))", "tan(sin(x))", "exp(tan(x))", "1",
                           "cos(x) + tan(x)", "sin(x)/tan(x)", "cos(tan(x + 1))"}) {
    EXPECT_FALSE(parse(text).by_tangent(0)) << text;
  }
}

}  // namespace by_tangent_test
}  // namespace polhode
