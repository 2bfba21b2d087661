// The checker's formulas against the prover's, with which they share nothing: the same text means
// the same, and sets hold the values of their members.

#include "checker/formula.hpp"

#include <gtest/gtest.h>

#include <random>

#include "formulas.hpp"
#include "generous.hpp"
#include "polhode/arithmetic/complex_ball.hpp"
#include "support/random.hpp"

namespace polhode::checker {
namespace formula_test {

using support::repeat;
using test::read;

polhode::rational as_provers(const rational& q) { return polhode::rational(q.str()); }

formula checkers(const std::string& text, std::string_view variable = "x") {
  const json value = text;
  return formula::read(place(value, "/f", generous()), {std::string(variable)});
}

void expect_holds(const interval& set, const ball& member, const std::string& what) {
  ASSERT_TRUE(member.is_bounded()) << what;
  EXPECT_LE(as_provers(set.lower()), upper_rational(member)) << what;
  EXPECT_LE(lower_rational(member), as_provers(set.upper())) << what;
}

class draw {
 public:
  long whole(long low, long high) {
    return std::uniform_int_distribution<long>(low, high)(engine_);
  }
  /// Up to `most` in size, with 20 bits.
  rational number(long most) { return rational(integer(whole(-most << 20, most << 20)), 1 << 20); }
  /// Between two numbers, ends included.
  rational between(const rational& low, const rational& high) {
    return low + (high - low) * rational(whole(0, 16), 16);
  }

