// Decimals: every printed digit is a digit of every member, or the error beside it is true.

#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "polhode/arithmetic/ball.hpp"
#include "polhode/arithmetic/certain_digits.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "polhode/arithmetic/text.hpp"
#include "support/exact_set.hpp"
#include "support/random.hpp"

namespace polhode {
namespace text_test {

using support::described;
using support::exact;
using support::exact_set;
using support::random_source;
using support::real;
using support::repeat;

/// A printed decimal: its value, its significant digits, and the value of its last place.
struct printed {
  rational value;
  long digits = 0;
  rational last_place;
};

printed read(const std::string& text) {
  printed result;
  result.value = parse_rational(text);
  const auto e = text.find_first_of("eE");
  const std::string mantissa = text.substr(0, e);
  const auto point = mantissa.find('.');
  const std::string decimals = point == std::string::npos ? "" : mantissa.substr(point + 1);
  bool leading = true;
  for (const char c : mantissa) {
    if (c < '0' || c > '9') continue;
    leading = leading && c == '0';
    if (!leading) ++result.digits;
  }
  const rational unit = e == std::string::npos ? rational(1) : parse_rational("1" + text.substr(e));
  result.last_place = unit / rational(pow(integer(10), static_cast<unsigned>(decimals.size())));
  return result;
}

/// |q| cut off after the place `last_place` is |value|: the printed digits are the leading digits
/// of q.
bool is_prefix(const printed& shown, const rational& q) {
  if (shown.value != 0 && (shown.value < 0) != (q < 0)) return false;
  const rational size = abs(shown.value);
  return size <= abs(q) && abs(q) < size + shown.last_place;
}

/// The first digits of two numbers of one sign and order of magnitude are the same, so many as to
/// end at this place.
bool share_digits(const rational& x, const rational& y, const rational& last_place) {
  const auto cut = [&](const rational& q) {
    const rational steps = abs(q) / last_place;
    return integer(numerator(steps) / denominator(steps));
  };
  return (x < 0) == (y < 0) && cut(x) == cut(y);
}

/// The place 10^k of the n-th significant digit of q.
rational place_of_digit(const rational& q, long n) {
  rational place = 1;
  while (abs(q) < place) place /= 10;
  while (abs(q) >= 10 * place) place *= 10;
  for (; n > 1; --n) place /= 10;
  return place;
}

void check(const ball& x, long most_digits, random_source& random) {
  SCOPED_TRACE(described(x) + " in " + std::to_string(most_digits) + " digits");
  const decimal_enclosure d = to_decimal_enclosure(x, most_digits);
  SCOPED_TRACE(d.lower + " | " + d.value + " ± " + d.radius + " | " + d.upper);
  const exact_set set = exact(x);
  const rational lower = parse_rational(d.lower);
  const rational upper = parse_rational(d.upper);
  const rational radius = parse_rational(d.radius);
  ASSERT_FALSE(d.value.empty());
  const printed shown = read(d.value);
  EXPECT_LE(lower, *set.lower);
  EXPECT_GE(upper, *set.upper);
  EXPECT_LE(read(d.lower).digits, std::max(d.digits, most_digits) + 3 + 22);

  // The error holds, and is no greater than two digits of it make necessary.
  EXPECT_LE(rational(shown.value - radius), lower);
  EXPECT_GE(rational(shown.value + radius), upper);
  const rational farthest = std::max(rational(upper - shown.value), rational(shown.value - lower));
  EXPECT_LE(radius, rational(farthest * 1101 / 1000));
  EXPECT_EQ(radius == 0, farthest == 0);

  EXPECT_EQ(d.exact, set.width() == 0 && shown.value == *set.lower &&
                         shown.digits <= std::max(most_digits, 25L));
  const rational half_width = (upper - lower) / 2;
  if (d.exact) {
    EXPECT_EQ(shown.value, *set.lower);
    EXPECT_EQ(shown.digits, d.digits);
    EXPECT_EQ(radius, 0);
    EXPECT_TRUE(d.has(most_digits) && d.has_cut(most_digits));
  } else if (d.cut) {
    EXPECT_EQ(shown.digits, d.digits);
    EXPECT_EQ(d.digits, d.shared);
    for (const rational& member : {*set.lower, *set.upper, random.member(set), random.member(set)})
      EXPECT_TRUE(is_prefix(shown, member));
    // The digits asked for, but for those that a number of this precision does not have.
    EXPECT_TRUE(d.digits == most_digits || d.digits >= x.precision());
  } else {
    EXPECT_GT(set.width(), 0);
    // Rounded to nearest at the last digit asked for, or further down than a twentieth of the half
    // width.
    const rational middle = (lower + upper) / 2;
    const rational off = abs(rational(shown.value - middle));
    const rational slack =
        support::ulp(set.greatest_size(), x.precision() + 60) + half_width / 1000;
    const rational last = middle == 0 ? rational(0) : place_of_digit(middle, most_digits);
    EXPECT_LE(off, rational(std::max(rational(last / 2), rational(half_width / 15)) + slack));
    if (shown.value != 0) {
      EXPECT_EQ(d.digits > 0, radius <= place_of_digit(shown.value, 1));
      if (d.digits > 0) {
        EXPECT_LE(radius, place_of_digit(shown.value, d.digits));
      }
      if (d.digits < most_digits) {
        EXPECT_GT(radius, place_of_digit(shown.value, d.digits + 1));
      }
    } else {
      EXPECT_EQ(d.digits, 0);
    }
    EXPECT_LT(d.shared, most_digits);
  }
  if (d.shared > 0 && set.width() > 0) {
    EXPECT_TRUE(share_digits(*set.lower, *set.upper, place_of_digit(*set.lower, d.shared)));
  }
  if (!d.exact && !d.cut && *set.lower != 0) {
    // No digit is kept back: with one more the ends differ.
    const rational next = place_of_digit(*set.lower, d.shared + 1);
    const rational slack = support::ulp(set.greatest_size(), x.precision() + 30);
    EXPECT_FALSE(share_digits(*set.lower - slack, *set.upper + slack, next));
  }

  const std::string brief = to_decimal(x, most_digits);
  if (d.exact) {
    EXPECT_EQ(brief, d.value);
  } else if (!d.cut) {
    EXPECT_EQ(to_text(d), d.value + " ± " + d.radius);
    EXPECT_EQ(brief, d.digits >= std::min(3L, most_digits) ? to_text(d)
                                                           : '[' + d.lower + ", " + d.upper + ']');
  } else {
    std::string without_dots = brief;
    const auto dots = brief.find("...");
    ASSERT_NE(dots, std::string::npos);
    without_dots.erase(dots, 3);
    EXPECT_EQ(without_dots, d.value);
  }
}

TEST(Text, DecimalsOfRandomBalls) {
  random_source random(400);
  for (repeat trial(3000); trial.again();) {
    const ball x = random.any_ball();
    if (x.is_bounded())
      check(x, random.one_in(2) ? random.between(1, 8) : random.between(1, 120), random);
  }
}

TEST(Text, DecimalsOfRoundNumbers) {
  random_source random(401);
  // Around numbers with short decimals, where prefixes change all their digits at once.
  for (repeat trial(3000); trial.again();) {
    const long e = random.one_in(5) ? random.between(-310, 310) : random.between(-9, 9);
    const rational centre =
        rational(random.between(-12, 12)) * parse_rational("1e" + std::to_string(e));
    const precision p = random.between(24, 1100);
    ball x(centre, p);
    if (random.one_in(3)) x = x.middle();
    if (random.one_in(2)) {
      x = x.enlarged(magnitude::power_of_two(
          random.between(-200, 0) + static_cast<long>(std::floor(3.32 * static_cast<double>(e)))));
    }
    check(x, random.between(1, 40), random);
  }
}

TEST(Text, Straddles) {
  const auto text = [](const char* low, const char* high, long digits) {
    const ball x = hull(parse_ball(low, 200), parse_ball(high, 200));
    random_source random(402);
    check(x, digits, random);
    return to_decimal_enclosure(x, digits);
  };
  const auto brief = [&](const char* low, const char* high, long digits) {
    return to_text(text(low, high, digits));
  };
  EXPECT_EQ(brief("0.0999999", "0.1000001", 10), "0.1 ± 1.1e-7");
  EXPECT_EQ(text("0.9999", "1.0001", 10).digits, 4);
  EXPECT_EQ(text("0.9999", "1.0001", 10).shared, 0);
  EXPECT_EQ(brief("-0.5", "0.25", 10), "-0.12 ± 0.38");
  EXPECT_EQ(brief("0", "0.25", 10), "0.12 ± 0.13");
  EXPECT_EQ(brief("-0.25", "0", 10), "-0.12 ± 0.13");
  EXPECT_EQ(brief("-0.25", "0.25", 10), "0 ± 0.25");
  EXPECT_EQ(text("1.2344", "1.2346", 10).value, "1.2345");
  EXPECT_EQ(text("1.2344", "1.2346", 10).shared, 4);
  EXPECT_EQ(text("-1.2346", "-1.2344", 10).value, "-1.2345");
  EXPECT_EQ(text("123", "129", 10).value, "126");
  EXPECT_EQ(text("12999", "13001", 10).value, "13000");
  EXPECT_EQ(text("11.999999", "12.000001", 30).value, "12");
  EXPECT_EQ(text("1.5e300", "1.6e300", 10).value, "1.55e300");
  EXPECT_EQ(text("-1.61e-300", "-1.605e-300", 10).value, "-1.6075e-300");
  EXPECT_EQ(text("3.14159", "3.1416", 10).value, "3.141595");
  EXPECT_EQ(text("3.14159", "3.1416", 2).value, "3.1");
  EXPECT_TRUE(text("3.14159", "3.1416", 2).cut);
  // Sizes that differ by more than any alignment, and the ends of carries.
  EXPECT_EQ(text("-1e-200", "1e200", 5).value, "5e199");
  EXPECT_EQ(text("0.9999999999999999999999999", "1.000000000000000000000000001", 30).value,
            "0.999999999999999999999999951");
}

TEST(Text, ShowsDigitsOnlyWhereMorePrecisionWouldShowNoOther) {
  const auto about_one = [](long bits) {
    return ball(1, 400).enlarged(magnitude::power_of_two(-bits));
  };
  EXPECT_TRUE(shows_digits(sqrt(ball(2, 64)), 15));
  EXPECT_FALSE(shows_digits(sqrt(ball(2, 64)), 25));
  // Five digits of it are right with 20 bits, but 1.0000 or 0.9999 may follow.
  EXPECT_FALSE(shows_digits(about_one(25), 5));
  EXPECT_FALSE(shows_digits(about_one(100), 5));
  EXPECT_TRUE(shows_digits(about_one(130), 5));
  EXPECT_TRUE(shows_digits(ball(0, 64), 50));
  EXPECT_FALSE(shows_digits(ball(0, 64).enlarged(magnitude::power_of_two(-1000)), 1));
  EXPECT_FALSE(shows_digits(ball::entire(64), 1));
  EXPECT_FALSE(shows_digits(ball::undefined(64), 1));
}

TEST(Text, KnownNumbers) {
  EXPECT_EQ(to_decimal(pi(200), 10), "3.141592653...");
  EXPECT_EQ(to_decimal(-pi(200), 10), "-3.141592653...");
  EXPECT_EQ(to_decimal(pi(200), 1), "3...");
  EXPECT_EQ(to_decimal_enclosure(pi(200), 50).value,
            "3.1415926535897932384626433832795028841971693993751");
  EXPECT_EQ(to_decimal(sqrt(ball(2, 100)), 6), "1.41421...");
  EXPECT_EQ(to_decimal(ball(0, 64), 6), "0");
  EXPECT_EQ(to_decimal(ball(-12, 64), 6), "-12");
  EXPECT_EQ(to_decimal(ball(1000, 64), 6), "1000");
  EXPECT_EQ(to_decimal(ball(rational(1, 8), 64), 6), "0.125");
  EXPECT_EQ(to_decimal(ball(rational(1, 8), 64), 2), "0.12...");
  EXPECT_EQ(to_decimal(ball(rational(1, 10), 64), 6).substr(0, 7), "0.1 ± ") << "both sides of 0.1";
  EXPECT_EQ(to_decimal(ball::undefined(64), 6), "undefined");
  EXPECT_EQ(to_decimal(ball::entire(64), 6), "[-inf, inf]");
  EXPECT_EQ(to_decimal(ball::from_end_points(real(64, 1), real::infinity(1), 64), 6).substr(0, 2),
            "[1");
}

TEST(Text, UnboundedBallsArePrintedOutward) {
  random_source random(403);
  for (repeat trial(500); trial.again();) {
    const ball x = random.any_ball(random.any_precision(), support::kind::half_infinite);
    const exact_set set = exact(x);
    const long digits = random.between(1, 12);
    const std::string text = to_decimal(x, digits);
    const auto comma = text.find(", ");
    ASSERT_NE(comma, std::string::npos) << text;
    const std::string low = text.substr(1, comma - 1);
    const std::string high = text.substr(comma + 2, text.size() - comma - 3);
    if (set.lower) {
      EXPECT_LE(parse_rational(low), *set.lower) << text;
      EXPECT_EQ(high, "inf");
    } else {
      EXPECT_EQ(low, "-inf");
      EXPECT_GE(parse_rational(high), *set.upper) << text;
    }
    EXPECT_THROW((void)to_decimal_enclosure(x, digits), std::domain_error);
  }
}

TEST(Text, BadRequests) {
  const ball x = pi(64);
  for (const long digits : {0L, -1L, std::numeric_limits<long>::min()}) {
    EXPECT_THROW((void)to_decimal_enclosure(x, digits), std::invalid_argument);
    EXPECT_THROW((void)to_decimal(x, digits), std::invalid_argument);
    EXPECT_THROW((void)to_decimal(ball::entire(64), digits), std::invalid_argument);
    EXPECT_THROW((void)bits_for_digits(digits), std::invalid_argument);
  }
  EXPECT_THROW((void)to_decimal_enclosure(ball::entire(64), 5), std::domain_error);
  EXPECT_THROW((void)to_decimal_enclosure(ball::undefined(64), 5), std::domain_error);
}

TEST(Text, Streams) {
  std::ostringstream out;
  out << pi(100) << ' ' << std::setprecision(12) << pi(100) << ' ' << ball::undefined(64) << ' '
      << std::setprecision(0) << ball(3, 64);
  EXPECT_EQ(out.str(), "3.14159... 3.14159265358... undefined 3");
}

TEST(Text, BitsForDigits) {
  // 10^d <= 2^bits, and not by a wide margin.
  for (long digits = 1; digits < 3000; digits += digits < 100 ? 1 : 37) {
    const long bits = bits_for_digits(digits);
    const integer power = pow(integer(10), static_cast<unsigned>(digits));
    EXPECT_LE(power, integer(1) << static_cast<unsigned>(bits));
    EXPECT_GT(power, integer(1) << static_cast<unsigned>(bits - 2));
  }
  for (const long digits :
       {1'000'000L, 999'999'999L, 1'000'000'000L, 1'000'000'001L, 5'000'000'000L}) {
    real bits(200, digits);
    real log2_10(200, 10);
    mpfr_log2(log2_10, log2_10, MPFR_RNDU);
    mpfr_mul(bits, bits, log2_10, MPFR_RNDU);
    EXPECT_LE(mpfr_cmp_si(bits.get(), bits_for_digits(digits)), 0) << digits;
  }
  EXPECT_THROW((void)bits_for_digits(5'000'000'001), std::invalid_argument);
  EXPECT_THROW((void)bits_for_digits(std::numeric_limits<long>::max()), std::invalid_argument);
}

}  // namespace text_test
}  // namespace polhode
