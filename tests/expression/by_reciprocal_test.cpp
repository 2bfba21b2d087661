// Formulas in u = 1/x.

#include <gtest/gtest.h>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "polhode/expression/expression.hpp"

namespace polhode {
namespace by_reciprocal_test {

expression parse(const char* text) { return expression(text, {{"x"}, {}}); }

TEST(ByReciprocal, IsTheFunctionOfTheReciprocal) {
  for (const char* text : {"floor(1/x)", "x*abs(sin(1/x))", "1/x - floor(1/x)",
                           "ceil(-3/(2*x^2))*x^3/7", "max(cos(pi/x), x)", "sqrt(x)*floor((1/x)^2)",
                           "exp(-x)*abs(cos(-2/x + 1))", "abs(-(1/x)^3)", "floor(x*x^-3)/(1 + x)",
                           "min(sqrt(2)/x, sin(x))", "floor((-2/x)^3)*x^5"}) {
    const expression f = parse(text);
    const std::optional<expression> g = f.by_reciprocal();
    ASSERT_TRUE(g) << text;
    for (const rational& u : {rational(1, 3), rational(3, 2), rational(12, 7), rational(40)}) {
      const ball value = (*g)(ball(u, 128));
      const ball expected = f(ball(rational(1 / u), 256)) / square(ball(u, 256));
      EXPECT_TRUE(overlaps(value, expected)) << text << " at u = " << u;
    }
  }
}

TEST(ByReciprocal, IsForStepsAndKinksOfReciprocalsAlone) {
  for (const char* text :
       {"1/x", "sin(1/x)", "abs(x)", "floor(x)/x", "abs(sin(x))*x", "max(x, 1/3)", "abs(x - 1/3)/x",
        "floor(1/(x + 1))", "abs(x^-100)", "7"}) {
    EXPECT_FALSE(parse(text).by_reciprocal()) << text;
  }
}

// It stands on what is under the functions: no sum with 1/x in it is a power.
TEST(ByReciprocal, KnowsThatSumsAreNoPowers) {
  const expression f = parse("floor(1/x + x)");
  const std::optional<expression> g = f.by_reciprocal();
  ASSERT_TRUE(g);
  EXPECT_TRUE(contains((*g)(ball(rational(2, 7), 64)), 3 * rational(49, 4)));
}

}  // namespace by_reciprocal_test
}  // namespace polhode
