// The witness of beta's bracket: its inequalities hold, and there is none for a bracket that beta
// is not in.

#include <gtest/gtest.h>

#include <string>

#include "polhode/certificate/agm_bracket.hpp"

namespace polhode {
namespace agm_bracket_test {

const char* const beta_floor = "0.0289732280378394600896939267034134383";

rational decimal_end(long bits, long steps_up) {
  // beta cut off to so many bits, and some units higher.
  const rational beta = parse_rational(beta_floor);
  const integer scale = integer(1) << static_cast<unsigned>(bits);
  return rational(integer(numerator(beta) * scale / denominator(beta)) + steps_up, scale);
}

integer number(const json& text) { return integer(text.get<std::string>()); }

void expect_chain(const json& chain, const integer& S, bool up) {
  const auto rounded = [up](const integer& given, const integer& exact) {
    return up ? given >= exact : given <= exact;
  };
  const integer n = number(chain.at("argument"));
  integer A = number(chain.at("start").at(0));
  integer B = number(chain.at("start").at(1));
  EXPECT_TRUE(rounded(A * A, (S + n) * S));
  EXPECT_TRUE(rounded(B * B, n * S));
  for (const json& step : chain.at("steps")) {
    const integer C = number(step.at(0));
    const integer D = number(step.at(1));
    EXPECT_TRUE(rounded(2 * C, A + B));
    EXPECT_TRUE(rounded(D * D, A * B));
    A = C;
    B = D;
  }
  EXPECT_TRUE(up ? 2 * A < S && 2 * B < S : 2 * A > S && 2 * B > S);
}

TEST(AgmBracket, HoldsItsInequalities) {
  for (const long bits : {6L, 20L, 60L, 110L}) {
    const rational lower = decimal_end(bits, 0);
    const rational upper = decimal_end(bits, 1);
    const auto witness = agm_bracket_witness(lower, upper);
    ASSERT_TRUE(witness) << bits;
    const integer S = number(witness->at("scale"));
    EXPECT_EQ(rational(number(witness->at("below").at("argument")), S), lower);
    EXPECT_EQ(rational(number(witness->at("above").at("argument")), S), upper);
    expect_chain(witness->at("below"), S, true);
    expect_chain(witness->at("above"), S, false);
  }
}

TEST(AgmBracket, IsNoneWhereBetaIsNot) {
  EXPECT_FALSE(agm_bracket_witness(decimal_end(60, 1), decimal_end(60, 2)));
  EXPECT_FALSE(agm_bracket_witness(decimal_end(60, -2), decimal_end(60, -1)));
}

}  // namespace agm_bracket_test
}  // namespace polhode
