// Formulas as sums of products of a periodic function, a power of x and a rational function.

#include <gtest/gtest.h>

#include <vector>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/expression/parse.hpp"

namespace polhode {
namespace periodic_sum_test {

constexpr precision p = 128;

ball value_of(const expression::periodic_sum::term& t, const ball& x) {
  ball result = t.factor(x) * pow(x, ball(t.exponent, p)) * t.numerator(x) / t.denominator(x);
  for (const auto& [coefficients, power] : t.powers) {
    ball base(0, p);
    for (std::size_t i = coefficients.size(); i-- > 0;) base = base * x + coefficients[i](x);
    result *= pow(base, ball(power, p));
  }
  return result;
}

TEST(PeriodicSum, HasTheValueAndThePeriod) {
  struct sample {
    const char* text;
    pi_combination period;
  };
  const std::vector<sample> samples{
      {"abs(sin(x))/x^2", {0, 2}},
      {"abs(sin(x)/x^3)", {0, 2}},
      {"(sin(2*x)/x + 1/x^2)^3", {0, 1}},
      {"sin(2*x/3)^2/x^2 + exp(cos(x/2))/(x + 1)^2", {0, 12}},
      {"sin(2*pi*x/3)*cospi(x/4)/sqrt(x)", {24, 0}},
      {"tan(3*x + 1)*(x - 2)^2/(x^2 + 1)/x^(5/2)", {0, rational(2, 3)}},
      {"floor(x)/x^3", {1, 0}},
      {"ceil(2*x/3 - 1)/x - floor(x/2)*x", {6, 0}},
      {"(x - floor(x))^2/x", {1, 0}},
      {"(2*x - floor(x))/x^4", {1, 0}},
      {"sqrt(x - floor(x))/x^2", {1, 0}},
      {"(3 + sin(x))^(1/3)/(2*x - 5)", {0, 2}},
      {"-exp(sin(x))/x + exp(sin(x))/(x + 1)", {0, 2}},
      {"1/(x*(2 + cos(x)))", {0, 2}},
      {"sin(x)*(4*x^2)^(1/2)", {0, 2}},
      {"(x - floor(x))/root(8*x^4, 3)", {1, 0}},
      {"(floor(3*x) - 3*x + 1/2)*x^(-1/2)/(x + 1)", {rational(1, 3), 0}},
      {"max(sin(x), 1/2)*x", {0, 2}},
      {"1/floor(x + 1)", {1, 0}},
      {"1/(2 + sin(x) + 1/x)", {0, 2}},
      {"cos(2*x)/(x^2 + sin(2*x)^2*x)/3", {0, 1}},
      {"sqrt(x + cos(x)/2)*(x + cos(x)/2)", {0, 2}},
      {"(2*x*(3 + sin(x)) + 1/sqrt(2)/x)^(-3)", {0, 2}},
      {"(x^(1/2) + cos(pi*x)*x^(-1/2) + 1/(2*x^(3/2)))^(2/3)/(5 - x + floor(x))", {2, 0}}};
  for (const auto& [text, period] : samples) {
    const expression f = parse(text);
    const auto sum = f.as_periodic_sum();
    ASSERT_TRUE(sum) << text;
    EXPECT_EQ(sum->period, period) << text << ": " << to_text(sum->period);
    for (const rational& at : {rational(1, 7), rational(1), rational(13, 5), rational(201, 11)}) {
      const ball x(at, p);
      ball total(0, p);
      for (const auto& term : sum->terms) {
        total += value_of(term, x);
        const ball later = term.factor(x + sum->period.at(p));
        EXPECT_TRUE(overlaps(term.factor(x), later)) << text << " at " << at;
      }
      // That these are enclosures of numbers, and not of everything.
      EXPECT_TRUE(certainly_less(abs(total - f(x)), ball(rational(1, 1000000), p)))
          << text << " at " << at;
    }
  }
}

TEST(PeriodicSum, IsNoneOfOthers) {
  for (const char* text : {"1/x^2",
                           "exp(-x)",
                           "sin(x^2)/x",
                           "sin(x)*cos(pi*x)",
                           "floor(x)*sin(x)",
                           "1/(2 + sin(x) + exp(x))",
                           "1/(sin(x) + sqrt(x))",
                           "sqrt(x + 1/(x + sin(x)))",
                           "1/(x^40 + sin(x))",
                           "1/(x + sin(x)/(x + 1))",
                           "abs(1/(x + sin(x)))",
                           "sin(x + sin(x))",
                           "exp(x*sin(x))",
                           "log(x)*sin(x)",
                           "sqrt(x*sin(x))",
                           "sin(x)^x",
                           "sin(exp(1)*x)",
                           "floor(x^2)",
                           "sin(x)*sqrt(-2*x)",
                           "sin(x)*sqrt(2*x)",
                           "abs(x - 1)*sin(x)",
                           "sin(x)*abs(-2*x)"}) {
    EXPECT_FALSE(parse(text).as_periodic_sum()) << text;
  }
  EXPECT_FALSE(parse("sin(x)*y", {"x", "y"}).as_periodic_sum());
}

}  // namespace periodic_sum_test
}  // namespace polhode
