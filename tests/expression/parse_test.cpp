#include "polhode/expression/parse.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "polhode/arithmetic/exact.hpp"

namespace polhode::test {
namespace parse_test {

TEST(Parse, DefinitionsMayStandInAnyOrder) {
  const expression f = parse("a*x", {"x"}, {{"a", "b + c"}, {"b", "2*c"}, {"c", "1/3"}});
  EXPECT_EQ(parse("a", {}, {{"a", "b + c"}, {"b", "2*c"}, {"c", "1/3"}}).exact_value(), 1);
  EXPECT_EQ(f.variables(), std::vector<std::string>{"x"});
}

TEST(Parse, KnowsTheEllipticFunctions) {
  const ball value = parse("ellipticK(1/2)", {}).value(200);
  const ball known = parse("pi/(2*agm(1, sqrt(1/2)))", {}).value(200);
  EXPECT_TRUE(overlaps(value, known));
  EXPECT_LE(value.radius(), magnitude::power_of_two(-150));
}

TEST(Parse, DefinitionsKeepTheOrderGivenWhereNoneNeedsAnother) {
  const std::vector<formula_definition> given{{"b", "2"}, {"a", "1"}, {"c", "3"}};
  EXPECT_EQ(in_order_of_need(given), given);
  const std::vector<formula_definition> ordered{{"x2", "1"}, {"k", "x2 + 1"}};
  EXPECT_EQ(in_order_of_need({ordered[1], ordered[0]}), ordered);
}

TEST(Parse, DefinitionsThatNeedEachOtherAreRefused) {
  const auto said = [](const std::vector<formula_definition>& definitions) {
    try {
      (void)parse("1", {}, definitions);
    } catch (const input_error& error) {
      return std::string(error.what());
    }
    return std::string("nothing");
  };
  EXPECT_EQ(said({{"k", "k + 1"}}), "the value of k needs k itself");
  EXPECT_EQ(said({{"a", "b"}, {"c", "1"}, {"b", "2*a"}}), "the values of a, b need each other");
}

TEST(Parse, WhatCannotBeReadSaysWhere) {
  try {
    (void)parse("1 + ");
    FAIL() << "it was read";
  } catch (const expression_error& error) {
    EXPECT_GE(error.column(), 4U);
  }
  EXPECT_THROW((void)parse("y"), expression_error);
  EXPECT_THROW((void)parse("1", {"sin"}), input_error);
}

TEST(Parse, TheOnlyNameIsTheVariable) {
  EXPECT_EQ(variable_of("x*t"), "x");
  EXPECT_EQ(variable_of("exp(z)-z"), "z");
  EXPECT_EQ(variable_of("theta^2 = cos(theta)"), "theta");
  EXPECT_EQ(variable_of("2*pi*t + e^t - besselJ(0, t)"), "t");
  EXPECT_EQ(variable_of("i*z + arctan(z)"), "z");
  EXPECT_EQ(variable_of("1e5*t + 2.5E-3*t + 1.e2"), "t");
  EXPECT_EQ(variable_of("k*t", {{"k", "2"}}), "t");
  // Of several, or none.
  EXPECT_EQ(variable_of("k*t"), "x");
  EXPECT_EQ(variable_of("1e5"), "x");
  EXPECT_EQ(variable_of("2*pi"), "x");
  EXPECT_EQ(variable_of(""), "x");
}

TEST(Parse, AnEquationIsTheDifferenceOfItsSides) {
  const ball two(2, 64);
  EXPECT_TRUE(contains(parse_equation("x^2 = 3*x-1")(two), -1));
  EXPECT_TRUE(contains(parse_equation("x^2")(two), 4));
  EXPECT_TRUE(contains(parse_equation("1-x = 2-x-k", {"x"}, {{"k", "5"}})(two), 4));
  for (const char* wrong : {"x = ", "= x", "=", "x == 2", "x = 2 = 3", "x) = (2", "1 = 1)-(x"}) {
    EXPECT_THROW((void)parse_equation(wrong), input_error) << wrong;
  }
}

}  // namespace parse_test
}  // namespace polhode::test
