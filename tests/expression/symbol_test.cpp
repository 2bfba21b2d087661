#include "polhode/expression/symbol.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/mpfr.hpp>

#include "polhode/expression/formula_of.hpp"
#include "polhode/expression/library_functions.hpp"
#include "polhode/expression/parse.hpp"

namespace polhode {
namespace symbol_test {

using boost::multiprecision::cpp_bin_float_50;
using boost::multiprecision::mpfr_float_50;

template <class F>
std::string text_of(const F& f) {
  return formula_of(f).to_text();
}

TEST(Symbol, RecordsWhatAFunctionDoes) {
  EXPECT_EQ(text_of([](auto x) { return exp(-x * x) / (1 + x / 3) - 2 * x + 1; }),
            parse("exp(-x*x)/(1 + x/3) - 2*x + 1").to_text());
  EXPECT_EQ(
      text_of([](const auto& x) { return sin(x) * pow(x, 3) + root(x, 5) - atan2(x, 2 + x); }),
      parse("sin(x)*x^3 + root(x, 5) - atan2(x, 2 + x)").to_text());
  EXPECT_EQ(text_of([](auto x) {
              auto s = x;
              s += 2;
              s *= x;
              s -= 1;
              s /= x + 1;
              return +s;
            }),
            parse("((x+2)*x - 1)/(x+1)").to_text());
}

TEST(Symbol, EveryFunctionOfTheTableIsThere) {
  const symbol x = symbol::variable(0);
  std::size_t count = 0;
#define POLHODE_TRY(f, arguments, ...)                                                    \
  ++count;                                                                                \
  if constexpr (std::string_view(arguments).starts_with("n, ")) {                         \
    EXPECT_EQ(formula_of(f(3, x), {"x"}).to_text(), parse(#f "(3, x)").to_text());        \
  } else if constexpr (std::string_view(arguments).find(',') != std::string_view::npos) { \
    EXPECT_EQ(formula_of(f(x, 3), {"x"}).to_text(), parse(#f "(x, 3)").to_text());        \
  } else if constexpr (std::string_view(#f) == "zeta") {                                  \
    EXPECT_EQ(formula_of(f(symbol(3)), {"x"}).to_text(), parse("zeta(3)").to_text());     \
  } else {                                                                                \
    EXPECT_EQ(formula_of(f(x), {"x"}).to_text(), parse(#f "(x)").to_text());              \
  }
  POLHODE_FUNCTION_TABLE(POLHODE_TRY, POLHODE_TRY, POLHODE_TRY, POLHODE_TRY)
#undef POLHODE_TRY
  EXPECT_EQ(count, expression_functions().size());
}

TEST(Symbol, NumbersBesideItAreExact) {
  EXPECT_EQ(text_of([](auto x) { return 0.5 * x + x / 4.0 - pow(x, 0.25); }),
            parse("1/2*x + x/4 - x^(1/4)").to_text());
  EXPECT_EQ(text_of([](auto x) { return x * "0.1"_r + 0.3_r - "1/7"_r * x; }),
            parse("x*0.1 + 3/10 - 1/7*x").to_text());
  const rational third(1, 3);
  EXPECT_EQ(text_of([&](auto x) { return third * x - integer(7); }), parse("1/3*x - 7").to_text());
  // 0.1 as Boost's numbers have it is another number than 1/10, and is taken as what it is.
  const mpfr_float_50 tenth("0.1");
  EXPECT_EQ(text_of([&](auto x) { return tenth * x; }),
            parse("k*x", {"x"}, {{"k", to_text(rational(tenth))}}).to_text());
  const cpp_bin_float_50 eighth("0.125");
  EXPECT_EQ(text_of([&](auto x) { return x - 2 * eighth; }), parse("x - 1/4").to_text());
  EXPECT_EQ(text_of([](auto) { return 2.5; }), "5/2");
  EXPECT_EQ(text_of([](auto) { return 3; }), "3");
}

TEST(Symbol, ADoubleThatIsNotItsDecimalIsRefused) {
  EXPECT_TRUE(exact_double::is_exact(0.5));
  EXPECT_TRUE(exact_double::is_exact(-1024.0));
  EXPECT_TRUE(exact_double::is_exact(0x1p-1070));
  EXPECT_TRUE(exact_double::is_exact(9007199254740991.0));
  EXPECT_TRUE(exact_double::is_exact(1e10));
  for (const double x : {0.1, 0.3, 1e-3, 3.14, 1e23, 0.7071067811865476, 1e300}) {
    EXPECT_FALSE(exact_double::is_exact(x)) << x;
  }
  EXPECT_FALSE(exact_double::is_exact(std::numeric_limits<double>::infinity()));
  EXPECT_FALSE(exact_double::is_exact(std::numeric_limits<double>::quiet_NaN()));
  EXPECT_THROW(static_cast<void>(text_of([](auto) { return 0.1; })), input_error);
  // All decimals of up to three places: exact are the eighths.
  for (int n = 1; n < 1000; ++n) EXPECT_EQ(exact_double::is_exact(n / 1000.0), n % 125 == 0) << n;
}

TEST(Symbol, WhatIsNotDefinedIsSaid) {
  const auto message = [](const auto& f) -> std::string {
    try {
      return formula_of(f).to_text();
    } catch (const input_error& error) {
      return error.what();
    }
  };
  EXPECT_NE(message([](auto x) { return x + log(symbol(-1)); }).find("log(-1)"), std::string::npos);
  EXPECT_NE(message([](auto x) { return x / (symbol(1) - 1); }).find("in the function"),
            std::string::npos);
  EXPECT_NE(message([](auto x) {
              return x * (mpfr_float_50(1) / std::numeric_limits<mpfr_float_50>::infinity()) +
                     std::numeric_limits<mpfr_float_50>::infinity();
            }).find("finite"),
            std::string::npos);
  EXPECT_THROW(static_cast<void>(formula_of(symbol::variable(1), {"x"})), input_error);
  EXPECT_THROW(static_cast<void>(formula_of(symbol::call("no_such", {symbol(1)}), {"x"})),
               input_error);
}

TEST(Symbol, LongChainsEndInTime) {
  const expression f = formula_of([](auto x) {
    auto sum = x;
    for (int k = 1; k < 200000; ++k) sum = sum * x + k;
    return sum;
  });
  EXPECT_GT(f.operation_count(), 300000U);
}

TEST(Symbol, SeveralVariables) {
  const expression f = formula_of(symbol::variable(0) * symbol::variable(2), {"x", "y", "z"});
  EXPECT_EQ(f.to_text(), "x*z");
  EXPECT_EQ(f.used_variables(), (std::vector<std::string>{"x", "z"}));
}

/// A ball is one number in it: what is made of it is not narrower, and two of one ball may differ.
TEST(Symbol, BallsAreNumbersInThem) {
  const ball wide = hull(ball(1, 64), ball(2, 64));
  const expression f = formula_of([&](const auto& x) { return wide * x - wide; });
  const ball value = f(ball(3, 64));
  EXPECT_TRUE(contains(value, hull(ball(1, 64), ball(5, 64))));  // of two numbers in [1, 2]
  EXPECT_FALSE(formula_of([&](const auto& x) { return wide * x - wide * x; }).is_formally_zero());
  const expression once = formula_of([&](const auto& x) {
    const auto k = 0 * x + wide;
    return k * x - k * x;
  });
  EXPECT_TRUE(contains_zero(once(ball(3, 64))));
  EXPECT_TRUE(f(jet<ball, 1>::variable(ball(3, 64)))[1].is_bounded());
  EXPECT_TRUE(contains(f(jet<ball, 1>::variable(ball(3, 64)))[1], wide));
  EXPECT_FALSE(f.exact_value().has_value());
  EXPECT_NE(f.to_text().find("(a number in a ball)"), std::string::npos);
  EXPECT_TRUE(formula_of([](const auto&) { return symbol(ball::undefined(64)); })(ball(1, 64))
                  .is_undefined());
  // One that is one number is exact; unless it is very long.
  EXPECT_EQ(formula_of([](const auto& x) { return x * ball(rational(3, 4), 64); }).to_text(),
            "x*(3/4)");
  EXPECT_TRUE(contains(
      formula_of([](const auto& x) { return x * scale(ball(1, 64), 1L << 40); })(ball(3, 64)),
      scale(ball(3, 64), 1L << 40)));
}

TEST(Symbol, ComplexNumbersAreInFormulasOfAComplexArgument) {
  const complex_ball w(2, 3, 64);
  EXPECT_EQ(complex_formula_of([&](const auto& z) { return z * w; }).to_text(), "z*(2 + i*3)");
  EXPECT_EQ(complex_formula_of([](const auto& z) { return times_i(z) + 1; }).to_text(), "i*z + 1");
  EXPECT_EQ(complex_formula_of([](const auto& z) { return z + complex_ball(2, 0, 64); }).to_text(),
            "z + 2");
  EXPECT_THROW((void)formula_of([&](const auto& x) { return x * w; }), input_error);
  // Nor is it a parameter.
  EXPECT_THROW(
      (void)formula_with_parameters([&](const auto& x, const auto& p) { return x * w + p[0]; }, 1),
      input_error);
}

/// A formula that is called with a symbol is a part of another one.
TEST(Symbol, FormulasAreFunctionsOfSymbols) {
  const ball wide = hull(ball(1, 64), ball(2, 64));
  for (const char* text :
       {"x", "3", "-x^2", "sin(x)/x + pi - e", "x^(1/3)*root(x, 5)", "max(x, 1/x)^x", "zeta(3)*x",
        "ellipticK(x/9) - euler_gamma", "floor(x) + atan2(x, 2)", "x^(-7) - catalan"}) {
    const expression f(text, {{"x"}, {}, library_functions()});
    EXPECT_EQ(formula_of([&](const auto& x) { return f(x); }).to_text(), f.to_text());
    EXPECT_EQ(formula_of([&](const auto& x) { return f(x + 1); }).to_text(),
              formula_of(f(symbol::variable(0) + 1), {"x"}).to_text());
  }
  const expression inner = formula_of([&](const auto& x) { return wide * x; });
  const expression outer = formula_of([&](const auto& x) { return inner(x) + inner(x + 1); });
  EXPECT_TRUE(contains(outer(ball(1, 64)), hull(ball(3, 64), ball(6, 64))));
  const expression two("x*y", {{"x", "y"}, {}});
  const std::vector<symbol> swapped{symbol::variable(1), symbol::variable(0)};
  EXPECT_EQ(formula_of(two.evaluate(std::span<const symbol>(swapped)), {"x", "y"}).to_text(),
            "y*x");
  EXPECT_THROW((void)two(symbol::variable(0)), std::invalid_argument);
}

}  // namespace symbol_test
}  // namespace polhode
