// The set operations, and the ways of making and remaking a ball.

#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include <gtest/gtest.h>

#include "polhode/arithmetic/ball.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "support/exact_set.hpp"
#include "support/random.hpp"

namespace polhode {
namespace sets_test {

using support::described;
using support::exact;
using support::exact_set;
using support::holds;
using support::identical;
using support::random_source;
using support::real;
using support::repeat;

TEST(Sets, Hull) {
  random_source random(20);
  for (repeat trial(2000); trial.again();) {
    const ball x = random.any_ball();
    const ball y = random.any_ball();
    SCOPED_TRACE(described(x) + ", " + described(y));
    const ball h = hull(x, y);
    EXPECT_EQ(h.precision(), std::max(x.precision(), y.precision()));
    EXPECT_TRUE(exact(h).holds(exact(x)));
    EXPECT_TRUE(exact(h).holds(exact(y)));
    EXPECT_TRUE(identical(h, hull(y, x)));
    // Each end is an operand's, rounded.
    const rational slack = h.is_bounded() ? rational(exact(h).width() / 256) : rational(0);
    const auto next_to = [&](const std::optional<rational>& end,
                             const std::optional<rational>& other) {
      if (!end || !other) return !end && !other;
      return abs(*end - *other) <= 3 * support::ulp(*other, h.precision()) + slack;
    };
    const exact_set sh = exact(h);
    const exact_set sx = exact(x);
    const exact_set sy = exact(y);
    EXPECT_TRUE(next_to(sh.lower, sx.lower) || next_to(sh.lower, sy.lower));
    EXPECT_TRUE(next_to(sh.upper, sx.upper) || next_to(sh.upper, sy.upper));
  }
}

TEST(Sets, Intersection) {
  random_source random(21);
  long empty = 0;
  for (repeat trial(4000); trial.again();) {
    const ball x = random.any_ball();
    const ball y = random.one_in(3) ? random.inside(x) : random.any_ball();
    SCOPED_TRACE(described(x) + ", " + described(y));
    const ball common = intersection(x, y);
    EXPECT_EQ(common.precision(), std::max(x.precision(), y.precision()));
    const exact_set sx = exact(x);
    const exact_set sy = exact(y);
    const bool disjoint = (sx.upper && sy.lower && *sx.upper < *sy.lower) ||
                          (sy.upper && sx.lower && *sy.upper < *sx.lower);
    if (common.is_undefined()) {
      EXPECT_TRUE(disjoint);
      ++empty;
      continue;
    }
    if (disjoint) continue;
    // The common part lies inside; and nothing beyond each operand but a rounding.
    exact_set part = sx;
    if (sy.lower && (!part.lower || *part.lower < *sy.lower)) part.lower = sy.lower;
    if (sy.upper && (!part.upper || *sy.upper < *part.upper)) part.upper = sy.upper;
    EXPECT_TRUE(exact(common).holds(part));
    // (The ends that a ball by midpoint and radius does not carry are rounded twice.)
    const auto slack = [&](const rational& end) {
      return 3 * support::ulp(end, common.precision()) +
             (part.is_bounded() ? rational(part.width() / 256) : 0);
    };
    if (part.lower) {
      EXPECT_GE(exact(common).lower.value(), *part.lower - slack(*part.lower));
    }
    if (part.upper) {
      EXPECT_LE(exact(common).upper.value(), *part.upper + slack(*part.upper));
    }
  }
  EXPECT_GT(empty, 0);
}

TEST(Sets, WithPrecision) {
  random_source random(22);
  for (repeat trial(4000); trial.again();) {
    const ball x = random.any_ball();
    const precision p = random.any_precision();
    SCOPED_TRACE(described(x) + " to " + std::to_string(p));
    const ball r = x.with_precision(p);
    EXPECT_EQ(r.precision(), p);
    EXPECT_TRUE(exact(r).holds(exact(x)));
    if (p >= x.precision() && x.is_exact()) {
      EXPECT_EQ(exact(r), exact(x)) << "no bit was lost";
    }
  }
}

TEST(Sets, Enlarged) {
  random_source random(23);
  for (repeat trial(4000); trial.again();) {
    const ball x = random.any_ball();
    const magnitude error = random.any_magnitude(-300, 30);
    SCOPED_TRACE(described(x));
    const ball r = x.enlarged(error);
    EXPECT_EQ(r.precision(), x.precision());
    exact_set grown = exact(x);
    const rational e = support::to_rational(error);
    if (grown.lower) grown.lower = *grown.lower - e;
    if (grown.upper) grown.upper = *grown.upper + e;
    EXPECT_TRUE(exact(r).holds(grown));
    EXPECT_TRUE(identical(x.enlarged({}), x));
    const exact_set all = exact(x.enlarged(magnitude::infinity()));
    EXPECT_FALSE(all.lower || all.upper);
  }
}

TEST(Sets, EndPointsAreRoundedOutward) {
  random_source random(24);
  for (repeat trial(3000); trial.again();) {
    const precision fine = random.any_precision();
    const precision p = random.any_precision();
    real a = random.any_real(fine, -40, 40);
    real b = random.any_real(fine, -40, 40);
    if (mpfr_greater_p(a, b) != 0) std::swap(a, b);
    const ball x = ball::from_end_points(a, b, p);
    EXPECT_EQ(x.precision(), p);
    EXPECT_TRUE(exact(x).holds(exact_set{support::to_rational(a), support::to_rational(b)}));
  }
}

TEST(Sets, EndPointsMustBeInOrder) {
  const real one(64, 1);
  const real two(64, 2);
  const real up = real::infinity(1);
  const real down = real::infinity(-1);
  EXPECT_THROW((void)ball::from_end_points(two, one, 64), std::invalid_argument);
  EXPECT_THROW((void)ball::from_end_points(real::nan(), one, 64), std::invalid_argument);
  EXPECT_THROW((void)ball::from_end_points(one, real::nan(), 64), std::invalid_argument);
  EXPECT_THROW((void)ball::from_end_points(up, up, 64), std::invalid_argument);
  EXPECT_THROW((void)ball::from_end_points(down, down, 64), std::invalid_argument);
  EXPECT_THROW((void)ball::from_end_points(one, down, 64), std::invalid_argument);
  EXPECT_FALSE(ball::from_end_points(down, up, 64).is_bounded());
  EXPECT_FALSE(ball::from_end_points(down, one, 64).is_bounded());
  EXPECT_TRUE(ball::from_end_points(one, one, 64).is_exact());
}

TEST(Sets, PrecisionsAreChecked) {
  const real one(64, 1);
  for (const precision bad :
       {precision{-1}, precision{0}, precision{1}, greatest_precision + 1,
        std::numeric_limits<precision>::max(), std::numeric_limits<precision>::min()}) {
    EXPECT_THROW((void)ball(1, bad), std::invalid_argument);
    EXPECT_THROW((void)ball(1U, bad), std::invalid_argument);
    EXPECT_THROW((void)ball(rational(1, 3), bad), std::invalid_argument);
    EXPECT_THROW((void)ball(integer(1), bad), std::invalid_argument);
    EXPECT_THROW((void)ball::exactly(1.0, bad), std::invalid_argument);
    EXPECT_THROW((void)ball::undefined(bad), std::invalid_argument);
    EXPECT_THROW((void)ball::entire(bad), std::invalid_argument);
    EXPECT_THROW((void)ball::from_end_points(one, one, bad), std::invalid_argument);
    EXPECT_THROW((void)ball(1, 64).with_precision(bad), std::invalid_argument);
    EXPECT_THROW((void)pi(bad), std::invalid_argument);
    EXPECT_THROW((void)log_2(bad), std::invalid_argument);
    EXPECT_THROW((void)parse_ball("1", bad), std::invalid_argument);
  }
  EXPECT_EQ(ball(1, 2).precision(), 2);
}

TEST(Sets, OneBitNumbersOfMpfrAreTakenToTheLeastPrecision) {
  const real one(1, 1);
  const ball x((mpfr_srcptr(one)));
  EXPECT_EQ(x.precision(), least_precision);
  EXPECT_TRUE(holds(x, 1));
  EXPECT_TRUE(x.is_exact());
}

TEST(Sets, FromMidpointAndRadius) {
  random_source random(25);
  for (repeat trial(3000); trial.again();) {
    const precision p = random.any_precision();
    const real m = random.any_real(p, -50, 50);
    const magnitude radius = random.any_magnitude(-200, 40);
    const ball x = ball::from_midpoint_radius(m, radius);
    SCOPED_TRACE(described(x));
    const rational middle = support::to_rational(m);
    const rational r = support::to_rational(radius);
    EXPECT_TRUE(holds(x, middle - r));
    EXPECT_TRUE(holds(x, middle + r));
    EXPECT_EQ(x.is_exact(), radius.is_zero());
  }
  const real one(64, 1);
  EXPECT_TRUE(ball::from_midpoint_radius(real::nan(), {}).is_undefined());
  EXPECT_TRUE(ball::from_midpoint_radius(real::infinity(1), {}).is_undefined());
  EXPECT_FALSE(ball::from_midpoint_radius(one, magnitude::infinity()).is_bounded());
  EXPECT_FALSE(ball::from_midpoint_radius(one, magnitude::infinity()).is_undefined());
}

TEST(Sets, FromNumbersThatAreNone) {
  EXPECT_TRUE(ball((mpfr_srcptr(real::nan()))).is_undefined());
  EXPECT_TRUE(ball((mpfr_srcptr(real::infinity(1)))).is_undefined());
  EXPECT_TRUE(ball::exactly(std::nan("")).is_undefined());
  EXPECT_TRUE(ball::exactly(-HUGE_VAL).is_undefined());
  EXPECT_TRUE(holds(ball::exactly(0.1), rational(0.1)));
  EXPECT_TRUE(ball::exactly(5e-324).is_exact());
  EXPECT_EQ(ball::exactly(0.1, 2).precision(), 53) << "53 bits or more: the value is exact";
  EXPECT_EQ(ball::exactly(0.1, 100).precision(), 100);
}

TEST(Sets, Queries) {
  random_source random(26);
  for (repeat trial(3000); trial.again();) {
    const ball x = random.any_ball();
    SCOPED_TRACE(described(x));
    const exact_set s = exact(x);
    EXPECT_EQ(x.is_bounded(), s.is_bounded());
    EXPECT_EQ(x.is_exact(), s.is_bounded() && s.width() == 0);
    EXPECT_EQ(contains_zero(x), s.holds(0));

    // Ends at another precision: outward, and not by more than a unit in the last place.
    const precision p = random.any_precision();
    real end(p);
    x.lower(end);
    if (s.lower) {
      EXPECT_LE(support::to_rational(end), *s.lower);
      EXPECT_LE(*s.lower - support::to_rational(end), support::ulp(*s.lower, p));
    } else {
      EXPECT_TRUE(mpfr_inf_p(end.get()) != 0);
    }
    x.upper(end);
    if (s.upper) {
      EXPECT_GE(support::to_rational(end), *s.upper);
      EXPECT_LE(support::to_rational(end) - *s.upper, support::ulp(*s.upper, p));
    }

    if (!s.is_bounded()) {
      EXPECT_TRUE(x.radius().is_infinite());
      EXPECT_TRUE(x.middle().is_undefined());
      EXPECT_TRUE(x.magnitude_upper().is_infinite());
      continue;
    }
    real middle(x.precision());
    x.midpoint(middle);
    const rational m = support::to_rational(middle);
    EXPECT_TRUE(s.holds(m));
    EXPECT_TRUE(identical(x.middle(), ball(middle.get())));
    const rational r = support::to_rational(x.radius());
    EXPECT_LE(m - r, *s.lower);
    EXPECT_GE(m + r, *s.upper);
    // The radius is not much more than half the width.
    EXPECT_LE(r, s.width() / 2 * (1 + support::power_of_two(-28)) +
                     support::ulp(s.greatest_size(), x.precision()));

    const rational most = s.greatest_size();
    const rational least = s.holds(0) ? rational(0) : std::min(abs(*s.lower), abs(*s.upper));
    const rational slack = most * support::power_of_two(-28);
    EXPECT_GE(support::to_rational(x.magnitude_upper()), most);
    EXPECT_LE(support::to_rational(x.magnitude_upper()), most + slack);
    EXPECT_LE(support::to_rational(x.magnitude_lower()), least);
    EXPECT_GE(support::to_rational(x.magnitude_lower()), least - slack);
  }
}

TEST(Sets, UndefinedSpreadsAndAnswersPossibly) {
  const ball u = ball::undefined(100);
  const ball x(1, 64);
  EXPECT_EQ(u.precision(), 100);
  EXPECT_FALSE(u.is_bounded());
  EXPECT_FALSE(u.is_exact());
  EXPECT_TRUE(u.radius().is_infinite());
  EXPECT_TRUE(u.magnitude_upper().is_infinite());
  EXPECT_TRUE(u.magnitude_lower().is_zero());
  real end(64);
  u.lower(end);
  EXPECT_TRUE(mpfr_nan_p(end.get()) != 0);
  u.upper(end);
  EXPECT_TRUE(mpfr_nan_p(end.get()) != 0);

  const rational half(1, 2);
  for (const ball& r : {u + x,
                        x + u,
                        u - x,
                        x - u,
                        u * x,
                        x * u,
                        u / x,
                        x / u,
                        u + 1,
                        1 - u,
                        u * 0,
                        u / 3,
                        u / 0,
                        -u,
                        u + half,
                        u * half,
                        half / u,
                        u + 7UL,
                        square(u),
                        sqrt(u),
                        scale(u, 3),
                        abs(u),
                        pow(u, 0),
                        pow(u, 1),
                        pow(u, 2),
                        pow(u, 3),
                        pow(u, -2),
                        hypot(u, x),
                        hypot(x, u),
                        exp(u),
                        log(u),
                        sin(u),
                        cos(u),
                        tan(u),
                        asin(u),
                        acos(u),
                        atan(u),
                        sinh(u),
                        cosh(u),
                        tanh(u),
                        asinh(u),
                        acosh(u),
                        atanh(u),
                        agm(u, x),
                        agm(x, u),
                        agm(u, ball(0, 64)),
                        hull(u, x),
                        hull(x, u),
                        intersection(u, x),
                        intersection(x, u),
                        u.middle(),
                        u.enlarged(magnitude::power_of_two(0)),
                        sin_cos(u).first,
                        sin_cos(u).second}) {
    EXPECT_TRUE(r.is_undefined());
    EXPECT_EQ(r.precision(), 100);
  }
  EXPECT_TRUE(u.with_precision(70).is_undefined());
  EXPECT_EQ(u.with_precision(70).precision(), 70);

  for (const auto& [a, b] : {std::pair{u, x}, std::pair{x, u}, std::pair{u, u}}) {
    EXPECT_FALSE(certainly_less(a, b));
    EXPECT_FALSE(certainly_less_equal(a, b));
    EXPECT_TRUE(possibly_less(a, b));
    EXPECT_TRUE(overlaps(a, b));
    EXPECT_FALSE(contains(a, b));
  }
  EXPECT_FALSE(certainly_less(u, 5L));
  EXPECT_FALSE(certainly_greater(u, 5L));
  EXPECT_FALSE(contains(u, 5L));
  EXPECT_FALSE(contains(u, half));
  EXPECT_FALSE(certainly_positive(u));
  EXPECT_FALSE(certainly_negative(u));
  EXPECT_EQ(sign_of(u), certain_sign::unknown);
}

}  // namespace sets_test
}  // namespace polhode
