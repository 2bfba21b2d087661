// The functions by tables are within the units that they say, which MPFR's at a higher precision judge; and come near to them: a bound
// that were many times too wide would hide an error.

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
namespace {

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

INSTANTIATE_TEST_SUITE_P(Limbs, TabulatedFunctions, ::testing::Range(2L, most_tabulated_limbs + 1));

}  // namespace
}  // namespace polhode::detail
