// Numbers from text, and balls to rationals.

#include <climits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "polhode/arithmetic/ball.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "support/exact_set.hpp"
#include "support/random.hpp"

namespace polhode {
namespace exact_test {

using support::described;
using support::exact;
using support::holds;
using support::random_source;
using support::real;
using support::repeat;

rational ten_to_the(unsigned n) { return rational(pow(integer(10), n)); }

TEST(Parsing, Decimals) {
  EXPECT_EQ(parse_rational("0"), 0);
  EXPECT_EQ(parse_rational("-0"), 0);
  EXPECT_EQ(parse_rational("-0.000e5"), 0);
  EXPECT_EQ(parse_rational("0.0629"), rational(629, 10000));
  EXPECT_EQ(parse_rational("18.125"), rational(145, 8));
  EXPECT_EQ(parse_rational("-1e-300"), -1 / ten_to_the(300));
  EXPECT_EQ(parse_rational("1e300"), ten_to_the(300));
  EXPECT_EQ(parse_rational("+2.5E+3"), 2500);
  EXPECT_EQ(parse_rational("007"), 7);
  EXPECT_EQ(parse_rational(".5"), rational(1, 2));
  EXPECT_EQ(parse_rational("5."), 5);
  EXPECT_EQ(parse_rational("-.5e-1"), rational(-1, 20));
  EXPECT_EQ(parse_rational("1e-0"), 1);
  EXPECT_EQ(parse_rational("0.1e007"), 1000000);
  EXPECT_EQ(parse_rational("9223372036854775808"), rational(integer(1) << 63));
}

TEST(Parsing, Quotients) {
  EXPECT_EQ(parse_rational("1/4"), rational(1, 4));
  EXPECT_EQ(parse_rational("-2.5e3/7"), rational(-2500, 7));
  EXPECT_EQ(parse_rational("1/-4"), rational(-1, 4));
  EXPECT_EQ(parse_rational("-6/-4"), rational(3, 2));
  EXPECT_EQ(parse_rational("0/5"), 0);
  EXPECT_EQ(parse_rational("0.1/0.3"), rational(1, 3));
}

TEST(Parsing, RefusesWhatIsNoNumber) {
  const std::string with_nul("1\0", 2);
  const std::vector<std::string> bad = {
      "",    "nan", "NaN",   "inf",   "-inf",  "infinity", "1e",    "1e+",   "1e-",   "e5",
      ".",   "-",   "+",     "--1",   "+-1",   "1..2",     "1.2.3", "1e5e5", "1e5.5", "0x1",
      "0x",  "1p3", " 1",    "1 ",    "1 /2",  "1/ 2",     "\t1",   "1\n",   "1,5",   "1'000",
      "1_0", "1/0", "1/0.0", "0/0",   "1/-0",  "/",        "1/",    "/2",    "1/2/3", "1//2",
      "a",   "1a",  "a1",    "1e+-5", "1e-+5", "1e++5",    "1e--5", "٣",     "1٣",    "１",
      "½",   "−1",  "∞",     "1e٣",   ".e5",   "-.e1",     "1/nan", "#",     "\xff",  with_nul};
  for (const std::string& text : bad) {
    EXPECT_THROW((void)parse_rational(text), input_error) << '"' << text << '"';
    EXPECT_THROW((void)parse_ball(text, 64), input_error) << '"' << text << '"';
  }
}

TEST(Parsing, TheErrorNamesWhatWasGiven) {
  const auto message = [](const std::string& text) -> std::string {
    try {
      (void)parse_rational(text);
    } catch (const input_error& e) {
      return e.what();
    }
    return "no error";
  };
  EXPECT_NE(message("12x").find("\"12x\""), std::string::npos);
  EXPECT_NE(message("7/2x").find("\"7/2x\""), std::string::npos) << "the whole, not the half";
  EXPECT_NE(message("1/0").find("zero"), std::string::npos);
  EXPECT_LT(message(std::string(100'000, 'x')).size(), 300U) << "a long text is not repeated";
  EXPECT_LT(message(std::string(1'000'000, '1')).size(), 300U);
}

TEST(Parsing, LengthsAndExponentsAreLimited) {
  const std::string longest(longest_number_text, '7');
  EXPECT_EQ(numerator(parse_rational(longest)) % 10, 7);
  EXPECT_THROW((void)parse_rational(longest + '7'), input_error);

  const std::string great = std::to_string(greatest_decimal_exponent);
  const std::string greater = std::to_string(greatest_decimal_exponent + 1);
  EXPECT_EQ(parse_rational("1e" + great),
            ten_to_the(static_cast<unsigned>(greatest_decimal_exponent)));
  EXPECT_EQ(parse_rational("1e-" + great) * parse_rational("1e" + great), 1);
  for (const std::string& e : {greater, std::string("9223372036854775807"),
                               std::string("9223372036854775808"), std::string(500, '9')}) {
    EXPECT_THROW((void)parse_rational("1e" + e), input_error);
    EXPECT_THROW((void)parse_rational("1e-" + e), input_error);
    EXPECT_THROW((void)parse_rational("0e" + e), input_error);
    EXPECT_THROW((void)parse_rational("1/1e" + e), input_error);
  }
}

TEST(Parsing, RoundTrips) {
  random_source random(300);
  for (repeat trial(2000); trial.again();) {
    const rational q = random.any_rational(random.between(1, 500));
    EXPECT_EQ(parse_rational(to_text(q)), q);
    // A decimal written from its digits.
    const integer digits = random.any_integer(200);
    const long e = random.between(-100, 100);
    const rational value = e >= 0 ? rational(digits) * ten_to_the(static_cast<unsigned>(e))
                                  : rational(digits) / ten_to_the(static_cast<unsigned>(-e));
    EXPECT_EQ(parse_rational(digits.str() + "e" + std::to_string(e)), value);
    const precision p = random.any_precision();
    const ball x = parse_ball(digits.str() + "e" + std::to_string(e), p);
    EXPECT_EQ(x.precision(), p);
    EXPECT_TRUE(holds(x, value));
  }
  EXPECT_EQ(to_text(rational(629, 10000)), "629/10000");
  EXPECT_EQ(to_text(rational(3)), "3");
  EXPECT_EQ(to_text(rational(-6, 4)), "-3/2");
}

TEST(EndsAsRationals, AreTrueBounds) {
  random_source random(301);
  for (repeat trial(4000); trial.again();) {
    const ball x = random.any_ball();
    SCOPED_TRACE(described(x));
    const auto set = exact(x);
    if (!set.is_bounded()) {
      EXPECT_THROW((void)lower_rational(x), std::domain_error);
      EXPECT_THROW((void)upper_rational(x), std::domain_error);
      continue;
    }
    EXPECT_LE(lower_rational(x), *set.lower);
    EXPECT_GE(upper_rational(x), *set.upper);
    const rational slack =
        support::ulp(set.greatest_size(), x.precision()) * support::power_of_two(-60);
    EXPECT_LE(*set.lower - lower_rational(x), slack);
    EXPECT_LE(upper_rational(x) - *set.upper, slack);
    if (support::bits_of_ends(x) <= x.precision() + 64) {
      EXPECT_EQ(lower_rational(x), *set.lower);
      EXPECT_EQ(upper_rational(x), *set.upper);
    }
  }
  EXPECT_THROW((void)lower_rational(ball::undefined(64)), std::domain_error);
  EXPECT_THROW((void)upper_rational(ball::entire(64)), std::domain_error);
}

TEST(EndsAsRationals, WithARadiusFarBelowTheLastPlace) {
  for (const long exponent : {-200L, -5000L, -(1L << 30), -(1L << 40), -(1L << 59), LONG_MIN}) {
    const ball x = ball::from_midpoint_radius(real(64, 1), magnitude::power_of_two(exponent));
    EXPECT_FALSE(x.is_exact());
    EXPECT_LT(lower_rational(x), 1);
    EXPECT_GT(upper_rational(x), 1);
    EXPECT_LT(upper_rational(x) - lower_rational(x), support::power_of_two(-100));
    // And the questions about members do not write such powers of two out.
    EXPECT_TRUE(contains(x, rational(1)));
    EXPECT_FALSE(contains(x, rational(1) + support::power_of_two(-150)));
    EXPECT_FALSE(contains(x, rational(2)));
    EXPECT_FALSE(contains(x, 0L));
  }
}

}  // namespace exact_test
}  // namespace polhode
