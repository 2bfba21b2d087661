// Formulas as polynomials, and their integrals, against values at points and against sums.

#include <gtest/gtest.h>

#include <optional>
#include <string>

#include "polhode/expression/expression.hpp"
#include "polhode/quadrature/integrate.hpp"
#include "support/random.hpp"

namespace polhode {
namespace polynomial_test {

std::optional<rational_polynomial> polynomial_of(const std::string& text) {
  return expression(text, {{"x"}, {}, nullptr}).polynomial();
}

TEST(Polynomial, IsFoundByItsCoefficients) {
  const auto p = polynomial_of("(x - 1/2)^3/4 - x*(x^2 - 7)*0.25 + 1");
  ASSERT_TRUE(p);
  EXPECT_EQ(*p, rational_polynomial({rational(31, 32), rational(31, 16), rational(-3, 8)}));
  EXPECT_TRUE(polynomial_of("x - x")->is_zero());
  EXPECT_EQ(polynomial_of("x^10000")->degree(), 10'000);
  for (const char* text :
       {"1/x", "sqrt(x^2)", "pi*x", "x^-1", "abs(x)", "2^x", "x^10001", "(x+1)^9000",
        "(x^2+1/3)^3000", "((x+1)^50+7)^100", "x/(x-x+1)*sin(1)"}) {
    EXPECT_FALSE(polynomial_of(text)) << text;
  }
}

std::optional<rational_quotient> quotient_of(const std::string& text) {
  return expression(text, {{"x"}, {}, nullptr}).quotient();
}

TEST(Quotient, HasTheValuesAndAllDivisors) {
  support::random_source random(3821);
  for (const char* text :
       {"1/x", "1/(1/x)", "x/x", "1/x+1/x^2-6", "(x^2-1)/(x-1)", "1/(1+x)^2+3/(1+x)^5-2/(x+1)",
        "x^-3/(2*x-4)", "1/(1-1/(1-1/x))", "(x+1/x)^3/(x-1/x)^2", "x^2/3", "(1/x-1/x)+2",
        "((x-1)/(x-2))^-2", "(1/(x^2+1))^0"}) {
    const auto q = quotient_of(text);
    ASSERT_TRUE(q) << text;
    const auto value = expression(text, {{"x"}, {}, nullptr}).evaluator<ball>(200);
    for (support::repeat trial(20); trial.again();) {
      const rational x(random.between(-6, 6), random.between(1, 3));
      rational below = 1;
      bool is_defined = true;
      for (const repeated_factor& d : q->divisors) {
        is_defined = is_defined && d.factor(x) != 0;
        for (long k = 0; k < d.multiplicity; ++k) below *= d.factor(x);
      }
      const ball y = value(ball(x, 200));
      EXPECT_EQ(is_defined, !y.is_undefined()) << text << " at " << to_text(x);
      if (is_defined) {
        EXPECT_TRUE(contains(y, rational(q->numerator(x) / below))) << text;
      }
    }
  }
  for (const char* text : {"1/(x-x)", "sqrt(x)/x", "1/pi", "x/sin(x)", "1/(x+1)^10001"}) {
    EXPECT_FALSE(quotient_of(text)) << text;
  }
}

TEST(PolynomialIntegral, IsAdditiveAndHasItsDerivative) {
  support::random_source random(5);
  const auto fraction = [&] { return rational(random.between(-50, 50), random.between(1, 20)); };
  for (support::repeat trial(300); trial.again();) {
    std::string text = "0";
    std::vector<rational> c;
    for (long n = 0, degree = random.between(0, 9); n <= degree; ++n) {
      c.push_back(fraction());
      text += " + (" + to_text(c.back()) + ")*x^" + std::to_string(n);
    }
    const auto p = polynomial_of(text);
    ASSERT_TRUE(p) << text;
    EXPECT_EQ(*p, rational_polynomial(c));
    const rational a = fraction();
    const rational b = fraction();
    const auto whole = exact_integral(*p, a, b);
    ASSERT_TRUE(whole);
    const rational middle = fraction();
    EXPECT_EQ(*whole, *exact_integral(*p, a, middle) + *exact_integral(*p, middle, b));
    // Term by term, without a common denominator.
    rational sum = 0;
    rational at_a = a;
    rational at_b = b;
    for (std::size_t n = 0; n < c.size(); ++n) {
      sum += c[n] * (at_b - at_a) / static_cast<long>(n + 1);
      at_a *= a;
      at_b *= b;
    }
    EXPECT_EQ(*whole, sum);
  }
  EXPECT_EQ(exact_integral(rational_polynomial(), 0, 1), rational(0));
  EXPECT_FALSE(exact_integral(*polynomial_of("x^10000"), 0, rational(1) / (integer(1) << 200)));
}

}  // namespace polynomial_test
}  // namespace polhode