 private:
  std::mt19937_64 engine_{4};
};

const std::vector<std::string>& formulas() {
  static const std::vector<std::string> texts{"x^2 - 3*x + 1/7",
                                              "1/(x - 2/3)",
                                              "(x + 1)/(x^2 + 2)",
                                              "x^-3",
                                              "x^0",
                                              "(1 - x)^5",
                                              "sqrt(x)",
                                              "exp(x)",
                                              "log(x)",
                                              "sin(x)",
                                              "cos(x)",
                                              "tan(x)",
                                              "sinh(x)",
                                              "cosh(x)",
                                              "tanh(x)",
                                              "atan(x)",
                                              "expm1(x)",
                                              "log1p(x)",
                                              "sinpi(x)",
                                              "cospi(x)",
                                              "asin(x)",
                                              "acos(x)",
                                              "asinh(x)",
                                              "acosh(x)",
                                              "atanh(x)",
                                              "x^(1/3)",
                                              "x^x",
                                              "pi*x",
                                              "2^x",
                                              "sqrt(x^2+1)",
                                              "log(1 + exp(x))",
                                              "sin(x+exp(x))"};
  return texts;
}

TEST(Formula, TextsMeanWhatTheProverMeans) {
  for (const char* text : {"1 - 2 - 3",
                           "2/3/5",
                           "2^3^2",
                           "-2^2",
                           "(-2)^2",
                           "2^-2",
                           "-3^2*2",
                           "2*-3",
                           "1 - -1",
                           "--3",
                           "-(2 - 5)^3",
                           "7 - 2*3 + 4/8",
                           "2^(1+2)",
                           "(1/2)^-3",
                           "4^(1/2)",
                           "2/-4",
                           "0^0",
                           "1/3*3",
                           "6/2*3",
                           "(((5)))",
                           "sqrt(2)*sqrt(2)",
                           "exp(1)^2",
                           "10^20 + 1/10^20",
                           "pi^2/6",
                           "2^100/2^99",
                           "x - 1",
                           "x*-x",
                           "-x^2",
                           "2^x^2",
                           "x^2^2",
                           "1/x/x",
                           "x^-1*x"}) {
    const std::string texts(text);
    const rational at(5, 3);
    const expression f = read(texts, "x");
    const interval mine = checkers(texts)(interval(at, at_bits(300)));
    const ball provers = f(ball(as_provers(at), 300));
    expect_holds(mine, provers, texts);
    EXPECT_LE(bit_length(integer(mine.high() - mine.low())), 100) << texts;
  }
}

/// Where the checker has an answer over a rectangle, it holds the principal values at its points.
TEST(Formula, RectanglesHoldTheValuesOfTheirMembers) {
  draw d;
  int answers = 0;
  for (repeat trial(60); trial.again();) {
    for (const std::string& text : formulas()) {
      const precision bits = at_bits(d.whole(60, 200));
      const rational x0 = d.number(3);
      const rational y0 = d.number(3);
      const rational size = rational(1, 1L << d.whole(0, 30));
      const rational x1 = x0 + d.between(0, size);
      const rational y1 = y0 + d.between(0, size);
      const rational x = d.between(x0, x1);
      const rational y = d.between(y0, y1);
      try {
        const rectangle set = checkers(text)(
            rectangle{interval::between(x0, x1, bits), interval::between(y0, y1, bits)});
        const complex_ball value =
            read(text, "x")(complex_ball(ball(as_provers(x), 250), ball(as_provers(y), 250)));
        ASSERT_TRUE(value.is_bounded()) << text << " at " << x << ' ' << y;
        expect_holds(set.re, value.re, text + ", real part");
        expect_holds(set.im, value.im, text + ", imaginary part");
        ++answers;
      } catch (const undecided&) {  // no answer is no wrong answer
      }
    }
  }
  if (support::effort() >= 1) {
    EXPECT_GT(answers, 1000);
  }
}

TEST(Formula, JetsHoldValuesAndDerivatives) {
  draw d;
  int answers = 0;
  for (repeat trial(60); trial.again();) {
    for (const std::string& text : formulas()) {
      const precision bits = at_bits(d.whole(60, 200));
      const rational x0 = d.number(3);
      const rational x1 = x0 + d.between(0, rational(1, 1L << d.whole(0, 30)));
      const rational x = d.between(x0, x1);
      try {
        const jet set =
            checkers(text)(jet{interval::between(x0, x1, bits), interval(rational(1), bits)});
        const auto at = read(text, "x")(polhode::jet<ball, 1>::variable(ball(as_provers(x), 250)));
        expect_holds(set.value, at[0], text);
        expect_holds(set.slope, at.derivative(1), text + ", derivative");
        ++answers;
      } catch (const undecided&) {  // no answer is no wrong answer
      }
    }
  }
  if (support::effort() >= 1) {
    EXPECT_GT(answers, 500);
  }
}

/// A rectangle that meets a cut or a pole has no answer.
TEST(Formula, CutsAndPolesAreUndecided) {
  const auto expect_none = [](const std::string& text, const rational& x0, const rational& x1,
                              const rational& y0, const rational& y1) {
    EXPECT_THROW(
        static_cast<void>(checkers(text)(rectangle{interval::between(x0, x1, at_bits(128)),
                                                   interval::between(y0, y1, at_bits(128))})),
        undecided)
        << text;
  };
  const rational e(1, 1'000'000);
  for (const char* text : {"sqrt(x)", "log(x)", "x^(1/3)", "x^x", "acosh(x)"}) {
    expect_none(text, -2, -1, -e, e);
    expect_none(text, -2, -1, 0, e);   // the cut's upper side
    expect_none(text, -2, -1, -e, 0);  // and its lower side
    expect_none(text, -1, 1, -1, 1);
    expect_none(text, 0, 0, 0, 0);
  }
  for (const char* text : {"asin(x)", "acos(x)", "atanh(x)"}) {
    expect_none(text, 1, 2, -e, e);
    expect_none(text, -2, -1, 0, e);
  }
  for (const char* text : {"atan(x)", "asinh(x)"}) {
    expect_none(text, -e, e, 1, 2);
    expect_none(text, -e, 0, -2, -1);
  }
  expect_none("1/x", 0, 1, 0, 1);
  expect_none("1/(x^2 + 1)", -e, e, 1 - e, 1 + e);
  expect_none("tan(x)", rational(3, 2), rational(8, 5), -e, e);
  expect_none("tanh(x)", -e, e, rational(3, 2), rational(8, 5));
  expect_none("exp(exp(exp(x)))", 10, 10, 0, 0);  // a value is too great
}

/// e^x for x far below 0 is more than 0 and less than a unit.
TEST(Formula, ExponentialsOfGreatNumbersCostNothing) {
  for (const long x : {-50L, -89L, -130L, -200L, -100'000L}) {
    const interval e = checkers("exp(x)")(interval(rational(x), at_bits(128)));
    EXPECT_LE(as_provers(e.lower()), upper_rational(exp(ball(x, 64)))) << x;
    EXPECT_LE(lower_rational(exp(ball(x, 64))), as_provers(e.upper())) << x;
    EXPECT_LE(e.high(), integer(1) << 60U) << x;
  }
  EXPECT_THROW(static_cast<void>(checkers("exp(x)")(interval(rational(100'000), at_bits(128)))),
               undecided);
  EXPECT_THROW(static_cast<void>(checkers("cosh(x)")(interval(rational(-100'000), at_bits(128)))),
               undecided);
}

TEST(Formula, WhatIsNoneIsRefused) {
  for (const char* text :
       {"",      " ",     "x +",        "(x",        "x)",     "2x",     "x x",      "y",
        "sin",   "sin x", "sin()",      "sin(x, 1)", "erf(x)", "01",     "1.5",      "1e5",
        "x^",    "*x",    "+x",         "x**2",      "1/0",    "0^-1",   "x/(1-1)",  "sqrt",
        "pi(x)", "x(1)",  "x^10000000", "a\nb",      "\xff",   "abs(x)", "gamma(x)", "e"}) {
    EXPECT_THROW(static_cast<void>(checkers(text)), refusal) << text;
  }
  EXPECT_THROW(static_cast<void>(checkers("x", "")), refusal);
  EXPECT_THROW(static_cast<void>(checkers(std::string(1'000'000, '('))), refusal);
  EXPECT_THROW(static_cast<void>(checkers(std::string(19'000, '('))), refusal);
  std::string tower;
  for (int i = 0; i < 5000; ++i) tower += "x^";
  EXPECT_THROW(static_cast<void>(checkers(tower + "x")), refusal);
  std::string functions;
  for (int i = 0; i < 4000; ++i) functions += "exp(";
  EXPECT_THROW(static_cast<void>(checkers(functions)), refusal);
  for (const char* name :
       {"", "1x", "pi", "sin", "a b", "a-b", "\xc3\xa9", "log1p", "Pi", "l", "e"}) {
    EXPECT_FALSE(formula::is_variable(name)) << name;
  }
  EXPECT_TRUE(formula::is_variable("x_1"));
}

}  // namespace formula_test
}  // namespace polhode::checker
