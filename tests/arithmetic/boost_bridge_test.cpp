// Between balls and Boost's mpfr_float: bits and values, whatever Boost's defaults are.

#include <limits>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "polhode/arithmetic/ball.hpp"
#include "polhode/arithmetic/boost_bridge.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "support/exact_set.hpp"
#include "support/random.hpp"

namespace polhode {
namespace boost_bridge_test {

using support::described;
using support::exact;
using support::exact_set;
using support::random_source;
using support::real;
using support::repeat;

rational value(const mpfr_float& x) { return support::to_rational(x.backend().data()); }

TEST(BoostBridge, EndsAndMiddle) {
  random_source random(900);
  for (repeat trial(2000); trial.again();) {
    const ball x = random.any_ball();
    SCOPED_TRACE(described(x));
    const mpfr_float low = lower(x);
    const mpfr_float high = upper(x);
    const mpfr_float middle = midpoint(x);
    EXPECT_EQ(precision_of(low), x.precision());
    EXPECT_EQ(precision_of(high), x.precision());
    EXPECT_EQ(precision_of(middle), x.precision());
    EXPECT_EQ(precision_of(x), x.precision());
    const exact_set set = exact(x);
    if (set.lower) {
      EXPECT_LE(value(low), *set.lower);
      EXPECT_LE(*set.lower - value(low), support::ulp(*set.lower, x.precision()));
    } else {
      EXPECT_TRUE(isinf(low) && low < 0);
    }
    if (set.upper) {
      EXPECT_GE(value(high), *set.upper);
      EXPECT_LE(value(high) - *set.upper, support::ulp(*set.upper, x.precision()));
    } else {
      EXPECT_TRUE(isinf(high) && high > 0);
    }
    EXPECT_TRUE(isfinite(middle));
    EXPECT_TRUE(set.holds(value(middle)));
    if (x.is_exact()) {
      EXPECT_EQ(low, high);
      EXPECT_EQ(low, middle);
    }
  }
}

TEST(BoostBridge, UndefinedIsNaN) {
  const ball u = ball::undefined(90);
  EXPECT_TRUE(isnan(lower(u)));
  EXPECT_TRUE(isnan(upper(u)));
  EXPECT_TRUE(isnan(midpoint(u)));
  EXPECT_EQ(precision_of(lower(u)), 90);
}

TEST(BoostBridge, FromBoostExactly) {
  random_source random(901);
  for (repeat trial(1000); trial.again();) {
    const precision p = random.any_precision();
    mpfr_float x = zero_of_precision(p);
    EXPECT_EQ(precision_of(x), p);
    EXPECT_EQ(x, 0);
    const real number = random.any_real(p, -100, 100);
    mpfr_set(x.backend().data(), number, MPFR_RNDN);
    const ball b(x);
    EXPECT_EQ(b.precision(), p);
    EXPECT_TRUE(b.is_exact());
    EXPECT_EQ(exact(b), (exact_set{value(x), value(x)}));
    EXPECT_EQ(midpoint(b), x);
  }
  EXPECT_TRUE(ball(mpfr_float(std::numeric_limits<double>::quiet_NaN())).is_undefined());
  EXPECT_TRUE(ball(mpfr_float(std::numeric_limits<double>::infinity())).is_undefined());
}

TEST(BoostBridge, DefaultsOfTheThreadDoNotMatter) {
  const unsigned before = mpfr_float::thread_default_precision();
  const ball x = pi(777);
  const ball thin = ball(rational(1, 3), 100);
  const mpfr_float low = lower(x);
  for (const unsigned digits : {5U, 50U, 5000U}) {
    mpfr_float::thread_default_precision(digits);
    EXPECT_EQ(precision_of(zero_of_precision(777)), 777);
    EXPECT_EQ(precision_of(lower(x)), 777);
    EXPECT_EQ(precision_of(midpoint(thin)), 100);
    EXPECT_TRUE(mpfr_equal_p(lower(x).backend().data(), low.backend().data()) != 0);
    std::vector<mpfr_float> kept;
    kept.push_back(lower(x));  // moved
    EXPECT_EQ(precision_of(kept.front()), 777);
    EXPECT_TRUE(mpfr_equal_p(kept.front().backend().data(), low.backend().data()) != 0);
  }
  mpfr_float::thread_default_precision(before);
  EXPECT_THROW((void)zero_of_precision(0), std::invalid_argument);
  EXPECT_THROW((void)zero_of_precision(-5), std::invalid_argument);
}

}  // namespace boost_bridge_test
}  // namespace polhode
