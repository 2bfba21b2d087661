// Random formulas: what is folded exactly against the same formula in which nothing can be folded,
// and values at two precisions.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "polhode/expression/expression.hpp"
#include "polhode/expression/formula_of.hpp"
#include "support/random.hpp"

namespace polhode {
namespace random_formulas_test {

/// One formula twice: with its numbers, and with n pi/pi in the place of each number n, so that it
/// is evaluated in balls.
struct formula {
  std::string plain;
  std::string veiled;
};

formula number(support::random_source& random) {
  std::string n;
  switch (random.between(0, 4)) {
    case 0:
      n = std::to_string(random.between(0, 4));
      break;
    case 1:
      n = std::to_string(random.between(0, 200)) + "/" + std::to_string(random.between(1, 12));
      break;
    case 2:
      n = std::to_string(random.between(0, 3)) + "." + std::to_string(random.between(0, 9999));
      break;
    case 3:
      n = "1e" + std::to_string(random.between(-40, 40));
      break;
    default:
      n = "(" + std::to_string(random.between(1, 30)) + "/" +
          std::to_string(random.between(1, 30)) + ")^" + std::to_string(random.between(2, 4));
  }
  return {"(" + n + ")", "(" + n + "*pi/pi)"};
}

formula of_name(const std::string& name, const formula& x) {
  return {name + "(" + x.plain + ")", name + "(" + x.veiled + ")"};
}
formula between(const formula& x, const std::string& what, const formula& y) {
  return {"(" + x.plain + what + y.plain + ")", "(" + x.veiled + what + y.veiled + ")"};
}

formula random_formula(support::random_source& random, int depth) {
  static constexpr std::array functions{
      "sqrt", "cbrt",  "exp",  "expm1", "log",   "log1p", "log2",     "log10",
      "sin",  "cos",   "tan",  "sinpi", "cospi", "asin",  "acos",     "atan",
      "sinh", "cosh",  "tanh", "sech",  "csch",  "asinh", "acosh",    "atanh",
      "abs",  "floor", "ceil", "gamma", "erf",   "erfc",  "log_gamma"};
  static constexpr std::array pairs{"min", "max", "hypot", "atan2", "agm"};
  static constexpr std::array operators{"+", "-", "*", "/"};
  static constexpr std::array constants{"pi", "e", "sqrt(2)", "euler_gamma"};
  if (depth == 0) {
    if (!random.one_in(6)) return number(random);
    const std::string constant = random.choose(constants);
    return {constant, constant};
  }
  const formula x = random_formula(random, depth - 1);
  switch (random.between(0, 5)) {
    case 0:
    case 1:
      return of_name(random.choose(functions), x);
    case 2: {
      const formula inside = between(x, ", ", random_formula(random, depth - 1));
      const std::string name = random.choose(pairs);
      return {name + inside.plain, name + inside.veiled};
    }
    case 3: {  // a power or a root whose number counts as such
      const std::string n = std::to_string(random.between(-3, 9));
      if (random.one_in(2)) return {x.plain + "^(" + n + ")", x.veiled + "^(" + n + ")"};
      const std::string order = std::to_string(random.between(1, 5));
      return {"root(" + x.plain + ", " + order + ")", "root(" + x.veiled + ", " + order + ")"};
    }
    case 4: {  // f(x 10^-k) - x 10^-k: what is left is a second or third power
      static constexpr std::array near_0{"sin", "tan", "atan", "sinh", "tanh", "expm1", "log1p"};
      const std::string small = "*1e-" + std::to_string(random.between(3, 80)) + ")";
      const formula y{"(" + x.plain + small, "(" + x.veiled + small};
      return between(of_name(random.choose(near_0), y), "-", y);
    }
    default:
      return between(x, random.choose(operators), random_formula(random, depth - 1));
  }
}

std::optional<expression> read(const std::string& text) {
  try {
    return expression(text);
  } catch (const expression_error&) {
    return std::nullopt;
  }
}

TEST(RandomFormulas, ThatAreExactHaveTheValueThatBallsEnclose) {
  support::random_source random(31);
  long exact = 0;
  long bounded = 0;
  for (support::repeat trial(1500); trial.again();) {
    const formula f = random_formula(random, static_cast<int>(random.between(1, 4)));
    const std::optional<expression> plain = read(f.plain);
    const std::optional<expression> veiled = read(f.veiled);
    if (!plain || !veiled) {
      // What is not defined has no value in balls either.
      if (veiled) {
        const ball value = veiled->value(300);
        EXPECT_TRUE(!value.is_bounded() || value.radius() > magnitude::power_of_two(-100))
            << f.plain << " " << value;
      }
      continue;
    }
    const ball in_balls = veiled->value(300);
    if (const auto& q = plain->exact_value()) {
      ++exact;
      EXPECT_TRUE(in_balls.is_undefined() || contains(in_balls, *q)) << f.plain << " " << in_balls;
      continue;
    }
    const ball coarse = plain->value(64);
    const ball fine = plain->value(500);
    if (fine.is_bounded()) ++bounded;
    for (const ball* other : {&coarse, &in_balls}) {
      EXPECT_TRUE(fine.is_undefined() || other->is_undefined() || overlaps(fine, *other))
          << f.plain << " " << fine << " " << *other;
    }
  }
  EXPECT_GT(exact, 50 * std::min(1.0, support::effort()));
  EXPECT_GT(bounded, 200 * std::min(1.0, support::effort()));
}

/// The formula with a ball around 1 as a factor of each number, through symbols: it holds the value
/// for 1.
TEST(RandomFormulas, WithNumbersInBallsHoldThoseOfTheNumbers) {
  support::random_source random(32);
  long bounded = 0;
  for (support::repeat trial(1500); trial.again();) {
    const formula f = random_formula(random, static_cast<int>(random.between(1, 4)));
    const std::optional<expression> plain = read(f.plain);
    if (!plain) continue;
    std::string text = f.veiled;
    for (std::size_t i = text.find("*pi/pi"); i != text.npos; i = text.find("*pi/pi", i)) {
      text.replace(i, 6, "*y");
    }
    const expression in_y(text, {{"y"}, {}});
    const ball near_1 = ball(1, 300).enlarged(magnitude::power_of_two(-random.between(20, 200)));
    const ball value = formula_of(in_y(symbol(near_1)), {}).value(300);
    const ball exact = plain->value(500);
    if (value.is_bounded()) ++bounded;
    EXPECT_TRUE(exact.is_undefined() || value.is_undefined() || overlaps(exact, value))
        << text << " " << exact << " " << value;
  }
  EXPECT_GT(bounded, 200 * std::min(1.0, support::effort()));
}

}  // namespace random_formulas_test
}  // namespace polhode
