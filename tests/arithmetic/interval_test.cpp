// Balls by their end points: every number and every answer against exact rationals.

#include <utility>

#include <gtest/gtest.h>

#include "polhode/arithmetic/ball.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "polhode/arithmetic/interval.hpp"
#include "support/exact_set.hpp"
#include "support/random.hpp"

namespace polhode {
namespace interval_test {

using support::described;
using support::exact;
using support::exact_set;
using support::holds;
using support::random_source;
using support::real;
using support::repeat;
using support::to_rational;

mpfr_srcptr raw(const mpfr_float& x) { return x.backend().data(); }

/// x is q, rounded up (or down) to x's precision.
::testing::AssertionResult is_rounded(const mpfr_float& x, const rational& q, mpfr_rnd_t rounding) {
  const real expected(precision_of(x), q, rounding);
  if (mpfr_equal_p(raw(x), expected) != 0) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << x << " is not " << described(q) << ", rounded";
}

TEST(Interval, FromEndPointsAndText) {
  random_source random(4399);
  for (repeat trial(1000); trial.again();) {
    rational a = random.any_rational(100);
    rational b = random.one_in(4) ? a : random.any_rational(100);
    if (b < a) std::swap(a, b);
    const precision p = random.any_precision();
    const ball x = from_end_points(a, b, p);
    EXPECT_EQ(x.precision(), p);
    const exact_set s = exact(x);
    EXPECT_TRUE(s.holds(exact_set{a, b}));
    const rational slack = 2 * support::ulp(s.greatest_size(), p);
    EXPECT_TRUE((exact_set{a - slack, b + slack}).holds(s));
    EXPECT_TRUE(
        support::identical(parse_interval("[" + to_text(a) + ", " + to_text(b) + "]", p), x));
    const auto low = exact(parse_interval("[" + to_text(a) + ",inf]", p));
    EXPECT_TRUE(low.lower && *low.lower <= a && !low.upper);
    const auto high = exact(parse_interval("[-inf ," + to_text(b) + " ]", p));
    EXPECT_TRUE(high.upper && *high.upper >= b && !high.lower);
  }
  EXPECT_TRUE(parse_interval("[ 2 ]", 64).is_exact());
  EXPECT_TRUE(contains(parse_interval("[0.1]", 64), rational(1, 10)));
  EXPECT_FALSE(parse_interval("[0.1]", 64).is_exact());
  for (const char* text : {"[entire]", " [-inf, inf] ", "[-inf,+inf]", "[ entire ]"}) {
    EXPECT_TRUE(is_entire(parse_interval(text, 64))) << text;
  }
  const ball x = from_end_points(mpfr_float(1), mpfr_float(4), 64);
  EXPECT_TRUE(is_equal(x, hull(ball(1, 64), ball(4, 64))));
}

TEST(Interval, RepresentableEndsStayWhereTheyAre) {
  const auto next_to_one = [](precision p) {
    real above(p, 1);
    mpfr_nextabove(above);
    return ball::from_end_points(real(p, 1), above, p);
  };
  const ball x = next_to_one(53);
  EXPECT_EQ(exact(x), (exact_set{rational(1), 1 + support::power_of_two(-52)}));
  EXPECT_FALSE(is_interior(ball(1, 53), x));
  EXPECT_FALSE(contains(x, rational(1) - support::power_of_two(-53)));

  random_source random(4401);
  for (repeat trial(3000); trial.again();) {
    const precision p = random.any_precision();
    const real a = random.any_real(p, -3, 3);
    real b = a;
    for (long i = random.between(0, 3); i > 0; --i) mpfr_nextabove(b);
    if (random.one_in(3)) {
      const real step = random.any_real(p, -p - 3, -p / 2);
      mpfr_abs(b, step, MPFR_RNDN);
      mpfr_add(b, a, b, MPFR_RNDU);
    }
    const exact_set ends{to_rational(a), to_rational(b)};
    const ball y = ball::from_end_points(a, b, p);
    SCOPED_TRACE(described(y));
    EXPECT_EQ(exact(y), ends);
    EXPECT_EQ(exact(hull(ball(a.get()), ball(b.get()))), ends);
    EXPECT_EQ(exact(intersection(y, hull(y, ball(1, p)))), ends);
    EXPECT_EQ(exact(min(y, ball(100, p))), ends);
    EXPECT_EQ(exact(max(y, ball(-100, p))), ends);
    EXPECT_EQ(exact(y.with_precision(p + 30)), ends);
    EXPECT_EQ(exact(scale(y, 7)), (exact_set{*ends.lower * 128, *ends.upper * 128}));
    EXPECT_EQ(exact(-(-y)), ends);
    EXPECT_TRUE(is_equal(y, ball::from_end_points(a, b, p + 5)));
    EXPECT_FALSE(is_interior(ball(a.get()), y));
    EXPECT_FALSE(is_interior(ball(b.get()), y));
    // y = 0 + y, and the other way round.
    EXPECT_EQ(exact(cancel_minus(y, ball(0, p))), ends);
    EXPECT_TRUE(holds(cancel_minus(y, y), rational(0)));
    EXPECT_TRUE(cancel_minus(y, y).is_exact());
  }
}

TEST(Interval, Numbers) {
  random_source random(4400);
  for (repeat trial(4000); trial.again();) {
    const ball x = random.any_ball();
    SCOPED_TRACE(described(x));
    const exact_set s = exact(x);
    EXPECT_EQ(precision_of(width(x)), x.precision());
    if (!s.is_bounded()) {
      EXPECT_NE(mpfr_inf_p(raw(width(x))), 0);
      EXPECT_NE(mpfr_inf_p(raw(half_width(x))), 0);
      EXPECT_NE(mpfr_inf_p(raw(magnitude_of(x))), 0);
      if (s.holds(0)) {
        EXPECT_NE(mpfr_zero_p(raw(mignitude_of(x))), 0);
      }
      continue;
    }
    EXPECT_TRUE(is_rounded(width(x), s.width(), MPFR_RNDU));
    const rational middle = to_rational(raw(midpoint(x)));
    const rational above = *s.upper - middle;
    const rational below = middle - *s.lower;
    EXPECT_TRUE(is_rounded(half_width(x), above < below ? below : above, MPFR_RNDU));
    EXPECT_TRUE(is_rounded(magnitude_of(x), s.greatest_size(), MPFR_RNDU));
    rational nearest = 0;
    if (*s.lower > 0) nearest = *s.lower;
    if (*s.upper < 0) nearest = -*s.upper;
    // sign_of may not see that the set misses 0 where it does so by next to nothing.
    if (sign_of(x) == certain_sign::unknown) nearest = 0;
    EXPECT_TRUE(is_rounded(mignitude_of(x), nearest, MPFR_RNDD));
  }
  const ball u = ball::undefined(64);
  for (const mpfr_float& n : {width(u), half_width(u), magnitude_of(u), mignitude_of(u)}) {
    EXPECT_NE(mpfr_nan_p(raw(n)), 0);
  }
}

TEST(Interval, SplitCoversWithACommonCut) {
  random_source random(4401);
  for (repeat trial(4000); trial.again();) {
    const ball x = random.any_ball();
    SCOPED_TRACE(described(x));
    const auto [low, high] = split(x);
    EXPECT_EQ(low.precision(), x.precision());
    EXPECT_TRUE(overlaps(low, high));
    const exact_set s = exact(x);
    for (int i = 0; i < 4; ++i) {
      const rational t = random.member(s);
      EXPECT_TRUE(contains(low, t) || contains(high, t)) << described(t);
    }
    EXPECT_TRUE(exact(hull(low, high)).holds(s));
    if (s.is_bounded() && s.width() * support::power_of_two(20) > s.greatest_size() &&
        x.precision() > 32) {
      EXPECT_LE(exact(low).width(), s.width() * rational(5, 8));
      EXPECT_LE(exact(high).width(), s.width() * rational(5, 8));
      EXPECT_EQ(*exact(low).upper, *exact(high).lower);
    }
  }
}

TEST(Interval, SplitOfUnboundedSets) {
  const auto ray = [](long a, int direction) {
    const real end(64, a);
    return direction > 0 ? ball::from_end_points(end, real::infinity(1), 64)
                         : ball::from_end_points(real::infinity(-1), end, 64);
  };
  const auto cut_of = [](const ball& x) { return *exact(split(x).first).upper; };
  EXPECT_EQ(cut_of(ray(3, 1)), 7);
  EXPECT_EQ(cut_of(ray(-3, 1)), 0);
  EXPECT_EQ(cut_of(ray(-3, -1)), -7);
  EXPECT_EQ(cut_of(ray(3, -1)), 0);
  EXPECT_EQ(cut_of(ball::entire(64)), 0);
  EXPECT_TRUE(split(ball::undefined(64)).first.is_undefined());
  EXPECT_TRUE(split(ball::undefined(64)).second.is_undefined());
}

TEST(Interval, CommonPart) {
  random_source random(4402);
  long empty = 0;
  for (repeat trial(4000); trial.again();) {
    const ball x = random.any_ball();
    const ball y = random.one_in(2) ? random.any_ball() : random.inside(x);
    SCOPED_TRACE(described(x) + ", " + described(y));
    const exact_set s = exact(x);
    const exact_set t = exact(y);
    const std::optional<ball> z = common_part(x, y);
    for (const rational& q : {random.member(s), random.member(t)}) {
      if (!s.holds(q) || !t.holds(q)) continue;
      ASSERT_TRUE(z.has_value());
      EXPECT_TRUE(contains(*z, q));
    }
    if (!z) {
      ++empty;
      EXPECT_TRUE((s.upper && t.lower && *s.upper < *t.lower) ||
                  (t.upper && s.lower && *t.upper < *s.lower));
    }
  }
  EXPECT_GT(empty, 100 * support::effort() / 2);
  const std::optional<ball> u = common_part(ball(1, 64), ball::undefined(64));
  ASSERT_TRUE(u.has_value());
  EXPECT_TRUE(u->is_undefined());
}

TEST(Interval, Cancellation) {
  random_source random(4403);
  long bounded = 0;
  for (repeat trial(4000); trial.again();) {
    const precision p = random.between(2, 200);
    const ball y = random.any_ball(p);
    const ball x = random.one_in(2) ? y + random.any_ball(p) : random.any_ball(p);
    SCOPED_TRACE(described(x) + ", " + described(y));
    const exact_set s = exact(x);
    const exact_set t = exact(y);
    const ball z = cancel_minus(x, y);
    EXPECT_TRUE(support::identical(cancel_plus(x, -y), z));
    if (!s.is_bounded() || !t.is_bounded() || s.width() < t.width()) {
      EXPECT_TRUE(is_entire(z));
      continue;
    }
    ++bounded;
    const exact_set truth{*s.lower - *t.lower, *s.upper - *t.upper};
    const exact_set got = exact(z);
    EXPECT_TRUE(got.holds(truth));
    const rational slack = 4 * support::ulp(got.greatest_size(), z.precision());
    EXPECT_LE(got.width(), truth.width() * (1 + support::power_of_two(-20)) + slack);
  }
  EXPECT_GT(bounded, 500 * support::effort() / 2);
  EXPECT_TRUE(cancel_minus(ball(1, 64), ball::undefined(64)).is_undefined());
}

/// An end for comparisons: (-1, 0) is minus infinity, (1, 0) infinity.
using place = std::pair<int, rational>;
place lower_of(const exact_set& s) { return s.lower ? place{0, *s.lower} : place{-1, 0}; }
place upper_of(const exact_set& s) { return s.upper ? place{0, *s.upper} : place{1, 0}; }
bool below(const place& a, const place& b) { return a < b || (a == b && a.first != 0); }

TEST(Interval, Questions) {
  random_source random(4404);
  long yes[6] = {};
  for (repeat trial(8000); trial.again();) {
    const ball x = random.any_ball();
    const ball y = random.one_in(4)   ? x.with_precision(x.precision() + random.between(0, 70))
                   : random.one_in(3) ? random.inside(x)
                   : random.one_in(2) ? x.enlarged(random.any_magnitude(-60, 2))
                                      : random.any_ball();
    SCOPED_TRACE(described(x) + ", " + described(y));
    const exact_set s = exact(x);
    const exact_set t = exact(y);
    const bool answers[6] = {is_equal(x, y),        is_subset(x, y), is_interior(x, y),
                             ends_less_equal(x, y), ends_less(x, y), is_entire(x)};
    const place a = lower_of(s);
    const place b = upper_of(s);
    const place c = lower_of(t);
    const place d = upper_of(t);
    EXPECT_EQ(answers[0], a == c && b == d);
    EXPECT_EQ(answers[1], c <= a && b <= d);
    EXPECT_EQ(answers[2], below(c, a) && below(b, d));
    EXPECT_EQ(answers[3], a <= c && b <= d);
    EXPECT_EQ(answers[4], below(a, c) && below(b, d));
    EXPECT_EQ(answers[5], !s.lower && !s.upper);
    for (int i = 0; i < 6; ++i) yes[i] += answers[i] ? 1 : 0;
  }
  for (const long n : yes) EXPECT_GT(n, 50 * support::effort() / 2);
  const ball u = ball::undefined(64);
  const ball x(1, 64);
  for (const auto& [v, w] : {std::pair{u, x}, std::pair{x, u}, std::pair{u, u}}) {
    EXPECT_FALSE(is_equal(v, w));
    EXPECT_FALSE(is_subset(v, w));
    EXPECT_FALSE(is_interior(v, w));
    EXPECT_FALSE(ends_less_equal(v, w));
    EXPECT_FALSE(ends_less(v, w));
  }
  EXPECT_FALSE(is_entire(u));
}

TEST(Contains, TakesEveryMachineInteger) {
  const ball x = ball(-1, 64);
  EXPECT_FALSE(contains(x, 0));
  EXPECT_TRUE(contains(x, -1));
  EXPECT_TRUE(contains(x, -1L));
  EXPECT_TRUE(contains(x, static_cast<short>(-1)));
  EXPECT_FALSE(contains(x, ~0UL)) << "2^64 - 1 is not -1";
  EXPECT_TRUE(contains(ball(~0UL, 64), ~0UL));
  EXPECT_TRUE(contains(ball(rational(1, 3), 64), rational(1, 3)));
}

// A result beyond MPFR's greatest exponent is not bounded, but its sign is kept where the operands
// are exact or wide. (The error of a product of thin balls there exceeds every number too, so that
// nothing is known of it.)
TEST(Overflow, KeepsTheSign) {
  const long top = mpfr_get_emax() - 100;
  real m(64);
  mpfr_set_ui_2exp(m, 3, top, MPFR_RNDN);
  const ball small = scale(ball(1, 64), -1000);
  for (const magnitude& radius : {magnitude{}, magnitude::power_of_two(top - 3)}) {
    const ball x = ball::from_midpoint_radius(m, radius);
    for (const ball& y : {x * x, square(x), pow(x, 3L), x * x * x, exp(x), x / small, scale(x, 999),
                          x * (1L << 62) * (1L << 62), cosh(x), exp2(x), exp10(x), pow(x, x)}) {
      EXPECT_TRUE(certainly_greater(y, 1L << 60)) << described(x) << y;
      EXPECT_FALSE(y.is_bounded());
      EXPECT_TRUE(certainly_less(-y, -(1L << 60)));
    }
    for (const ball& y : {x * -x, pow(-x, 3L), -x / small, sinh(-x)}) {
      EXPECT_TRUE(certainly_less(y, -(1L << 60))) << described(x) << y;
      EXPECT_FALSE(y.is_bounded());
    }
  }
  // The lower bound leaves room for the error below the greatest number.
  real greatest(64);
  mpfr_set_inf(greatest, 1);
  mpfr_nextbelow(greatest);
  const ball y = ball::from_midpoint_radius(greatest, magnitude::power_of_two(top + 70));
  const ball sum = y + y;
  real lower(64);
  sum.lower(lower);
  real least(200);
  mpfr_set_ui_2exp(least, 1, top + 71, MPFR_RNDN);
  mpfr_sub(least, greatest, least, MPFR_RNDU);
  EXPECT_TRUE(mpfr_lessequal_p(lower, least) != 0);
  EXPECT_TRUE(mpfr_sgn(lower.get()) > 0);
}

}  // namespace interval_test
}  // namespace polhode
