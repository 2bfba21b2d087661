#include "polhode/real/number.hpp"

#include <gtest/gtest.h>

#include <unordered_set>

#include <fmt/format.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include "polhode/arithmetic/format.hpp"
#include "polhode/arithmetic/interval.hpp"
#include "polhode/real/ball_traits.hpp"
#include "support/random.hpp"

namespace polhode {
namespace number_test {

namespace mp = boost::multiprecision;
using et_off_50 = mp::number<mp::mpfr_float_backend<50>, mp::et_off>;

template <class Real>
class RealNumbers : public testing::Test {};
using reals = testing::Types<double, long double, mp::mpfr_float_50, et_off_50, mp::mpfr_float,
                             mp::cpp_bin_float_50, mp::cpp_bin_float_quad>;
TYPED_TEST_SUITE(RealNumbers, reals);

TYPED_TEST(RealNumbers, BoundsOfABallHoldIt) {
  using Real = TypeParam;
  for (const char* text : {"0.1", "-1/3", "1e-30", "-7e25", "0", "1",
                           "123456789012345678901234567890123456789012345678901234567890"}) {
    const rational q = parse_rational(text);
    const ball x(q, 400);
    const Real lower = lower_as<Real>(x);
    const Real upper = upper_as<Real>(x);
    const Real near = nearest_as<Real>(x);
    const auto exactly = [](const Real& y) { return lower_rational(ball_of(y)); };
    EXPECT_LE(exactly(lower), q) << text;
    EXPECT_GE(exactly(upper), q) << text;
    EXPECT_LE(lower, near);
    EXPECT_LE(near, upper);
    // And no wider than two units in the last place.
    const rational width = exactly(upper) - exactly(lower);
    const rational size = q < 0 ? rational(-q) : q;
    rational unit = size;
    mpq_div_2exp(unit.backend().data(), unit.backend().data(),
                 static_cast<mp_bitcnt_t>(usual_bits<Real>() - 2));
    EXPECT_LE(width, unit) << text;
  }
}

// In exact rationals: lower_as(x) <= x <= upper_as(x) for random balls x, with and without width,
// whose exponents go far beyond the type's own range; and where they lie within it, each bound is
// within two units in the last place of the ball's.
TYPED_TEST(RealNumbers, BoundsHoldForExponentsUpToAMillion) {
  using Real = TypeParam;
  using limits = std::numeric_limits<Real>;
  constexpr long most_exponent = 1'000'000;
  constexpr int count = 400;
  support::random_source random(20);
  const precision bits = usual_bits<Real>();
  const auto power = [](long e) {
    rational q = 1;
    if (e < 0) mpq_div_2exp(q.backend().data(), q.backend().data(), static_cast<mp_bitcnt_t>(-e));
    if (e >= 0) mpq_mul_2exp(q.backend().data(), q.backend().data(), static_cast<mp_bitcnt_t>(e));
    return q;
  };
  const auto is_finite = [](const Real& y) { return (y - y) == 0; };
  int inside = 0;
  for (int i = 0; i < count; ++i) {
    // A third near 1, a third over the range of a double, a third over all exponents.
    const long span = i % 3 == 0 ? 70 : i % 3 == 1 ? 1'100 : most_exponent;
    const long exponent = random.between(-span, span);
    const rational mantissa(random.between(-(1L << 60), 1L << 60), 1L << 60);
    const rational middle = mantissa * power(exponent);
    ball x(middle, 40 + random.between(0, 300));
    if (random.between(0, 1) == 1) {
      const long width = -random.between(0, 400);
      x = x.enlarged(scale(x.magnitude_upper(), width));
    }
    const support::exact_set ends = support::exact(x);
    const rational least = ends.lower.value();
    const rational most = ends.upper.value();
    const Real lower = lower_as<Real>(x);
    const Real upper = upper_as<Real>(x);
    ASSERT_FALSE(lower != lower || upper != upper) << i;
    ASSERT_LE(lower, upper) << i;
    if (is_finite(lower)) {
      ASSERT_LE(lower_rational(ball_of(lower)), least) << i;
    } else {
      ASSERT_LT(lower, 0) << i;
    }
    if (is_finite(upper)) {
      ASSERT_GE(lower_rational(ball_of(upper)), most) << i;
    } else {
      ASSERT_GT(upper, 0) << i;
    }
    // As close as the type can have it.
    constexpr int margin = 4;
    const auto is_inside = [&](const rational& q) {
      const rational size = q < 0 ? rational(-q) : q;
      return size > power(limits::min_exponent + margin + bits) &&
             size < power(limits::max_exponent - margin);
    };
    if constexpr (limits::max_exponent < 2 * most_exponent) {
      if (!is_inside(least) || !is_inside(most)) continue;
    }
    ++inside;
    const auto unit = [&](const rational& q) {
      return rational((q < 0 ? rational(-q) : q) * power(2 - bits));
    };
    ASSERT_LE(rational(least - lower_rational(ball_of(lower))), unit(least)) << i;
    ASSERT_LE(rational(lower_rational(ball_of(upper)) - most), unit(most)) << i;
  }
  EXPECT_GT(inside, count / 3);
}

TYPED_TEST(RealNumbers, AreBallsWithoutWidth) {
  using Real = TypeParam;
  const Real x = Real(5) / 3;
  const ball exact = ball_of(x);
  EXPECT_TRUE(exact.is_exact());
  EXPECT_EQ(nearest_as<Real>(exact, exact.precision()), x);
  EXPECT_EQ(lower_as<Real>(exact, exact.precision()), x);
  EXPECT_EQ(upper_as<Real>(exact, exact.precision()), x);
  EXPECT_TRUE(ball_of(std::numeric_limits<Real>::quiet_NaN()).is_undefined());
  EXPECT_TRUE(ball_of(Real(std::numeric_limits<Real>::infinity())).is_undefined());
  const Real nothing = nearest_as<Real>(ball::undefined(64));
  EXPECT_TRUE(nothing != nothing);
}

TEST(RealNumbersBeyondTheRange, AreBoundedOutward) {
  const ball huge = exp(ball(100000, 64));
  EXPECT_EQ(lower_as<double>(huge), std::numeric_limits<double>::max());
  EXPECT_EQ(upper_as<double>(huge), std::numeric_limits<double>::infinity());
  EXPECT_EQ(lower_as<double>(-huge), -std::numeric_limits<double>::infinity());
  const ball tiny = exp(ball(-100000, 64));
  EXPECT_EQ(lower_as<double>(tiny), 0);
  EXPECT_EQ(upper_as<double>(tiny), std::numeric_limits<double>::denorm_min());
  using quad = mp::cpp_bin_float_quad;  // exponents of 15 bits
  EXPECT_EQ(lower_as<quad>(huge), (std::numeric_limits<quad>::max)());
  EXPECT_EQ(upper_as<quad>(huge), std::numeric_limits<quad>::infinity());
  EXPECT_EQ(upper_as<quad>(-huge), -(std::numeric_limits<quad>::max)());
  EXPECT_EQ(lower_as<quad>(-huge), -std::numeric_limits<quad>::infinity());
  EXPECT_EQ(lower_as<quad>(tiny), 0);
  EXPECT_EQ(upper_as<quad>(tiny), (std::numeric_limits<quad>::min)());
  EXPECT_EQ(lower_as<quad>(-tiny), -(std::numeric_limits<quad>::min)());
}

TEST(BallTraits, SayWhatABallIs) {
  using limits = std::numeric_limits<ball>;
  EXPECT_TRUE(limits::is_specialized);
  EXPECT_FALSE(limits::is_exact);
  EXPECT_EQ(limits::digits, 0);
  EXPECT_TRUE(limits::quiet_NaN().is_undefined());
}

TEST(BallTraits, EqualSetsHaveEqualHashes) {
  struct same {
    bool operator()(const ball& x, const ball& y) const { return is_equal(x, y); }
  };
  std::unordered_set<ball, std::hash<ball>, same> set;
  set.insert(ball(1, 64));
  set.insert(ball(1, 500));  // the same set
  set.insert(ball(rational(1, 3), 64));
  set.insert(hull(ball(1, 64), ball(2, 64)));
  set.insert(ball::undefined(64));
  EXPECT_EQ(set.size(), is_equal(ball::undefined(64), ball::undefined(64)) ? 4U : 4U);
  const std::hash<ball> hash;
  EXPECT_NE(hash(ball(1, 64)), hash(ball(2, 64)));
  EXPECT_NE(hash(ball(1, 64)), hash(hull(ball(1, 64), ball(2, 64))));
  EXPECT_EQ(fmt::format("{:.5}", ball(rational(1, 3), 64)), "0.33333...");
}

}  // namespace number_test
}  // namespace polhode
