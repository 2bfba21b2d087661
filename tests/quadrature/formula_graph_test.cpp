// A formula's operations as nodes, and their evaluation with given branches.

#include <gtest/gtest.h>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "polhode/expression/expression.hpp"
#include "polhode/expression/library_functions.hpp"
#include "polhode/quadrature/integrate.hpp"
#include "quadrature/formula/formula_graph.hpp"
#include "quadrature/formula/integrand.hpp"

namespace polhode {
namespace formula_graph_test {

using detail::choices;
using detail::formula_graph;
using detail::formula_node;
using detail::operation;

formula_graph graph_of(const char* text) { return formula_graph(expression(text, {{"x"}, {}})); }

std::size_t count_of(const formula_graph& f, operation what) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < f.size(); ++i) count += f.node(i).what == what ? 1 : 0;
  return count;
}

ball value_at(const formula_graph& f, const rational& x, precision p) {
  return detail::evaluate(f, p, ball(x, p), choices(f.size()), f.result())[f.result()];
}

TEST(FormulaGraph, EveryNodeComesAfterItsOperands) {
  const formula_graph f = graph_of("min(sin(x)^2, x/pi) + max(x/pi, sin(x)^2) - root(x, 3)*abs(x)");
  for (std::size_t i = 0; i < f.size(); ++i) {
    f.for_each_operand(f.node(i), [&](std::size_t k) { EXPECT_LT(k, i); });
    if (f.node(i).is_piecewise()) {
      EXPECT_LT(f.node(i).decider, i);
    }
  }
  EXPECT_TRUE(f.has_breaks());
}

TEST(FormulaGraph, OfTheSamePairMinAndMaxHaveOneDecider) {
  // The difference stands in the formula besides, before them and after them.
  for (const char* text : {"min(x, cos(x)) + max(cos(x), x)", "(x - cos(x))^2 + min(cos(x), x)",
                           "exp(min(cos(x), x)) + (x - cos(x))^2"}) {
    const formula_graph f = graph_of(text);
    EXPECT_EQ(count_of(f, operation::subtract), 1) << text;
  }
  // Beside 0 the other operand decides, as it does of its absolute value.
  const formula_graph f = graph_of("max(0, sin(x)) + min(sin(x), 0) + abs(sin(x))");
  EXPECT_EQ(count_of(f, operation::subtract), 0);
  std::size_t decider = 0;
  for (std::size_t i = 0; i < f.size(); ++i) {
    if (!f.node(i).is_piecewise()) continue;
    EXPECT_EQ(f.node(f.node(i).decider).what, operation::sin);
    EXPECT_TRUE(decider == 0 || decider == f.node(i).decider);
    decider = f.node(i).decider;
  }
}

TEST(FormulaGraph, IsTheFormula) {
  for (const char* text :
       {"min(x, 1/3) - max(-1, -x) + floor(5*x) + ceil(2*x) + abs(x - 2)", "2^x/root(x, 3) + x^5",
        "atan2(x, pi) + expm1(x)*gamma(x + 1) - sinpi(x)", "7/3", "x", "pi - 3"}) {
    const formula_graph f = graph_of(text);
    const expression e(text, {{"x"}, {}});
    for (const rational& x : {rational(1, 7), rational(5, 3), rational(4)}) {
      for (const precision p : {100, 1000}) {
        const ball value = value_at(f, x, p);
        EXPECT_TRUE(overlaps(value, e(ball(x, p)))) << text;
        EXPECT_TRUE(value.radius() <=
                    scale(max(value.magnitude_upper(), magnitude::power_of_two(0)), 30 - p))
            << text << " with " << p << " bits";
      }
    }
  }
}

TEST(FormulaGraph, BranchesAreTakenWhereverTheArgumentIs) {
  const formula_graph f = graph_of("abs(x) + 10*floor(x) + 100*min(x, 5) + 1000*max(x, 5)");
  choices chosen(f.size());
  for (std::size_t i = 0; i < f.size(); ++i) {
    const operation what = f.node(i).what;
    if (what == operation::abs) chosen[i] = -1;
    if (what == operation::floor) chosen[i] = 7;
    if (what == operation::min) chosen[i] = 1;   // 5
    if (what == operation::max) chosen[i] = -1;  // 5
  }
  const ball value = detail::evaluate(f, 64, ball(3, 64), chosen, f.result())[f.result()];
  EXPECT_TRUE(contains(value, rational(-3 + 70 + 500 + 5000)));
}

TEST(FormulaGraph, ExactConstantsAreKnown) {
  const formula_graph f = graph_of("x*(2/3) + sqrt(2)*x^2 + cos(x)");
  std::size_t exact = 0;
  std::size_t enclosed = 0;
  for (std::size_t i = 0; i < f.size(); ++i) {
    if (!f.node(i).is_constant()) continue;
    (f.node(i).exact ? exact : enclosed) += 1;
  }
  EXPECT_EQ(exact, 1);
  EXPECT_EQ(enclosed, 1);
}

// A break beside a function of three and of four arguments.
TEST(FormulaGraph, CallsOfManyOperandsHaveBranchesBesideThem) {
  expression_names names{{"x"}, {}, library_functions()};
  const auto over = [&](const char* text, const rational& a, const rational& b) {
    const integral found = integrate(expression(text, names), a, b, {.digits = 20});
    EXPECT_EQ(found.verdict, status::certified) << text << found.obstacle;
    return found.enclosure;
  };
  const rational third(1, 3);
  EXPECT_TRUE(overlaps(over("abs(x - 1/3)*ellipticPi(1/4, 1, x/2)", 0, 1),
                       over("(x - 1/3)*ellipticPi(1/4, 1, x/2)", third, 1) -
                           over("(x - 1/3)*ellipticPi(1/4, 1, x/2)", 0, third)));
  EXPECT_TRUE(overlaps(over("max(x, 1/3)*carlsonRJ(1, 2, x + 1, 3)", 0, 1),
                       over("x*carlsonRJ(1, 2, x + 1, 3)", third, 1) +
                           over("carlsonRJ(1, 2, x + 1, 3)/3", 0, third)));
}

// Not decided by the values of constants, but by what they are.
TEST(FormulaGraph, PiIsOneFrequencyHoweverItIsWritten) {
  const auto value = [](const char* text) {
    const integral found =
        integrate(expression(text, {{"x"}, {}}), 1, end_point::infinity(), {.digits = 20});
    EXPECT_EQ(found.verdict, status::certified) << text << ": " << found.obstacle;
    return found.enclosure;
  };
  EXPECT_TRUE(overlaps(value("sin(pi*x)*sinpi(x)/x^2"), value("sinpi(x)^2/x^2")));
  EXPECT_TRUE(overlaps(value("cos(pi*x/3)*sinpi(x/3)/(1+x^2)"), value("sinpi(2*x/3)/(1+x^2)") / 2));
}

}  // namespace formula_graph_test
}  // namespace polhode
