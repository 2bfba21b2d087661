// Identities and signs of polynomials: what holds, what does not, and that every step of every claim can fail.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "proofs/claim.hpp"
#include "proofs/exact_polynomial.hpp"

namespace polhode::proofs {
namespace {

exact_polynomial parse(const char* text) { return exact_polynomial::parse(text); }

TEST(ExactPolynomial, ExpandsWhatItReads) {
  EXPECT_EQ(parse("(a+b)^2"), parse("a^2 + 2*a*b + b^2"));
  EXPECT_EQ(parse("(a-b)*(a+b)"), parse("a*a - b*b"));
  EXPECT_EQ(parse("-a^2"), parse("0 - a*a"));
  EXPECT_EQ(parse("--a"), parse("a"));
  EXPECT_EQ(parse("a^0"), parse("1"));
  EXPECT_EQ(parse("a - a"), exact_polynomial());
  EXPECT_EQ(parse(" ( ( a ) ) "), parse("a"));
  EXPECT_EQ(parse("123456789012345678901234567890*a - a*123456789012345678901234567890"),
            parse("0"));
  EXPECT_FALSE(parse("a*b") == parse("a+b"));
  EXPECT_FALSE(parse("(a+b)^3") == parse("a^3 + 3*a^2*b + 3*a*b^2"));
  EXPECT_FALSE(parse("a") == parse("b"));
}

TEST(ExactPolynomial, RefusesWhatIsNone) {
  for (const char* text :
       {"",    " ",    "a+",    "+a", "a b", "2a",  "a**b", "(a", "a)", "a^",
        "a^b", "a^-1", "a^100", "A",  "a/2", "1.5", "a=b",  "#",  "()", "a^2^3 4"}) {
    EXPECT_THROW((void)parse(text), std::invalid_argument) << text;
  }
}

TEST(ExactPolynomial, DifferentiatesAndSubstitutes) {
  EXPECT_EQ(parse("x^3*y + 2*x").derivative('x'), parse("3*x^2*y + 2"));
  EXPECT_EQ(parse("y^2").derivative('x'), parse("0"));
  EXPECT_EQ(parse("q + b*y").with('q', parse("1-b")).with('y', parse("1-x")), parse("1-b*x"));
  EXPECT_EQ(parse("x^2 + x*y").with('x', parse("x+1")), parse("(x+1)^2 + (x+1)*y"));
  EXPECT_THROW((void)parse("x").derivative('X'), std::invalid_argument);
}

TEST(ExactPolynomial, KnowsPositiveCoefficients) {
  EXPECT_TRUE(parse("a + a*q + b").has_positive_coefficients());
  EXPECT_TRUE(parse("7").has_positive_coefficients());
  EXPECT_TRUE(parse("(a-b) + b").has_positive_coefficients());
  EXPECT_FALSE(parse("0").has_positive_coefficients());
  EXPECT_FALSE(parse("a-a").has_positive_coefficients());
  EXPECT_FALSE(parse("a^2 - 2*a*b + b^2").has_positive_coefficients());
}

TEST(PolynomialStep, HoldsOrNot) {
  EXPECT_TRUE(identity("(1-b)^2 - b*(a+b)", "1 - 2*b - a*b", "").holds());
  EXPECT_FALSE(identity("(1-b)^2 - b*(a+b)", "1 - 2*b + a*b", "").holds());
  EXPECT_TRUE(positive("1-b*x", "q + b*y", "q = 1-b, y = 1-x", "").holds());
  EXPECT_FALSE(positive("1-b*x", "q - b*y", "q = 1-b, y = x-1", "").holds())
      << "equal, but of no sign";
  EXPECT_FALSE(positive("1-b*x", "q + b*y", "q = 1-b", "").holds()) << "y without a meaning";
  EXPECT_FALSE(positive("a-a", "0", "", "").holds());
  EXPECT_TRUE(slope('x', "1-x", "a+b*x", "-(a+b)", "").holds());
  EXPECT_FALSE(slope('x', "1-x", "a+b*x", "a+b", "").holds());
  EXPECT_FALSE(slope('a', "1-x", "a+b*x", "-(a+b)", "").holds());
  EXPECT_THROW((void)positive("a", "q", "q 1-b", "").holds(), std::invalid_argument);
  EXPECT_THROW((void)positive("a", "q", ",", "").holds(), std::invalid_argument);
}

TEST(PolynomialStep, OneThatFailsLeavesTheClaimUncertified) {
  certificate c;
  EXPECT_TRUE(add_steps(c, {identity("a", "a", "")}));
  c.conclude();
  EXPECT_EQ(c.verdict, status::certified);
  EXPECT_FALSE(add_steps(c, {identity("a", "a", ""), identity("a", "b", "")}));
  EXPECT_EQ(c.witness.at("polynomials").size(), 3U);
  c.conclude();
  EXPECT_EQ(c.verdict, status::not_certified);
}

polynomial_step step_from(const json& one) {
  const std::string what = one.at("kind");
  const auto text = [&](const char* key) { return one.value(key, std::string()); };
  if (what == "identity") return identity(text("left"), text("right"), "");
  if (what == "positive coefficients")
    return positive(text("left"), text("right"), text("letters"), "");
  return slope(text("variable").at(0), text("left"), text("over"), text("right"), "");
}

/// Every text that differs from this one in a sign or in one number.
std::vector<std::string> mutants_of(const std::string& text) {
  std::vector<std::string> result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    std::string other = text;
    if (text[i] == '+') {
      other[i] = '-';
    } else if (text[i] == '-') {
      if (i == 0 || text[i - 1] == '(') continue;  // a unary sign
      other[i] = '+';
    } else if (text[i] >= '0' && text[i] <= '8') {
      ++other[i];
    } else {
      continue;
    }
    result.push_back(other);
  }
  return result;
}

TEST(PolynomialStep, OfEveryClaimIsRefusedWhenOneSignOrNumberOfItIsWrong) {
  long mutants = 0;
  for (const claim& c : all_claims()) {
    const certificate result = c.prove({});
    if (!result.witness.contains("polynomials")) continue;
    for (const json& one : result.witness.at("polynomials")) {
      EXPECT_TRUE(step_from(one).holds()) << c.name << one;
      for (const char* side : {"left", "right"}) {
        for (const std::string& mutant : mutants_of(one.at(side))) {
          json wrong = one;
          wrong[side] = mutant;
          EXPECT_FALSE(step_from(wrong).holds()) << c.name << wrong;
          ++mutants;
        }
      }
    }
  }
  EXPECT_GT(mutants, 500);
}

}  // namespace
}  // namespace polhode::proofs
