// The errors of operations on thin balls, which are counted in 30 bits, against the corners of
// their operands, exactly. Midpoints are such that results are exact, or nearly so: what holds the
// corners is then the error of the operands alone.

#include <array>

#include <gtest/gtest.h>

#include "arithmetic/functions/elementary/carrying.hpp"
#include "polhode/arithmetic/complex_ball.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "support/exact_set.hpp"
#include "support/random.hpp"

namespace polhode {
namespace rounding_errors_test {

using support::random_source;
using support::repeat;

struct thin {
  ball set;
  rational middle, radius;
};

/// A midpoint of some 45 bits, often just below what 30 bits would make of it, and a radius from
/// the greatest that a thin ball has down to far below it, or 0.
thin any_thin(random_source& random, precision p) {
  const long more = random.between(1, 15);
  integer m = (integer(1) << 29U) + integer(random.between(0, (1L << 29) - 1));
  m <<= static_cast<unsigned>(more);
  if (random.one_in(2)) m += (integer(1) << static_cast<unsigned>(more)) - 1;
  const rational middle = rational(m) * support::power_of_two(random.between(-60, 20));
  const support::real value(p, random.one_in(2) ? middle : rational(-middle), MPFR_RNDN);
  magnitude radius;
  if (!random.one_in(5)) {
    const long below = random.one_in(2) ? 24 : random.between(24, 140);
    const long e = static_cast<long>(mpfr_get_exp(value)) - below - 30;
    radius = magnitude::from_bits_up((1U << 29) + (random.bits() >> 35), e);
  }
  const ball set = ball::from_midpoint_radius(value, radius);
  const support::exact_set ends = support::exact(set);
  const rational low = *ends.lower;
  const rational high = *ends.upper;
  return {set, rational((low + high) / 2), rational((high - low) / 2)};
}

::testing::AssertionResult holds(const ball& x, const rational& q) {
  const support::exact_set set = support::exact(x);
  if (*set.lower <= q && q <= *set.upper) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << support::described(x) << " excludes " << q;
}

constexpr std::array signs{-1, 1};

TEST(RoundingErrors, OfThinBallsHoldTheCorners) {
  random_source random(77);
  for (repeat trial(6000); trial.again();) {
    const precision p = random.one_in(2) ? 128 : random.between(50, 200);
    const thin x = any_thin(random, p);
    const thin y = any_thin(random, p);
    const thin z = any_thin(random, p);
    const ball sum = x.set + y.set;
    const ball product = x.set * y.set;
    const ball quotient = x.set / y.set;
    ball fused;
    fma(fused, x.set, y.set, z.set);
    const long n = random.between(1, 1000);
    const ball multiple = x.set * n;
    const ball part = x.set / n;
    const ball squared = square(x.set);
    const ball cubed = pow(x.set, 3);
    for (const int s : signs) {
      const rational a = x.middle + s * x.radius;
      EXPECT_TRUE(holds(multiple, rational(a * n)));
      EXPECT_TRUE(holds(part, rational(a / n)));
      EXPECT_TRUE(holds(squared, rational(a * a)));
      EXPECT_TRUE(holds(cubed, rational(a * a * a)));
      for (const int t : signs) {
        const rational b = y.middle + t * y.radius;
        EXPECT_TRUE(holds(sum, rational(a + b)));
        EXPECT_TRUE(holds(product, rational(a * b)));
        EXPECT_TRUE(holds(quotient, rational(a / b)));
        for (const int u : signs) {
          EXPECT_TRUE(holds(fused, rational(a * b + z.middle + u * z.radius)));
        }
      }
    }
  }
}

// Of the root the squares of the ends are compared; that of a square is exact.
TEST(RoundingErrors, OfRootsHoldTheEnds) {
  random_source random(78);
  for (repeat trial(6000); trial.again();) {
    const precision p = random.one_in(3) ? random.between(2, 31) : random.between(32, 200);
    support::real middle = random.any_real(random.one_in(3) ? p : p / 2, -20, 20);
    if (mpfr_get_prec(middle) == p / 2) {
      support::real squared(p);
      mpfr_sqr(squared, middle, MPFR_RNDN);
      middle = squared;
    }
    mpfr_abs(middle, middle, MPFR_RNDN);
    const long below = random.one_in(2) ? 24 : random.between(24, 140);
    const magnitude radius = magnitude::from_bits_up(
        (1U << 29) + (random.bits() >> 35), static_cast<long>(mpfr_get_exp(middle)) - below - 30);
    const ball set = ball::from_midpoint_radius(middle, radius);
    const support::exact_set ends = support::exact(set);
    const support::exact_set root = support::exact(sqrt(set));
    EXPECT_LE(*root.lower * *root.lower, *ends.lower);
    EXPECT_GE(*root.upper * *root.upper, *ends.upper);
  }
}

// 1 + 7/8 of half a unit in the last place is rounded to 1, of whose neighbours the lower one is
// nearer.
TEST(RoundingErrors, OfSumsThatAreRoundedToOneHoldThem) {
  for (precision p = 3; p <= 200; ++p) {
    const rational little = rational(7, 8) * support::power_of_two(-p);
    const ball sum = ball(1, p) + ball(little, p);
    EXPECT_TRUE(holds(sum, rational(1 + little))) << p;
  }
}

TEST(RoundingErrors, OfComplexProductsHoldTheCorners) {
  random_source random(79);
  for (repeat trial(2000); trial.again();) {
    const precision p = random.one_in(2) ? 160 : random.between(50, 200);
    const thin a = any_thin(random, p);
    const thin b = any_thin(random, p);
    const thin c = any_thin(random, p);
    const thin d = any_thin(random, p);
    const complex_ball product = complex_ball(a.set, b.set) * complex_ball(c.set, d.set);
    const complex_ball squared = square(complex_ball(a.set, b.set));
    for (int corner = 0; corner < 16; ++corner) {
      const auto end = [&](const thin& x, int bit) {
        return rational((corner >> bit & 1) != 0 ? x.middle + x.radius : x.middle - x.radius);
      };
      const rational x = end(a, 0);
      const rational y = end(b, 1);
      const rational u = end(c, 2);
      const rational v = end(d, 3);
      EXPECT_TRUE(holds(product.re, rational(x * u - y * v)));
      EXPECT_TRUE(holds(product.im, rational(x * v + y * u)));
      EXPECT_TRUE(holds(squared.re, rational(x * x - y * y)));
      EXPECT_TRUE(holds(squared.im, rational(2 * x * y)));
    }
  }
}

/// magnitude as the rational that it is.
rational exact(const magnitude& m) {
  return rational(integer(m.fraction())) * support::power_of_two(m.exponent());
}

TEST(RoundingErrors, OfCofunctionsAreNearlyAttained) {
  random_source random(83);
  for (repeat trial(6000); trial.again();) {
    const precision p = random.one_in(2) ? 53 : random.between(30, 300);
    // 1 - |y| between 2^-1 and 2^-40, or y anywhere.
    const rational rest = rational(1 + random.between(0, 1L << 30), (1L << 30) + 1) *
                          support::power_of_two(-random.between(0, 40));
    support::real y(p,
                    random.one_in(8) ? rational(random.between(1, 1000), 1001) : rational(1 - rest),
                    random.one_in(2) ? MPFR_RNDU : MPFR_RNDD);
    const rational middle = support::exact(ball::from_midpoint_radius(y, {})).lower.value();
    if (random.one_in(2)) mpfr_neg(y, y, MPFR_RNDN);
    // The number that y stands for may be smaller by half a unit of its last place and a little.
    const rational unit = support::power_of_two(mpfr_get_exp(static_cast<mpfr_srcptr>(y)) - p);
    const rational least = middle - unit * rational(513, 1024);
    const rational bound = exact(detail::elementary::cofunction_up(y));
    const rational square = 1 - (least > 0 ? rational(least * least) : rational(0));
    EXPECT_GE(bound * bound, square) << middle << " with " << p << " bits";
    if (p >= 53 && square > support::power_of_two(-20)) {
      EXPECT_LE(bound * bound, square * (1 + support::power_of_two(-26))) << middle;
    }
  }
}

}  // namespace rounding_errors_test
}  // namespace polhode
