// Formulas that are 0 by their expansion: identities are found, and what is not 0 never passes for
// 0.

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "polhode/arithmetic/ball.hpp"
#include "polhode/expression/parse.hpp"
#include "support/random.hpp"

namespace polhode {
namespace formal_zero_test {

using support::random_source;
using support::repeat;

const std::vector<std::string> atoms{"x",        "sin(x)", "exp(-x)", "sqrt(2)",
                                     "log(3+x)", "2/3",    "x/(2+x)", "exp(x)/sin(x)"};

/// A sum of at most three products of at most three of the atoms.
std::string small_sum(random_source& random) {
  std::string sum;
  for (long terms = random.between(1, 3); terms > 0; --terms) {
    sum += sum.empty() ? "" : random.between(0, 1) == 0 ? "+" : "-";
    sum += std::to_string(random.between(1, 5));
    for (long factors = random.between(0, 3); factors > 0; --factors) {
      sum += "*" + random.choose(atoms);
    }
  }
  return "(" + sum + ")";
}

/// An expansion that holds in every commutative ring, as left - right.
std::string identity(random_source& random) {
  const std::string a = small_sum(random);
  const std::string b = small_sum(random);
  const std::string c = small_sum(random);
  switch (random.between(0, 4)) {
    case 0:
      return a + "*(" + b + "+" + c + ")-" + a + "*" + b + "-" + c + "*" + a;
    case 1:
      return "(" + a + "-" + b + ")^2-" + a + "^2-" + b + "^2+2*" + a + "*" + b;
    case 2:
      return "(" + a + "+" + b + ")*(" + a + "-" + b + ")+" + b + "^2-" + a + "^2";
    case 3:
      return "-(" + a + "-" + b + ")+" + a + "-(" + c + "+" + b + ")+" + c;
    default:
      return "(" + a + "+1)^3-1-3*" + a + "*(1+" + a + ")-" + a + "*" + a + "*" + a;
  }
}

bool is_certainly_nonzero_somewhere(const expression& f, random_source& random) {
  for (int i = 0; i < 8; ++i) {
    if (!contains_zero(f(ball(rational(random.between(1, 1000), 997), 400)))) return true;
  }
  return false;
}

TEST(FormalZero, IsFoundOfIdentitiesAndNeverOfTheirNeighbours) {
  random_source random(3361);
  for (repeat trial(300); trial.again();) {
    const std::string zero = identity(random);
    EXPECT_TRUE(parse(zero).is_formally_zero()) << zero;
    // Another term, with a factor that an error in a coefficient or an exponent would leave.
    const std::string neighbour =
        zero + (random.between(0, 1) == 0 ? "+" : "-") + random.choose(atoms) + "^" +
        std::to_string(random.between(1, 3)) + "/" + std::to_string(random.between(1, 1'000'000));
    const expression f = parse(neighbour);
    EXPECT_TRUE(is_certainly_nonzero_somewhere(f, random)) << neighbour;
    EXPECT_FALSE(f.is_formally_zero()) << neighbour;
  }
}

TEST(FormalZero, IsNothingThatHasAnotherValue) {
  random_source random(3362);
  for (repeat trial(500); trial.again();) {
    // Differences of which few are 0.
    const std::string text = small_sum(random) + "*" + small_sum(random) + "-" + small_sum(random) +
                             "^" + std::to_string(random.between(1, 2));
    const expression f = parse(text);
    if (is_certainly_nonzero_somewhere(f, random)) {
      EXPECT_FALSE(f.is_formally_zero()) << text;
    }
  }
  for (const char* text : {"sin(x)-sin(2*x)", "sin(x)-x", "2*sin(x)-sin(x)", "sin(x)^2-sin(x)",
                           "sqrt(x)*sqrt(x)+x", "-x-x", "x*exp(x)-exp(x)", "x^2-x", "1-x^0-x",
                           "(x+1)^3-x^3-3*x^2-3*x", "x^(-1)-x", "x^(-2)-x", "x-x/(1+1e-9)",
                           "x/(1+x)-x*(1+x)", "x/sin(x)-sin(x)/x", "x/2-x/3", "1/x-1/x^2"}) {
    EXPECT_FALSE(parse(text).is_formally_zero()) << text;
  }
}

TEST(FormalZero, HasDivisorsAsUnknowns) {
  for (const char* text :
       {"0/(x+1)", "(x-x)/sin(x)", "sin(x)/x*x-sin(x)", "1/sin(x)*sin(x)-1",
        "(1+x)/exp(x)-1/exp(x)-x/exp(x)", "x/7-3*x/21", "x/(1+x)/(1+x)-x/(1+x)*1/(1+x)"}) {
    EXPECT_TRUE(parse(text).is_formally_zero()) << text;
  }
}

TEST(SumOfSizes, IsThatOfTheTerms) {
  for (const auto& [text, sum] :
       std::vector<std::pair<std::string, std::string>>{{"pi-3-exp(1)", "pi+3+exp(1)"},
                                                        {"-(pi-4)", "pi+4"},
                                                        {"3-(2-sqrt(2))", "5+sqrt(2)"},
                                                        {"-pi", "pi"},
                                                        {"sin(4)-cos(4)", "-sin(4)-cos(4)"},
                                                        {"(1-pi)*2", "2*pi-2"}}) {
    EXPECT_TRUE(overlaps(parse(text).sum_of_sizes().value(200), parse(sum).value(200))) << text;
  }
}

TEST(FormalZero, IsZeroAlmostEverywhereWhereMeromorphic) {
  for (const char* formula :
       {"1/(x-sqrt(2))-1/(x-sqrt(2))", "sin(x)-sin(x)", "exp(x)/sin(x)-exp(x)*sin(x)^-1*1",
        "(x-pi)^(-2)-(x-pi)^(-2)", "erf(x^2)/cos(x)-erf(x^2)/cos(x)", "1/(1/x-1)-1/(1/x-1)"}) {
    EXPECT_EQ(parse(formula).is_zero_almost_everywhere(), parse(formula).is_formally_zero())
        << formula;
  }
  EXPECT_TRUE(parse("1/(x-sqrt(2))-1/(x-sqrt(2))").is_zero_almost_everywhere());
  for (const char* formula : {"log(x)-log(x)", "sqrt(x)-sqrt(x)", "x^pi-x^pi", "exp(1/x)-exp(1/x)",
                              "gamma(x)-gamma(x)", "1/(x-x+sin(x)-sin(x))-1/(sin(x)-sin(x))",
                              "1/(sin(x)^2+cos(x)^2-1)-1/(sin(x)^2+cos(x)^2-1)", "1/x-1/(x+1e-30)",
                              "log(x/(x-1))-log(x/(x-1))", "0*log(x)", "tan(x)-tan(x)"}) {
    EXPECT_FALSE(parse(formula).is_zero_almost_everywhere()) << formula;
  }
}

}  // namespace formal_zero_test
}  // namespace polhode
