// Values that exact rules show to be rational: known ones, what is left open, random formulas
// against enclosures, and formulas of great size.

#include <gtest/gtest.h>

#include <array>
#include <numeric>
#include <optional>
#include <string>

#include "polhode/expression/expression.hpp"
#include "support/random.hpp"

namespace polhode {
namespace rational_value_test {

void expect_value(const std::string& formula, const std::string& value) {
  const auto q = expression(formula).rational_value();
  ASSERT_TRUE(q) << formula;
  EXPECT_EQ(to_text(*q), value) << formula;
}

TEST(RationalValue, KnownIdentities) {
  const std::pair<const char*, const char*> known[] = {
      {"7/3", "7/3"},
      {"cos(pi)", "-1"},
      {"sin(pi)", "0"},
      {"sin(pi/6)", "1/2"},
      {"tan(pi/4)", "1"},
      {"sin(-17*pi/6)", "-1/2"},
      {"cos(pi/5) - 1/4 - sqrt(5)/4", "0"},
      {"cos(2*pi/5)*cos(pi/5)", "1/4"},
      {"cos(pi/12)*cos(5*pi/12)", "1/4"},
      {"sin(pi/10)*sin(3*pi/10)", "1/4"},
      {"sin(pi/8)*cos(pi/8) - sqrt(2)/4", "0"},
      {"cos(pi/7) - cos(2*pi/7) + cos(3*pi/7)", "1/2"},
      {"cos(pi/9)*cos(2*pi/9)*cos(4*pi/9)", "1/8"},
      {"8*cos(pi/9)^3 - 6*cos(pi/9)", "1"},
      {"(sin(pi/7)*sin(2*pi/7)*sin(3*pi/7))^2", "7/64"},
      {"cos(4*pi/7)^2 + sin(4*pi/7)^2", "1"},
      {"tan(pi/8) + 1 - sqrt(2)", "0"},
      {"4*cospi(1/4)*sqrt(2)", "4"},
      {"acos(1/2)/pi", "1/3"},
      {"asin(-sqrt(3)/2)/pi", "-1/3"},
      {"atan(1)*4/pi", "1"},
      {"acos(cos(9*pi/5))/pi", "1/5"},
      {"sin(asin(1/3))", "1/3"},
      {"cos(2*atan(1/3))", "4/5"},
      {"tan(atan(7) - atan(2))", "1/3"},
      {"16*atan(1/5) - 4*atan(1/239) - pi", "0"},
      {"atan2(-1, -1)/pi", "-3/4"},
      {"atan2(1, sin(pi))/pi", "1/2"},
      {"sqrt(2)^2", "2"},
      {"sqrt(2)*sqrt(8)", "4"},
      {"4^(1/2)", "2"},
      {"2^(1/3)*4^(1/3)", "2"},
      {"cbrt(-2)^3", "-2"},
      {"hypot(sqrt(2), sqrt(7))", "3"},
      {"sqrt(3+2*sqrt(2)) - 1 - sqrt(2)", "0"},
      {"sqrt((1-sqrt(2))^2) - sqrt(2)", "-1"},
      {"sqrt(5-2*sqrt(6)) + sqrt(2) - sqrt(3)", "0"},
      {"sqrt(6+2*sqrt(2)+2*sqrt(3)+2*sqrt(6)) - sqrt(2) - sqrt(3)", "1"},
      {"sqrt(2+sqrt(2))^2 - sqrt(2)", "2"},
      {"(1+sqrt(5))/2 - 2/(1+sqrt(5))", "1"},
      {"1/(sqrt(2)+sqrt(3)+sqrt(5)) - (2*sqrt(3)+3*sqrt(2)-sqrt(30))/12", "0"},
      {"log(8)/log(2)", "3"},
      {"log(9)/log(27)", "2/3"},
      {"log(2) + log(3) - log(6)", "0"},
      {"log(6)/(log(2)+log(3))", "1"},
      {"log(2+sqrt(3)) + log(2-sqrt(3))", "0"},
      {"exp(log(3))", "3"},
      {"exp(log(2)/2)^2", "2"},
      {"exp(2)*exp(-2)", "1"},
      {"log(exp(sqrt(2))) - sqrt(2)", "0"},
      {"2^(log(3)/log(2))", "3"},
      {"cosh(log(2))", "5/4"},
      {"tanh(log(3))", "4/5"},
      {"cosh(1)^2 - sinh(1)^2", "1"},
      {"sinh(asinh(3))", "3"},
      {"asinh(3/4) - log(2)", "0"},
      {"acosh(5/4)/log(2)", "1"},
      {"atanh(1/3)/log(2)", "1/2"},
      {"expm1(log(4))", "3"},
      {"log1p(7)/log(2)", "3"},
      {"gamma(1/2)^2 - pi", "0"},
      {"gamma(7/2)/sqrt(pi)", "15/8"},
      {"gamma(-3/2)/sqrt(pi)", "4/3"},
      {"zeta(2)*6/pi^2", "1"},
      {"zeta(12)/pi^12", "691/638512875"},
      {"pi/(1+pi) + 1/(1+pi)", "1"},
      {"(2*pi+2*pi^2)/(pi^2+pi)", "2"},
      {"sqrt((1-pi)^2) - pi", "-1"},
      {"abs(sqrt(2)-2) + sqrt(2)", "2"},
      {"max(sqrt(2), sqrt(3))^2", "3"},
      {"min(sqrt(2), sqrt(3))^2", "2"},
      {"floor(pi)", "3"},
      {"ceil(-pi)", "-3"},
      {"euler_gamma - euler_gamma", "0"},
      {"(erf(1)+1)*(erf(1)-1) - erf(1)^2", "-1"},
      {"agm(sqrt(2), 2/sqrt(2))^2", "2"},
      // Cosines and sines of other angles than multiples of pi.
      {"sin(1)^2 + cos(1)^2", "1"},
      {"sin(2) - 2*sin(1)*cos(1)", "0"},
      {"sin(1/2)*cos(1/3) - (sin(5/6) + sin(1/6))/2", "0"},
      {"sin(-1/3)^3 + (3*sin(1/3) - sin(1))/4", "0"},
      {"tan(1)*cos(1)/sin(1)", "1"},
      {"tan(2) - 2*tan(1)/(1 - tan(1)^2)", "0"},
      {"sin(pi/3 + 1) - sin(1)/2 - sqrt(3)/2*cos(1)", "0"},
      {"cos(sqrt(2))^2 + sin(sqrt(2))^2", "1"},
      {"cos(sqrt(2) + pi/7)^2 + sin(sqrt(2) + pi/7)^2", "1"},
      {"cosh(1)*sin(1) - sin(1)*(e + 1/e)/2", "0"},
      {"sqrt(1 - cos(2)) - sqrt(2)*sin(1)", "0"},
      {"2*sin(atan(1/2)/2)^2 + 2/sqrt(5)", "1"},
      {"sin(1e-200)^2 + cos(1e-200)^2", "1"},
      // Algebraic numbers whose terms do not cancel by themselves.
      {"cbrt(2 + sqrt(5)) + cbrt(2 - sqrt(5))", "1"},
      {"cbrt(cbrt(2) - 1) - cbrt(1/9) + cbrt(2/9) - cbrt(4/9)", "0"},
      {"sqrt(cbrt(28) - 3) - (cbrt(98) - cbrt(28) - 1)/3", "0"},
      {"cbrt(7 + 5*sqrt(2)) - sqrt(2)", "1"},
      {"sin(pi/7)*sin(2*pi/7)*sin(3*pi/7)/sqrt(7)", "1/8"},
      {"cos(2*pi/17) + cos(4*pi/17) + cos(8*pi/17) + cos(16*pi/17) - sqrt(17)/4", "-1/4"},
      {"sin(1)*(cbrt(2 + sqrt(5)) + cbrt(2 - sqrt(5)) - 1) + 3", "3"},
      // Of numbers known by their enclosures alone, negative ones.
      {"abs(sin(4))/sin(4)", "-1"},
      {"sqrt(sin(4)^2)/sin(4)", "-1"},
      {"abs(log(pi-3))/log(pi-3)", "-1"},
  };
  for (const auto& [formula, value] : known) expect_value(formula, value);
}

TEST(RationalValue, WhatIsNotShownIsLeftOpen) {
  for (const char* formula :
       {"pi", "sqrt(2)", "log(2)", "e", "euler_gamma", "sin(1)", "pi + 1e-400", "cos(pi/7)",
        "log(2)*log(3)", "sqrt(2) + sqrt(3)", "sqrt(2+sqrt(2))", "exp(pi)",
        // not equal to the integer by less than an enclosure of a double shows
        "exp(pi*sqrt(163))", "sqrt(1e200+1) - 1e100",
        // the first one at which precision, not a rule, decides
        "floor(1e200*pi)", "sin(1)^2 + cos(2)^2", "sin(1)^2 + cos(1 + 1e-100)^2",
        "cos(sqrt(2))*cos(sqrt(3))", "cbrt(2 + sqrt(5)) - cbrt(2 - sqrt(5))", "cbrt(3) - sqrt(2)",
        // 3 (sqrt(10^160 + 1) - 10^80), which the enclosures do not tell from 0. With p the product
        // of the cube roots, which is 1, it is a root of a polynomial that is 0 at 0 too: of t (t^2
        // + 6*10^80 t - 9), as the rules do not see that p is not e^(2 pi i/3).
        "(sqrt(10^160+1) - 10^80)*((cbrt(2+sqrt(5))*cbrt(sqrt(5)-2))^2 + "
        "cbrt(2+sqrt(5))*cbrt(sqrt(5)-2) + 1)",
        // as small, and not 0 by the polynomial's value at 0
        "sqrt(10^160+1) - 10^80 + sqrt(2) - sqrt(2)",
        // nearer to a known angle than the enclosures tell
        "asin(1/2 + 1e-200)*6/pi", "acos(1/2 + 1e-200)*3/pi", "atan(1 + 1e-200)*4/pi",
        "atan(sqrt(3) + 1e-200)*3/pi"}) {
    EXPECT_FALSE(expression(formula).rational_value()) << formula;
  }
}

TEST(RationalValue, NoValueWhereTheFormulaHasNone) {
  for (const char* formula :
       {"tan(pi/2)", "1/sin(pi)", "0*log(-pi)", "log(-pi) - log(-pi)", "0/sin(pi)", "sqrt(1-pi)^2",
        "(1-pi)^(1/2) - (1-pi)^(1/2)", "acosh(sqrt(2)-1) - acosh(sqrt(2)-1)", "asin(pi) - asin(pi)",
        "atanh(sqrt(2)) - atanh(sqrt(2))", "sin(pi)^(-1)*0", "sin(pi)/sin(pi)", "exp(log(-pi))",
        "atan2(sin(pi), sin(pi))", "1/(sin(1)^2+cos(1)^2-1)", "log(sin(2)-2*sin(1)*cos(1))*0",
        "0/(cbrt(2+sqrt(5))+cbrt(2-sqrt(5))-1)", "sin(log(-pi))^2+cos(log(-pi))^2",
        "gamma(-2*sin(pi/6))/gamma(-2*sin(pi/6))", "sin(pi)^(-sqrt(2))", "log(sqrt(2)-sqrt(8))*0",
        "log1p(-pi)/log1p(-pi)", "agm(-pi, -pi)/pi",
        // a number that is 0, of which nothing but an enclosure is known
        "erf(sin(1)^2 + cos(1)^2 - 1)/erf(sin(1)^2 + cos(1)^2 - 1)",
        "erf(sin(1)^2 + cos(1)^2 - 1)^(-1)*erf(sin(1)^2 + cos(1)^2 - 1)"}) {
    EXPECT_FALSE(expression(formula).rational_value()) << formula;
  }
}

// ---------------------------------------------------------------------------------------------
// Random formulas in which much is exact

std::string number(support::random_source& random) {
  static constexpr std::array numbers{"0",           "1",         "2",           "3",
                                      "1/2",         "1/3",       "5/4",         "4",
                                      "6",           "12",        "pi",          "(pi/2)",
                                      "(pi/3)",      "(pi/4)",    "(pi/5)",      "(pi/8)",
                                      "(2*pi/7)",    "(5*pi/12)", "sqrt(2)",     "sqrt(3)",
                                      "log(2)",      "log(3)",    "(1+sqrt(2))", "e",
                                      "sin(4)",      "cos(2)",    "log(pi-3)",   "erf(1)",
                                      "cos(1)",      "sin(2)",    "cbrt(2)",     "cbrt(2+sqrt(5))",
                                      "(sqrt(5)-1)", "(1-pi)",    "atan(1/2)",   "atan(1/3)",
                                      "zeta(2)",     "gamma(1/2)"};
  return random.choose(numbers);
}

std::string random_formula(support::random_source& random, int depth) {
  static constexpr std::array functions{"sqrt", "sqrt",  "cbrt", "exp",   "expm1", "log",   "log1p",
                                        "sin",  "cos",   "tan",  "sinpi", "cospi", "asin",  "acos",
                                        "atan", "sinh",  "cosh", "tanh",  "asinh", "acosh", "atanh",
                                        "abs",  "floor", "ceil", "gamma", "-"};
  static constexpr std::array pairs{"min", "max", "hypot", "atan2", "agm"};
  static constexpr std::array operators{"+", "-", "*", "/", "^"};
  if (depth == 0) return number(random);
  const std::string x = random_formula(random, depth - 1);
  switch (random.between(0, 6)) {
    case 0:
    case 1:
      return std::string(random.choose(functions)) + "(" + x + ")";
    case 2:
      return std::string(random.choose(pairs)) + "(" + x + ", " +
             random_formula(random, depth - 1) + ")";
    case 3:
      return "(" + x + ")^(" + std::to_string(random.between(-3, 4)) +
             (random.one_in(2) ? "/2)" : ")");
    case 4: {  // a function and one that undoes it
      static constexpr std::array undone{
          std::pair("exp", "log"),    std::pair("log", "exp"),    std::pair("sin", "asin"),
          std::pair("cos", "acos"),   std::pair("tan", "atan"),   std::pair("asin", "sin"),
          std::pair("acos", "cos"),   std::pair("atan", "tan"),   std::pair("cosh", "acosh"),
          std::pair("sinh", "asinh"), std::pair("tanh", "atanh"), std::pair("acosh", "cosh")};
      const auto& [f, g] = random.choose(undone);
      return std::string(f) + "(" + g + "(" + x + "))";
    }
    default:
      return "(" + x + ")" + random.choose(operators) + "(" + random_formula(random, depth - 1) +
             ")";
  }
}

TEST(RationalValue, LiesInTheEnclosure) {
  support::random_source random(20261123);
  constexpr precision bits = 300;
  long decided = 0;
  long compared = 0;
  long beyond_the_reader = 0;  // not by folding numbers alone
  for (support::repeat trial(20'000); trial.again();) {
    const std::string text = random_formula(random, static_cast<int>(random.between(1, 4)));
    SCOPED_TRACE(text);
    std::optional<expression> f;
    try {
      f.emplace(text);
    } catch (const expression_error&) {
      continue;  // certainly not defined
    }
    const auto q = f->rational_value();
    if (!q) continue;
    ++decided;
    if (!f->exact_value()) ++beyond_the_reader;
    const ball around = f->value(bits);
    // An enclosure may be undefined where an operand lies on the boundary of a domain:
    // acos(sin(pi/2)).
    if (!around.is_bounded()) continue;
    ++compared;
    EXPECT_TRUE(contains(around, *q)) << to_text(*q) << " and " << around;
  }
  const double share = std::min(1.0, support::effort());
  EXPECT_GT(decided, 500 * share);
  EXPECT_GT(compared, decided / 2);
  EXPECT_GT(beyond_the_reader, 300 * share);
}

/// A random polynomial in cosines and sines of angles n/6 + m sqrt(2) + k pi/5: of the same with
/// every angle's parts apart, by the sums of angles, it is not different.
TEST(RationalValue, DecidesTrigonometricIdentities) {
  support::random_source random(1770);
  const auto text = [&](long least, long most) {
    return std::to_string(random.between(least, most));
  };
  for (support::repeat trial(200); trial.again();) {
    std::string whole;
    std::string apart;
    for (int terms = 0; terms < 3; ++terms) {
      const std::string c = "+(" + text(-5, 5) + ")/" + text(1, 5);
      whole += c;
      apart += c;
      for (long factors = random.between(1, 3); factors > 0; --factors) {
        const std::string x = "(" + text(-6, 6) + "/6)";
        const std::string y = "(" + text(-2, 2) + "*sqrt(2)+" + text(0, 9) + "*pi/5)";
        const bool is_sine = random.one_in(2);
        whole += std::string(is_sine ? "*sin(" : "*cos(") + x + "+" + y + ")";
        apart += is_sine ? "*(sin" + x + "*cos" + y + "+cos" + x + "*sin" + y + ")"
                         : "*(cos" + x + "*cos" + y + "-sin" + x + "*sin" + y + ")";
      }
    }
    expect_value("(" + whole + ") - (" + apart + ")", "0");
    EXPECT_NE(expression("(" + whole + ") - (" + apart + ") + sin(1/7)").rational_value(),
              rational(0));
  }
}

/// Roots of x^3 + 3 p x - 2 q with a rational root r, by Cardano's formula: q = (r^3 + 3 p r)/2.
TEST(RationalValue, DecidesCubicRoots) {
  support::random_source random(1545);
  for (support::repeat trial(60); trial.again();) {
    const std::string r = std::to_string(random.between(1, 9));
    const std::string p = std::to_string(random.between(1, 9));
    const std::string q = "((" + r + "^3+3*" + p + "*" + r + ")/2)";
    const std::string s = "sqrt(" + q + "^2+" + p + "^3)";
    expect_value("cbrt(" + q + "+" + s + ")+cbrt(" + q + "-" + s + ")", r);
  }
}

/// x - y for two forms of the same number: random elements of Q(sqrt 2, sqrt 3, sqrt 5), squared
/// and rooted, divided and multiplied, must come back. The sum of the primitive n-th roots of unity
/// is Moebius' mu(n); a cosine by itself is rational for denominators to 3 alone (I. Niven,
/// Irrational Numbers, 1956, cor. 3.12).
TEST(RationalValue, DecidesCosinesByRootsOfUnity) {
  for (long n = 4; n <= 60; ++n) {
    long mu = 1;
    long rest = n;
    for (long prime = 2; prime <= rest; ++prime) {
      if (rest % prime != 0) continue;
      rest /= prime;
      mu = rest % prime == 0 ? 0 : -mu;
    }
    std::string sum = "0";
    for (long k = 1; k <= n; ++k) {
      if (std::gcd(k, n) == 1)
        sum += "+cospi(" + std::to_string(2 * k) + "/" + std::to_string(n) + ")";
    }
    // Where n is a power of 2 times 1, 3 or 5 the cosines are nested square roots, of which not
    // everything is known.
    long odd = n;
    while (odd % 2 == 0) odd /= 2;
    const auto found = expression(sum).rational_value();
    if (found || odd > 5) {
      EXPECT_EQ(found, rational(mu)) << n;
    }
    const std::string one = "cospi(1/" + std::to_string(n) + ")";
    EXPECT_FALSE(expression(one).rational_value()) << n;
    EXPECT_FALSE(expression(sum + "+" + one + "^3").rational_value()) << n;
  }
}

// The product of cos(pi k/n) over 0 < k < n/2, n odd, is 2^-((n-1)/2); at 25 and 45 no other rule
// shows it, and a prime divides n twice.
TEST(RationalValue, DecidesProductsOfCosinesByRootsOfUnity) {
  for (const long n : {7L, 9L, 15L, 25L, 45L}) {
    std::string product = "1";
    for (long k = 1; 2 * k < n; ++k) {
      product += "*cospi(" + std::to_string(k) + "/" + std::to_string(n) + ")";
    }
    EXPECT_EQ(expression(product).rational_value(), rational(1, integer(1) << ((n - 1) / 2))) << n;
    EXPECT_FALSE(expression(product + "*cospi(1/" + std::to_string(n) + ")").rational_value()) << n;
  }
}

TEST(RationalValue, UndoesWhatWasDoneInSquareRoots) {
  support::random_source random(17);
  for (support::repeat trial(300); trial.again();) {
    const auto integer_text = [&] { return std::to_string(random.between(-9, 9)); };
    const std::string x = "(" + integer_text() + " + " + integer_text() + "*sqrt(2) + " +
                          integer_text() + "*sqrt(3))";
    const std::string y = "(" + std::to_string(random.between(1, 9)) + " + " +
                          std::to_string(random.between(1, 9)) + "*sqrt(5) + sqrt(2))";
    expect_value(x + "*" + y + "/" + y + " - " + x, "0");
    expect_value("sqrt(" + x + "^2) - abs(" + x + ")", "0");
    const std::string expanded = "(1*" + x + "*" + x + " + 0*sqrt(7))";
    expect_value("sqrt(" + expanded + ") - abs(" + x + ")", "0");
  }
}

// ---------------------------------------------------------------------------------------------
// Great sizes: the answer may be anything true, but it comes at once (the limit of the test is what
// would show else).

TEST(RationalValue, GivesUpOnGreatFormulas) {
  const auto many = [](int n, auto&& part) {
    std::string text;
    for (int k = 2; k < n; ++k) text += (k == 2 ? "" : "+") + part(std::to_string(k));
    return text;
  };
  const auto nested = [](int n, const std::string& before, const std::string& after) {
    std::string text = "2";
    for (int k = 0; k < n; ++k) text = before + text + after;
    return text;
  };
  const std::string roots = many(60, [](const std::string& k) { return "sqrt(" + k + ")"; });
  for (const std::string& text :
       {roots,
        "(" + roots + ")^20",
        "1/(" + roots + ")",
        "sqrt(" + roots + ")",
        "log(" + roots + ")",
        many(300, [](const std::string& k) { return "atan(1/" + k + ")"; }),
        many(200, [](const std::string& k) { return "cos(pi/" + k + ")"; }),
        many(3000, [](const std::string& k) { return "log(" + k + ")"; }),
        nested(100, "(", "^(1/2)+sqrt(3))^2"),
        nested(100, "sqrt(sqrt(3)+", ")"),
        many(100, [](const std::string& k) { return k + "^(1/" + k + ")"; }),
        many(100, [](const std::string& k) { return "cbrt(" + k + "+sqrt(" + k + "+1))"; }) +
            "-cbrt(7)",
        many(12, [](const std::string& k) { return "cbrt(" + k + ")"; }) + "-cbrt(2+sqrt(5))",
        "(" + many(40, [](const std::string& k) { return "sin(" + k + ")"; }) + ")^9",
        many(100, [](const std::string& k) { return "cos(1/" + k + ")^" + k; }),
        many(100, [](const std::string& k) { return "tan(1/" + k + ")"; }),
        nested(40, "sin(cos(1)*", ")^2"),
        nested(40, "cbrt(sqrt(5)+", ")"),
        std::string("sin(10^4000)^2+cos(10^4000)^2"),
        std::string("sin(exp(exp(20)))^2+cos(exp(exp(20)))^2"),
        std::string("sin(1)^(10^12)"),
        std::string("sin(1)^30*cos(2)^30*sin(3)^30"),
        std::string("2^(1/1000003)+3^(1/1000003)-5^(1/7)"),
        nested(60, "exp(", "^2)"),
        nested(60, "sin(", ")+sqrt(2)"),
        std::string("2^(1/2)^(1/2)^(1/3)^(1/5)^(1/7)"),
        std::string("sqrt(2)^(10^12)"),
        std::string("sqrt(2)^(-10^12)"),
        std::string("log(10^9999+7)/log(10^9998+3)"),
        std::string("sqrt(10^9999+7)*sqrt(10^9998+3)"),
        std::string("exp(log(2)*10^12)"),
        std::string("cos(10^4000*pi/7)"),
        std::string("atan(10^4000/7)*4"),
        std::string("(1+sqrt(2))^(10^9)"),
        std::string("floor(exp(exp(10)))")}) {
    SCOPED_TRACE(text.substr(0, 60));
    const auto q = expression(text).rational_value();
    if (!q) continue;
    EXPECT_TRUE(contains(expression(text).value(1000), *q));
  }
  expect_value("(" + roots + ") - (" + roots + ")", "0");
}

TEST(DivisorZeros, AreCandidates) {
  const auto of = [](const std::string& f) {
    std::vector<std::string> texts;
    for (const expression& x : expression(f, {.variables = {"x"}, .definitions = {}})
                                   .divisor_zeros(hull(double_interval(-2), double_interval(2)))) {
      texts.push_back(x.to_text());
    }
    return texts;
  };
  using texts = std::vector<std::string>;
  EXPECT_EQ(of("1/(x-3)"), texts{"3"});
  EXPECT_EQ(of("1/(2*x-sqrt(2))"), texts{"sqrt(2)/2"});
  EXPECT_EQ(of("1/(cos(x)-cos(1))"), (texts{"acos(cos(1))", "-acos(cos(1))"}));
  EXPECT_EQ(of("log(exp(x)-3)"), texts{"log(3)"});
  EXPECT_EQ(of("sqrt(exp(x)+3)"), texts{});
  EXPECT_EQ(of("sin(x)*x"), texts{});
  EXPECT_EQ(of("log(tan(x))"), (texts{"pi/2", "pi/2 + -1*pi", "0"}));
  EXPECT_EQ(of("1/(x^2+1)").size(), 0U);
  EXPECT_EQ(of("(x^4-2)^(-2)").size(), 2U);
}

}  // namespace rational_value_test
}  // namespace polhode
