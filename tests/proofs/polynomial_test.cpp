// Identities and signs of polynomials: what holds, what does not, and that every step of every
// claim can fail.

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "proofs/claim.hpp"
#include "proofs/exact_polynomial.hpp"

namespace polhode::proofs {

using statements::identity;
using statements::not_negative;
using statements::positive;
using statements::slope;

namespace polynomial_test {

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

TEST(PolynomialStep, HoldsOrNot) {
  EXPECT_TRUE(holds(identity("(1-b)^2 - b*(a+b)", "1 - 2*b - a*b", "")));
  EXPECT_FALSE(holds(identity("(1-b)^2 - b*(a+b)", "1 - 2*b + a*b", "")));
  const char* ranges = "b > 0, q = 1-b > 0, y = 1-x >= 0";
  EXPECT_TRUE(holds(positive("1-b*x", "q + b*y", ranges, "")));
  EXPECT_FALSE(holds(positive("1-b*x", "q - b*y", ranges, ""))) << "a negative coefficient";
  EXPECT_FALSE(holds(positive("1+b*x", "q + b*y", ranges, ""))) << "another polynomial";
  EXPECT_FALSE(holds(positive("1-b*x", "q + b*y", "b > 0, q = 1-b > 0", ""))) << "y has no range";
  EXPECT_TRUE(holds(slope("1-x", "a+b*x", "x", "-(a+b)", "")));
  EXPECT_FALSE(holds(slope("1-x", "a+b*x", "x", "a+b", "")));
  EXPECT_FALSE(holds(slope("1-x", "a+b*x", "a", "-(a+b)", "")));
}

TEST(PolynomialStep, ConcludesASignFromRangesThatTheClaimsHaveOnly) {
  // The same polynomials, no negative coefficient, and no sign: 0 < b < 1.
  EXPECT_FALSE(holds(positive("b-1", "q", "q = b-1 > 0", "")));
  EXPECT_FALSE(holds(not_negative("b-1", "q", "q = b-1 >= 0", "")));
  EXPECT_TRUE(holds(positive("1-b", "q", "q = 1-b > 0", "")));
  EXPECT_THROW((void)holds(positive("b-1", "q", "q = b-1", "")), std::invalid_argument);
  // What may be 0 gives >= 0 and not > 0, unless another term is positive.
  EXPECT_TRUE(holds(not_negative("b*(1-x)", "b*y", "b > 0, y = 1-x >= 0", "")));
  EXPECT_FALSE(holds(positive("b*(1-x)", "b*y", "b > 0, y = 1-x >= 0", "")));
  EXPECT_TRUE(holds(positive("b*(1-x)", "b*y", "b > 0, y = 1-x > 0", "")));
  EXPECT_TRUE(holds(positive("b+b*(1-x)", "b+b*y", "b > 0, y = 1-x >= 0", "")));
  EXPECT_TRUE(holds(not_negative("a-a", "0", "a > 0", "")));
  EXPECT_FALSE(holds(positive("a-a", "0", "a > 0", "")));
  EXPECT_FALSE(holds(positive("k", "k", "k > 0", ""))) << "k = cos^2 may be 0";
  EXPECT_FALSE(holds(positive("1-a*b-2*b", "p", "p = 1-a*b-2*b > 0", ""))) << "planar: 0";
  EXPECT_TRUE(holds(not_negative("1-a*b-2*b", "p", "p = 1-a*b-2*b >= 0", "")));
  // A negative coefficient, and a letter without a range.
  EXPECT_FALSE(holds(positive("2*a-b", "2*a-b", "a > 0, b > 0", "")));
  EXPECT_FALSE(holds(not_negative("a-b", "a-b", "a > 0, b > 0", "")));
  EXPECT_FALSE(holds(positive("a+b", "a+b", "a > 0", "")));
  EXPECT_FALSE(holds(not_negative("b", "b", "a > 0", "")));
  // A letter has one range, and what it stands for is said in letters that stand for themselves.
  EXPECT_FALSE(holds(positive("a", "a", "a > 0, a > 0", "")));
  EXPECT_FALSE(holds(positive("x", "q", "q = 1-b > 0, b = 1-x > 0", "")));
  for (const char* letters : {"q 1-b > 0", ",", "", "q = 1-b", "b > 1", "b < 1", "b > 0,"}) {
    EXPECT_THROW((void)holds(positive("b", "b", letters, "")), std::invalid_argument) << letters;
  }
}

/// All hypotheses at once hold at one point, so that none of them excludes another.
TEST(PolynomialStep, HypothesesHoldTogether) {
  const std::vector<std::pair<char, rational>> point{{'a', {1, 4}}, {'b', {1, 4}}, {'c', {1, 8}},
                                                     {'k', {1, 2}}, {'u', {1, 4}}, {'x', {3, 4}},
                                                     {'y', {1, 2}}, {'z', {1, 4}}};
  for (const hypothesis& h : hypotheses()) {
    exact_polynomial value = parse(h.quantity);
    for (const auto& [letter, q] : point) value = value.with(letter, exact_polynomial(q));
    ASSERT_EQ(value.terms().size(), 1U) << h.of;
    EXPECT_EQ(value.terms().begin()->first, exact_polynomial::exponents()) << h.of;
    EXPECT_GT(value.terms().begin()->second, 0) << h.of;
  }
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

/// The step whose texts are those of the JSON, which must outlive it.
polynomial_step step_from(const json& one) {
  const std::string what = one.at("kind");
  const auto text = [&](const char* key) -> std::string_view {
    return one.at(key).get_ref<const std::string&>();
  };
  if (what == "identity") return identity(text("left"), text("right"), "");
  if (what == "sign by coefficients") {
    const bool strict = one.at("conclusion") == "> 0";
    return (strict ? positive : not_negative)(text("left"), text("right"), text("letters"), "");
  }
  return slope(text("left"), text("over"), text("variable"), text("right"), "");
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
      EXPECT_TRUE(holds(step_from(one))) << c.name << one;
      for (const char* side : {"left", "right"}) {
        for (const std::string& mutant : mutants_of(one.at(side))) {
          json wrong = one;
          wrong[side] = mutant;
          EXPECT_FALSE(holds(step_from(wrong))) << c.name << wrong;
          ++mutants;
        }
      }
    }
  }
  EXPECT_GT(mutants, 500);
}

}  // namespace polynomial_test
}  // namespace polhode::proofs
