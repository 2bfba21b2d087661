// Integrals to infinity that are proved to diverge, beside twins that converge.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "polhode/arithmetic/text.hpp"
#include "polhode/expression/parse.hpp"
#include "polhode/quadrature/integrate.hpp"
#include "polhode/quadrature/zero_free_ends.hpp"
#include "support/integrals_as_text.hpp"
#include "support/random.hpp"

namespace polhode {
namespace divergence_test {

using support::number;
using support::random_source;
using support::repeat;

reason why(const std::string& f, const std::string& a, const std::string& b) {
  const integral found = integrate(parse(f), number(a), number(b), {.digits = 15});
  return found.verdict == status::certified ? reason::none : found.why;
}

TEST(Divergence, OfWhatGrowsOrDoesNotDecay) {
  for (const char* f :
       {"exp(x)", "exp(x)-100", "exp(x)-x^3", "sinh(x)", "cosh(x)*exp(-x)", "exp(x^2)",
        "exp(x)/x^2", "exp(sqrt(x))/(1+x)", "2^x", "log(x)^2*exp(x)", "erf(x)", "gamma(x)", "x^x",
        "exp(exp(x))", "besselI(0,x)", "exp(x)-sin(x)", "exp(x^2)*erfc(x)", "exp(x)/(1+exp(x))",
        // Kinks in the tail.
        "max(exp(x),x^2)", "max(exp(-x),1/x)", "min(exp(x),x^2)", "max(exp(x)-20,0)*exp(-x)",
        // Waves that do not decay.
        "sin(x)", "sin(x)^2", "sin(x)*cos(x)", "sin(x)+cos(2*x)", "exp(x)*sin(x)", "x*sin(x)",
        "log(x)*sin(x)", "sqrt(x)*cos(3*x)", "sin(x)*atan(x)", "cos(x)*tanh(x)", "exp(sin(x))",
        "abs(sin(x))"}) {
    EXPECT_EQ(why(f, "2", "inf"), reason::not_integrable) << f;
  }
  for (const char* f : {"exp(-x)", "x*sin(x)", "exp(-x)*sin(x)", "cosh(x)", "exp(x^2)"}) {
    EXPECT_EQ(why(f, "-inf", "0"), reason::not_integrable) << f;
    EXPECT_EQ(why(f, "-inf", "inf"), reason::not_integrable) << f;
  }
}

TEST(Divergence, IsNotSaidOfTwinsThatConverge) {
  for (const char* f :
       {"exp(-x)", "cosh(x)*exp(-1.001*x)", "exp(-x^2)*exp(x)", "exp(x)/(1+exp(x))^2", "erfc(x)",
        "1/gamma(x)", "x^(-x)", "exp(-exp(x))", "exp(-x)*besselI(0,x/2)", "max(exp(-x),1/x^2)",
        "min(exp(-x),1/x)", "max(exp(x)-20,0)*exp(-1.001*x)", "sin(x)/x", "exp(-x/1000)*sin(x)",
        "cos(x)/cosh(x/100)", "abs(sin(x))/x^2", "sin(x^2)", "x*sin(x^4)"}) {
    EXPECT_EQ(why(f, "2", "inf"), reason::none) << f;
  }
}

// What is near to the bounds: 1/x and what decays as fast, a sign that is not one, a wave that is
// 0.
TEST(Divergence, IsProvedOfTailsUpToTheReciprocal) {
  const auto diverges = [](const std::string& f, const rational& from) {
    return zero_free_ends(parse(f)).diverges_beyond(from);
  };
  EXPECT_TRUE(diverges("1/x", 2));
  EXPECT_TRUE(diverges("1/(x+x^(1/pi))", 2));
  EXPECT_TRUE(diverges("-1/x", -2));
  EXPECT_FALSE(diverges("1/x^(1+1e-9)", 2));
  EXPECT_FALSE(diverges("1/x^2", 2));
  EXPECT_FALSE(diverges("x^(-sqrt(2))", 2));
  EXPECT_FALSE(diverges("1/(x^2+x^(1/pi))", 2));
  EXPECT_FALSE(diverges("exp(-x)", 2));
  EXPECT_TRUE(diverges("exp(-x)", -2));
  EXPECT_FALSE(diverges("sin(x)/x", 2));
  EXPECT_TRUE(diverges("sin(x)*(1+1/x)", 2));
  EXPECT_TRUE(diverges("sin(x)+1/x", 2));
  EXPECT_TRUE(diverges("x*cos(x)-3*log(x)*sin(2*x)", 9));
  EXPECT_TRUE(diverges("sin(x)+sin(pi*x)/2", 2));
  EXPECT_TRUE(diverges("x*besselJ(0,x)", 9));
  EXPECT_TRUE(diverges("sqrt(x)*besselY(1/3,x)", 9));
  EXPECT_TRUE(diverges("x*besselJ(2,x)^2", -9));
  EXPECT_FALSE(diverges("besselJ(0,x)", 9));
  EXPECT_FALSE(diverges("x*sin(x^2)", 2));
  EXPECT_FALSE(diverges("x*airyAi(-x)", 9));
  EXPECT_FALSE(diverges("sin(x)/log(x)", 2));
  EXPECT_FALSE(diverges("sin(x)*exp(-x)", 2));
  EXPECT_FALSE(diverges("exp(x)*sin(exp(2*x))", 2));
  EXPECT_FALSE(diverges("exp(x)*(sin(x)^2+cos(x)^2-1)", 2));
  EXPECT_FALSE(diverges("0*sin(x)", 2));
  EXPECT_FALSE(diverges("x*(floor(x)-ceil(x-1))", 2));
}

TEST(Divergence, SignsBeyondAPoint) {
  const auto sign = [](const std::string& f, const rational& from) {
    return zero_free_ends(parse(f)).sign_beyond(from);
  };
  EXPECT_EQ(sign("exp(x)-x^3", 16), 1);
  EXPECT_EQ(sign("x^3-exp(x)", 16), -1);
  EXPECT_EQ(sign("exp(-x)-1/(1+x)^3", 16), -1);
  EXPECT_EQ(sign("log(x)^2-sqrt(x)", 1 << 14), -1);
  EXPECT_EQ(sign("log(x)^2-sqrt(x)", 16), 0);
  EXPECT_EQ(sign("x-20", 16), 0);
  EXPECT_EQ(sign("x-20", 21), 1);
  EXPECT_EQ(sign("x-20", -1), -1);
  EXPECT_EQ(sign("exp(-x)*(x-20)", 16), 0);
  EXPECT_EQ(sign("sin(x)", 16), 0);
  EXPECT_EQ(sign("floor(x)-20.5", 16), 0);
  EXPECT_EQ(sign("1/(x-20)", 16), 0);
  EXPECT_EQ(sign("sqrt(x-20)", 16), 0);
  // One summand outgrows the others.
  EXPECT_EQ(sign("gamma(x)-x^2", 16), 1);
  EXPECT_EQ(sign("x^2-gamma(x)", 16), -1);
  EXPECT_EQ(sign("gamma(x)-x^2", 5), 0);  // the root 5.04
  EXPECT_EQ(sign("x^x-x^2-1", 4), 1);
  EXPECT_EQ(sign("x^x-x^2-1", 2), 0);  // the root 2.23
  EXPECT_EQ(sign("1-x^x+x^3", 4), -1);
  // A factor of all summands has zeros, or all of them are 0.
  for (const char* f :
       {"x*sin(x)+sin(x)", "x*sin(x)^2+sin(x)^2", "(x-20)*x^x+(x-20)", "(x-20)*gamma(x)+(x-20)*x^2",
        "x^2*cos(x)-cos(x)", "0*x^x+0*x", "x^x*floor(sin(x))-floor(sin(x))", "x^x-x^x-1/x+1/x",
        "sin(x)+sin(x)/2", "sin(x)/2+x*sin(x)", "3*sin(x)-pi*sin(x)",
        // Each of the others is less, and their sum is not: the root 17.4.
        "x^3-10*x^2-130*x", "x^x*(1-10/x-130/x^2)", "gamma(x+1)-10*gamma(x)-130*gamma(x-1)"}) {
    EXPECT_FALSE(zero_free_ends(parse(f)).beyond(16)) << f;
  }
}

// Sums of powers, exponentials, gamma and x^x: where they are proved to have no zero from some
// point on, none of many values from there on is 0, and all have the sign that is proved.
TEST(Divergence, SumsThatAreOutgrownHaveNoZeros) {
  random_source random(412);
  long proved = 0;
  for (repeat trial(60); trial.again();) {
    std::string f;
    for (long n = random.between(2, 4); n > 0; --n) {
      constexpr std::array summands{"x",       "x^2",      "sqrt(x)", "x^3", "log(x)",
                                    "exp(x)",  "gamma(x)", "x^x",     "1",   "exp(x/3)",
                                    "x^(5/2)", "(x-12)",   "sin(x)"};
      const auto which = static_cast<std::size_t>(random.between(0, summands.size() - 1));
      f += (f.empty()          ? ""
            : random.one_in(2) ? "+"
                               : "-") +
           std::to_string(random.between(1, random.one_in(2) ? 3 : 3000)) + "*" +
           summands.at(which);
    }
    const rational from(random.between(2, 40));
    SCOPED_TRACE(f + " from " + to_text(from));
    const zero_free_ends ends(parse(f));
    const bool has_none = ends.beyond(from);
    const int sign = ends.sign_beyond(from);
    if (!has_none && sign == 0) continue;
    ++proved;
    constexpr precision enough = 8192;  // x^x may cancel
    const auto value_at = parse(f).evaluator<ball>(enough);
    std::optional<int> first;
    for (long k = 0; k < 50; ++k) {
      const rational x = from + rational(k * k, 5);
      const ball value = value_at(ball(x, enough));
      ASSERT_FALSE(contains_zero(value)) << to_text(x);
      const int its = certainly_positive(value) ? 1 : -1;
      if (!first) first = its;
      ASSERT_EQ(its, *first) << to_text(x);
    }
    EXPECT_TRUE(sign == 0 || sign == *first);
  }
  EXPECT_GT(proved, 15 * support::effort());
}

}  // namespace divergence_test
}  // namespace polhode
