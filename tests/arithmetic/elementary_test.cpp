// The inclusion principle for functions that rationals cannot follow: MPFR, 200 bits and more
// beyond the result's precision, encloses f at an exact member, and the enclosure must lie in the
// result.

#include <algorithm>
#include <array>

#include <gtest/gtest.h>

#include "polhode/arithmetic/ball.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "support/exact_set.hpp"
#include "support/functions.hpp"
#include "support/random.hpp"

namespace polhode {
namespace elementary_test {

using support::described;
using support::elementary_function;
using support::elementary_functions;
using support::enclosure;
using support::exact;
using support::exact_set;
using support::holds;
using support::identical;
using support::kind;
using support::random_source;
using support::real;
using support::repeat;

constexpr precision further = 200;

::testing::AssertionResult holds_all(const ball& x, const enclosure& e) {
  if (!e.lower.is_finite() || !e.upper.is_finite()) {
    return ::testing::AssertionFailure() << "the oracle overflowed";
  }
  const auto low = holds(x, support::to_rational(e.lower));
  return low ? holds(x, support::to_rational(e.upper)) : low;
}

/// A ball that f is likely to be defined on, where it has a bounded domain.
ball likely_operand(random_source& random, const elementary_function& f, precision p) {
  ball x = random.any_ball(p);
  for (int attempt = 0; attempt < 4 && !f.defined_on(exact(x)); ++attempt) {
    if (x.is_bounded() && !x.magnitude_upper().is_zero()) {
      // Into the unit interval, or on to the positive axis.
      const long exponent = static_cast<long>(x.magnitude_upper().log2_floor()) + 1;
      x = attempt % 2 == 0 ? scale(x, -exponent) : abs(x);
      if (attempt == 3) x = x + 1;
    } else {
      x = random.any_ball(p);
    }
  }
  return x;
}

class Elementary : public ::testing::TestWithParam<elementary_function> {};

TEST_P(Elementary, HoldsTheValueAtEveryMember) {
  const elementary_function& f = GetParam();
  random_source random(100);
  long defined = 0;
  for (repeat trial(1200); trial.again();) {
    const precision p = random.any_precision();
    const ball x = likely_operand(random, f, p);
    SCOPED_TRACE(described(x));
    const ball y = f.of(x);
    EXPECT_EQ(y.precision(), p);

    ball r = random.used_ball();
    f.in_place(r, x);
    EXPECT_TRUE(identical(r, y)) << "two addresses";
    r = x;
    f.in_place(r, r);
    EXPECT_TRUE(identical(r, y)) << "one address";

    const exact_set s = exact(x);
    if (!f.defined_on(s)) {
      EXPECT_TRUE(y.is_undefined());
      continue;
    }
    if (y.is_undefined()) {
      // Only where the ends of a ball by midpoint and radius, rounded, touch the domain's end.
      EXPECT_FALSE(x.is_exact());
      EXPECT_FALSE(f.defined_on(exact(x.enlarged(scale(x.radius(), -16)).with_precision(p))))
          << "why?";
      continue;
    }
    ++defined;
    // The oracle's two ends must lie closer together than y's: sinpi and cospi near an exact +-1
    // are narrower than the last place.
    precision enough = p + further;
    if (y.is_bounded() && !y.is_exact() && y.magnitude_lower() > magnitude{}) {
      enough += std::max<long>(y.magnitude_upper().log2_floor() - y.radius().log2_floor() - p, 0);
    }
    for (int i = 0; i < 3; ++i) {
      const rational a = random.member(s);
      if (f.grows && abs(a) > support::power_of_two(12)) continue;
      EXPECT_TRUE(holds_all(y, value_at(f, a, enough))) << f.name << " at " << described(a);
    }
  }
  EXPECT_GT(defined, 100 * support::effort() / 2);
}

TEST_P(Elementary, OfAnExactNumberIsWithinHalfAUnit) {
  const elementary_function& f = GetParam();
  random_source random(101);
  for (repeat trial(300); trial.again();) {
    const precision p = random.between(32, 300);
    ball x(random.any_real(p, -30, 6).get());
    if (!f.defined_on(exact(x))) x = scale(abs(x), -6);
    if (!f.defined_on(exact(x))) x = (x + 1).middle();
    SCOPED_TRACE(described(x));
    const ball y = f.of(x);
    ASSERT_FALSE(y.is_undefined());
    const rational size = exact(y).greatest_size();
    EXPECT_LE(support::to_rational(y.radius()), support::ulp(size, p) * rational(33, 64));
  }
}

INSTANTIATE_TEST_SUITE_P(Functions, Elementary, ::testing::ValuesIn(elementary_functions()),
                         [](const auto& tested) { return std::string(tested.param.name); });

TEST(Elementary, SineAndCosineTogether) {
  random_source random(102);
  for (repeat trial(2000); trial.again();) {
    const ball x = random.any_ball();
    SCOPED_TRACE(described(x));
    const auto [s, c] = sin_cos(x);
    EXPECT_TRUE(identical(s, sin(x)));
    EXPECT_TRUE(identical(c, cos(x)));
    ball one = x;
    ball other = random.used_ball();
    sin_cos(one, other, one);
    EXPECT_TRUE(identical(one, s) && identical(other, c)) << "the sine is the operand";
    other = x;
    one = random.used_ball();
    sin_cos(one, other, other);
    EXPECT_TRUE(identical(one, s) && identical(other, c)) << "the cosine is the operand";
  }
}

TEST(Elementary, ArithmeticGeometricMean) {
  random_source random(103);
  for (repeat trial(1500); trial.again();) {
    ball x = random.any_ball();
    ball y = random.any_ball();
    if (random.one_in(2)) x = abs(x);
    if (random.one_in(2)) y = abs(y);
    SCOPED_TRACE(described(x) + ", " + described(y));
    const precision p = std::max(x.precision(), y.precision());
    const ball r = agm(x, y);
    EXPECT_EQ(r.precision(), p);
    EXPECT_TRUE(identical(r, agm(y, x)));
    ball t = x;
    agm(t, t, y);
    EXPECT_TRUE(identical(t, r)) << "the result is x";
    t = y;
    agm(t, x, t);
    EXPECT_TRUE(identical(t, r)) << "the result is y";
    t = random.used_ball();
    agm(t, x, y);
    EXPECT_TRUE(identical(t, r));
    const exact_set sx = exact(x);
    const exact_set sy = exact(y);
    if (!sx.lower || *sx.lower < 0 || !sy.lower || *sy.lower < 0) {
      EXPECT_TRUE(r.is_undefined());
      continue;
    }
    EXPECT_GE(exact(r).lower.value(), 0);
    for (int i = 0; i < 3; ++i) {
      const real a = support::exact_real(random.member(sx));
      const real b = support::exact_real(random.member(sy));
      EXPECT_TRUE(holds_all(
          r, support::enclose([&](mpfr_ptr v, mpfr_rnd_t rounding) { mpfr_agm(v, a, b, rounding); },
                              p + further)));
    }
    if (x.is_exact() && y.is_exact() && p >= 32) {
      EXPECT_LE(support::to_rational(r.radius()),
                support::ulp(exact(r).greatest_size(), p) * rational(33, 64));
    }
  }
}

TEST(Elementary, ArithmeticGeometricMeanWithZero) {
  const ball zero(0, 64);
  const ball half_line = ball::from_end_points(real(64, 1), real::infinity(1), 64);
  EXPECT_TRUE(identical(agm(zero, zero), zero));
  EXPECT_TRUE(identical(agm(zero, pi(64)), zero));
  EXPECT_TRUE(identical(agm(pi(64), zero), zero));
  EXPECT_TRUE(identical(agm(zero, half_line), zero));
  EXPECT_TRUE(identical(agm(half_line, zero), zero));
  EXPECT_TRUE(agm(zero, ball(-1, 64)).is_undefined());
  EXPECT_TRUE(agm(ball::from_end_points(real(64, -1), real(64, 1), 64), zero).is_undefined());
  const ball wide = ball::from_end_points(real(64, 0), real(64, 1), 64);
  EXPECT_TRUE(identical(agm(wide, wide), wide));
}

TEST(Elementary, PowersOfAndWithUnboundedSets) {
  const ball above = ball::from_end_points(real(64, 3), real::infinity(1), 64);
  const ball below = ball::from_end_points(real::infinity(-1), real(64, -3), 64);
  const ball two(2, 64);
  const auto expect_hull = [](const ball& power, long lower, long upper) {  // 2^-upper .. 2^-lower
    EXPECT_FALSE(power.is_undefined());
    EXPECT_TRUE(possibly_less(power, scale(ball(1, 64), -lower + 1)));
    EXPECT_TRUE(certainly_less(power, scale(ball(9, 64), -lower - 3)));
    EXPECT_TRUE(contains(power, rational(1, integer(1) << static_cast<unsigned>(upper))));
  };
  expect_hull(pow(two, below), 3, 1000);
  expect_hull(pow(two.with_precision(128), -above), 3, 77);
  EXPECT_TRUE(contains(pow(two, above), rational(8)));
  EXPECT_TRUE(contains(pow(two, above), rational(integer(1) << 5000U)));
  EXPECT_TRUE(certainly_less(ball(7, 64), pow(two, above)));
  EXPECT_TRUE(contains(pow(above, above), rational(27)));
  EXPECT_TRUE(contains(pow(1 / above, two), rational(1, 9)));
  EXPECT_TRUE(pow(below, above).is_undefined());
  EXPECT_TRUE(pow(ball(0, 64), above).is_undefined());
}

TEST(Elementary, Constants) {
  random_source random(104);
  for (repeat trial(300); trial.again();) {
    const precision p = random.any_precision();
    const auto check = [&](const ball& x, int (*f)(mpfr_ptr, mpfr_rnd_t)) {
      EXPECT_EQ(x.precision(), p);
      EXPECT_TRUE(holds_all(x, support::enclose(f, p + further)));
      if (p >= 32) {
        EXPECT_LE(support::to_rational(x.radius()),
                  support::ulp(exact(x).greatest_size(), p) * rational(33, 64));
      }
    };
    check(pi(p), mpfr_const_pi);
    check(log_2(p), mpfr_const_log2);
  }
}

// Routes that share no formula: identities between the functions, as sets.
TEST(Elementary, Identities) {
  random_source random(105);
  for (repeat trial(500); trial.again();) {
    const precision p = random.any_precision();
    const ball x =
        random.any_ball(p, random.choose(std::array{kind::exact, kind::thin, kind::wide}));
    const ball y = scale(x, -5);
    SCOPED_TRACE(described(x));
    const auto [s, c] = sin_cos(y);
    EXPECT_TRUE(holds(square(s) + square(c), 1));
    EXPECT_TRUE(holds(square(cosh(y)) - square(sinh(y)), 1));
    EXPECT_TRUE(overlaps(log(exp(y)), y));
    EXPECT_TRUE(overlaps(exp(log(abs(x))), abs(x)));
    EXPECT_TRUE(overlaps(asinh(sinh(y)), y));
    EXPECT_TRUE(overlaps(atanh(tanh(y)), y));
    EXPECT_TRUE(overlaps(tan(atan(x)), x));
    EXPECT_TRUE(overlaps(scale(asin(tanh(x)) + acos(tanh(x)), 1), pi(p + 50)));
    EXPECT_TRUE(overlaps(acosh(cosh(y)), abs(y)));
    EXPECT_TRUE(overlaps(agm(x, x), x));
    EXPECT_TRUE(overlaps(hypot(x, x), sqrt(ball(2, p)) * abs(x)));
  }
}

}  // namespace elementary_test
}  // namespace polhode
