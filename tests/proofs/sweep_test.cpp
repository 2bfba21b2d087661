// The sweep over all bodies and motions: its boxes, its bound, its limit, and the integral behind
// it.

#include <gtest/gtest.h>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/rigid_body/phase_integrands.hpp"
#include "proofs/slope_sweep.hpp"
#include "support/random.hpp"
#include "support/reference.hpp"

namespace polhode::proofs {
namespace sweep_test {

using support::meet;

/// W = -u sqrt(b (a + b)) dG/du.
ball slope_of(const oscillating_motion& motion, precision p) {
  return -motion.u * sqrt((motion.b * (motion.a + motion.b)).at(p)) * half_phase_slope(motion, p);
}

oscillating_motion any_motion(support::random_source& random) {
  oscillating_motion motion{rational(random.between(1, 1000), random.between(1, 1000)),
                            rational(random.between(1, 999), 1000),
                            rational(random.between(1, 1000), 1000)};
  if (random.one_in(4)) motion.a = support::power_of_ten(random.between(-40, 40));
  if (random.one_in(4)) motion.b = support::power_of_ten(-random.between(1, 40));
  if (random.one_in(4)) motion.b = 1 - motion.b;
  if (random.one_in(4)) motion.u = support::power_of_ten(-random.between(1, 40));
  return motion;
}

TEST(SlopeEnclosure, HoldsTheSlopeOfAnyMotion) {
  support::random_source random(18);
  for (support::repeat trial(300); trial.again();) {
    const oscillating_motion motion = any_motion(random);
    const sweep_point point = point_of(motion, 64);
    for (const ball* side : {&point.p, &point.r, &point.u}) {
      EXPECT_TRUE(certainly_positive(*side));
      EXPECT_FALSE(certainly_greater(*side, 1));
    }
    const ball w = slope_of(motion, 200);
    EXPECT_TRUE(contains(slope_enclosure(point), w))
        << motion.a << " " << motion.b << " " << motion.u << ": " << slope_enclosure(point) << w;
    EXPECT_FALSE(certainly_less(w, slope_lower_bound(point)));
    EXPECT_TRUE(certainly_less(scale(pi(64), -2) - rational(1, 1000), w)) << "pi/4 is the infimum";
  }
}

TEST(SlopeEnclosure, IsAsNarrowAsItsCells) {
  // Where u is not small: the integrand falls from its greatest value to 0 over 64 cells.
  const oscillating_motion motion{rational(1265, 100), rational(629, 10000), rational(1, 4)};
  EXPECT_TRUE(slope_enclosure(point_of(motion, 64)).radius() <= magnitude::power_of_two(-5));
  // At u = 1, W = (pi/4)(1 + r).
  const oscillating_motion at_one{rational(2), rational(1, 2), rational(1)};
  EXPECT_TRUE(meet(slope_enclosure(point_of(at_one, 64)), scale(pi(64), -2) * rational(8, 5)));
}

TEST(SlopeLowerBound, IsBelowTheSlopeOfEveryMember) {
  support::random_source random(19);
  for (support::repeat trial(200); trial.again();) {
    const oscillating_motion motion = any_motion(random);
    const sweep_point point = point_of(motion, 64);
    const auto around = [&](const ball& x) {
      const ball low = x * rational(random.between(0, 16), 16);
      const ball high = x + (1 - x) * rational(random.between(0, 16), 16);
      return hull(x, hull(low, high));
    };
    const sweep_point box{around(point.p), around(point.r), around(point.u)};
    EXPECT_FALSE(certainly_less(slope_of(motion, 200), slope_lower_bound(box)));
    EXPECT_FALSE(certainly_less(slope_lower_bound(point), slope_lower_bound(box)))
        << "a larger box has a smaller bound";
  }
}

TEST(Sweep, CoversTheBox) {
  const sweep_result result = sweep_slope();
  EXPECT_TRUE(result.holds);
  EXPECT_EQ(result.bound, rational(3, 4));
  EXPECT_GT(result.least, result.bound);
  EXPECT_LT(result.least, rational(7854, 10000)) << "pi/4 is attained in the limit";
  // Every split adds one box: a binary tree. The counts are pinned.
  EXPECT_EQ(result.evaluations, 2 * result.boxes - 1);
  EXPECT_EQ(result.boxes, 62);
  EXPECT_EQ(result.deepest, 12);
}

TEST(Sweep, ProvesNothingBeyondItsLimit) {
  const long needed = sweep_slope().evaluations;
  EXPECT_TRUE(sweep_slope(needed).holds);
  for (const long limit : {0L, 1L, 2L, needed / 2, needed - 1}) {
    const sweep_result result = sweep_slope(limit);
    EXPECT_FALSE(result.holds) << limit;
    EXPECT_EQ(result.evaluations, limit);
  }
}

TEST(Sweep, DoesNotProveWhatIsFalse) {
  // W tends to pi/4 at u = 1, r = 0: no bound above it holds. Bounds below it do.
  EXPECT_FALSE(sweep_slope(3000, rational(786, 1000)).holds);
  EXPECT_FALSE(sweep_slope(3000, rational(4, 5)).holds);
  EXPECT_FALSE(sweep_slope(3000, rational(1)).holds);
  EXPECT_TRUE(sweep_slope(3000, rational(1, 2)).holds);
  EXPECT_TRUE(sweep_slope(3000, rational(0)).holds);
}

}  // namespace sweep_test
}  // namespace polhode::proofs
