// The bounds of what the theta series of the rotation leave out: with few terms, held against many.

#include <gtest/gtest.h>

#include "rigid_body/rotor_states.hpp"
#include "rigid_body/rotor_tables.hpp"

namespace polhode {
namespace rotor_series_test {

using detail::rotor_tables;
using detail::theta_point;

/// The error of the middle of x over its radius; 0 where x is no wider than its rounding.
double share_of_radius(const ball& x, const ball& exact) {
  EXPECT_TRUE(overlaps(x, exact));
  const magnitude error = (x.middle() - exact).magnitude_upper();
  const magnitude share = divide_up(error, x.radius());
  return share.is_zero() ? 0
                         : std::ldexp(static_cast<double>(share.fraction()),
                                      static_cast<int>(share.exponent()));
}

// m near 1/2, where the nome is the greatest, so that what is left out is too.
TEST(RotorSeries, TruncationStaysWithinItsBounds) {
  std::array<double, 6> greatest{};
  for (const bool hyperbolic : {false, true}) {
    for (const long k : {1L, 3L, 50L}) {
      // Oscillating: 1 - m = -c (a+b)/(b (a-c)), which is 1/2 for c = -a b/(2a + b). kappa from
      // small to great.
      const rational a(k, 3);
      const rational b(1, 3);
      const rational half(-a * b / (2 * a + b));
      const rational c(half * (hyperbolic ? rational(999, 1000) : rational(1001, 1000)));
      const initial_state state = initial_state::at_middle_of_twist(body(a, b), c);
      const precision bits = 400;
      const rotor_tables many(state, bits);
      ASSERT_EQ(many.series.hyperbolic, hyperbolic);
      for (const std::size_t terms : {2UL, 3UL, 4UL}) {
        const rotor_tables few(state, bits, terms);
        ASSERT_EQ(few.series.odd.size(), terms);
        EXPECT_TRUE(overlaps(few.rates.turns, many.rates.turns));
        for (std::size_t i = 0; i < 3; ++i) {
          EXPECT_TRUE(overlaps(few.amplitude[i], many.amplitude[i]));
        }
        greatest[5] = std::max(greatest[5], share_of_radius(few.rates.turns, many.rates.turns));
        for (int n = -50; n <= 50; n += 5) {
          const ball w(rational(n, 100), bits);
          const theta_point<ball> x = theta_values_at<true>(few.series, w);
          const theta_point<ball> exact = theta_values_at<true>(many.series, w);
          const std::array pairs{std::pair{&x.sn, &exact.sn}, std::pair{&x.cn, &exact.cn},
                                 std::pair{&x.dn, &exact.dn}, std::pair{&x.x, &exact.x},
                                 std::pair{&x.y, &exact.y}};
          for (std::size_t i = 0; i < pairs.size(); ++i) {
            greatest[i] = std::max(greatest[i], share_of_radius(*pairs[i].first, *pairs[i].second));
          }
        }
      }
    }
  }
  // No bound is far above what it bounds, so that one too small would have been seen.
  for (const double share : greatest) {
    EXPECT_GT(share, 0.01);
    EXPECT_LE(share, 1);
  }
}

// What the series beyond N terms are at w = 0, where the terms of theta_3 add up, and U_n = 2n + 1.
TEST(RotorSeries, TailsAreAtLeastWhatIsLeftOutAtZero) {
  const rational a(5, 3);
  const rational b(1, 3);
  const rational c(-a * b / (2 * a + b) * rational(1001, 1000));
  const initial_state state = initial_state::at_middle_of_twist(body(a, b), c);
  const precision bits = 400;
  const rotor_tables many(state, bits);
  ASSERT_FALSE(many.series.hyperbolic);
  for (const std::size_t terms : {2UL, 3UL, 4UL}) {
    const rotor_tables few(state, bits, terms);
    ball odd(0, bits);
    ball even(0, bits);
    for (std::size_t n = terms; n < many.series.odd.size(); ++n) {
      odd += many.series.odd[n] * static_cast<long>(2 * n + 1);
      even += 2 * many.series.even[n];
    }
    EXPECT_TRUE(odd.magnitude_lower() <= few.series.odd_tail) << terms;
    EXPECT_TRUE(even.magnitude_lower() <= few.series.even_tail) << terms;
    EXPECT_TRUE(few.series.odd_tail <= scale(odd.magnitude_upper(), 2)) << terms;
    EXPECT_TRUE(few.series.even_tail <= scale(even.magnitude_upper(), 2)) << terms;
  }
}

}  // namespace rotor_series_test
}  // namespace polhode
