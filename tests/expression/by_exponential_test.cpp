// Formulas in an exponential of their variable.

#include <gtest/gtest.h>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/expression/parse.hpp"

namespace polhode::test {
namespace by_exponential_test {

TEST(ByExponential, HasTheValuesOfTheFormula) {
  constexpr precision p = 128;
  for (const char* formula : {
           "sin(exp(x))",
           "sin(exp(-x))",
           "x*sin(exp(3*x-1/2)+2)",
           "exp(-x)*sin(exp(3*x))",
           "cos(exp(x/2)+exp(x/3))",
           "cos(exp(x/6)-exp(-3*x/4))",
           "sin(2^x)",
           "sin(4^x+2^(3*x+1))",
           "log(2+x)*cos(sinh(x)+2*cosh(x))",
           "sin(expm1(2*x))/sqrt(1+x)",
           "sin(exp(sqrt(2)*x))*exp(-x/sqrt(2))",
           "cos(exp(pi*x+sqrt(3)))^2",
       }) {
    SCOPED_TRACE(formula);
    const expression f = parse(formula);
    const auto in_u = f.by_exponential();
    ASSERT_TRUE(in_u);
    const ball c = in_u->slope.value(p);
    for (const rational& at : {rational(1, 7), rational(3, 5), rational(4, 3)}) {
      const ball x(at, p);
      const ball u = exp(c * x);
      const ball value = in_u->formula(u) * c * u;
      EXPECT_TRUE(overlaps(value, f(x))) << to_decimal(value, 20) << " " << to_decimal(f(x), 20);
      EXPECT_LT(estimated_log2(value.radius()), -80);
    }
  }
}

TEST(ByExponential, ItsSlopeIsThatOfThePhase) {
  const auto slope = [](const char* formula) {
    return parse(formula).by_exponential().value().slope.rational_value().value();
  };
  EXPECT_EQ(slope("sin(exp(x))"), 1);
  EXPECT_EQ(slope("exp(-x)*sin(exp(3*x))"), 1);
  EXPECT_EQ(slope("exp(x)*sin(exp(-3*x))"), -1);
  EXPECT_EQ(slope("exp(-x)*sin(exp(x))"), 1);
  EXPECT_EQ(slope("exp(-5*x)*sin(exp(x))"), 1);
  EXPECT_EQ(slope("sin(exp(x/2)+exp(x/3))"), rational(1, 6));
  EXPECT_EQ(slope("cos(exp(-2*x))+sin(exp(-4*x))"), -2);
}

TEST(ByExponential, OthersAreLeftAsTheyAre) {
  for (const char* formula :
       {"sin(x)", "exp(x)", "exp(x)*sin(x)", "sin(exp(x^2))", "sin(exp(x^2+x))", "sin(x^x)",
        "sin(exp(x)+exp(sqrt(2)*x))", "sin(exp(x)+exp(65*x))", "sin(exp(x))*exp(1/x)",
        "sin(exp(exp(x)))"}) {
    EXPECT_FALSE(parse(formula).by_exponential()) << formula;
  }
}

}  // namespace by_exponential_test
}  // namespace polhode::test
