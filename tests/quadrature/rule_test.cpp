// The rule itself: its value in closed form, for every number of nodes, and in both scalars.

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "polhode/quadrature/periodic_trapezoid.hpp"
#include "polhode/rigid_body/phase_integrands.hpp"
#include "quadrature/integrands.hpp"
#include "support/reference.hpp"

namespace polhode {
namespace rule_test {

using support::agrees;
using support::as_narrow_as;
using support::constant_integrand;
using support::meet;
using support::poisson_kernel;
using support::power_of_cosine;

/// Records the cosines that it is asked for.
class recording_integrand {
 public:
  explicit recording_integrand(std::vector<ball>& cosines) : cosines_(&cosines) {}
  template <scalar T>
  [[nodiscard]] auto evaluator(precision) const {
    return [all = cosines_](const T& cosine) -> T {
      all->push_back(cosine);
      return cosine;
    };
  }

 private:
  std::vector<ball>* cosines_;
};

TEST(PeriodicTrapezoidSum, VisitsEachNodeOnce) {
  for (long n = 1; n <= 70; ++n) {
    std::vector<ball> cosines;
    const ball sum = periodic_trapezoid_sum<ball>(recording_integrand(cosines), n, 128);
    EXPECT_TRUE(contains_zero(sum)) << n;
    ASSERT_EQ(cosines.size(), static_cast<std::size_t>(n));
    std::sort(cosines.begin(), cosines.end(),
              [](const ball& x, const ball& y) { return certainly_less(y, x); });
    for (long k = 0; k < n; ++k) {
      const ball expected = cos((2 * k + 1) * pi(160) / (2 * n));
      const ball& node = cosines[static_cast<std::size_t>(k)];
      EXPECT_TRUE(meet(node, expected)) << k << " of " << n;
      EXPECT_TRUE(node.radius() <= magnitude::power_of_two(-115)) << k << " of " << n;
    }
  }
}

TEST(PeriodicTrapezoidSum, HasItsClosedFormForPoissonsKernel) {
  for (const rational& q : {rational(1, 10), rational(1, 2), rational(9, 10)}) {
    const poisson_kernel g(q);
    for (long n = 1; n <= 60; ++n) {
      const ball sum = periodic_trapezoid_sum<ball>(g, n, 128);
      EXPECT_TRUE(meet(sum, g.rule_over_pi(n) * pi(256))) << q << " " << n;
      EXPECT_TRUE(as_narrow_as(sum, 105)) << q << " " << n;
    }
  }
}

TEST(PeriodicTrapezoidSum, IsExactForPolynomialsBelowTwiceTheNodes) {
  for (const long n : {1L, 2L, 3L, 4L, 7L, 12L}) {
    for (long k = 0; k < 2 * n; ++k) {
      const power_of_cosine g(k);
      const ball sum = periodic_trapezoid_sum<ball>(g, n, 128);
      EXPECT_TRUE(meet(sum, g.integral_over_pi() * pi(256))) << "c^" << k << ", n = " << n;
      EXPECT_TRUE(sum.radius() <= magnitude::power_of_two(-110));
    }
    // Of degree 2n it misses the part of T_2n, -1 at each node: by pi 2^(1-2n).
    const power_of_cosine g(2 * n);
    const ball error = periodic_trapezoid_sum<ball>(g, n, 128) - g.integral_over_pi() * pi(256);
    EXPECT_TRUE(meet(error, -scale(pi(256), 1 - 2 * n))) << n;
  }
}

TEST(PeriodicTrapezoidSum, IsTheWeightForAConstant) {
  for (long n = 1; n <= 9; ++n) {
    EXPECT_TRUE(meet(periodic_trapezoid_sum<ball>(constant_integrand(rational(3, 7)), n, 200),
                     rational(3, 7) * pi(300)));
  }
}

TEST(PeriodicTrapezoidSum, GivesTheMiddleOfTheBallInMpfrFloat) {
  // The same operations in the same order: the uncertified value is within the radius that the ball
  // proved for them. (Boost counts in decimal digits: its temporaries have a bit or two more, and
  // 68 at least.)
  const oscillating_motion motion{rational(1265, 100), rational(629, 10000), rational(1, 4)};
  for (const precision p : {53L, 64L, 200L, 1000L}) {
    for (const long n : {1L, 2L, 3L, 40L, 101L}) {
      const auto compare = [&](const auto& integrand) {
        const mpfr_float value = periodic_trapezoid_sum<mpfr_float>(integrand, n, p);
        const ball enclosure = periodic_trapezoid_sum<ball>(integrand, n, p);
        EXPECT_GE(precision_of(value), p);
        EXPECT_LE(precision_of(value), std::max(p + 4, 68L));
        EXPECT_TRUE(contains(enclosure, ball(value))) << p << " bits, n = " << n;
      };
      compare(half_phase_integrand(motion));
      compare(half_phase_slope_integrand(motion));
      compare(poisson_kernel(rational(2, 3)));
      compare(power_of_cosine(6));
    }
  }
}

TEST(PeriodicTrapezoidSum, IsUndefinedWhereANodeIs) {
  const oscillating_motion motion{rational(1), rational(1, 2), rational(1, 1000000)};
  // At 2 bits x(t) near u cannot be told from 0.
  EXPECT_TRUE(periodic_trapezoid_sum<ball>(half_phase_integrand(motion), 1000, 4).is_undefined());
}

}  // namespace rule_test
}  // namespace polhode
