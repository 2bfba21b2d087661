// Formulas as texts: what they mean, decided in exact rationals, what is refused and where, and the
// graph.

#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "polhode/expression/expression.hpp"
#include "polhode/expression/functions.hpp"
#include "support/random.hpp"

namespace polhode {
namespace grammar_test {

using support::random_source;
using support::repeat;

const expression_names with_x{{"x"}, {}};

std::string exact(const std::string& text, const expression_names& names = {}) {
  const expression f(text, names);
  return f.exact_value() ? to_text(*f.exact_value()) : "not exact";
}

TEST(Grammar, PrecedenceAndAssociativity) {
  const std::pair<const char*, const char*> meanings[] = {
      {"1 + 2*3", "7"},
      {"(1 + 2)*3", "9"},
      {"7 - 4 - 2", "1"},
      {"7 - (4 - 2)", "5"},
      {"48/4/3", "4"},
      {"48/(4/3)", "36"},
      {"2^3^2", "512"},
      {"(2^3)^2", "64"},
      {"2**3**2", "512"},
      {"-2^2", "-4"},
      {"(-2)^2", "4"},
      {"2^-1", "1/2"},
      {"2^-2^2", "1/16"},
      {"2^--2", "4"},
      {"-2^-2", "-1/4"},
      {"2*-3", "-6"},
      {"2 - -3", "5"},
      {"--3", "3"},
      {"-+-3", "3"},
      {"-3*2", "-6"},
      {"-6/4", "-3/2"},
      {"6/-4", "-3/2"},
      {"3!", "6"},
      {"-3!", "-6"},
      {"3!^2", "36"},
      {"2^3!", "64"},
      {"(3!)!", "720"},
      {"3! !", "720"},
      {"0!", "1"},
      {"0!!", "1"},
      {"5!!", "15"},
      {"8!!", "384"},
      {"-5!!", "-15"},
      {"2^4!!", "256"},
      {"(1 + 2)!", "6"},
      {"1 - 1/3", "2/3"},
      {"1/3*3", "1"},
      {"2 + 3 * 4 ^ 2", "50"},
      {"((((5))))", "5"},
      {"0.0629", "629/10000"},
      {"1e-3", "1/1000"},
      {"2.5e+3", "2500"},
      {".5 + 5.", "11/2"},
      {"1E2", "100"},
      {" 1\t+\n2 ", "3"},
      {"0^0", "1"},
      {"(1 + 1e-50) - 1 - 1e-50", "0"},
  };
  for (const auto& [text, value] : meanings) EXPECT_EQ(exact(text), value) << text;
}

/// A number before a name or a parenthesis is a factor.
TEST(Grammar, JuxtaposedFactors) {
  const expression_names names{{}, {{"x", "5"}, {"e3", "7"}, {"x1", "11"}}};
  const std::pair<const char*, const char*> meanings[] = {
      {"2x", "10"},           {"2 x", "10"},        {"2(x + 1)", "12"},
      {"2x^2", "50"},         {"-2x^2", "-50"},     {"2x/3", "10/3"},
      {"x - 2x", "-5"},       {"x*2x", "50"},       {"3 sqrt(4)x1", nullptr},
      {"3 sqrt(4)*x1", "66"}, {"(2x)(3)", nullptr}, {"2exp(0)", "2"},
      {"2e3", "2000"},        {"2e3x", "10000"},    {"2 e3", "14"},
      {"2*e3", "14"},         {"2 e3x", nullptr},   {".5x", "5/2"},
      {"2.(3)", "6"},         {"2x!", "240"},       {"0x", "0"},
      {"2**3 - 2x", "-2"},
  };
  for (const auto& [text, value] : meanings) {
    if (value == nullptr) {
      EXPECT_THROW(exact(text, names), expression_error) << text;
    } else {
      EXPECT_EQ(exact(text, names), value) << text;
    }
  }
  EXPECT_EQ(expression("2pi + 2 sin(3x)", with_x).to_text(),
            expression("2*pi + 2*sin(3*x)", with_x).to_text());
}

/// Beyond the factorials that are kept exact, n!! is made of them.
TEST(Grammar, DoubleFactorials) {
  rational odd = 1;
  rational even = 1;
  for (long n = 1; n <= 300; ++n) {
    rational& product = n % 2 == 0 ? even : odd;
    product *= n;
    EXPECT_EQ(exact(std::to_string(n) + "!!"), to_text(product)) << n;
  }
  for (const char* zero :
       {"log(10001!!) - log(10001) - log(9999!!)", "log(10002!!) - log(10002) - log(10000!!)",
        "log(20001!!) + log(20000!!) - log_gamma(20002)"}) {
    const ball value = expression(zero).value(300);
    EXPECT_TRUE(contains(value, 0)) << zero;
    EXPECT_TRUE(certainly_less(abs(value), ball(1, 64) / 1000000)) << zero;
  }
}

TEST(Grammar, OtherNamesMeanTheSame) {
  for (const expression_alias& a : expression_aliases()) {
    const bool is_constant = a.meaning == "pi";
    const std::string arguments = is_constant ? "" : a.meaning == "atan2" ? "(x, 2)" : "(x)";
    EXPECT_EQ(expression(a.name + arguments, with_x).to_text(),
              expression(a.meaning + arguments, with_x).to_text());
    EXPECT_THROW(expression("1", {{a.name}, {}}), input_error) << a.name;
  }
}

/// Their canonical text has the older names alone, which the checker of certificates reads.
TEST(Grammar, ReciprocalsOfFunctions) {
  EXPECT_EQ(expression("sec(x)", with_x).to_text(), "1/cos(x)");
  EXPECT_EQ(expression("csc(x)", with_x).to_text(), "1/sin(x)");
  EXPECT_EQ(expression("cot(x)", with_x).to_text(), "cos(x)/sin(x)");
  EXPECT_EQ(expression("coth(x)", with_x).to_text(), "1/tanh(x)");
  EXPECT_EQ(expression("arctan(x)", with_x).to_text(), "atan(x)");
}

TEST(Grammar, SignIsExact) {
  for (const char* text : {"1e-3000", "1/3", "1/2", "3/4", "1", "7", "1e3000"}) {
    EXPECT_EQ(exact("sign(" + std::string(text) + ")"), "1") << text;
    EXPECT_EQ(exact("sign(-" + std::string(text) + ")"), "-1") << text;
  }
  EXPECT_EQ(exact("sign(0)"), "0");
  const expression f("sign(x)", with_x);
  for (const long n : {-1000, -1, 0, 1, 1000}) {
    for (const long d : {1, 3, 1000, 1000000}) {
      const ball y = f(ball(n, 64) / d);
      EXPECT_TRUE(contains(y, n < 0 ? -1 : n > 0 ? 1 : 0)) << n << '/' << d;
      EXPECT_TRUE(y.is_exact()) << n << '/' << d;
    }
  }
  const ball around_zero = f(hull(ball(-1, 64), ball(2, 64)));
  EXPECT_TRUE(contains(around_zero, -1) && contains(around_zero, 0) && contains(around_zero, 1));
}

TEST(Grammar, MinusOneToAWholePart) {
  for (const char* whole : {"floor", "ceil"}) {
    const expression f("(-1)^" + std::string(whole) + "(x)", {{"x"}, {}});
    for (long k = -12; k <= 12; ++k) {
      const rational x(k, 4);
      const integer n = whole[0] == 'f' ? floor_of(x) : ceil_of(x);
      const long expected = n % 2 == 0 ? 1 : -1;
      EXPECT_EQ(lower_rational(f(ball(x, 64))), expected) << whole << x;
    }
    const ball around = f(hull(ball(rational(1, 4), 64), ball(rational(5, 4), 64)));
    EXPECT_TRUE(contains(around, 1) && contains(around, -1));
  }
}

TEST(Grammar, ExactValuesOfFunctions) {
  const std::pair<const char*, const char*> values[] = {
      {"sqrt(4/9)", "2/3"},
      {"cbrt(-8/27)", "-2/3"},
      {"root(-32, 5)", "-2"},
      {"root(7, 1)", "7"},
      {"4^(3/2)", "8"},
      {"(1/8)^(2/3)", "1/4"},
      {"8^(-1/3)", "1/2"},
      {"0^0.5", "0"},
      {"1^(1/3)", "1"},
      {"(-1)^(10^30)", "1"},
      {"(-1)^(10^30 + 1)", "-1"},
      {"pow(2, 10)", "1024"},
      {"floor(-7/2)", "-4"},
      {"ceil(-7/2)", "-3"},
      {"floor(5)", "5"},
      {"abs(-3/4)", "3/4"},
      {"min(1/3, 1/2)", "1/3"},
      {"max(1/3, 1/2)", "1/2"},
      {"max(1/3, 1/2, 1/7)", "1/2"},
      {"min(3, 2, 5, 1, 4)", "1"},
      {"hypot(3, 4, 12)", "13"},
      {"hypot(3, 4)", "5"},
      {"gamma(5)", "24"},
      {"log_gamma(2)", "0"},
      {"exp(0)", "1"},
      {"log(1)", "0"},
      {"cos(0)", "1"},
      {"acosh(1)", "0"},
      {"erfc(0)", "1"},
      {"sinpi(1/6)", "1/2"},
      {"sinpi(-7/6)", "1/2"},
      {"cospi(2/3)", "-1/2"},
      {"cospi(10^30 + 1)", "-1"},
      {"sinpi(1/2)", "1"},
      {"sinpi(17)", "0"},
      {"log2(1/1024)", "-10"},
      {"log10(1e300)", "300"},
      {"e^0", "1"},
      {"agm(3, 3)", "3"},
  };
  for (const auto& [text, value] : values) EXPECT_EQ(exact(text), value) << text;
  for (const char* text :
       {"sqrt(2)", "exp(1)", "sinpi(1/5)", "cospi(1/4)", "log2(3)", "2^(1/2)", "pi", "e",
        "gamma(1/2)", "2^100000", "hypot(1, 1)", "agm(1, 2)", "log10(20)"}) {
    EXPECT_EQ(exact(text), "not exact") << text;
  }
}

/// A formula in rational numbers, and its value by hand.
struct sample {
  std::string text;
  rational value;
};

sample any_sum(random_source& random, int depth);

sample any_operand(random_source& random, int depth) {
  if (depth > 0 && random.one_in(2)) {
    const sample inner = any_sum(random, depth - 1);
    return {"(" + inner.text + ")", inner.value};
  }
  const long n = random.between(0, 99);
  if (random.one_in(3)) return {"0." + std::to_string(n + 100), rational(n + 100, 1000)};
  return {std::to_string(n), rational(n)};
}
sample any_power(random_source& random, int depth) {
  sample base = any_operand(random, depth);
  if (!random.one_in(4)) return base;
  const long n = random.between(0, 3);
  rational value = 1;
  for (long i = 0; i < n; ++i) value *= base.value;
  return {base.text + (random.one_in(2) ? "^" : " ** ") + std::to_string(n), value};
}
sample any_signed(random_source& random, int depth) {
  const sample x = any_power(random, depth);
  return random.one_in(4) ? sample{"-" + x.text, rational(-x.value)} : x;
}
sample any_product(random_source& random, int depth) {
  sample result = any_signed(random, depth);
  while (random.one_in(2)) {
    const sample next = any_signed(random, depth);
    if (next.value != 0 && random.one_in(2)) {
      result = {result.text + "/" + next.text, rational(result.value / next.value)};
    } else {
      result = {result.text + " * " + next.text, rational(result.value * next.value)};
    }
  }
  return result;
}
sample any_sum(random_source& random, int depth) {
  sample result = any_product(random, depth);
  while (random.one_in(2)) {
    const sample next = any_product(random, depth);
    if (random.one_in(2)) {
      result = {result.text + " + " + next.text, rational(result.value + next.value)};
    } else {
      result = {result.text + "-" + next.text, rational(result.value - next.value)};
    }
  }
  return result;
}

TEST(Grammar, RandomFormulasInRationalNumbers) {
  random_source random(11);
  for (repeat trial(2000); trial.again();) {
    const sample s = any_sum(random, 4);
    if (s.text.size() > longest_expression) continue;
    EXPECT_EQ(exact(s.text), to_text(s.value)) << s.text;
  }
}

// ---------------------------------------------------------------------------------------------
// Errors

void expect_error(const std::string& text, std::size_t column,
                  const std::vector<std::string>& words, const expression_names& names = with_x) {
  SCOPED_TRACE(text.substr(0, 60));
  try {
    const expression f(text, names);
    FAIL() << "was read as " << f.to_text();
  } catch (const expression_error& error) {
    const std::string message = error.what();
    EXPECT_EQ(error.column(), column) << message;
    for (const std::string& word : words) {
      EXPECT_NE(message.find(word), std::string::npos) << word << " in " << message;
    }
  }
}

TEST(GrammarErrors, SayTheColumnAndWhatWouldBeRight) {
  expect_error("", 1, {"column 1", "ends here", "a number, a name"});
  expect_error("   ", 4, {"ends here"});
  expect_error("1 +", 4, {"ends here"});
  expect_error("1 + * 2", 5, {"\"*\"", "a number, a name"});
  expect_error("x x", 3, {"operator", "x*x"});
  expect_error("x 2", 3, {"operator", "x*2"});
  expect_error("(1 + 2)(3)", 8, {"(1 + 2)*(...)"});
  expect_error("(2 pi x)", 7, {"(2 pi*x"});
  expect_error("1/2x", 4, {"write /2*x or /(2*x)"});
  expect_error("1/-2 x", 6, {"write /2*x or /(2*x)"});
  expect_error("6/2(1 + 2)", 4, {"write /2*(...) or /(2*(...))"});
  expect_error("2^3x", 4, {"write ^3*x or ^(3*x)"});
  expect_error("x**-3x", 6, {"write ^3*x or ^(3*x)"});
  expect_error("x(3)", 1, {"x*(...)"});
  expect_error("pi(3)", 1, {"pi*(...)"});
  expect_error("(1 + 2", 7, {"ends here", "\")\""});
  expect_error("1 + 2)", 6, {"\")\"", "the end"});
  expect_error("sin(1, 2)", 1, {"1 argument, not 2", "sin(x)"});
  expect_error("atan2(1)", 1, {"2 arguments, not 1", "atan2(y, x)"});
  expect_error("sin()", 5, {"\")\""});
  expect_error("sin", 1, {"write sin(x)"});
  expect_error("1 + sine(x)", 5, {"\"sine\"", "nearest is sin"});
  expect_error("1 + alpho", 5, {"\"alpho\"", "nearest name is alpha"}, {{"alpha"}, {}});
  expect_error("Sin(x)", 1, {"nearest is sin"});
  expect_error("x, 2", 2, {"\",\""});
  expect_error("1 $ 2", 3, {"\"$\""});
  expect_error("1 + \xcf\x81", 5, {"a character"});
  expect_error("1 + \xff", 5, {"a character"});
  expect_error("|x|", 1, {"abs(x)"});
  expect_error("log(x, 2)", 1, {"1 argument, not 2", "log(x)/log(b)"});
  expect_error(std::string("1 +\0 2", 6), 4, {"a character"});
  expect_error("1e", 1, {"\"1e\"", "exponent of ten has digits", "1*e"});
  expect_error("x + 2.5E", 5, {"\"2.5E\"", "exponent of ten has digits"});
  expect_error("1e+", 1, {"exponent of ten has digits"});
  expect_error("1.2.3", 4, {"operator"});
  expect_error("0x1F", 1, {"\"0x1F\"", "decimal"});
  expect_error("0b101", 1, {"\"0b101\"", "decimal"});
  expect_error("1_000", 1, {"\"1_000\"", "without _"});
  expect_error("1,5", 2, {"decimal point"});
  expect_error("1!!!", 2, {"double factorial"});
  expect_error("(1/2)!!", 6, {"whole numbers"});
  expect_error("1 + oo", 5, {"\"oo\"", "limits"});
  expect_error("Infinity", 1, {"limits"});
  expect_error("x***2", 4, {"\"*\""});
  expect_error("2* *3", 4, {"\"*\""});
  expect_error("x = 2", 3, {"\"=\""});
  expect_error("1e400000000", 1, {"exponent of ten"});
  expect_error("1e99999999999999999999", 1, {"exponent of ten"});
}

TEST(GrammarErrors, CertainlyUndefinedOperations) {
  expect_error("x + 1/0", 6, {"division by zero"});
  expect_error("1/(2 - 2)", 2, {"division by zero"});
  expect_error("0^-1", 2, {"0 has no negative powers"});
  expect_error("0^(-1/2)", 2, {"0 has no negative powers"});
  expect_error("(-8)^(1/3)", 5, {"-8", "1/3", "root(x, n)"});
  expect_error("1 + sqrt(-4)", 5, {"sqrt(-4)", "x >= 0"});
  expect_error("root(-16, 4)", 1, {"-16"});
  expect_error("root(2, 1/2)", 1, {"whole number"});
  expect_error("root(2, x)", 1, {"whole number"});
  expect_error("root(2, 0)", 1, {"whole number"});
  for (const char* text :
       {"log(0)",   "ln(-1)",     "log2(0)",    "log10(-3)",   "log1p(-1)", "asin(2)",
        "acos(-2)", "acosh(1/2)", "atanh(1)",   "gamma(0)",    "gamma(-3)", "lgamma(-1)",
        "csch(0)",  "agm(-1, 2)", "asec(1/2)",  "acsc(0)",     "asech(0)",  "asech(2)",
        "acsch(0)", "acoth(1)",   "agm(2, -1)", "atan2(0, 0)", "zeta(1)",   "zeta(1/2)"}) {
    expect_error(text, 1, {});
  }
  expect_error("(1/2)!", 6, {"gamma(x + 1)"});
  expect_error("(-1)!", 5, {"gamma(x + 1)"});
  expect_error("x!", 2, {"gamma(x + 1)"});
}

TEST(GrammarErrors, HostileTexts) {
  const std::string many(1'000'000, '(');
  expect_error(many, longest_expression + 1, {"1000000 characters"});
  expect_error(many.substr(0, 50'000), 201, {"parentheses inside each other"});
  expect_error(std::string(90'000, ')'), 1, {"\")\""});
  std::string calls;
  for (int i = 0; i < 20'000; ++i) calls += "sin(";
  expect_error(calls, 804, {"parentheses inside each other"});
  const std::string deepest = std::string(200, '(') + "1" + std::string(200, ')');
  EXPECT_EQ(exact(deepest), "1");
  EXPECT_EQ(exact(std::string(99'999, '-') + "1"), "-1");
  expect_error("1" + std::string(99'999, '!'), 2, {"double factorial"});
  std::string factorials = "1";
  while (factorials.size() < 99'990) factorials += "! ";
  EXPECT_EQ(exact(factorials), "1");
  expect_error(std::string(100'000, '9') + "9", longest_expression + 1, {});
  EXPECT_EQ(exact(std::string(100'000, '9')).size(), 100'000U);
  expect_error(std::string(1'000, 'a'), 1, {"aaa..."});
  std::string tower = "1";
  std::string sum = "x";
  std::string fractions = "1";
  while (tower.size() < 99'990) tower += "^1";
  while (sum.size() < 99'990) sum += "+x";
  for (int i = 2; fractions.size() < 99'980; ++i) fractions += "+1/" + std::to_string(i);
  EXPECT_EQ(exact(tower), "1");
  EXPECT_NE(exact(fractions), "not exact");
  const expression long_sum(sum, with_x);
  EXPECT_TRUE(contains(long_sum(ball(1, 64)), long_sum.operation_count() + 1));
  EXPECT_THROW(static_cast<void>(long_sum.to_text()), std::length_error);
}

TEST(GrammarErrors, ShortTextsOfGreatNumbersCostLittle) {
  for (const char* text :
       {"2^(10^12)", "9^9^9^9", "1e300000000", "1e-300000000*1e-300000000", "2^-(10^18)", "(10^9)!",
        "root(2, 10^18)", "2^(1/10^18)", "zeta(10^18)", "2^(10^30)", "exp(1e300000000)",
        "tan(1e1000000)", "log2(1e300000)", "sinh(1e9)", "gamma(-1e9 - 1/2)"}) {
    const expression f(text);
    EXPECT_FALSE(f.exact_value()) << text;
    EXPECT_EQ(f.value(64).precision(), 64) << text;
  }
}

/// What other programs and books call functions is said in the names of this one.
TEST(GrammarErrors, NamesOfOtherPrograms) {
  expect_error("1 + psi(x)", 5,
               {"no function \"psi\"; it is written digamma(x) or polygamma(n, x)"});
  expect_error("E1(x)", 1, {"expint(1, x)"});
  expect_error("beta(x, 2)", 1, {"euler_beta(x, y)"});
  expect_error("jv(0, x)", 1, {"besselJ(nu, x)"});
  expect_error("ellipk(x)", 1, {"ellipticK(m)"});
  expect_error("tg(x)", 1, {"tan(x)"});
  expect_error("erfinv(x)", 1, {"erf(y) - x"});
}

/// Formulas as they are typeset are those in plain characters; a column is counted in what was
/// given.
TEST(Grammar, TypesetCharacters) {
  for (const auto& [typeset, plain] :
       {std::pair("x² − 2π", "x^2 - 2*pi"), std::pair("3×x·4÷5", "3*x*4/5"),
        std::pair("√(x + 1)³", "sqrt(x + 1)^3"), std::pair("x⁻¹²", "x^(-12)"),
        std::pair("−x²", "-(x^2)"), std::pair("2x¹⁰", "2*x^10"), std::pair("x ⋅ 3²", "x*9"),
        std::pair("(x²)²", "(x^2)^2"), std::pair("√ (x)", "sqrt(x)"),
        std::pair("e^−x²", "e^(-x^2)")}) {
    EXPECT_EQ(expression(typeset, with_x).to_text(), expression(plain, with_x).to_text())
        << typeset;
  }
  expect_error("π + √x", 6, {"sqrt(x)"}, with_x);
  expect_error("x²^3", 2, {"needs parentheses"}, with_x);
  expect_error("x² **3", 2, {"needs parentheses"}, with_x);
  expect_error("x² !", 2, {"needs parentheses"}, with_x);
  expect_error("x² ²", 2, {"needs parentheses"}, with_x);
  expect_error("sin²(x)", 1, {"write sin(x)"}, with_x);
  expect_error("x²x", 4, {"expected an operator"}, with_x);
  expect_error("π + $", 6, {"\"$\""}, with_x);
  expect_error("2² + (1", 9, {"ends here"}, with_x);
  expect_error("²", 1, {}, with_x);
  expect_error("x²⁻", 2, {"whole number"}, with_x);
  expect_error("x⁻", 2, {"whole number"}, with_x);
  EXPECT_TRUE(is_infinity("∞"));
}

/// A name far from every other has no suggestion.
TEST(GrammarErrors, NearestNamesAreNear) {
  for (const char* text : {"k", "zq", "quux(x)", "y + x"}) {
    try {
      const expression f(text, with_x);
      FAIL() << "was read as " << f.to_text();
    } catch (const expression_error& error) {
      EXPECT_EQ(std::string(error.what()).find("nearest"), std::string::npos) << error.what();
    }
  }
}

// ---------------------------------------------------------------------------------------------
// Names

TEST(Names, DefinitionsAreExactAndUseEarlierOnes) {
  const expression_names names{{"x"},
                               {{"a", "1/3"}, {"b", "a + 1"}, {"c", "sqrt(b*3)"}, {"_d2", "pi/2"}}};
  EXPECT_EQ(exact("a*b*c", names), "8/9");
  const expression f("x + _d2", names);
  EXPECT_EQ(f.to_text(), "x + pi/2");
  EXPECT_EQ(f.used_variables(), std::vector<std::string>{"x"});
  EXPECT_TRUE(expression("a", names).used_variables().empty());
}

void expect_refused_names(const expression_names& names, const std::string& word) {
  try {
    const expression f("1", names);
    FAIL() << "was accepted";
  } catch (const input_error& error) {
    EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
  }
}

TEST(Names, MayNotHideFunctionsConstantsOrEachOther) {
  expect_refused_names({{"sin"}, {}}, "function");
  expect_refused_names({{}, {{"pi", "3"}}}, "constant");
  expect_refused_names({{"x", "x"}, {}}, "twice");
  expect_refused_names({{"x"}, {{"x", "1"}}}, "twice");
  expect_refused_names({{}, {{"k", "1"}, {"k", "2"}}}, "twice");
  for (const char* name : {"", "2x", "a b", "a-b", "\xcf\x80"}) {
    expect_refused_names({{}, {{name, "1"}}}, "cannot be a name");
  }
  // A value may use neither a later name nor a variable; the error speaks of it.
  expect_error("k", 1, {"in the value of k", "column 1", "\"j\""}, {{}, {{"k", "j"}, {"j", "1"}}});
  expect_error("k", 5, {"in the value of k", "\"x\""}, {{"x"}, {{"k", "1 + x"}}});
}

// ---------------------------------------------------------------------------------------------
// The graph

TEST(Graph, SharesEqualSubexpressions) {
  const std::pair<const char*, std::size_t> counts[] = {
      {"sin(x) + sin(x)", 2},
      {"sin(x)*cos(x) + cos(x)*sin(x)", 4},  // the product once, in either order
      {"(x + 1)^2 + (1 + x)^3", 4},          // 1 + x is x + 1
      {"exp(-x^2)/(1 + exp(-x^2))", 5},
      {"2*3*x + 1", 2},
      {"e^x + exp(x)", 2},
      {"x^0.5 + sqrt(x)", 2},
      {"x", 0},
      {"7", 0},
  };
  for (const auto& [text, count] : counts) {
    EXPECT_EQ(expression(text, with_x).operation_count(), count) << text;
  }
  // 2^40 additions without sharing.
  expression_names names{{"x"}, {{"a0", "pi"}}};
  for (int i = 1; i <= 40; ++i) {
    const std::string last = "a" + std::to_string(i - 1);
    names.definitions.emplace_back("a" + std::to_string(i), last + " + " + last);
  }
  const expression f("a40*x", names);
  EXPECT_EQ(f.operation_count(), 42U);
  EXPECT_THROW(static_cast<void>(f.to_text()), std::length_error);
  EXPECT_TRUE(overlaps(f(ball(1, 100)), scale(pi(100), 40)));
}

TEST(Graph, PrintsWhatIsReadBackTheSame) {
  for (const char* text : {"x - (x - 1) - -x",
                           "-x^2",
                           "(-x)^2",
                           "(x^2)^3",
                           "x^(2^x)",
                           "(x^x)^x",
                           "x/(x/3)",
                           "x/3*x",
                           "x*(x/3)",
                           "2^-x",
                           "-(x + 1)",
                           "-(x*2)",
                           "x^-3",
                           "x^(1/3)",
                           "(1/2)^x",
                           "(-2)^x",
                           "x - 1/2",
                           "x + -1/2*x",
                           "root(x, 5)",
                           "atan2(x, -1)",
                           "10^(10^7) + x",
                           "zeta(3)*catalan + euler_gamma",
                           "e^x",
                           "min(x, -2)",
                           "1e-30*x",
                           "log2(x)",
                           "sech(x) - csch(x)",
                           "cbrt(x + 1)!",
                           "x^(3/2)",
                           "--x",
                           "2*(x + 1)^2"}) {
    std::string given = text;
    if (given.back() == '!') given.pop_back();
    const expression f(given, with_x);
    const expression again(f.to_text(), with_x);
    EXPECT_EQ(again.to_text(), f.to_text()) << given;
    EXPECT_EQ(again.operation_count(), f.operation_count()) << given;
    for (const char* point : {"1/3", "-7/5", "40"}) {
      const ball x = parse_ball(point, 128);
      const ball y = f(x);
      const ball z = again(x);
      EXPECT_EQ(y.is_undefined(), z.is_undefined()) << given;
      EXPECT_TRUE(overlaps(y, z)) << given;
    }
  }
}

TEST(Graph, PowersOfPowersOfNumbersAreOne) {
  const expression f("1e1000000^2");
  ASSERT_TRUE(f.exact_power());
  EXPECT_EQ(f.exact_power()->first, 10);
  EXPECT_EQ(f.exact_power()->second, 2'000'000);
  EXPECT_EQ(expression("(2^-1000000)^-3").to_text(), "2^3000000");
  EXPECT_FALSE(expression("(2^(10^18))^100").exact_power());  // beyond a machine integer
  // Not of other bases: (x^-1)^-1 is not defined at 0.
  EXPECT_TRUE(expression("(x^-1)^-1", with_x)(ball(0, 64)).is_undefined());
  EXPECT_FALSE(expression("x^3", with_x).exact_power());
}

TEST(Graph, KnowsItsVariables) {
  const expression f("y + 0*x", {{"x", "y", "z"}, {}});
  EXPECT_EQ(f.used_variables(), (std::vector<std::string>{"x", "y"}));
  EXPECT_EQ(f.variables().size(), 3U);
  EXPECT_THROW(static_cast<void>(f.value(64)), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(f(ball(1, 64))), std::invalid_argument);
  const std::vector<ball> values{ball(1, 64), ball(2, 100), ball(3, 64)};
  const ball sum = f.evaluate<ball>(values);
  EXPECT_TRUE(contains(sum, 2) && sum.is_exact());
  EXPECT_THROW(static_cast<void>(f.evaluate<ball>(std::span(values).first(2))),
               std::invalid_argument);
  EXPECT_TRUE(contains(expression("2/3", {{"x"}, {}}).value(64), rational(2, 3)));
}

// Its negative is no machine number.
TEST(Grammar, TheLeastMachineNumberIsAnExponent) {
  for (const char* text : {"x^(-9223372036854775808)", "x^(-9223372036854775807)",
                           "x^9223372036854775807", "(x^(-4611686018427387904))^2"}) {
    const expression f(text, {{"x"}, {}});
    EXPECT_TRUE(contains(f(ball(1, 64)), rational(1))) << text;
  }
  EXPECT_TRUE(certainly_positive(expression("(2^(-4611686018427387904))^2 + 1", {}).value(64)));
}

}  // namespace grammar_test
}  // namespace polhode
