// Integrals that are found to be rational numbers, beside those that `integrate` encloses.

#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "integrals.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/quadrature/integrate.hpp"

namespace polhode::differential {
namespace exact_integrals_test {

const term x = "x";

struct exact_case {
  term integrand;
  rational lower;
  rational upper;
};

rational any_rational(maker& m, long most) {
  return rational(m.between(-most, most), m.between(1, 6));
}

/// The derivative of a quotient.
term rational_function(maker& m) {
  const term above = m.one_in(2) ? term(1) : m.polynomial(m.between(0, 3));
  term below = m.positive_polynomial(true);
  if (m.one_in(3)) below = power(x - m.between(-9, 9), m.between(1, 3));
  const term f = above / power(below, m.between(1, 2));
  return m.one_in(8) ? f : derivative(f);
}

/// Of x, abs, min and max.
term with_kinks(maker& m, long depth) {
  if (depth == 0) return m.one_in(3) ? m.quotient(m.within(-3, 3)) : x;
  const term u = with_kinks(m, depth - 1);
  switch (m.between(0, 4)) {
    case 0:
      return call("abs", u - m.between(-2, 2));
    case 1:
      return call(m.any_of({"min", "max"}), u, with_kinks(m, depth - 1));
    case 2:
      return u * m.between(1, 3) + with_kinks(m, depth - 1);
    case 3:
      return power(u, 2);
    default:
      return u - m.quotient(m.within(-3, 3));
  }
}

/// Of x, floor and ceil of linear forms.
term with_steps(maker& m, long depth) {
  if (depth == 0) {
    if (m.one_in(3)) return x;
    return call(
        m.any_of({"floor", "ceil"}),
        m.quotient((m.one_in(2) ? 1 : -1) * m.within(0.3, 2)) * x + m.quotient(m.within(-2, 2)));
  }
  const term u = with_steps(m, depth - 1);
  const term v = with_steps(m, depth - 1);
  return m.one_in(2) ? u * v : u - v;
}

term with_root(maker& m) {
  const term base = m.between(1, 3) * x + m.between(0, 4);
  const term root = m.one_in(2) ? call("sqrt", base) : power(base, m.any_of({"1/3", "2/3", "3/2"}));
  switch (m.between(0, 3)) {
    case 0:
      return root * x;
    case 1:
      return 1 / root;
    case 2:
      return power(1 + root, -m.between(3, 5));
    default:
      return root + power(x, 2) / root;
  }
}

/// Odd about the middle but for a constant, or nearly so, or not integrable there.
exact_case about_the_middle(maker& m) {
  const rational middle = any_rational(m, 10);
  const rational half = abs(any_rational(m, 9)) + rational(1, 7);
  const term u = x - term("(" + to_text(middle) + ")");
  const term k = m.near(m.within(0.2, 3));
  const term odd = m.any_of({u, power(u, 3), 1 / u, call("cbrt", u), call("sin", k * u),
                             call("tanh", k * u), call("erf", u), call("atan", k * u)});
  const term even =
      m.any_of({term(1), call("cos", k * u), call("exp", -k * power(u, 2)), 1 / (1 + power(u, 2)),
                power(call("abs", u), m.exponent_between(-2, 2)), call("log", call("abs", u)),
                power(u, -2)});
  term f = odd * even;
  if (m.one_in(3)) f = f + m.quotient(m.within(-3, 3));
  if (m.one_in(5)) f = f + even / 1000;
  return {f, middle - half, middle + half};
}

exact_case drawn(maker& m) {
  if (m.one_in(5)) return about_the_middle(m);
  const rational a = any_rational(m, 20);
  const rational length = abs(any_rational(m, 30)) + rational(1, 7);
  switch (m.between(0, 3)) {
    case 0:
      return {rational_function(m), a, a + length};
    case 1:
      return {with_kinks(m, m.between(1, 3)), a, a + length};
    case 2:
      return {with_steps(m, m.between(0, 2)), a, a + length};
    default:
      return {with_root(m), rational(m.between(0, 9)), rational(m.between(10, 40))};
  }
}

TEST(ExactIntegrals, LieInTheEnclosures) {
  long found = 0;
  run_cases("exact integrals", "of rational value", 150, [&](std::uint64_t seed, counts& c) {
    maker m(seed);
    const exact_case given = drawn(m);
    const std::string formula = given.integrand.text();
    SCOPED_TRACE(formula + " from " + to_text(given.lower) + " to " + to_text(given.upper));
    ++c.cases;
    std::optional<expression> f;
    try {
      f.emplace(formula, expression_names{.variables = {"x"}, .definitions = {}});
    } catch (const input_error&) {
      return;  // a division by zero, as it is written
    }
    const auto exact = exact_integral(*f, given.lower, given.upper);
    if (!exact) {
      ++c.refused;
      return;
    }
    ++found;
    ++c.certified;
    const integral enclosed =
        integrate(*f, given.lower, given.upper,
                  {.digits = 12, .most_evaluations = 200'000, .rule = quadrature_rule::automatic});
    if (!enclosed.enclosure.is_bounded()) return;
    ++c.checks;
    EXPECT_LE(lower_rational(enclosed.enclosure), *exact) << to_text(*exact);
    EXPECT_GE(upper_rational(enclosed.enclosure), *exact) << to_text(*exact);
  });
  EXPECT_GT(found, 0);
}

/// Meromorphic; not so in the last three cases, in some of which it has no value on an interval.
term factor(maker& m) {
  const term c = m.near(m.within(-5, 5));
  switch (m.between(0, 8)) {
    case 0:
      return 1 / (x - c);
    case 1:
      return power(x - c, -m.between(2, 3));
    case 2:
      return call(m.any_of({"sin", "exp", "erf", "cosh"}), x * c);
    case 3:
      return 1 / call(m.any_of({"sin", "cos"}), x - c);
    case 4:
      return x - c;
    case 5:
      return 1 / (power(call("sin", c * x), 2) + power(call("cos", c * x), 2) - m.between(1, 2));
    case 6:
      return call(m.any_of({"log", "sqrt"}), x - c);
    case 7:
      return power(x - c, m.quotient(m.within(0.1, 2)));
    default:
      return call("exp", 1 / (x - c));
  }
}

/// An identity of rings, over factors that may have no value: 0 is the integral only where the
/// formula is defined but for points. Points with the denominator 10007 tell that apart.
TEST(ExactIntegrals, OfWhatCancelsAreZeroWhereItIsDefined) {
  long found = 0;
  long undefined = 0;
  run_cases("exact integrals", "of what cancels", 150, [&](std::uint64_t seed, counts& c) {
    maker m(seed);
    const term u = factor(m);
    const term v = factor(m);
    const term w = m.any_of({u * (v + 1) - u - u * v, u * v - v * u,
                             power(u - v, 2) - power(u, 2) - power(v, 2) + 2 * u * v});
    const rational a = any_rational(m, 20);
    const rational b = a + abs(any_rational(m, 30)) + rational(1, 7);
    SCOPED_TRACE(w.text() + " from " + to_text(a) + " to " + to_text(b));
    ++c.cases;
    std::optional<expression> f;
    try {
      f.emplace(w.text(), expression_names{.variables = {"x"}, .definitions = {}});
    } catch (const input_error&) {
      return;
    }
    long holes = 0;
    for (long k = 0; k < 40; ++k) {
      const rational at = a + (b - a) * m.between(1, 10006) / 10007;
      if (!(*f)(ball(at, 256)).is_bounded()) ++holes;
    }
    if (holes > 2) ++undefined;
    const auto exact = exact_integral(*f, a, b);
    if (!exact) {
      ++c.refused;
      return;
    }
    ++found;
    ++c.certified;
    ++c.checks;
    EXPECT_EQ(*exact, 0);
    EXPECT_LE(holes, 2);
  });
  EXPECT_GT(found, 0);
  EXPECT_GT(undefined, 0);
}

}  // namespace exact_integrals_test
}  // namespace polhode::differential
