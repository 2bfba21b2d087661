// A formula in s in place of x = e + sigma exp(-s), or sigma exp(s): known texts, and random
// formulas against their values at x.

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "polhode/arithmetic/special_functions.hpp"
#include "polhode/expression/expression.hpp"
#include "polhode/expression/library_functions.hpp"
#include "support/random.hpp"

namespace polhode {
namespace exponential_substitution_test {

expression of_x(const std::string& f) {
  return expression(f, {.variables = {"x"}, .definitions = {}});
}

std::string in_s(const std::string& f, const std::string& end, int side) {
  const bool is_infinite = end == "inf";
  const expression e(is_infinite ? "0" : end);
  const auto g = of_x(f).in_exponential(is_infinite ? nullptr : &e, side);
  return g ? g->to_text() : "none";
}

TEST(ExponentialSubstitution, TakesExponentsOut) {
  EXPECT_EQ(in_s("1/(x*log(x)^2)", "inf", 1), "1/s^2");
  EXPECT_EQ(in_s("x^(-1+1e-8)", "0", 1), "exp(-1/100000000*s)");
  EXPECT_EQ(in_s("(1-x)^(-1+1e-8)", "1", -1), "exp(-1/100000000*s)");
  EXPECT_EQ(in_s("1", "inf", -1), "exp(s)");
  EXPECT_EQ(in_s("x^2", "sqrt(2)", 1), "exp(-1*s)*(sqrt(2) + exp(-1*s))^2");
  EXPECT_EQ(in_s("abs(2-x^1)", "2", -1), "exp(-2*s)");
  EXPECT_EQ(in_s("log(-x)", "inf", 1), "none");
}

// Differences from a constant, and what only looks like one: the same values, and to few bits less.
TEST(ExponentialSubstitution, WritesDifferencesFromAConstantWithoutThem) {
  constexpr precision bits = 200;
  const expression e("0");
  for (const char* const text : {"1-cos(x)",
                                 "cos(x)-1",
                                 "2-cos(x)",
                                 "cos(x)+1",
                                 "cos(x)-2",
                                 "1-cosh(x)",
                                 "cosh(x^2)-1",
                                 "exp(x)-1",
                                 "1-exp(-x)",
                                 "1+exp(x)",
                                 "exp(x)-2",
                                 "expm1(x)",
                                 "log(1+x)",
                                 "log(1-x)",
                                 "log(1-x^2)",
                                 "log1p(-x)",
                                 "log(2+x)",
                                 "sqrt(1+x)-1",
                                 "1-sqrt(1-x)",
                                 "1-sqrt(1-x^2)",
                                 "sqrt(1-x)+1",
                                 "1-cos(pi+x)",
                                 "1+cos(pi-x)",
                                 "1+cos(pi+x)",
                                 "-1-cos(pi+x)",
                                 "-cos(x)-1",
                                 "1+(-cos(x))",
                                 "-exp(x)-1",
                                 "1-(-exp(x))",
                                 "-cosh(x)+1",
                                 "-sqrt(1+x)-1",
                                 "-sqrt(1+x)+1",

                                 "log(-(-(1+x^2)))",
                                 "sqrt(-(-(1+x^2)))-1",

                                 "2+(-(1+x^2))",
                                 "log(abs(-(1+x^2)))",
                                 "abs(-(1+x^2))-1",

                                 "cos(1+x)-cos(1)",
                                 "sin(1-x)-sin(1)",
                                 "cosh(x-1)-cosh(1)",
                                 "sinh(2+x)-sinh(2)",
                                 "exp(1-x)-exp(1)",
                                 "sqrt(2+x)-sqrt(2)",
                                 "log(3-x)-log(3)",
                                 "(2+x)^0.3-2^0.3",
                                 "(2+x)^3-8",
                                 "1/(2+x)-1/2",
                                 "(2+x)*(3-x)-6",
                                 "cbrt(8+x)-2",
                                 "2/(3-cos(x))-1",
                                 "1/cosh(x)^2-1",
                                 "1-1/(1+sin(x))",
                                 "(1-x)^20-1",
                                 "(1+x)^(-2)-1",
                                 "sqrt(1+sin(x))-1",
                                 "log(cos(x))",
                                 "log(cosh(x)^2)",
                                 "exp(tan(x))-1",
                                 "cos(pi/2+x)+x^2",
                                 "sin(pi/2+x)-1",
                                 "sin(-pi/2+x)+1",
                                 "log(1-atan(x))",
                                 "log1p(sin(pi+x))",
                                 "expm1(sinh(x))",
                                 "2*cos(x)-cosh(x)-1",
                                 "sqrt(pi-x)*sqrt(pi)-pi",
                                 "(3+x)/(2-x)-3/2",
                                 "cos(cos(x))-cos(1)",
                                 "exp(cos(x))-e",
                                 "-exp(1+x)+e",
                                 "2-(1+cos(x))",
                                 "(x-2)^4-16",
                                 "(x-2)^3+8"}) {
    const auto g = of_x(text).in_exponential(&e, 1);
    ASSERT_TRUE(g) << text;
    for (const long n : {1L, 5L, 40L}) {
      const ball s(n, bits);
      const ball t = exp(-ball(n, 4 * bits));
      const ball expected = of_x(text)(t) * t;
      const ball found = (*g)(s);
      EXPECT_TRUE(overlaps(found, expected)) << text << " at " << n << ": " << g->to_text();
      // Where nothing is rewritten the difference remains.
      if (std::string_view(text).find("abs") != std::string_view::npos) continue;
      EXPECT_LE(found.radius(), scale(expected.magnitude_upper(), 16 - bits))
          << text << " at " << n;
    }
  }
}

// ellipticK(m) where m tends to 1, and to other numbers: as pi/(2 agm(1, sqrt(1 - m))) with 1 - m
// to few bits less.
TEST(ExponentialSubstitution, WritesCompleteIntegralsByTheComplement) {
  constexpr precision bits = 200;
  const expression e("0", {.variables = {}, .definitions = {}, .further = library_functions()});
  for (const std::string m :
       {"1-x",          "1-3*x^2",      "cos(x)^2",     "cos(x)^3",   "sqrt(1-x)",  "2/(3-cos(x))",
        "1/cosh(x)^2",  "1-sin(x)",     "1/2-x",        "2*cos(x)-1", "cos(x)-1/3", "exp(-x)",
        "(1+x)^(-1/3)", "1-x*exp(-x)",  "1/(1+tan(x))", "log(e-x)",   "2-cosh(x)",  "x",
        "cos(pi+x)^2",  "sin(x-pi/2)^4"}) {
    const expression_names names{
        .variables = {"x"}, .definitions = {}, .further = library_functions()};
    const expression parameter(m, names);
    const expression f("ellipticK(" + m + ")", names);
    const auto g = f.in_exponential(&e, 1);
    ASSERT_TRUE(g) << m;
    for (const long n : {2L, 5L, 40L}) {
      const ball t = exp(-ball(n, 8 * bits));
      const ball mean = agm(ball(1, 8 * bits), sqrt(1 - parameter(t)));
      const ball expected = pi(8 * bits) / (2 * mean) * t;
      const ball found = (*g)(ball(n, bits));
      EXPECT_TRUE(overlaps(found, expected)) << m << " at " << n << ": " << g->to_text();
      EXPECT_LE(found.radius(), scale(expected.magnitude_upper(), 24 - bits)) << m << " at " << n;
    }
  }
}

TEST(ExponentialSubstitution, WritesOtherCompleteIntegrals) {
  constexpr precision bits = 200;
  const expression_names names{
      .variables = {"x"}, .definitions = {}, .further = library_functions()};
  const expression e("0", {.variables = {}, .definitions = {}, .further = library_functions()});
  for (const char* text :
       {"ellipticE(1-x)", "ellipticE(cos(x)^2)", "ellipticE(2/(3-cos(x)))", "ellipticE(1/2-x)",
        "ellipticE(1-3*x^2)", "carlsonRF(0,x,1)", "carlsonRF(x,2,0)", "carlsonRF(x,0,x^2)",
        "carlsonRF(3,x,0)", "carlsonRF(1,x,2)", "carlsonRF(0,x^3,x+1/2)", "carlsonRG(0,x,1)"}) {
    const expression f(text, names);
    const auto g = f.in_exponential(&e, 1);
    ASSERT_TRUE(g) << text;
    for (const long n : {2L, 5L, 40L}) {
      const ball t = exp(-ball(n, 8 * bits));
      const ball expected = f(t) * t;
      const ball found = (*g)(ball(n, bits));
      EXPECT_TRUE(overlaps(found, expected)) << text << " at " << n << ": " << g->to_text();
      EXPECT_LE(found.radius(), scale(expected.magnitude_upper(), 24 - bits))
          << text << " at " << n;
    }
  }
  // Two limits that are 0.
  EXPECT_FALSE(
      (*expression("carlsonRF(0,0*x,x)", names).in_exponential(&e, 1))(ball(2, bits)).is_bounded());
}

/// A value over the middle of which is known by few operations: of x alone, with numbers.
std::string random_formula(support::random_source& random, int depth, const std::string& end) {
  static constexpr std::array functions{"sqrt", "cbrt",  "exp",  "log",   "log1p", "sin", "cos",
                                        "tan",  "asinh", "atan", "tanh",  "abs",   "erf", "expm1",
                                        "sinh", "cosh",  "acos", "floor", "-"};
  static constexpr std::array numbers{"2", "1/3", "pi", "sqrt(2)", "e", "1", "1/2", "0.3", "-3/4"};
  if (depth == 0) {
    switch (random.between(0, 5)) {
      case 0:
        return std::string("(") + random.choose(numbers) + ")";
      case 1:
        return end == "inf" ? "x" : "(x-(" + end + "))";
      case 2:
        return end == "inf" ? "(-x)" : "((" + end + ")-x)";
      default:
        return "x";
    }
  }
  const std::string x = random_formula(random, depth - 1, end);
  switch (random.between(0, 6)) {
    case 0:
    case 1:
      return std::string(random.choose(functions)) + "(" + x + ")";
    case 2:
      return "(" + x + ")^(" + random.choose(numbers) + ")";
    case 3:
      return "(" + x + ")^(" + std::to_string(random.between(-3, 4)) + ")";
    case 4:
      return "(" + x + ")^(" + random_formula(random, depth - 1, end) + ")";
    default: {
      static constexpr std::array operators{"+", "-", "*", "/"};
      return "(" + x + ")" + random.choose(operators) + "(" +
             random_formula(random, depth - 1, end) + ")";
    }
  }
}

// g(s) = f(x) |dx/ds| wherever f(x) is defined; and where it is not, nor is g.
TEST(ExponentialSubstitution, HasTheValuesOfRandomFormulas) {
  constexpr precision bits = 400;
  support::random_source random(37);
  long compared = 0;
  long undefined = 0;
  static constexpr std::array ends{"0",   "1",   "sqrt(2)", "pi",     "-pi/2", "-1/3",
                                   "inf", "inf", "e",       "log(5)", "2*pi/3"};
  for (support::repeat trial(4000); trial.again();) {
    const std::string end = random.choose(ends);
    const int side = random.one_in(2) ? 1 : -1;
    std::string text = random_formula(random, static_cast<int>(random.between(0, 4)), end);
    std::optional<expression> f;
    try {
      f = of_x(text);
    } catch (const input_error&) {
      continue;
    }
    const bool is_infinite = end == "inf";
    const expression e(is_infinite ? "0" : end);
    const auto g = f->in_exponential(is_infinite ? nullptr : &e, side);
    // No whole number: (-1)^s would have a value there.
    const ball s(rational(8 * random.between(1, 40) + 1, 8 * random.between(1, 7)), bits);
    const ball step = exp(is_infinite ? s : -s);
    const ball x = is_infinite ? ball(step * side) : ball(e.value(bits) + step * side);
    const ball expected = (*f)(x)*step;
    // A ball of some width may be undefined where the number is not.
    const mpfr_float number = (*f)(midpoint(x));
    const bool is_undefined = !expected.is_bounded() && mpfr_nan_p(number.backend().data()) != 0;
    if (!g) {
      EXPECT_FALSE(expected.is_bounded()) << text << " at " << end;
      continue;
    }
    const ball found = (*g)(s);
    if (expected.is_bounded()) {
      // What the formula decides by an enclosure alone, the substitution may leave open at a step,
      // and only there.
      EXPECT_TRUE(overlaps(found, expected) || found.is_undefined())
          << text << " at " << end << ", side " << side << ": " << g->to_text();
      ++compared;
    } else if (is_undefined) {
      EXPECT_FALSE(found.is_bounded())
          << text << " at " << end << ", side " << side << ": " << g->to_text();
      ++undefined;
    }
  }
  EXPECT_GT(compared, 1000 * std::min(1.0, support::effort()));
  EXPECT_GT(undefined, 300 * std::min(1.0, support::effort()));
}

}  // namespace exponential_substitution_test
}  // namespace polhode
