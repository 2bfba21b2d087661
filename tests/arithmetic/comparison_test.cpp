// The questions that may be asked of balls, against exact ends.

#include <gtest/gtest.h>

#include "polhode/arithmetic/ball.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "support/exact_set.hpp"
#include "support/random.hpp"

namespace polhode {
namespace comparison_test {

using support::described;
using support::exact;
using support::exact_set;
using support::random_source;
using support::repeat;

bool wholly_below(const exact_set& x, const exact_set& y) {
  return x.upper && y.lower && *x.upper < *y.lower;
}
bool nowhere_above(const exact_set& x, const exact_set& y) {
  return x.upper && y.lower && *x.upper <= *y.lower;
}

// An answer "certainly" (or a "no" to "possibly") is true. Where all four ends are representable in
// the precision of the comparison, the opposite answer is true as well.
TEST(Comparison, OfTwoBalls) {
  random_source random(30);
  long certain = 0;
  for (repeat trial(5000); trial.again();) {
    const ball x = random.any_ball();
    ball y = random.any_ball();
    if (random.one_in(3)) y = random.inside(x);
    if (random.one_in(6)) y = x.middle().is_undefined() ? y : x.middle();
    if (random.one_in(6)) y = x.enlarged(scale(x.radius(), -random.between(0, 20)));
    if (random.one_in(6) && x.is_bounded()) {  // beside x, or just across its end
      const rational radius = upper_rational(ball(0, 64).enlarged(x.radius()));
      y = ball(rational(lower_rational(x.middle()) + radius * random.between(3, 7) / 4), 256)
              .enlarged(scale(x.radius(), -3));
    }
    SCOPED_TRACE(described(x) + ", " + described(y));
    const exact_set sx = exact(x);
    const exact_set sy = exact(y);
    const bool below = wholly_below(sx, sy);
    const bool above = wholly_below(sy, sx);
    certain += certainly_less(x, y) ? 1 : 0;
    if (certainly_less(x, y)) {
      EXPECT_TRUE(below);
    }
    if (certainly_less_equal(x, y)) {
      EXPECT_TRUE(nowhere_above(sx, sy));
    }
    if (!possibly_less(x, y)) {
      EXPECT_TRUE(nowhere_above(sy, sx));
    }
    if (!overlaps(x, y)) {
      EXPECT_TRUE(below || above);
    }
    if (contains(x, y)) {
      EXPECT_TRUE(sx.holds(sy));
    }
    const long p = std::max(x.precision(), y.precision());
    const auto short_ends = [&](const ball& z) { return support::bits_of_ends(z) <= p + 64; };
    if (x.is_exact() && y.is_exact()) {
      EXPECT_EQ(certainly_less(x, y), below);
      EXPECT_EQ(certainly_less_equal(x, y), nowhere_above(sx, sy));
      EXPECT_EQ(possibly_less(x, y), below);
      EXPECT_EQ(overlaps(x, y), !below && !above);
    }
    if (short_ends(x) && short_ends(y)) {
      EXPECT_EQ(overlaps(x, y), !below && !above);
    }
    if (short_ends(y)) {
      EXPECT_EQ(contains(x, y), sx.holds(sy));
    }
  }
  EXPECT_GT(certain, 0);
}

TEST(Comparison, WithNumbers) {
  random_source random(31);
  for (repeat trial(5000); trial.again();) {
    const ball x = random.any_ball();
    SCOPED_TRACE(described(x));
    const exact_set s = exact(x);
    const rational inside = random.member(x);
    EXPECT_TRUE(contains(x, inside));
    const rational any = random.any_rational(60);
    EXPECT_EQ(contains(x, any), s.holds(any));
    if (s.lower) {
      EXPECT_FALSE(contains(x, *s.lower - support::power_of_two(-2000)));
    }
    if (s.upper) {
      EXPECT_FALSE(contains(x, *s.upper + support::power_of_two(-2000)));
    }

    const long n = random.one_in(2) ? random.between(-3, 3)
                                    : static_cast<long>(random.bits() >> random.between(1, 62));
    EXPECT_EQ(contains(x, n), s.holds(rational(n)));
    if (certainly_less(x, n)) {
      EXPECT_TRUE(s.upper && *s.upper < n);
    }
    if (certainly_greater(x, n)) {
      EXPECT_TRUE(s.lower && *s.lower > n);
    }
    if (x.is_exact()) {
      EXPECT_EQ(certainly_less(x, n), *s.upper < n);
      EXPECT_EQ(certainly_greater(x, n), *s.lower > n);
    }

    const bool positive = s.lower && *s.lower > 0;
    const bool negative = s.upper && *s.upper < 0;
    const bool zero = s.is_bounded() && *s.lower == 0 && *s.upper == 0;
    EXPECT_EQ(sign_of(x), positive   ? certain_sign::positive
                          : negative ? certain_sign::negative
                          : zero     ? certain_sign::zero
                                     : certain_sign::unknown);
    EXPECT_EQ(certainly_positive(x), positive);
    EXPECT_EQ(certainly_negative(x), negative);
    EXPECT_EQ(contains_zero(x), s.holds(0));
  }
}

TEST(Comparison, OfTheAlmostEqual) {
  // 1 and 1 + 2^-500: decided at 64 bits of precision, since one operand has more.
  const ball one(1, 64);
  const ball more = ball(1, 600) + ball(support::power_of_two(-500), 600);
  EXPECT_TRUE(certainly_less(one, more));
  EXPECT_FALSE(certainly_less(more, one));
  EXPECT_FALSE(certainly_less(one, one));
  EXPECT_TRUE(certainly_less_equal(one, one));
  EXPECT_FALSE(possibly_less(one, one));
  EXPECT_TRUE(overlaps(one, one));
}

}  // namespace comparison_test
}  // namespace polhode
