// That the machine sees what is wrong when it is told something wrong, and that formulas are
// printed and differentiated as meant.

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "integrals.hpp"
#include "values.hpp"

namespace polhode::differential {
namespace machine_test {

const term x = "x";

TEST(machine, prints_formulas_with_the_parentheses_they_need) {
  EXPECT_EQ((x - (x - 1)).text(), "x - (x - 1)");
  EXPECT_EQ((x / (2 * x)).text(), "x/(2*x)");
  EXPECT_EQ(power(-x, 2).text(), "(-x)^2");
  EXPECT_EQ(power("1/2", -3).text(), "(1/2)^(-3)");
  EXPECT_EQ((-(x + 1) * 2).text(), "-(x + 1)*2");
  EXPECT_EQ(power(power(x, 2), 3).text(), "(x^2)^3");
  EXPECT_EQ((1 / term("1/3")).text(), "1/(1/3)");
  EXPECT_EQ(substituted(power(x, 2) + x, "x", 1 - x).text(), "(1 - x)^2 + 1 - x");
}

TEST(machine, reads_formulas) {
  for (const char* text :
       {"x - (x - 1)", "x/(2*x)", "(-x)^2", "2^3^2", "-(24/16) + sqrt(2)", "1.5e-3*atan2(x, 2)",
        "exp(-20*x^2)/(18 - x^3)", "(4 + sqrt(40))/2", "(7*x)^(-3)", "1/(1 + exp(x)) + 1e-40"}) {
    const term t = parsed(text);
    EXPECT_EQ(parsed(t.text()).text(), t.text());
    for (const char* value : {"3/7", "5"}) {
      const term at = substituted(t, "x", value);
      expression_names names;
      names.definitions = {{"x", value}};
      const expression meant(text, names);
      EXPECT_TRUE(overlaps(read(at).value(100), meant.value(100))) << text;
      EXPECT_EQ(read(at).exact_value(), meant.exact_value()) << text;
    }
  }
  EXPECT_THROW((void)parsed("2*(x"), std::invalid_argument);
  EXPECT_THROW((void)parsed("2x y"), std::invalid_argument);
}

TEST(machine, differentiates) {
  EXPECT_EQ(derivative(power(x, 3)).text(), "3*x^(3 - 1)");
  EXPECT_EQ(derivative(call("sin", 2 * x)).text(), "cos(2*x)*2");
  EXPECT_EQ(derivative(call("exp", 3)).text(), "0");
}

TEST(machine, finds_a_wrong_closed_form) {
  integral_case c{call("exp", x), 0, 1, 20};
  c.value = call("exp", 1) - 1 + term("1e-15");
  counts tally;
  EXPECT_NONFATAL_FAILURE(examine_thoroughly(c, 1, tally), "the enclosures are disjoint");
  EXPECT_EQ(tally.wrong, 1);
}

TEST(machine, finds_a_wrong_antiderivative_and_shrinks_it) {
  integral_case c{call("cos", x) + 1, 0, 1, 20};
  c.antiderivative = call("sin", x);
  counts tally;
  EXPECT_NONFATAL_FAILURE(examine_thoroughly(c, 1, tally), "by an antiderivative");
  EXPECT_EQ(tally.wrong, 1);
}

TEST(machine, finds_a_certified_integral_that_is_said_to_diverge) {
  integral_case c{1 / call("sqrt", x), 0, 1, 10};
  c.diverges = true;
  counts tally;
  EXPECT_NONFATAL_FAILURE(examine_thoroughly(c, 1, tally), "the integral diverges");
  EXPECT_EQ(tally.wrong, 1);
}

TEST(machine, finds_a_wrong_identity) {
  counts tally;
  EXPECT_NONFATAL_FAILURE(
      examine(value_case{call("sin", 1), call("sin", 1) + term("1e-20")}, 3, tally), "disjoint");
  EXPECT_EQ(tally.wrong, 1);
}

/// Of an integral that every route computes, the routes agree, and many are there.
TEST(machine, takes_many_routes) {
  integral_case c{call("exp", -power(x, 2)), 1, 2, 15};
  counts tally;
  examine_thoroughly(c, 1, tally);
  EXPECT_EQ(tally.certified, 1);
  EXPECT_GE(tally.computed, 12);
  EXPECT_GE(tally.checks, 50);
}

}  // namespace machine_test
}  // namespace polhode::differential
