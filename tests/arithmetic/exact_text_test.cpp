// Text without loss, the fmt formatter, and what numeric_limits does not claim.

#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "polhode/arithmetic/format.hpp"
#include "polhode/arithmetic/text.hpp"
#include "support/exact_set.hpp"
#include "support/random.hpp"

namespace polhode {
namespace exact_text_test {

TEST(ExactText, ReadsBackEveryBall) {
  support::random_source random(11);
  for (int trial = 0; trial < static_cast<int>(2000 * support::effort()) + 1; ++trial) {
    const precision p = 2 + trial % 400;
    const ball x = random.any_ball(p);
    const std::string text = to_exact_text(x);
    const ball again = parse_exact_text(text);
    EXPECT_EQ(to_exact_text(again), text);
    if (!x.is_undefined()) {
      EXPECT_TRUE(support::identical(x, again)) << text;
    }
  }
}

TEST(ExactText, IsAsDocumented) {
  EXPECT_EQ(to_exact_text(ball(-6, 64)), "64:-0x3p+1+-0");
  EXPECT_EQ(to_exact_text(ball::undefined(64)), "64:undefined");
  EXPECT_EQ(to_exact_text(exp(ball::entire(64))), "64:[0, inf]");
  EXPECT_TRUE(parse_exact_text("64:undefined").is_undefined());
  EXPECT_TRUE(contains(parse_exact_text("64:[0x1p+0, 0x3p+0]"), 2));
}

TEST(ExactText, RefusesAnythingElse) {
  const std::string long_mantissa(1'000'000, 'f');
  for (const std::string& text : {std::string(),
                                  std::string("64"),
                                  std::string("64:"),
                                  std::string("64:0x"),
                                  std::string("64:0x+-0"),
                                  std::string("64:nan+-0"),
                                  std::string("0:0+-0"),
                                  std::string("1:0+-0"),
                                  std::string("-5:0+-0"),
                                  std::string("9223372036854775808:0+-0"),
                                  std::string("64:0x1p0"),
                                  std::string("64:[0x1p+1, 0x1p+0]"),
                                  std::string("64:[inf, inf]"),
                                  std::string("64:[-inf, -inf]"),
                                  std::string("64:[0x1p+0, -inf]"),
                                  std::string("64:[nan, inf]"),
                                  std::string("64:0x1p+0+--0x1p0"),
                                  std::string("64:0x1p+0+-inf"),
                                  std::string("64:inf+-0"),
                                  std::string("64:0x10000000000000001p0+-0"),
                                  std::string("64:0x1p0+-0x80000001p0"),
                                  std::string("64:0x1p99999999999999999999+-0"),
                                  std::string("64:0x1p+4611686018427387904+-0"),
                                  std::string("64:0+-0 "),
                                  std::string(" 64:0+-0"),
                                  std::string("64:0x1P0+-0"),
                                  "64:0x" + long_mantissa + "p0+-0"}) {
    try {
      const ball x = parse_exact_text(text);
      ADD_FAILURE() << "accepted: " << text.substr(0, 60) << " as " << x;
    } catch (const input_error& e) {
      EXPECT_NE(std::string(e.what()).find("accepted are"), std::string::npos);
      EXPECT_LT(std::string(e.what()).size(), 400U);
    }
  }
}

TEST(Format, PrintsTrueEnclosures) {
  const ball root = sqrt(ball(2, 200));
  EXPECT_EQ(fmt::format("{}", root), to_decimal(root, 6));
  EXPECT_EQ(fmt::format("{:.20}", root), to_decimal(root, 20));
  EXPECT_EQ(fmt::format("{:.3}", ball::undefined(64)), "undefined");
  EXPECT_THROW((void)fmt::format(fmt::runtime("{:x}"), root), fmt::format_error);
  EXPECT_THROW((void)fmt::format(fmt::runtime("{:.0}"), root), fmt::format_error);
}

TEST(NumericLimits, ClaimNothingOfABall) {
  EXPECT_FALSE(std::numeric_limits<ball>::is_specialized);
}

}  // namespace exact_text_test
}  // namespace polhode
