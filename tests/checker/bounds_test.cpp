// The checker's bounds of what its sums leave out, with so few bits, or so few nodes, that this is
// what most of a set is there for.

#include <gtest/gtest.h>

#include <random>

#include "checker/elliptic.hpp"
#include "checker/interval.hpp"
#include "generous.hpp"
#include "support/random.hpp"

namespace polhode::checker {
namespace bounds_test {

bool holds(const interval& x, const interval& finer) {
  return x.lower() <= finer.lower() && finer.upper() <= x.upper();
}

// A step is the last one where the means are 64 units apart: with 4 to 12 bits that is far.
TEST(CheckerBounds, MeansAndSumsThatEndEarlyHoldTheWhole) {
  std::mt19937_64 engine(31);
  const auto whole = [&](long low, long high) {
    return std::uniform_int_distribution<long>(low, high)(engine);
  };
  for (support::repeat trial(3000); trial.again();) {
    const long bits = whole(4, 12);
    // Both are exact with so few bits.
    const rational one(whole(1, 4L << bits), integer(1) << static_cast<unsigned>(bits));
    const rational other(whole(1, 4L << bits), integer(1) << static_cast<unsigned>(bits));
    const auto at = [&](long n, const rational& q) { return interval(q, at_bits(n)); };
    const mean_and_sum few =
        agm_with_sum(at(bits, std::max(one, other)), at(bits, std::min(one, other)));
    const mean_and_sum many =
        agm_with_sum(at(300, std::max(one, other)), at(300, std::min(one, other)));
    EXPECT_TRUE(holds(few.mean, many.mean)) << one << " " << other << " " << bits;
    EXPECT_TRUE(holds(few.sum, many.sum)) << one << " " << other << " " << bits;
    const mean_and_sum few_of_bartky = bartky_sums(at(bits, one), at(bits, other));
    const mean_and_sum many_of_bartky = bartky_sums(at(300, one), at(300, other));
    EXPECT_TRUE(holds(few_of_bartky.mean, many_of_bartky.mean))
        << one << " " << other << " " << bits;
    EXPECT_TRUE(holds(few_of_bartky.sum, many_of_bartky.sum)) << one << " " << other << " " << bits;
  }
}

// cos(2 n t) has the same size at all nodes, and the integral 0: on a wide strip, where it is at
// most cosh(2 n H), the bound is little more than what the rule makes of it.
TEST(CheckerBounds, TheTrapezoidalRuleIsOffByAsMuchAsItsBound) {
  for (const long n : {1L, 2L}) {
    const precision bits = at_bits(100);
    const rational half_width(12 / n);
    const interval e = exp(interval(rational(24), bits));
    const interval supremum = (e + interval(rational(1), bits) / e) / 2;
    const periodic_integral found = periodic_trapezoid(
        [&](const interval& cosine) {
          const interval double_angle = square(cosine) * 2 - interval(rational(1), cosine.bits());
          return n == 1 ? double_angle
                        : square(double_angle) * 2 - interval(rational(1), cosine.bits());
        },
        n, half_width, supremum.upper(), bits);
    EXPECT_TRUE(holds(found.value, interval(rational(0), bits))) << n;
    EXPECT_LT(found.value.upper() - found.value.lower(), rational(7)) << n;  // 2 pi and little more
  }
}

}  // namespace bounds_test
}  // namespace polhode::checker
