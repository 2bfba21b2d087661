// The functions by tables are within the units that they say, which MPFR's at a higher precision
// judge; and come near to them: a bound that were many times too wide would hide an error.

#include "arithmetic/functions/tabulated_functions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

#include <gtest/gtest.h>

#include "support/random.hpp"
#include "support/real.hpp"

namespace polhode::detail {
namespace tabulated_functions_test {

using support::random_source;
using support::real;
using support::repeat;

constexpr precision judged_bits = 1200;
using number = std::array<mp_limb_t, most_tabulated_limbs + 1>;

real value_of(const number& x, long w) {
  real result(judged_bits);
  mpfr_set_zero(result, 1);
  for (long i = w; i >= 0; --i) {  // each step is exact
    mpfr_mul_2ui(result, result, 64, MPFR_RNDN);
    mpfr_add_ui(result, result, x[static_cast<std::size_t>(i)], MPFR_RNDN);
  }
  mpfr_div_2ui(result, result, static_cast<unsigned long>(64 * w), MPFR_RNDN);
  return result;
}

/// A fraction: random, with runs of equal bits, with few bits, or near 0.
number any_fraction(random_source& random, long w) {
  number x{};
  const bool runs = random.one_in(2);
  for (long i = 0; i < w; ++i) {
    x[static_cast<std::size_t>(i)] = !runs ? random.bits()
                                     : random.one_in(2)
                                         ? 0
                                         : ~std::uint64_t{0} << random.between(0, 63);
  }
  if (random.one_in(8)) std::fill_n(x.begin(), w - 1, 0);
  if (random.one_in(4)) {
    const long empty = random.between(0, w - 1);
    std::fill_n(x.begin() + (w - empty), empty, 0);
  }
  return x;
}
number fraction_below(random_source& random, long w, const mp_limb_t* limit) {
  number x = any_fraction(random, w);
  while (mpn_cmp(x.data(), limit, w) >= 0) x[static_cast<std::size_t>(w - 1)] >>= 1;
  return x;
}

/// got - wanted, in units.
double error_in_units(const real& got, const real& wanted, long w) {
  real difference(64);
  mpfr_sub(difference, got, wanted, MPFR_RNDN);
  mpfr_mul_2ui(difference, difference, static_cast<unsigned long>(64 * w), MPFR_RNDN);
  return mpfr_get_d(difference, MPFR_RNDN);
}

class TabulatedFunctions : public ::testing::TestWithParam<long> {
 protected:
  /// That all errors are less than `units`, and the greatest of them is above a quarter of it.
  void judge(double error, std::uint64_t units) {
    units_ = static_cast<double>(units);
    ASSERT_LT(std::abs(error), units_);
    greatest_ = std::max(greatest_, std::abs(error));
  }
  void expect_near_the_bound() const {
    if (support::effort() >= 1) {
      EXPECT_GT(greatest_, units_ / 4);
    }
  }

