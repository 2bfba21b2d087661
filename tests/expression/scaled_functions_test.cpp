// Products of exponentials with functions that grow or decay as exponentials, by scaled functions.

#include <gtest/gtest.h>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "polhode/expression/formula_of.hpp"
#include "polhode/expression/library_functions.hpp"
#include "polhode/expression/parse.hpp"

namespace polhode {
namespace scaled_functions_test {

class ScaledFunctions : public ::testing::Test {
 protected:
  void SetUp() override {
    if (arb_functions()->empty()) GTEST_SKIP() << "built without Arb";
  }
};

expression formula(const char* text) { return parse(text, {"x"}); }

TEST_F(ScaledFunctions, AreTheSameFunction) {
  for (const char* text :
       {"exp(x)*expint(1,x)", "exp(2*x)*expint(3/2,2*x)/(1+x)", "exp(-3*x)*besselI(0,x)^3",
        "besselI(0,x)*besselK(1/3,x)*x", "cos(x)*besselI(2,x/3)/(exp(x)*sqrt(x))",
        "exp(x^2)*erfc(x)", "exp(x^2-x)*erfc(x)/(1+x)", "(1-erf(x/sqrt(2)))*exp(x^2/2)",
        "exp(x)*erfc(sqrt(x))", "exp(9*x/4)*erfc(-3/2*(-sqrt(x)))", "exp(x)*gammaUpper(1/3,x)/x",
        "(exp(x)*besselK(0,x))^2*log(x)",
        "-exp(x)*(3*besselK(2,x))/besselI(1,x)*exp(-5*x/2)*besselI(0,x/2)^5",
        "1+1/(exp(-x)/besselK(1,x))", "erfi(x/2)*exp(-x^2/4)/x", "erfi(x)*erfc(x)",
        "expint(1,x)*sinh(x)/x", "besselI(0,x)*cosh(2*x)^2*exp(-6*x)/cosh(x)",
        "sin(exp(-x)*besselI(0,x))"}) {
    const expression f = formula(text);
    const std::optional<expression> g = f.with_scaled_functions();
    ASSERT_TRUE(g) << text;
    for (const rational& at : {rational(1, 3), rational(2), rational(12), rational(87, 2)}) {
      const ball x(at, 512);
      const ball expected = f(x);
      const ball value = (*g)(x);
      ASSERT_TRUE(expected.is_bounded()) << text << " at " << at;
      EXPECT_TRUE(overlaps(value, expected)) << text << " at " << at;
      EXPECT_TRUE(value.radius() <= scale(expected.magnitude_upper(), -60)) << text << " at " << at;
    }
    // Far out, where a factor is beyond the exponents of numbers.
    EXPECT_TRUE((*g)(ball(parse_rational("1e40"), 256)).is_bounded()) << text;
  }
}

TEST_F(ScaledFunctions, HaveTheirExponentialsTogether) {
  const auto text = [](const char* of) { return formula(of).with_scaled_functions()->to_text(); };
  EXPECT_EQ(text("exp(x)*expint(1,x)"), text("exp(3*x)*expint(1,x)*exp(-2*x)"));
  EXPECT_EQ(text("exp(x^2)*erfc(x)"), "erfcx(x)");
  EXPECT_EQ(text("exp(x)*erfc(sqrt(x))"), "erfcx(sqrt(x))");
  EXPECT_EQ(text("exp(-3*x)*besselI(0,x)^3"), "besselIx(0, x)^3");
  EXPECT_EQ(text("besselI(0,x)*besselK(0,x)"), "besselIx(0, x)*besselKx(0, x)");
  EXPECT_EQ(text("exp(-2*x)*besselI(0,x)"), "exp(-1*x)*besselIx(0, x)");
}

TEST_F(ScaledFunctions, AreForProductsInWhichAFactorGrowsAndTheWholeDoesNot) {
  for (const char* text :
       {"exp(-x)*besselK(0,x)", "exp(2*x)*expint(1,x)", "besselI(0,x)", "exp(-x)*erfc(x)",
        "exp(x)*besselK(0,1/x)", "exp(x)+besselK(0,x)", "exp(x)*exp(-x)", "exp(-x^2)*erfc(x)",
        "exp(x)*besselJ(0,x)", "exp(x)*gammaUpper(x,1)", "3"}) {
    EXPECT_FALSE(formula(text).with_scaled_functions()) << text;
  }
}

/// Where exponents cancel, what they are made of is defined.
TEST_F(ScaledFunctions, KeepTheDomain) {
  for (const char* text :
       {"exp(x+0*log(5-x))*besselK(0,x)", "exp(x+log(5-x))*exp(-log(5-x))*besselK(0,x)",
        "exp(x+1/(x-7))*exp(-1/(x-7))*expint(1,x)", "exp(x+sqrt(3-x)-sqrt(3-x))*expint(1,x)",
        "cosh(x+0*asin(x))*expint(1,x)", "exp(x+(x-9)^(-2)*0)*expint(1,x)"}) {
    const expression f = formula(text);
    const auto g = f.with_scaled_functions();
    if (!g) continue;
    for (const rational& at : {rational(6), rational(7), rational(9), rational(23, 2)}) {
      const ball x(at, 128);
      EXPECT_TRUE(f(x).is_bounded() || !(*g)(x).is_bounded()) << text << " at " << at;
    }
  }
  for (const char* text :
       {"exp(x^2+sqrt(x)/(1+x)-log(x))*erfc(x)", "exp(x+1/x^2)*expint(1,x)",
        "exp(2*x+sin(x)-x)*besselK(0,x)", "exp(x+x^(1/3)-x^(1/2))*besselK(0,x)"}) {
    EXPECT_TRUE(formula(text).with_scaled_functions()) << text;
  }
}

/// A formula with few nodes and 2^60 paths through them.
TEST_F(ScaledFunctions, AreNotLookedForAlongAllPaths) {
  const auto f = [](const auto& x) {
    auto u = x;
    for (int k = 0; k < 60; ++k) u = u + sin(u - u * x);
    return exp(u) * exp(x * x) * erfc(x);
  };
  EXPECT_FALSE(formula_of(f).with_scaled_functions());
}

}  // namespace scaled_functions_test
}  // namespace polhode
