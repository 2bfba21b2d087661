// Every directed operation against exact rationals, with the excess that is documented: 2^-29.

#include <array>
#include <cstdint>
#include <limits>
#include <optional>

#include <gtest/gtest.h>

#include "polhode/arithmetic/exact.hpp"
#include "polhode/arithmetic/magnitude.hpp"
#include "support/exact_set.hpp"
#include "support/random.hpp"

namespace polhode {
namespace magnitude_test {

using support::random_source;
using support::real;
using support::repeat;
using support::to_rational;

const rational excess = support::power_of_two(-29);

::testing::AssertionResult is_above(const magnitude& m, const rational& value) {
  if (!m.is_infinite() && value <= to_rational(m) && to_rational(m) <= value * (1 + excess)) {
    return ::testing::AssertionSuccess();
  }
  return ::testing::AssertionFailure()
         << "not a close upper bound of " << support::described(value);
}
::testing::AssertionResult is_below(const magnitude& m, const rational& value) {
  if (!m.is_infinite() && value * (1 - excess) <= to_rational(m) && to_rational(m) <= value) {
    return ::testing::AssertionSuccess();
  }
  return ::testing::AssertionFailure()
         << "not a close lower bound of " << support::described(value);
}

/// Fractions at both ends of their range are drawn often, and exponents that differ by any number
/// of places around 31 and 62.
magnitude any(random_source& random) {
  static constexpr std::array<std::uint64_t, 5> corners = {1U << 30, (1U << 30) + 1, (1U << 31) - 1,
                                                           (1U << 31) - 2, 3U << 29};
  if (random.one_in(3))
    return magnitude::from_bits_up(random.choose(corners), random.between(-40, 40));
  return random.any_magnitude(-40, 40);
}

TEST(Magnitude, SumsAndDifferences) {
  random_source random(200);
  for (repeat trial(20000); trial.again();) {
    const magnitude x = any(random);
    const magnitude y = any(random);
    const rational a = to_rational(x);
    const rational b = to_rational(y);
    EXPECT_TRUE(is_above(add_up(x, y), a + b));
    EXPECT_TRUE(is_below(add_down(x, y), a + b));
    const rational difference = a > b ? rational(a - b) : rational(0);
    EXPECT_TRUE(is_above(subtract_up(x, y), difference));
    EXPECT_TRUE(is_below(subtract_down(x, y), difference));
  }
}

TEST(Magnitude, ProductsQuotientsRoots) {
  random_source random(201);
  for (repeat trial(20000); trial.again();) {
    const magnitude x = any(random);
    const magnitude y = any(random);
    const rational a = to_rational(x);
    const rational b = to_rational(y);
    EXPECT_TRUE(is_above(multiply_up(x, y), a * b));
    EXPECT_TRUE(is_below(multiply_down(x, y), a * b));
    if (b != 0) {
      EXPECT_TRUE(is_above(divide_up(x, y), a / b));
      EXPECT_TRUE(is_below(divide_down(x, y), a / b));
    }
    const rational up = to_rational(sqrt_up(x));
    const rational down = to_rational(sqrt_down(x));
    EXPECT_GE(up * up, a);
    EXPECT_LE(up * up, a * (1 + excess) * (1 + excess));
    EXPECT_LE(down * down, a);
    EXPECT_GE(down * down, a * (1 - excess) * (1 - excess));
    const long n = random.between(-100, 100);
    EXPECT_EQ(to_rational(scale(x, n)), a * support::power_of_two(n));
  }
}

TEST(Magnitude, Order) {
  random_source random(202);
  for (repeat trial(5000); trial.again();) {
    const magnitude x = any(random);
    const magnitude y = random.one_in(4) ? x : any(random);
    const rational a = to_rational(x);
    const rational b = to_rational(y);
    EXPECT_EQ(x < y, a < b);
    EXPECT_EQ(x > y, a > b);
    EXPECT_EQ(x <= y, a <= b);
    EXPECT_EQ(x >= y, a >= b);
    EXPECT_EQ(x == y, a == b);
    EXPECT_EQ(to_rational(max(x, y)), std::max(a, b));
    EXPECT_EQ(to_rational(min(x, y)), std::min(a, b));
    EXPECT_TRUE(x < magnitude::infinity());
    EXPECT_FALSE(magnitude::infinity() < x);
    if (a != 0) {
      EXPECT_EQ(x.log2_floor(), support::log2_floor(a));
    }
  }
  EXPECT_TRUE(magnitude::infinity() <= magnitude::infinity());
  EXPECT_FALSE(magnitude::infinity() < magnitude::infinity());
}

TEST(Magnitude, FromIntegersAndBits) {
  random_source random(203);
  for (repeat trial(20000); trial.again();) {
    std::uint64_t n = random.bits() >> random.between(0, 63);
    if (random.one_in(8)) n = std::numeric_limits<std::uint64_t>::max() - (n & 3);
    if (random.one_in(8)) n = (std::uint64_t{1} << random.between(0, 63)) - (n & 1);
    EXPECT_TRUE(is_above(magnitude::from_integer_up(n), rational(n)));
    EXPECT_TRUE(is_below(magnitude::from_integer_down(n), rational(n)));
    const long e = random.between(-300, 300);
    EXPECT_TRUE(is_above(magnitude::from_bits_up(n, e), rational(n) * support::power_of_two(e)));
    EXPECT_TRUE(is_below(magnitude::from_bits_down(n, e), rational(n) * support::power_of_two(e)));
    EXPECT_EQ(to_rational(magnitude::power_of_two(e)), support::power_of_two(e));
    // The representation is unique.
    const magnitude m = magnitude::from_integer_up(n);
    if (n != 0) {
      EXPECT_GE(m.fraction(), 1U << 30);
      EXPECT_LT(m.fraction(), 1U << 31);
    }
  }
}

TEST(Magnitude, OfMpfrNumbers) {
  random_source random(204);
  for (repeat trial(20000); trial.again();) {
    real x = random.any_real(random.any_precision(), -300, 300);
    if (random.one_in(4)) mpfr_nextbelow(x);  // all ones, as a rule after a power of two
    EXPECT_TRUE(is_above(magnitude::abs_up(x), abs(to_rational(x))));
    EXPECT_TRUE(is_below(magnitude::abs_down(x), abs(to_rational(x))));
  }
  EXPECT_TRUE(magnitude::abs_up(real(64, 0)).is_zero());
  EXPECT_TRUE(magnitude::abs_down(real(64, 0)).is_zero());
  EXPECT_TRUE(magnitude::abs_up(real::infinity(-1)).is_infinite());
  EXPECT_TRUE(magnitude::abs_down(real::infinity(-1)).is_infinite());
  EXPECT_EQ(to_rational(magnitude::abs_up(real(64, 1))), 1);
  EXPECT_EQ(to_rational(magnitude::abs_down(real(1, -1))), 1);
}

// The operations commute with powers of two as far as the exponents go.
TEST(Magnitude, FarExponents) {
  random_source random(205);
  for (repeat trial(5000); trial.again();) {
    const magnitude x = any(random);
    const magnitude y = any(random);
    const std::int64_t k =
        (std::int64_t{1} << random.between(32, 59)) * (random.one_in(2) ? 1 : -1) - 200;
    const std::int64_t half = k / 2 * 2;
    EXPECT_EQ(add_up(scale(x, k), scale(y, k)), scale(add_up(x, y), k));
    EXPECT_EQ(add_down(scale(x, k), scale(y, k)), scale(add_down(x, y), k));
    EXPECT_EQ(subtract_up(scale(x, k), scale(y, k)), scale(subtract_up(x, y), k));
    EXPECT_EQ(subtract_down(scale(x, k), scale(y, k)), scale(subtract_down(x, y), k));
    EXPECT_EQ(multiply_up(scale(x, k), y), scale(multiply_up(x, y), k));
    EXPECT_EQ(multiply_down(scale(x, k), y), scale(multiply_down(x, y), k));
    EXPECT_EQ(multiply_up(scale(x, k), scale(y, -k)), multiply_up(x, y));
    EXPECT_EQ(divide_up(scale(x, k), scale(y, k)), divide_up(x, y));
    EXPECT_EQ(divide_down(scale(x, k), scale(y, k)), divide_down(x, y));
    EXPECT_EQ(sqrt_up(scale(x, half)), scale(sqrt_up(x), half / 2));
    EXPECT_EQ(sqrt_down(scale(x, half)), scale(sqrt_down(x), half / 2));
    EXPECT_EQ(x < y, scale(x, k) < scale(y, k));
  }
}

TEST(Magnitude, Saturation) {
  constexpr std::int64_t limit = std::int64_t{1} << 60;
  constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max();
  constexpr std::int64_t least = std::numeric_limits<std::int64_t>::min();
  const magnitude one = magnitude::power_of_two(0);
  const magnitude great = magnitude::power_of_two(limit);
  const magnitude small = magnitude::power_of_two(-limit + 40);
  ASSERT_FALSE(great.is_infinite());
  // Upper bounds: on to infinity, and never below the least number.
  EXPECT_TRUE(multiply_up(great, great).is_infinite());
  EXPECT_TRUE(divide_up(great, small).is_infinite());
  EXPECT_FALSE(multiply_up(small, small).is_zero());
  EXPECT_FALSE(divide_up(small, great).is_zero());
  EXPECT_TRUE(multiply_up(small, small) <= small);
  // Lower bounds: down to zero, and never to infinity.
  EXPECT_TRUE(multiply_down(small, small).is_zero());
  EXPECT_TRUE(divide_down(small, great).is_zero());
  EXPECT_FALSE(multiply_down(great, great).is_infinite());
  EXPECT_TRUE(multiply_down(great, great) >= great);
  EXPECT_FALSE(divide_down(great, small).is_infinite());
  // Sums at both ends.
  EXPECT_TRUE(add_up(great, great) > great);
  EXPECT_TRUE(add_down(great, great) >= great);
  EXPECT_FALSE(add_down(great, great).is_infinite() && great.is_infinite());
  EXPECT_EQ(add_up(great, small).fraction(), great.fraction() + 1);
  EXPECT_EQ(add_down(great, small), great);
  EXPECT_EQ(subtract_up(great, small), great);
  EXPECT_TRUE(subtract_down(great, small) < great);
  // Powers of two, and scaling, as far as a 64-bit integer goes.
  EXPECT_TRUE(magnitude::power_of_two(most).is_infinite());
  EXPECT_FALSE(magnitude::power_of_two(least).is_zero());
  EXPECT_TRUE(magnitude::power_of_two(least) <= small);
  for (const magnitude& m : {one, great, small}) {
    EXPECT_TRUE(scale(m, most).is_infinite());
    EXPECT_FALSE(scale(m, least).is_zero());
    EXPECT_FALSE(scale(m, least).is_infinite());
    EXPECT_TRUE(scale(m, least) <= small);
  }
}

TEST(Magnitude, ZeroAndInfinity) {
  const magnitude zero;
  const magnitude one = magnitude::power_of_two(0);
  const magnitude infinite = magnitude::infinity();
  EXPECT_TRUE(zero.is_zero());
  EXPECT_FALSE(zero.is_infinite());
  EXPECT_TRUE(infinite.is_infinite());
  EXPECT_FALSE(infinite.is_zero());
  for (const auto& add : {+[](const magnitude&x, const magnitude&y) { return add_up(x, y); },
                          +[](const magnitude&x, const magnitude&y) { return add_down(x, y); }}) {
    EXPECT_EQ(add(zero, one), one);
    EXPECT_EQ(add(one, zero), one);
    EXPECT_EQ(add(zero, zero), zero);
    EXPECT_EQ(add(zero, infinite), infinite);
    EXPECT_EQ(add(one, infinite), infinite);
    EXPECT_EQ(add(infinite, one), infinite);
  }
  for (const auto& times :
       {+[](const magnitude&x, const magnitude&y) { return multiply_up(x, y); },
        +[](const magnitude&x, const magnitude&y) { return multiply_down(x, y); }}) {
    EXPECT_EQ(times(zero, infinite), zero);
    EXPECT_EQ(times(infinite, zero), zero);
    EXPECT_EQ(times(one, infinite), infinite);
    EXPECT_EQ(times(zero, one), zero);
  }
  EXPECT_EQ(divide_up(one, zero), infinite);
  EXPECT_EQ(divide_up(zero, zero), zero);
  EXPECT_EQ(divide_up(one, infinite), zero);
  EXPECT_EQ(divide_up(infinite, one), infinite);
  EXPECT_EQ(divide_down(one, zero), infinite);
  EXPECT_EQ(divide_down(infinite, infinite), zero);
  EXPECT_EQ(divide_down(infinite, one), infinite);
  EXPECT_EQ(divide_down(one, infinite), zero);
  EXPECT_EQ(subtract_up(infinite, one), infinite);
  EXPECT_EQ(subtract_down(infinite, one), infinite);
  EXPECT_EQ(subtract_down(one, zero), one);
  EXPECT_EQ(subtract_up(zero, one), zero);
  EXPECT_EQ(sqrt_up(infinite), infinite);
  EXPECT_EQ(sqrt_down(infinite), infinite);
  EXPECT_EQ(sqrt_up(zero), zero);
  EXPECT_EQ(scale(zero, 5), zero);
  EXPECT_EQ(scale(infinite, -5), infinite);
  EXPECT_EQ(sqrt_up(magnitude::power_of_two(-6)), magnitude::power_of_two(-3));
  EXPECT_EQ(sqrt_down(magnitude::power_of_two(8)), magnitude::power_of_two(4));
}

}  // namespace magnitude_test
}  // namespace polhode