 private:
  double units_ = 0;
  double greatest_ = 0;
};

TEST_P(TabulatedFunctions, Expm1) {
  const long w = GetParam();
  random_source random(91);
  for (repeat trial(3000); trial.again();) {
    const number t = fraction_below(random, w, tabulated_log_2(w));
    number m{};
    const std::uint64_t units = tabulated_expm1(m.data(), t.data(), w);
    real wanted(judged_bits);
    mpfr_expm1(wanted, value_of(t, w), MPFR_RNDN);
    const double error = error_in_units(value_of(m, w), wanted, w);
    judge(error, units);
    ASSERT_LE(error, 0);
  }
  expect_near_the_bound();
}

TEST_P(TabulatedFunctions, SinCos) {
  const long w = GetParam();
  random_source random(92);
  for (repeat trial(3000); trial.again();) {
    const number t = fraction_below(random, w, tabulated_quarter_pi(w));
    number s{};
    number c{};
    const std::uint64_t units = tabulated_sin_cos(s.data(), c.data(), t.data(), w);
    real wanted(judged_bits);
    mpfr_sin(wanted, value_of(t, w), MPFR_RNDN);
    judge(error_in_units(value_of(s, w), wanted, w), units);
    mpfr_cos(wanted, value_of(t, w), MPFR_RNDN);
    judge(error_in_units(value_of(c, w), wanted, w), units);
  }
  expect_near_the_bound();
}

TEST_P(TabulatedFunctions, Log1p) {
  const long w = GetParam();
  random_source random(93);
  for (repeat trial(3000); trial.again();) {
    const number f = any_fraction(random, w);
    number l{};
    const std::optional<std::uint64_t> units = tabulated_log1p(l.data(), f.data(), w);
    ASSERT_TRUE(units);
    const auto top = static_cast<std::size_t>(w);
    const bool negative = (l[top] >> 63) != 0;
    if (negative) mpn_neg(l.data(), l.data(), w + 1);
    real got = value_of(l, w);
    if (negative) mpfr_neg(got, got, MPFR_RNDN);
    real wanted(judged_bits);
    mpfr_log1p(wanted, value_of(f, w), MPFR_RNDN);
    judge(error_in_units(got, wanted, w), *units);
  }
  expect_near_the_bound();
}

TEST_P(TabulatedFunctions, Atan) {
  const long w = GetParam();
  const auto top = static_cast<std::size_t>(w);
  random_source random(94);
  for (repeat trial(3000); trial.again();) {
    number a = any_fraction(random, w);
    number b{};
    if (random.one_in(2)) {
      b[top] = 1;
      if (random.one_in(20)) a = b;
    } else {
      b = any_fraction(random, w);
      b[top - 1] |= mp_limb_t{1} << 63;
      if (mpn_cmp(a.data(), b.data(), w) > 0) std::swap(a, b);
    }
    number t{};
    const std::optional<std::uint64_t> units = tabulated_atan(t.data(), a.data(), b.data(), w);
    ASSERT_TRUE(units);
    real wanted(judged_bits);
    mpfr_atan2(wanted, value_of(a, w), value_of(b, w), MPFR_RNDN);
    judge(error_in_units(value_of(t, w), wanted, w), *units);
  }
  expect_near_the_bound();
}

// The parts of an error are added up where each is the greatest: the numbers that were off by most
// are changed in their last bits, and so the entries of the tables are kept. More than half of the
// bound of the logarithm comes about.
TEST_P(TabulatedFunctions, Log1pIsOffByMoreThanHalfItsBound) {
  const long w = GetParam();
  const auto top = static_cast<std::size_t>(w);
  random_source random(95);
  number worst{};
  double greatest = 0;
  for (int trial = 0; trial < 6000; ++trial) {
    number f = any_fraction(random, w);
    // Entries of both tables are told by the first 14 bits.
    if (trial > 3000) {
      const mp_limb_t mask = ~mp_limb_t{0} << 48;
      f[top - 1] = (worst[top - 1] & mask) | (f[top - 1] & ~mask);
    }
    number l{};
    const std::optional<std::uint64_t> units = tabulated_log1p(l.data(), f.data(), w);
    ASSERT_TRUE(units);
    const bool negative = (l[top] >> 63) != 0;
    if (negative) mpn_neg(l.data(), l.data(), w + 1);
    real got = value_of(l, w);
    if (negative) mpfr_neg(got, got, MPFR_RNDN);
    real wanted(700);
    mpfr_log1p(wanted, value_of(f, w), MPFR_RNDN);
    const double error = std::abs(error_in_units(got, wanted, w));
    ASSERT_LT(error, static_cast<double>(*units));
    if (error > greatest) {
      greatest = error;
      worst = f;
    }
  }
  // With fewer limbs no two entries of the tables are cut off so far.
  if (w >= 5) {
    EXPECT_GT(greatest, 3);
  }
}

// Why no test fails where half of the arc tangent's bound is taken, 3 units: tan(first + second) is
// q/p exactly, and then only the entries are wrong, which no two of are by as much as 1.999 units
// together. The quotient and its series are not wrong in one direction by more than 1.0002 besides.
TEST_P(TabulatedFunctions, EntriesOfArcTangentsAreOffByLessThanTwo) {
  const long w = GetParam();
  const auto top = static_cast<std::size_t>(w);
  for (long j = 0; j <= 128; ++j) {
    for (long i = -64; i <= 64; i += support::effort() < 1 ? 8 : 1) {
      const long p = (1L << 21) - i * j;
      const long q = (j << 14) + i * 128;
      // Others are approached with the next j.
      const bool is_chosen = std::abs(i) * (16'384 + j * j) <= 63 * 16'384;
      if (q < 0 || q > p || !is_chosen) continue;
      const auto number_of = [&](long n) {  // n / 2^22
        number x{};
        x[top - 1] = static_cast<mp_limb_t>(n) << 42;
        return x;
      };
      const number a = number_of(q);
      const number b = number_of(p);
      number t{};
      ASSERT_TRUE(tabulated_atan(t.data(), a.data(), b.data(), w));
      real wanted(640);
      mpfr_atan2(wanted, value_of(a, w), value_of(b, w), MPFR_RNDN);
      ASSERT_LT(std::abs(error_in_units(value_of(t, w), wanted, w)), 1.999) << i << " " << j;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Limbs, TabulatedFunctions, ::testing::Range(2L, most_tabulated_limbs + 1));

}  // namespace tabulated_functions_test
}  // namespace polhode::detail
