// What an end without a series is bounded by: c t^a <= |f(t)| <= C t^b against values of f, for t
// down to 2^-2000 and by bounds that are attained.

#include "quadrature/ends/growth_bound.hpp"

#include <gtest/gtest.h>

#include "polhode/expression/parse.hpp"
#include "quadrature/formula/integrand.hpp"
#include "support/reference.hpp"

namespace polhode {
namespace growth_bound_test {

constexpr precision p = 4000;
constexpr precision few = 400;  // of functions that take long, and not so near the end

struct looked_at {
  growth_bound bound;
  expression f;
  double r;
};

looked_at look(const std::string& text, double r, long q = 1) {
  const expression f = parse(text);
  return {integrand_of(f).growth(
              growth_bound::argument(known_number(rational(0)), known_number(rational(1)), q, r)),
          f, r};
}

ball power_bound(const magnitude& factor, const rational& exponent, const ball& t) {
  ball c = ball(0, 64).enlarged(factor);
  mpfr_float end = zero_of_precision(64);
  c.upper(end.backend().data());
  return ball(end) * pow(t, ball(exponent, p));
}

/// At t = r 2^-k for k = 0, 1, ... and between.
void expect_bounds(const std::string& text, double r, long q = 1, long most_halvings = 1000) {
  const auto [g, f, reach] = look(text, r, q);
  ASSERT_FALSE(g.is_blocked()) << text << ": " << g.where();
  ASSERT_FALSE(g.factor().is_infinite()) << text;
  const auto at = f.evaluator<ball>(p);
  for (const long k : {0L, 1L, 2L, 3L, 5L, 8L, 20L, 60L, 64L, 92L, 100L, 300L, 1000L}) {
    if (k > most_halvings) break;
    for (const long n : {16L, 13L, 11L, 9L}) {
      const ball t = scale(ball::exactly(r) * ball(rational(n, 16), p), -k);
      const ball value = at(q > 0 ? t : 1 / t);
      ASSERT_TRUE(value.is_bounded()) << text << " at " << t;
      EXPECT_FALSE(certainly_less(power_bound(g.factor(), g.exponent(), t), abs(value)))
          << text << " at " << t << ": " << value;
      if (!g.least_factor().is_zero()) {
        EXPECT_FALSE(
            certainly_less(abs(value), power_bound(g.least_factor(), g.least_exponent(), t)))
            << text << " at " << t << ": " << value;
      }
      const bool contradicts = (g.sign() > 0 && certainly_negative(value)) ||
                               (g.sign() < 0 && certainly_positive(value));
      EXPECT_FALSE(contradicts) << text << " at " << t;
    }
  }
}

/// Where both are numbers of MPFR.
TEST(GrowthBound, HoldsQuotientsOfWhatDecaysExponentially) {
  for (const double r : {0.25, 0x1p-8}) {
    for (const char* text : {"exp(-1/x)/exp(-1/(2*x))", "-exp(-2/x)/exp(-1/(sqrt(2)*x))",
                             "exp(-1/x)*x/exp(-x^(-1/3))", "exp(-1/x^2)/(-exp(-3/x))"}) {
      expect_bounds(text, r, 1, 8);
    }
  }
}

TEST(GrowthBound, HoldsTheFunction) {
  for (const double r : {0.25, 0x1p-8}) {
    for (const char* text : {"x^sqrt(2)",
                             "x^(-1/sqrt(2))",
                             "x^pi + 3*x^sqrt(2)",
                             "x^pi - 3*x^sqrt(2)",
                             "2 + x^sqrt(2)",
                             "1 - x^sqrt(2)",
                             "x^sqrt(2)*x^(-pi)",
                             "x^sqrt(2)/(1+x^pi)",
                             "1/(1+x^pi)",
                             "x^x",
                             "x^(-x)",
                             "x^sin(x)",
                             "x^(x^x)",
                             "log(log(1/x))",
                             "1/sqrt(-log(x))",
                             "cos(log(x))",
                             "sin(x^sqrt(2))",
                             "atan(x^(-pi))",
                             "tanh(log(x))",
                             "exp(x^sqrt(2))",
                             "exp(-x^(-sqrt(2)))",
                             "exp(-1/x)",
                             "exp(-x^(-pi)/1000)*x^(-3)",
                             "exp(-30*x^(-1/pi))",
                             "log(x^sqrt(2))",
                             "log(2+x^pi)",
                             "log(x)^3*x^(1/pi)",
                             "abs(log(x))^pi",
                             "sqrt(x^sqrt(2)+x^pi)",
                             "root(x^sqrt(2), 3)",
                             "(x^sqrt(2))^3",
                             "(x^sqrt(2))^(-2)",
                             "erf(x^(-pi))",
                             "hypot(x^sqrt(2), x)",
                             "expm1(x^sqrt(2))",
                             "log1p(x^sqrt(2))",
                             "(-x^sqrt(2))^3",
                             "abs(-x^sqrt(2))",
                             "log(x^pi)/log(x^sqrt(2))",
                             "x^pi/(x^sqrt(2)-x^pi)",
                             "(x-1)/log(x)",
                             "sinpi(x^sqrt(2))",
                             "(2+cos(log(x)))*x^(-1/pi)",
                             "log(1/2-x^pi)",
                             "cos(x^sqrt(2))",
                             "log(x)*(1/x) - log(x)*(1/x - x)",
                             "log(x)+1/(1000*x)",
                             "x^x-2^x",
                             "exp(x^2)-x^x",
                             "1-x^x",
                             "exp(-x^pi)-1",
                             "exp(3/2*log(x)+x*log(x))",
                             "exp(2*log(x)-x)",
                             "1/sin(x^sqrt(2))",
                             "1/sin(-20*x^sqrt(2))",
                             "sin(24*x^sqrt(2))",
                             "sin(50*x^sqrt(2))",
                             "1/tan(11*x^sqrt(2))",
                             "tan(11*x^sqrt(2))",
                             "tan(-x^sqrt(2))",
                             "1/atan(20*x^sqrt(2))",
                             "1/tanh(-20*x^sqrt(2))",
                             "1/cos(11*x^sqrt(2))",
                             "cos(12*x^sqrt(2))",
                             "cos(50*x^sqrt(2))",
                             "log(tan(x^sqrt(2)))",
                             "sin(x^sqrt(2))^(-sqrt(3))"}) {
      expect_bounds(text, r);
    }
    for (const char* text : {"1/(1+x^pi)", "x^(-sqrt(2))", "x^sqrt(2)/(1+x^pi)", "1/(1+x^100)",
                             "log(x)/x^pi", "atan(x^pi)/x^sqrt(3)", "exp(-x)", "x^5*exp(-x)",
                             "exp(-x/100)", "exp(-9*x)-1/10", "exp(-sqrt(x))", "exp(-x^pi)"}) {
      expect_bounds(text, r, -1);
    }
  }
}

/// The greatest quotient of the value and the upper bound at t = r 2^-k; and of the lower bound and
/// the value.
void expect_attained(const std::string& text, double r, const rational& upper,
                     const rational& lower, precision bits = p, long most = 200) {
  const auto [g, f, reach] = look(text, r);
  ASSERT_FALSE(g.is_blocked()) << text;
  const auto at = f.evaluator<ball>(bits);
  bool is_near_upper = false;
  bool is_near_lower = lower == 0;
  for (long k = 0; k < most; ++k) {
    const ball t = scale(ball::exactly(r) * ball(1, bits), -k);
    const ball value = abs(at(t));
    if (certainly_less(power_bound(g.factor(), g.exponent(), t) * upper, value))
      is_near_upper = true;
    if (lower != 0 &&
        certainly_less(value * lower, power_bound(g.least_factor(), g.least_exponent(), t)))
      is_near_lower = true;
  }
  EXPECT_TRUE(is_near_upper) << text;
  EXPECT_TRUE(is_near_lower) << text;
}

TEST(GrowthBound, IsNearlyAttained) {
  const rational nearly(99, 100);
  expect_attained("x^sqrt(2)", 0.25, nearly, nearly);
  expect_attained("5*x^sqrt(2)*x^pi", 0.25, nearly, nearly);
  expect_attained("3/x^sqrt(2)", 0.25, nearly, nearly);
  expect_attained("x^sqrt(2) + x^pi", 0.25, nearly, nearly);
  expect_attained("x^sqrt(2) - x^pi", 0.25, rational(3, 4), nearly);
  expect_attained("x^pi - x^sqrt(2)", 0.25, rational(3, 4), nearly);
  expect_attained("(2*x^sqrt(2))^3", 0.25, nearly, nearly);
  expect_attained("sqrt(3*x^sqrt(2))", 0.25, nearly, nearly);
  expect_attained("root(3*x^sqrt(2), 3)", 0.25, nearly, nearly);
  expect_attained("(3*x^sqrt(2))^(-1/sqrt(3))", 0.25, nearly, nearly);
  expect_attained("exp(x^sqrt(2))", 0.25, nearly, rational(3, 4));
  expect_attained("exp(-x^sqrt(2))", 0.25, rational(3, 4), nearly);
  expect_attained("exp(-x^(-sqrt(2)))+1", 0x1p-8, rational(2, 5), nearly);
  expect_attained("log(x^pi)", 0.25, rational(2, 5), nearly);
  expect_attained("log(3*x^(-pi))", 0.25, rational(2, 5), nearly);
  expect_attained("log(2+x^pi)", 0.25, rational(2, 5), rational(9, 10));
  expect_attained("cos(x^pi)", 0.25, nearly, 0);
  expect_attained("sin(x^pi)", 0.25, nearly, 0);
  expect_attained("1/sin(15*x^sqrt(2))", 0.25, nearly, nearly);
  expect_attained("1/tan(10*x^sqrt(2))", 0.25, nearly, nearly);
  expect_attained("1/atan(20*x^sqrt(2))", 0.25, nearly, nearly);
  expect_attained("1/tanh(20*x^sqrt(2))", 0.25, nearly, nearly);
  expect_attained("1/cos(10*x^sqrt(2))", 0.25, nearly, nearly);
  expect_attained("atan(x^(-pi))", 0x1p-4, nearly, 0);
  expect_attained("tanh(x^(-pi))", 0x1p-4, nearly, 0);
  expect_attained("erf(x^(-pi))", 0x1p-4, nearly, 0);
  expect_attained("gamma(x)", 0.25, nearly, rational(2, 5), few, 40);
  expect_attained("log_gamma(x)", 0.25, rational(1, 3), rational(1, 5), few, 40);
  expect_attained("agm(1,x)", 0.25, rational(4, 5), rational(4, 5), few, 40);
  expect_attained("1/agm(2,3*exp(-1/x))", 0.25, rational(1, 4), rational(2, 5), few, 6);
  expect_attained("1/agm(1,exp(-1/x))", 0.25, rational(1, 2), rational(9, 10), few, 8);
  expect_attained("log(sin(exp(-1/x)))", 0.25, nearly, nearly, few, 8);
  expect_attained("log(-(-exp(-1/x)))", 0.25, nearly, nearly, few, 8);
  expect_attained("1/gamma(1/x)", 0x1p-4, rational(1, 3), 0, few, 4);
  expect_attained("ellipticK(x)", 0.25, nearly, rational(9, 10), few, 40);
}

/// At t from r down to r/2^12, and for q < 0 down to r/16.
void expect_few_bounds(const std::string& text, double r, long q = 1) {
  const auto [g, f, reach] = look(text, r, q);
  ASSERT_FALSE(g.is_blocked()) << text << ": " << g.where();
  const auto at = f.evaluator<ball>(few);
  for (long n = 0; n < 16; ++n) {
    const ball t = q > 0
                       ? scale(ball(rational(16 - n % 4, 16), few) * ball::exactly(r), -(n - n / 4))
                       : ball::exactly(r) * ball(rational(16 - n, 16), few);
    const ball value = at(q > 0 ? t : 1 / t);
    ASSERT_TRUE(value.is_bounded()) << text << " at " << t;
    EXPECT_FALSE(certainly_less(power_bound(g.factor(), g.exponent(), t), abs(value)))
        << text << " at " << t << ": " << value;
    EXPECT_FALSE(certainly_less(abs(value), power_bound(g.least_factor(), g.least_exponent(), t)))
        << text << " at " << t << ": " << value;
  }
}

TEST(GrowthBound, HoldsSpecialFunctions) {
  for (const double r : {0.25, 0x1p-5}) {
    for (const char* text : {"gamma(x)",
                             "log_gamma(x)",
                             "log(gamma(x^sqrt(2)))",
                             "x^pi*gamma(x)",
                             "1/gamma(x)",
                             "gamma(1+x^pi)",
                             "log_gamma(3/2+cos(log(x))/4)",
                             "agm(1,x)",
                             "agm(x^pi,3)/x",
                             "1/agm(1,x^sqrt(2))",
                             "1/agm(2,3*exp(-1/x))",
                             "log(sqrt(2*sin(exp(-1/x)/2)^2))",
                             "log(abs(tanh(-exp(-1/x))^3/7))",
                             "log(exp(-1/x)/(1/1000+x^sqrt(2)))",
                             "log(sin(exp(-1/(4*x))))",
                             "log(-2*exp(-1/x)*sin(-exp(-1/x)))",
                             "1/agm(1,exp(-sqrt(x)))",
                             "x/agm(1,exp(-1/x)*(1+x))",
                             "1/gamma(1/x)",
                             "ellipticK(x^sqrt(2))",
                             "ellipticK(sin(log(x))/2)"}) {
      expect_few_bounds(text, r);
    }
    for (const char* text :
         {"1/gamma(x)", "x^3/gamma(x+1/2)", "log_gamma(x)", "log_gamma(2*x)/x^2"}) {
      expect_few_bounds(text, r, -1);
    }
  }
}

/// Of functions that grow faster than all powers: a lower bound, and its sign.
void expect_lower_bounds(const std::string& text, double r) {
  const auto [g, f, reach] = look(text, r);
  EXPECT_TRUE(g.is_blocked()) << text;
  EXPECT_FALSE(g.is_unknown()) << text;
  ASSERT_FALSE(g.least_factor().is_zero()) << text;
  const auto at = f.evaluator<ball>(few);
  for (long n = 0; n < 16; ++n) {
    const ball t = ball::exactly(r) * ball(rational(16 - n, 16), few);
    const ball value = at(t);
    ASSERT_TRUE(value.is_bounded()) << text << " at " << t;
    EXPECT_FALSE(certainly_less(abs(value), power_bound(g.least_factor(), g.least_exponent(), t)))
        << text << " at " << t << ": " << value;
    EXPECT_EQ(g.sign(), certainly_positive(value) ? 1 : -1) << text;
  }
}

TEST(GrowthBound, HoldsQuotientsOfWhatGrows) {
  for (const double r : {0x1p-4, 0x1p-7}) {
    for (const char* text : {"1/sqrt(gamma(1/x))",
                             "1/log(gamma(1/x))",
                             "1/(gamma(1/x)*exp(-1/x))",
                             "1/(1+gamma(1/x))",
                             "1/abs(-gamma(1/x))",
                             "1/root(gamma(1/x), 3)",
                             "1/(gamma(1/x)/x)",
                             "1/gamma(1/x)^(1/4)",
                             "1/gamma(1/x)^sqrt(2)",
                             "1/gamma(1/x)^3",
                             "1/(gamma(1/x)-5)",
                             "exp(1/x)/gamma(1/x)",
                             "gamma(1/x)/x^(-1/x)",
                             "gamma(1/x)^2/gamma(2/x)",
                             "exp(2/x)/exp(1/x)^3",
                             "gamma(1/x)*exp(1/x)*x^(1/x)/sqrt(x)",
                             "gamma(1/x+1/2)/gamma(1/x+3)",
                             "gamma(1/x)/gamma(1/x+sqrt(2))",
                             "gamma(1/x+3)/gamma(1/x+1/2)",
                             "x^3*exp(1/x)/(exp(1/x)-1/x)",
                             "(exp(2/x)-6*exp(1/x))/(9+exp(2/x))",
                             "cosh(1/x)/sinh(1/x)",
                             "log(cosh(1/x))",
                             "log(gamma(1/x)*exp(2/x)/x^2)",
                             "exp(-sqrt(2)*log(x)+x)",
                             "exp(3/2*log(x)+x*log(x)+1)",
                             "exp(log(x)/pi-2)",
                             "(1/x)*log(1/x)-1/x",
                             "log(x)^2-log(x)+x*log(x)^3",
                             "1/x-log(x)/8",
                             "airyAi(1/x)*airyBi(1/x)",
                             "besselK(0,1/x)*besselI(1,1/x)/x",
                             "lambertW(1/x)*sqrt(x)",
                             "abs(cos(log(x))*exp(-1/x))*exp(1/x)",
                             "abs(sin(log(x))*gamma(1/x))/gamma(1/x)",
                             "abs(-exp(-1/x))+exp(-1/x)"}) {
      expect_few_bounds(text, r);
    }
    for (const char* text :
         {"exp(1/x)", "gamma(1/x)", "-gamma(1/x)", "x^(-1/x)", "gamma(1/x)-exp(1/x)",
          "exp(1/x)-gamma(1/x)", "x^5*exp(2/x)-exp(1/x)", "sqrt(gamma(1/x))", "sinh(-1/x)",
          "gamma(1/x)*exp(1/x)/sqrt(x)", "abs(-exp(1/x))", "exp(1/x)+1/x", "gamma(1/x)^2",
          "x^(-1/x)/gamma(1/x)", "exp(1/x)*(2+cos(log(x)))", "1/exp(-1/x)"}) {
      expect_lower_bounds(text, r);
    }
  }
  // Where e^-v decays, and grows itself.
  for (const char* text : {"exp(-gamma(1/x))", "1/exp(gamma(1/x))", "exp(-exp(1/x))/x^3"}) {
    expect_few_bounds(text, 0x1p-3);
  }
  EXPECT_EQ(look("x/(-gamma(1/x))", 0x1p-3).bound.sign(), -1);
  EXPECT_TRUE(look("exp(1/x)/gamma(1/x)", 0x1p-4).bound.has_growing_parts());
  EXPECT_FALSE(look("exp(-1/x)", 0x1p-4).bound.has_growing_parts());
}

TEST(GrowthBound, WhatIsNotFollowedIsBlocked) {
  for (const char* text : {"1/sin(gamma(1/x))", "1/(gamma(1/x)-exp(3/x))", "sin(exp(1/x))",
                           "exp(1/x)-exp(1/x)", "gamma(gamma(1/x))"}) {
    EXPECT_TRUE(look(text, 0.25).bound.is_blocked()) << text;
    EXPECT_TRUE(look(text, 0.25).bound.least_factor().is_zero()) << text;
  }
  for (const char* text :
       {"gamma(1/x)", "exp(x^(-pi))", "(x-1/8)^sqrt(2)", "log(cos(log(x)))", "1/cos(log(x))",
        "ellipticK(1-x)", "agm(1,cos(log(x)))", "tan(25*x^sqrt(2))"}) {
    EXPECT_TRUE(look(text, 0.25).bound.is_blocked()) << text;
  }
  EXPECT_TRUE(look("cos(x^(-pi))*x^sqrt(2)", 0.25).bound.oscillates());
  EXPECT_FALSE(look("cos(log(x))", 0.25).bound.oscillates());
}

TEST(GrowthBound, IntegralsOfItAreKnown) {
  const auto check = [](const char* text, const end_point& b, const std::string& value) {
    const integral i = integrate(parse(text), 0, b, {.digits = 25});
    EXPECT_EQ(i.verdict, status::certified) << text << ": " << i.obstacle;
    EXPECT_TRUE(overlaps(i.enclosure, parse(value, {}).value(200))) << text;
  };
  check("x^(sqrt(2)-1)", 1, "1/sqrt(2)");
  check("x^(pi-4)", 1, "1/(pi-3)");
  check("x^(pi-4)*log(x)^2", 1, "2/(pi-3)^3");
  check("1/(1+x^pi)", end_point::infinity(), "1/sin(1)");
  check("x^(sqrt(2)-1)*exp(-x)", end_point::infinity(), "gamma(sqrt(2))");
  check("abs(log(x))^pi", 1, "gamma(pi+1)");
  check("cos(log(x))", 1, "1/2");
  check("(x-1)/log(x)", 1, "log(2)");
  check("log(log(1/x))", rational(1, 3), "0.21776067270380014874046904785");
  check("x^x", 1, "0.783430510712134407059264386526975469407681990146930958255417822");
  check("x^(-x)", 1, "1.29128599706266354040728259059560054149861936827452231731000244");
  // J. L. Raabe (1843); the constant of Fransen and Robinson (OEIS A058655); DLMF 19.8.5 and the
  // moments of K and K' (DLMF 19.13).
  check("log_gamma(x)", 1, "log(2*pi)/2");
  check("log_gamma(1-x)", 1, "log(2*pi)/2");
  check("log(gamma(x))", 1, "log(2*pi)/2");
  check("1/gamma(x)", end_point::infinity(), "2.8077702420285193652215011865577729323081");
  check("1/agm(1,x)", 1, "pi/2");
  check("x/agm(1,x)", 1, "2/pi");
  check("ellipticK(x)", 1, "2");
  check("ellipticK(1-x)", 1, "2");
  check("ellipticK(2*x)", rational(1, 2), "1");
  check("ellipticK(x)/sqrt(x)", 1, "4*catalan");
  check("ellipticK(x)/sqrt(1-x)", 1, "pi^2/2");
  check("ellipticK(x^2)", 1, "2*catalan");
  check("ellipticK(sqrt(x))", 1, "20/9");
  check("ellipticE(x)", 1, "4/3");
  check("ellipticE(sqrt(x))", 1, "56/45");
  check("carlsonRF(0,x,1)", 1, "2");
  check("carlsonRG(0,x,1)", 1, "2/3");
  check("ellipticK(1-x^2)", 1, "pi^2/4");
  check("ellipticK(4*x/(1+x)^2)", 1, "1+2*catalan");
  check("x*ellipticK(1-x^2)", 1, "1");
  check("ellipticK(x^2)/(1+x)", 1, "pi^2/8");
  // Where 1 - m is a difference of numbers near 1 that is written without it.
  const end_point quarter_turn = end_point::pi(rational(1, 2));
  check("ellipticK(sin(x)^2)", quarter_turn, "gamma(1/4)^4/(16*pi)");
  check("ellipticK(cos(x)^2)", quarter_turn, "gamma(1/4)^4/(16*pi)");
  check("ellipticK(cos(pi-x)^2)", quarter_turn, "gamma(1/4)^4/(16*pi)");
  check("2*exp(-x)*ellipticK(exp(-x))", end_point::infinity(), "4");
  check("exp(-x)*ellipticK(exp(-2*x))", end_point::infinity(), "2*catalan");
}

/// K towards its logarithmic singularity at both ends, inside, at infinities, and from the left.
TEST(GrowthBound, CompleteEllipticIntegralsOfRationalFunctions) {
  const auto check = [](const char* text, const end_point& a, const end_point& b,
                        const std::string& value) {
    const integral i = integrate(parse(text), a, b, {.digits = 25});
    EXPECT_EQ(i.verdict, status::certified) << text << ": " << i.obstacle;
    EXPECT_TRUE(overlaps(i.enclosure, parse(value, {}).value(200))) << text;
  };
  check("ellipticK(1-x^2)", -1, 1, "pi^2/2");
  check("ellipticK(1-(x-1/3)^2)", rational(-2, 3), rational(4, 3), "pi^2/2");
  check("ellipticK(1-1/x^2)/x^2", 1, end_point::infinity(), "pi^2/4");
  check("ellipticK(1-1/x^2)/x^2", -end_point::infinity(), -1, "pi^2/4");
  check("-ellipticK(1+1/x)/x^3", -end_point::infinity(), -1, "8/9");
  check("ellipticK(x)", -1, 0, "4*ellipticK(-1)-2*ellipticE(-1)");
  // The same integral from both sides, at infinities, and by the mean.
  const auto value = [](const char* text, const end_point& a, const end_point& b) {
    const integral i = integrate(parse(text), a, b, {.digits = 25});
    EXPECT_EQ(i.verdict, status::certified) << text << ": " << i.obstacle;
    return i.enclosure;
  };
  const ball by_mean = value("pi/(2*agm(1,sqrt(x+x^2)))", 0, 1);
  EXPECT_TRUE(overlaps(by_mean, value("ellipticK(1-x-x^2)", 0, 1)));
  EXPECT_TRUE(overlaps(by_mean, value("ellipticK(1+x-x^2)", -1, 0)));
  EXPECT_TRUE(overlaps(by_mean, value("ellipticK(1-(1-x)*(2-x))", 0, 1)));
  EXPECT_TRUE(overlaps(by_mean, value("ellipticK(1-1/x-1/x^2)/x^2", 1, end_point::infinity())));
  EXPECT_TRUE(overlaps(by_mean, value("ellipticK(1+1/x-1/x^2)/x^2", -end_point::infinity(), -1)));
  // Of such a function no more than its logarithm is integrable.
  EXPECT_EQ(integrate(parse("ellipticK(1-x^3)/x"), -1, 1, {.digits = 10}).verdict,
            status::not_certified);
  EXPECT_EQ(
      integrate(parse("ellipticK(1-1/x^2)"), 1, end_point::infinity(), {.digits = 10}).verdict,
      status::not_certified);
}

TEST(GrowthBound, DivergenceIsProved) {
  for (const char* text : {"gamma(x)", "gamma(1-x)", "ellipticK(x)/(1-x)", "log_gamma(x)/x",
                           "1/(x*agm(1,x))", "x^pi/x^5"}) {
    const integral found = integrate(parse(text), 0, 1, {.digits = 10});
    EXPECT_EQ(found.verdict, status::not_certified) << text;
    EXPECT_EQ(found.why, reason::not_integrable) << text;
  }
}

TEST(GrowthBound, DivergentIntegralsAreRefused) {
  for (const char* text :
       {"x^(-sqrt(2))", "x^(-pi/3)", "x^(-sqrt(1+1e-8))", "1/(x*log(x))",
        "1/(x^sqrt(2)*(2+cos(log(x))))", "x^(-1-x)", "log(log(1/x))/x", "1/(x^2*log(gamma(1/x)))",
        "gamma(x)", "log_gamma(x)/x", "1/(x*agm(1,x))", "sin(x)^(-sqrt(2))", "tan(x)^(-pi/3)"}) {
    EXPECT_NE(integrate(parse(text), 0, rational(1, 4), {.digits = 10, .most_evaluations = 20000})
                  .verdict,
              status::certified)
        << text;
  }
  for (const char* text : {"1/(1+x^(pi/4))", "x^(-1/sqrt(2))", "1/log(2+x^pi)"}) {
    EXPECT_NE(
        integrate(parse(text), 1, end_point::infinity(), {.digits = 10, .most_evaluations = 20000})
            .verdict,
        status::certified)
        << text;
  }
}

growth_bound growth_of(const std::string& f, const rational& at, const rational& width) {
  return integrand_of(parse(f)).growth(
      growth_bound::argument(known_number(at), known_number(rational(4 * width)), 1, 0.25));
}

/// What is defined nowhere beside a point is told from what is not known.
TEST(GrowthBound, KnowsWhereNothingIsDefined) {
  for (const char* f : {"sqrt(x)", "log(x)", "x^0.3", "x^pi", "root(x,4)", "1+exp(sqrt(x))",
                        "x*sqrt(sin(x))", "gamma(sqrt(x))", "sqrt(x)/x", "2-log(sin(x))", "x^x"}) {
    EXPECT_TRUE(growth_of(f, 0, rational(-1, 8)).is_nowhere_defined()) << f;
    EXPECT_FALSE(growth_of(f, 0, rational(1, 8)).is_nowhere_defined()) << f;
  }
  for (const char* f : {"cbrt(x)", "abs(x)^0.3", "x^3", "x^(-1)", "sqrt(x^2)", "sqrt(x+1)",
                        "log(x+1)", "x^erf(30)", "gamma(x)", "x^(8*x)"}) {
    EXPECT_FALSE(growth_of(f, 0, rational(-1, 8)).is_nowhere_defined()) << f;
  }
  // sqrt(x + 1/100) is defined on a part of -1/8 <= x < 0.
  EXPECT_FALSE(growth_of("sqrt(x+1/100)", 0, rational(-1, 8)).is_nowhere_defined());
  EXPECT_FALSE(growth_of("log(x+1/100)", 0, rational(-1, 8)).is_nowhere_defined());
}

}  // namespace growth_bound_test
}  // namespace polhode
