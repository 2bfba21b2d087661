// Real numbers of which every digit can be had.

#include <stdexcept>

#include <gtest/gtest.h>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/exact_real.hpp"
#include "support/random.hpp"

namespace polhode {
namespace exact_real_test {

exact_real root_of(const rational& q) {
  return exact_real::irrational([q](precision p) { return sqrt(ball(q, p)); }, 64);
}

bool is_narrow(const ball& x, long bits) {
  return x.is_bounded() && x.radius() <= scale(x.magnitude_lower(), -bits);
}

TEST(ExactReal, OfRationalNumbersIsRational) {
  const exact_real x(rational(2, 3));
  const exact_real sum = (x + 1) * 3 - x / 2;
  EXPECT_EQ(sum.as_rational(), rational(14, 3));
  EXPECT_EQ(sum.exact(), rational(14, 3));
  EXPECT_TRUE(sum == rational(14, 3));
  EXPECT_EQ(sum.sign(), 1);
  EXPECT_EQ((-x).sign(), -1);
  EXPECT_EQ((x - x).sign(), 0);
  EXPECT_TRUE(x < 1 && x > 0 && x <= x);
  EXPECT_THROW((void)(x / exact_real(0)), std::domain_error);
  EXPECT_EQ(to_text(x), "2/3");
}

TEST(ExactReal, KeepsItsDigitsWhereNumbersCancel) {
  const exact_real root = root_of(2);
  // (sqrt 2 + 1)^n (sqrt 2 - 1)^n = 1, and sqrt 2 less its convergents.
  exact_real below = 1;
  exact_real above = 1;
  for (int n = 0; n < 12; ++n) {
    below = below * (root - 1);
    above = above * (root + 1);
  }
  const ball one = (below * above).at(300);
  EXPECT_TRUE(contains(one, 1) && is_narrow(one, 299));
  rational convergent(1);
  for (int n = 1; n < 60; ++n) {
    convergent = 1 + 1 / (1 + convergent);
    const exact_real gap = root - convergent;
    EXPECT_EQ(gap.sign(), n % 2 == 0 ? 1 : -1);
    EXPECT_TRUE(is_narrow(gap.at(200), 199));
    // (sqrt 2 - q)(sqrt 2 + q) = 2 - q^2
    EXPECT_TRUE(contains((gap * (root + convergent)).at(200), 2 - convergent * convergent));
  }
  EXPECT_FALSE(root == rational(7, 5));
  EXPECT_TRUE(root > rational(7, 5) && root < rational(3, 2));
  EXPECT_TRUE(root < root_of(3));
}

TEST(ExactReal, DoesNotDecideWhatIsNoNumberOfItsKind) {
  const exact_real zero = root_of(2) - root_of(2);
  EXPECT_FALSE(zero.at(64).is_bounded());
  EXPECT_THROW((void)zero.sign(), std::domain_error);
  EXPECT_THROW((void)root_of(2).exact(), std::logic_error);
  EXPECT_EQ((0 * root_of(2)).as_rational(), rational(0));
  EXPECT_EQ((0 / root_of(2)).as_rational(), rational(0));
}

TEST(ExactReal, BesideABallHoldsTheResults) {
  const exact_real root = root_of(2);
  const ball y = ball(rational(3, 7), 200);
  const ball right = sqrt(ball(2, 400));
  EXPECT_TRUE(overlaps(root * y, right * rational(3, 7)) && overlaps(y * root, root * y));
  EXPECT_TRUE(overlaps(root + y, right + rational(3, 7)) && overlaps(y + root, root + y));
  EXPECT_TRUE(overlaps(root - y, right - rational(3, 7)) && overlaps(y - root, -(root - y)));
  EXPECT_TRUE(overlaps(root / y, right * rational(7, 3)) && overlaps(y / root, 1 / (root / y)));
}

TEST(ExactReal, HasShortRationalNumbersBelow) {
  support::random_source random(390);
  for (support::repeat trial(300); trial.again();) {
    const rational square(random.between(2, 1'000'000), random.between(1, 1'000'000));
    const rational scaled(random.one_in(2) ? square
                                           : rational(square * square * square / 1'000'000));
    const integer n = numerator(scaled) * denominator(scaled);
    if (sqrt(n) * sqrt(n) == n) continue;
    for (const exact_real& x : {root_of(scaled), -root_of(scaled)}) {
      const rational below = rational_below(x, 12);
      EXPECT_TRUE(below < x);
      const ball gap = (x - below).at(64);
      EXPECT_TRUE(certainly_less(gap, abs(x.at(64)) / 2048)) << to_text(x);
      EXPECT_LE(msb(integer(abs(numerator(below)))) - lsb(integer(abs(numerator(below)))), 12U);
    }
  }
  EXPECT_EQ(rational_below(rational(1, 3), 12), rational(1, 3));
}

}  // namespace exact_real_test
}  // namespace polhode
