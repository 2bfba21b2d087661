// A formula over one denominator, and the constants of formulas that are exactly q + r pi.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "polhode/arithmetic/text.hpp"
#include "polhode/expression/evaluation.hpp"
#include "polhode/expression/expression.hpp"
#include "polhode/expression/symbol.hpp"
#include "support/random.hpp"

namespace polhode {
namespace fraction_test {

expression of_x(const std::string& f) {
  return expression(f, {.variables = {"x"}, .definitions = {}});
}
ball value_at(const expression& f, const rational& x) { return f(ball(x, 200)); }

struct known_fraction {
  std::string formula;
  std::string denominator;
  std::vector<long> without_value;  // whole numbers
};

TEST(Fraction, IsTheFormulaTimesItsDenominator) {
  const std::vector<known_fraction> cases{{"tan(x)-x", "cos(x)", {}},
                                          {"1/(1/x)", "1", {0}},
                                          {"1/(x-1)+1/(x+1)", "(x-1)*(x+1)", {1, -1}},
                                          {"1/(x-1)-2/(x-1)^2", "(x-1)^2", {1}},
                                          {"(x/(x-1))^(-2)", "x^2", {0, 1}},
                                          {"(x/(x-1))^2", "(x-1)^2", {1}},
                                          {"1/(x*(x-1)^2)-1/x+3/(x-1)", "x*(x-1)^2", {0, 1}},
                                          {"tanh(x)/x-1/3", "cosh(x)*x", {0}},
                                          {"(1/x-x)/(1/x+x)", "x*(1+x^2)", {0}},
                                          {"-(2/x)*(3/x^2)", "x^3", {0}},
                                          {"exp(x)*sin(x)", "1", {}},
                                          {"1/tan(x)-1/x", "sin(x)*x", {0}}};
  for (const known_fraction& c : cases) {
    const expression f = of_x(c.formula);
    const auto parts = f.as_fraction();
    ASSERT_TRUE(parts) << c.formula;
    for (const rational& x : {rational(1, 3), rational(-7, 2), rational(11, 5), rational(40)}) {
      const ball expected = value_at(f, x) * value_at(of_x(c.denominator), x);
      EXPECT_TRUE(overlaps(value_at(parts->numerator, x), expected))
          << c.formula << ": " << parts->numerator.to_text();
      for (const expression& d : parts->divisors) {
        EXPECT_FALSE(contains_zero(value_at(d, x))) << c.formula << ' ' << d.to_text();
      }
    }
    for (const long x : c.without_value) {
      bool is_any_0 = false;
      for (const expression& d : parts->divisors) {
        is_any_0 = is_any_0 || sign_of(value_at(d, x)) == certain_sign::zero;
      }
      EXPECT_TRUE(is_any_0) << c.formula << " at " << x;
    }
  }
}

/// The number q + r pi that a constant is known to be.
std::optional<pi_combination> form_of(const detail::possibly_exact_constant& c) {
  if (const rational* q = std::get_if<rational>(&c)) return pi_combination{*q, 0};
  return std::get<known_number>(c).form();
}

/// A sum, difference, product, quotient or function of small numbers and multiples of pi.
std::string any_constant(support::random_source& random, int depth) {
  if (depth == 0) {
    return random.one_in(2) ? "pi"
                            : fmt::format("({}/{})", random.between(-9, 9), random.between(1, 9));
  }
  if (random.one_in(6)) {
    constexpr std::array functions{"sqrt", "exp",  "log",   "sin", "cos",
                                   "atan", "tanh", "cospi", "-"};
    const auto i = static_cast<std::size_t>(random.between(0, functions.size() - 1));
    return fmt::format("{}({})", functions.at(i), any_constant(random, depth - 1));
  }
  const std::string operators = "+-*/";
  return fmt::format("({}{}{})", any_constant(random, depth - 1),
                     operators[static_cast<std::size_t>(random.between(0, 3))],
                     any_constant(random, random.one_in(3) ? 0 : depth - 1));
}

TEST(ExactConstants, LieInTheirEnclosures) {
  support::random_source random(7);
  long exact = 0;
  long with_formula = 0;
  for (support::repeat trial(2000); trial.again();) {
    const std::string text = any_constant(random, static_cast<int>(random.between(1, 3)));
    std::optional<expression> f;
    try {
      f = of_x("x+" + text);
    } catch (const input_error&) {
      continue;  // a quotient by 0
    }
    const auto values = detail::constants_of(f->instructions(), 400);
    const auto known = detail::possibly_exact_constants_of(f->instructions(), 300);
    ASSERT_EQ(values.size(), known.size());
    for (std::size_t k = 0; k < values.size(); ++k) {
      if (const auto form = form_of(known[k])) {
        ++exact;
        EXPECT_TRUE(overlaps(form->at(400), values[k])) << text << ' ' << to_text(*form);
        continue;
      }
      const known_number& x = std::get<known_number>(known[k]);
      if (!x.enclosure().is_bounded()) continue;
      EXPECT_TRUE(overlaps(x.enclosure(), values[k])) << text;
      if (!x.has_formula()) continue;
      ++with_formula;
      const expression same(symbol_of(*x.formula()), {});
      EXPECT_TRUE(overlaps(same.value(400), values[k])) << text << ' ' << same.to_text();
    }
  }
  EXPECT_GT(exact, 500 * support::effort());
  EXPECT_GT(with_formula, 100 * support::effort());
  const auto is_known = [](const std::string& text) {
    const auto all = detail::possibly_exact_constants_of(of_x("x+" + text).instructions(), 64);
    return all.size() == 1 && form_of(all[0]).has_value();
  };
  EXPECT_TRUE(is_known("(pi/3-2)"));
  EXPECT_TRUE(is_known("2*pi*3"));
  EXPECT_FALSE(is_known("pi*pi"));
  EXPECT_FALSE(is_known("sqrt(2)"));
}

// Only what has a value can be 0.
TEST(ExactConstants, AreSettledByRulesWhereTheyAreDefined) {
  const auto zero = exact_formula::of("-", {exact_formula::of("pi"), exact_formula::of("pi")});
  const ball near = ball(0, 64).enlarged(magnitude::power_of_two(-50));
  EXPECT_TRUE(settled(known_number(near, zero)).is_zero());
  EXPECT_FALSE(settled(known_number(ball::undefined(64), zero)).is_zero());
  EXPECT_FALSE(settled(known_number(ball::entire(64), zero)).is_zero());
  const auto other = exact_formula::of("-", {exact_formula::of("pi"), exact_formula::of("e")});
  EXPECT_FALSE(settled(known_number(near, other)).is_zero());
  EXPECT_FALSE(settled(known_number(near, nullptr)).is_zero());
}

}  // namespace fraction_test
}  // namespace polhode
