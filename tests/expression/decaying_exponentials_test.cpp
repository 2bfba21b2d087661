// Formulas with divisors that grow exponentially, by exponentials that decay.

#include <gtest/gtest.h>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "polhode/expression/expression.hpp"

namespace polhode {
namespace decaying_exponentials_test {

expression parse(const char* text) { return expression(text, {{"x"}, {}}); }

TEST(DecayingExponentials, AreTheSameFunction) {
  for (const char* text : {"1/sinh(x)",
                           "1/cosh(x)",
                           "1/x^2 - 1/sinh(x)^2",
                           "(1/x - 3/(exp(x) - 1))/x",
                           "(1/x - 1/(2 - exp(3*x)))/x",
                           "x/(x^2 - sinh(2*x))",
                           "1/(x + cosh(x/2))^3",
                           "sinh(x)^(-2)/x",
                           "1/(1/x - exp(x))",
                           "1/(x*sinh(-x))",
                           "(x + 1)/(-exp(x)*cosh(x) + 1/x)",
                           "1/(exp(x)/x + x)",
                           "cos(x)/sinh(x - 3)",
                           "exp(-x)/(exp(-x) + 1)/(1 + exp(x^2))",
                           "1/sinh(x^2)^3",
                           "2^x/(exp(x) - x)",
                           "1/(2^x - x^(5/2)*3)",
                           "1/(exp(x) - 2*exp(x/sqrt(2)) - 1)",

                           "1/(1/3 - (2/3)^(-x))",
                           "1/(2^x - 3^x + 5)"}) {
    const expression f = parse(text);
    const std::optional<expression> g = f.with_decaying_exponentials();
    ASSERT_TRUE(g) << text;
    for (const rational& at :
         {rational(1, 3), rational(-7, 2), rational(2), rational(12), rational(173, 2)}) {
      const ball x(at, 256);
      const ball expected = f(x);
      const ball value = (*g)(x);
      if (!expected.is_bounded()) continue;
      EXPECT_TRUE(overlaps(value, expected)) << text << " at " << at;
      EXPECT_TRUE(value.radius() <= scale(expected.magnitude_upper(), -60)) << text << " at " << at;
    }
    // Far out and wide the new formula is near 0, where the old one divides by a set that holds 0.
    const ball side = hull(ball(-2, 64), ball(2, 64));
    const region far = region::in_balls({side + 1000, side});
    EXPECT_TRUE(g->evaluator<region>(64)(far).is_analytic()) << text;
  }
}

TEST(DecayingExponentials, AreForDivisorsThatGrow) {
  for (const char* text :
       {"1/x", "sinh(x)", "exp(x)/x", "1/exp(-x)", "1/(1 + exp(-x))", "1/cosh(1/x)",
        "1/(exp(x) - cosh(x))", "tanh(x)", "1/sin(x)", "1/exp(sin(x))", "1/sqrt(cosh(x))", "3"}) {
    EXPECT_FALSE(parse(text).with_decaying_exponentials()) << text;
  }
}

TEST(DecayingExponentials, HaveNoValueWhereADivisorOfADivisorIsZero) {
  for (const char* text : {"1/(exp(x)/max(5 - x, 0))", "1/(cosh(x)/floor(5/x) + x)"}) {
    const auto g = parse(text).with_decaying_exponentials();
    ASSERT_TRUE(g) << text;
    EXPECT_TRUE((*g)(ball(4, 128)).is_bounded()) << text;
    EXPECT_FALSE((*g)(ball(8, 128)).is_bounded()) << text;
  }
}

}  // namespace decaying_exponentials_test
}  // namespace polhode
