// exp, sinh, cosh, log, sin, cos and atan have algorithms of their own up to some thousands of
// bits. MPFR's, at a higher precision, judge them.

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "arithmetic/functions/fixed_point/bit_burst.hpp"
#include "arithmetic/functions/fixed_point/circular.hpp"
#include "arithmetic/functions/fixed_point/exponential.hpp"
#include "arithmetic/functions/fixed_point/prime_numbers.hpp"
#include "arithmetic/functions/fixed_point/prime_reduction.hpp"
#include "arithmetic/functions/fixed_point_functions.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/mpfr_functions.hpp"
#include "support/random.hpp"
#include "support/real.hpp"

namespace polhode {
namespace fixed_point_functions_test {

using support::random_source;
using support::real;
using support::repeat;

struct function {
  const char* name;
  void (*of)(ball&, const ball&);
  int (*reference)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);
};
constexpr std::array<function, 7> functions = {{{"exp", exp, mpfr_exp},
                                                {"sinh", sinh, mpfr_sinh},
                                                {"cosh", cosh, mpfr_cosh},
                                                {"log", log, mpfr_log},
                                                {"sin", sin, mpfr_sin},
                                                {"cos", cos, mpfr_cos},
                                                {"atan", atan, mpfr_atan}}};

/// j c / 2^k, rounded to p bits up or down: where arguments are reduced, and values are near 0 or
/// 1.
real near_multiple(random_source& random, int (*constant)(mpfr_ptr, mpfr_rnd_t), precision p) {
  real c(p + 80);
  constant(c, MPFR_RNDN);
  mpfr_mul_si(c, c, random.between(1, 1L << random.between(1, 17)), MPFR_RNDN);
  mpfr_div_2ui(c, c, static_cast<unsigned long>(random.between(0, 4)), MPFR_RNDN);
  real x(p);
  mpfr_set(x, c, random.one_in(2) ? MPFR_RNDD : MPFR_RNDU);
  return x;
}

real any_argument(random_source& random, precision p) {
  real x(p);
  switch (random.between(0, 6)) {
    case 0:
      return near_multiple(random, mpfr_const_pi, p);
    case 1:
      return near_multiple(random, mpfr_const_log2, p);
    case 2: {  // 2^j (1 +- 2^-k): 1 +- 2^-k, powers of two, and where log and atan are near those
      mpfr_set_ui_2exp(x, 1, -random.between(0, p + 2), MPFR_RNDN);
      if (random.one_in(2)) mpfr_neg(x, x, MPFR_RNDN);
      mpfr_add_ui(x, x, 1, MPFR_RNDN);
      if (mpfr_zero_p(x) != 0) mpfr_set_ui(x, 1, MPFR_RNDN);
      mpfr_mul_2si(x, x, random.between(-3, 3), MPFR_RNDN);
      return x;
    }
    case 3:  // few bits
      mpfr_set_si(x, random.between(1, 1000), MPFR_RNDN);
      mpfr_div_2ui(x, x, static_cast<unsigned long>(random.between(0, 24)), MPFR_RNDN);
      return x;
    case 4: {  // where the algorithms begin and end
      static constexpr std::array<long, 8> edges = {-65, -64, -17, -16, 0, 1, 16, 17};
      const long e = random.choose(edges);
      return random.any_real(p, e, e);
    }
    default:
      return random.any_real(p, -20, 18);
  }
}

precision any_bits(random_source& random) {
  switch (random.between(0, 9)) {
    case 0:
      return random.one_in(10) ? random.between(3700, 30'000) : random.between(400, 3700);
    case 1:
      return 64 * random.between(1, 12) + random.between(-1, 1);
    default:
      return random.between(32, 400);
  }
}

class FixedPointFunctions : public ::testing::TestWithParam<function> {};

TEST_P(FixedPointFunctions, HoldTheValueTightly) {
  const function f = GetParam();
  random_source random(1800);
  long judged = 0;
  for (repeat trial(12000); trial.again();) {
    const precision p = any_bits(random);
    real a = any_argument(random, p);
    if (std::string(f.name) == "log") {
      mpfr_abs(a, a, MPFR_RNDN);
    } else if (random.one_in(2)) {
      mpfr_neg(a, a, MPFR_RNDN);
    }
    if (mpfr_regular_p(a.get()) == 0) continue;
    SCOPED_TRACE(f.name + std::string(" at ") + std::to_string(p) + " bits of " +
                 std::to_string(mpfr_get_d(a, MPFR_RNDN)));
    ball y;
    f.of(y, ball(a.get()));
    // A ball about +-1 may be far narrower than a unit in its last place.
    real low(p + 300);
    real high(p + 300);
    f.reference(low, a, MPFR_RNDD);
    f.reference(high, a, MPFR_RNDU);
    ASSERT_TRUE(contains(y, ball(low.get())) && contains(y, ball(high.get())));
    if (mpfr_regular_p(low.get()) == 0) continue;
    // Half a unit in the last place for the rounding, and 2^-9 for all that comes before it.
    const magnitude unit = magnitude::power_of_two(y.magnitude_upper().log2_floor() + 1 - p);
    ASSERT_LE(y.radius(), add_up(scale(unit, -1), scale(unit, -9)));
    ++judged;
    // The same of a thin set's ends.
    const ball x = ball::from_midpoint_radius(
        a, magnitude::power_of_two(mpfr_get_exp(a) - random.between(26, p + 8)));
    f.of(y, x);
    for (const int side : {-1, 1}) {
      real end(p + 300);
      if (side < 0) {
        x.lower(end);
      } else {
        x.upper(end);
      }
      f.reference(low, end, MPFR_RNDD);
      f.reference(high, end, MPFR_RNDU);
      ASSERT_TRUE(y.is_undefined() ||
                  (contains(y, ball(low.get())) && contains(y, ball(high.get()))));
    }
  }
  EXPECT_GT(judged, 1000 * support::effort());
}

INSTANTIATE_TEST_SUITE_P(All, FixedPointFunctions, ::testing::ValuesIn(functions),
                         [](const auto& tested) { return std::string(tested.param.name); });

struct near_inverse {
  const char* name;
  detail::near_function of;
  int (*function)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);
  int (*inverse)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);
  long least, most;  // of values, in units of 2^-12
};
constexpr std::array<near_inverse, 6> near_inverses = {
    {{"exp", detail::near_exp, mpfr_exp, mpfr_log, 1, 1L << 20},
     {"sinh", detail::near_sinh, mpfr_sinh, mpfr_asinh, 1, 1L << 20},
     {"cosh", detail::near_cosh, mpfr_cosh, mpfr_acosh, 4100, 1L << 20},
     {"sin", detail::near_sin, mpfr_sin, mpfr_asin, 1, 4000},
     {"cos", detail::near_cos, mpfr_cos, mpfr_acos, 1, 4000},
     {"atan", detail::near_atan, mpfr_atan, mpfr_tan, 1, 6300}}};

/// Half way between two numbers of p bits, from those bounds.
real any_tie(random_source& random, precision p, long least, long most) {
  real y(p + 1);
  mpfr_set_si_2exp(y, random.between(least, most - 1), -12, MPFR_RNDN);
  const real more = random.any_real(p + 1, -12, -12);
  mpfr_add(y, y, more, MPFR_RNDZ);
  mpfr_nextabove(y);
  real rounded(p);
  while (mpfr_set(rounded, y, MPFR_RNDZ) == 0) mpfr_nextabove(y);
  return y;
}

// Where the value is half way between two numbers, but for a few units of the fractions that are
// computed with, the wrong one of them is chosen as soon as an error goes the other way: then the
// result is off by more than half a unit in its last place, and only the errors counted before the
// rounding cover that.
TEST(FixedPointErrors, AreCountedWhereTheResultIsRoundedTheWrongWay) {
  random_source random(1801);
  for (const near_inverse& f : near_inverses) {
    long wrong = 0;
    for (repeat trial(1500); trial.again();) {
      const precision p = random.one_in(3) ? random.between(600, 1500) : random.between(40, 500);
      const real y = any_tie(random, p, f.least, f.most);
      real x(p + random.between(16, 90));
      f.inverse(x, y, MPFR_RNDN);
      real got(p);
      magnitude error;
      if (!f.of(got, x, error)) continue;
      real exact(p + 300);
      f.function(exact, x, MPFR_RNDN);
      real difference(p + 300);
      mpfr_sub(difference, exact, got, MPFR_RNDZ);
      mpfr_abs(difference, difference, MPFR_RNDN);
      const rational off = support::to_rational(difference);
      ASSERT_LE(off, support::to_rational(error)) << f.name << " at " << p << " bits";
      if (support::power_of_two(mpfr_get_exp(got.get()) - p - 1) < off) ++wrong;
    }
    if (support::effort() >= 1) {
      EXPECT_GT(wrong, 20) << f.name;
    }
  }
}

TEST(FixedPointErrors, AreCountedBesideAZeroOfTheSine) {
  random_source random(1802);
  long found = 0;
  long wrong = 0;
  for (repeat trial(1500); trial.again();) {
    const precision p = random.between(40, 300);
    const long zeros = random.between(17, 150);
    real y = any_tie(random, p, 1, 4000);
    mpfr_div_2ui(y, y, static_cast<unsigned long>(zeros), MPFR_RNDN);  // exact
    // x = n pi/2 + asin(y), of which the sine is y or -y for even n, and the cosine for odd n.
    const precision bits = p + zeros + random.between(30, 90);
    real turns(bits + 20);
    mpfr_const_pi(turns, MPFR_RNDN);
    const long n = random.between(1, 20'000);
    mpfr_mul_si(turns, turns, n, MPFR_RNDN);
    mpfr_div_2ui(turns, turns, 1, MPFR_RNDN);
    real x(bits);
    mpfr_asin(x, y, MPFR_RNDN);
    mpfr_add(x, x, turns, MPFR_RNDN);
    real got(p);
    magnitude error;
    const bool by_sine = n % 2 == 0;
    if (!(by_sine ? detail::near_sin : detail::near_cos)(got, x, error)) continue;
    ++found;
    real exact(p + 300);
    (by_sine ? mpfr_sin : mpfr_cos)(exact, x, MPFR_RNDN);
    real difference(p + 300);
    mpfr_sub(difference, exact, got, MPFR_RNDZ);
    mpfr_abs(difference, difference, MPFR_RNDN);
    const rational off = support::to_rational(difference);
    const rational half_unit = support::power_of_two(mpfr_get_exp(got.get()) - p - 1);
    ASSERT_LE(off, support::to_rational(error)) << p << " bits, " << zeros << " zeros";
    ASSERT_LE(support::to_rational(error), half_unit * (1 + rational(1, 512)));
    if (half_unit < off) ++wrong;
  }
  if (support::effort() >= 1) {
    EXPECT_GT(found, 1000);
    EXPECT_GT(wrong, 20);
  }
}

TEST(OnlyMpfrFunctions, LeaveAllArgumentsToMpfr) {
  for (const precision p : {64L, 700L, 5000L}) {
    const ball x = ball(7, p) / 5;
    real value(p);
    real argument(p);
    x.midpoint(argument);
    for (const near_inverse& f : near_inverses) {
      magnitude error;
      EXPECT_TRUE(f.of(value, argument, error)) << f.name;
      const detail::only_mpfr_functions outer;
      {
        const detail::only_mpfr_functions inner;
        EXPECT_FALSE(f.of(value, argument, error)) << f.name;
      }
      EXPECT_FALSE(f.of(value, argument, error)) << f.name;
      EXPECT_FALSE(detail::near_log(value, argument, error));
    }
    magnitude error;
    EXPECT_TRUE(detail::near_log(value, argument, error));
  }
}

namespace fixed_point = detail::fixed_point;

/// The fraction's number, exactly.
real as_real(const fixed_point::limb* x, long w) {
  real value(64 * w);
  mpz_t whole;
  mpz_roinit_n(whole, x, w);
  mpfr_set_z_2exp(value, whole, -64 * w, MPFR_RNDN);
  return value;
}

/// Sets a fraction of w limbs: random bits, few, or beside a number of few.
void set_any_fraction(fixed_point::fraction& t, random_source& random, long w,
                      fixed_point::limb most_at_top) {
  const long kind = random.between(0, 3);
  const fixed_point::limb filler = kind == 0 ? 0 : ~fixed_point::limb{0};
  for (long i = 0; i < w; ++i) t[i] = kind < 2 ? filler : random.bits();
  t[w - 1] = random.bits() % most_at_top;
  if (random.one_in(4)) t[w - 1] &= random.bits() >> random.between(0, 63);
}

/// (true value - computed)/unit, rounded to a double.
double units_missing(real& exact, const real& computed, long w) {
  mpfr_sub(exact, exact, computed, MPFR_RNDN);
  mpfr_mul_2si(exact, exact, 64 * w, MPFR_RNDN);
  return mpfr_get_d(exact, MPFR_RNDN);
}

/// Limbs of one of the algorithms beyond tables, in any number up to `most` but for some with which
/// arguments are taken apart.
long any_limbs(random_source& random, long least, long most) {
  if (random.one_in(150)) return random.between(1100, 1800);
  switch (random.between(0, 5)) {
    case 0:
      return random.between(fixed_point::most_limbs_for_halving - 1,
                            fixed_point::most_limbs_for_halving + 2);
    case 1:
      return random.between(least, most);
    default:
      return random.between(least, std::min(most, 60L));
  }
}

TEST(FixedPointErrors, OfTheExponentialAreCountedInUnits) {
  random_source random(1803);
  double greatest = 0;
  for (repeat trial(1500); trial.again();) {
    const long w = any_limbs(random, detail::most_tabulated_limbs + 1, 300);
    // log 2 is 0.B17217F7...
    fixed_point::fraction t(w);
    set_any_fraction(t, random, w, 0xB17217F7D1CF79AB);
    fixed_point::fraction m(w);
    const auto units = static_cast<double>(fixed_point::expm1_of_fraction(m.data(), t.data(), w));
    real exact(64 * w + 128);
    mpfr_expm1(exact, as_real(t.data(), w), MPFR_RNDN);
    const double missing = units_missing(exact, as_real(m.data(), w), w);
    ASSERT_LE(std::abs(missing), units) << w;
    if (!fixed_point::is_by_primes(w)) {
      ASSERT_GE(missing, -1e-9) << w;
      // A table with as many limbs as it has is as wrong as its products make it.
      if (w < fixed_point::most_limbs_for_halving) greatest = std::max(greatest, missing);
    }
  }
  if (support::effort() >= 1) {
    EXPECT_GT(greatest, 4);
  }
}

TEST(FixedPointErrors, OfTheVersineAreCountedInUnits) {
  random_source random(1804);
  for (repeat trial(1500); trial.again();) {
    const long w = random.between(4, fixed_point::most_limbs_for_halving);
    // pi/4 is 0.C90FDAA2...
    fixed_point::fraction t(w);
    set_any_fraction(t, random, w, 0xC90FDAA22168C234);
    fixed_point::fraction v(w);
    const auto units = static_cast<double>(fixed_point::versine_of_fraction(v.data(), t.data(), w));
    // 1 - cos t = 2 sin(t/2)^2.
    real exact(64 * w + 128);
    real half = as_real(t.data(), w);
    mpfr_div_2ui(half, half, 1, MPFR_RNDN);
    mpfr_sin(exact, half, MPFR_RNDN);
    mpfr_sqr(exact, exact, MPFR_RNDN);
    mpfr_mul_2ui(exact, exact, 1, MPFR_RNDN);
    ASSERT_LE(std::abs(units_missing(exact, as_real(v.data(), w), w)), units) << w;
  }
}

TEST(FixedPointErrors, OfTheReductionByPrimesAreCountedInUnits) {
  random_source random(1805);
  double greatest = 0;
  for (repeat trial(1500); trial.again();) {
    const long w = any_limbs(random, 2, 300);
    const bool circular = random.one_in(2);
    fixed_point::fraction t(w);
    set_any_fraction(t, random, w, circular ? 0xC90FDAA22168C234 : 0xB17217F7D1CF79AB);
    const real argument = as_real(t.data(), w);
    real exact(64 * w + 128);
    const auto judge = [&](const fixed_point::limb* computed, long n, std::uint64_t units) {
      mpz_t whole;
      mpz_roinit_n(whole, computed, n);
      real value(64 * n);
      mpfr_set_z_2exp(value, whole, -64 * w, MPFR_RNDN);
      const double missing = std::abs(units_missing(exact, value, w));
      ASSERT_LE(missing, static_cast<double>(units)) << w;
      greatest = std::max(greatest, missing / static_cast<double>(units));
    };
    if (circular) {
      fixed_point::fraction s(w);
      fixed_point::fraction c(w);
      const auto units = fixed_point::sine_and_cosine_by_primes(s.data(), c.data(), t.data(), w);
      mpfr_sin(exact, argument, MPFR_RNDN);
      judge(s.data(), w, units);
      mpfr_cos(exact, argument, MPFR_RNDN);
      judge(c.data(), w, units);
    } else {
      fixed_point::number value(w);
      const auto units = fixed_point::exponential_by_primes(value, t.data(), w);
      mpfr_exp(exact, argument, MPFR_RNDN);
      judge(value.data(), w + 1, units);
    }
  }
  if (support::effort() >= 1) {
    EXPECT_GT(greatest, 0.1);
  }
}

TEST(FixedPointErrors, OfShortArgumentsAreCountedInUnits) {
  random_source random(1807);
  double greatest = 0;
  for (repeat trial(1500); trial.again();) {
    const long bits = random.between(64, random.one_in(4) ? 6000 : 700);
    const long small = random.between(1, random.one_in(3) ? 2 : bits / 2);
    const long scale = random.between(small + 1, bits);
    // 0 < |a| < 2^(scale - small), beside the bounds at times.
    integer a = integer(1) << static_cast<unsigned long>(scale - small);
    const long kind = random.between(0, 2);
    a = kind == 0 ? integer(1) : kind == 1 ? integer(a - 1) : random.any_integer(scale - small);
    if (a == 0) continue;
    if (random.one_in(2)) a = -a;
    real x(bits + 8);
    mpfr_set_z_2exp(x, a.backend().data(), -scale, MPFR_RNDN);
    const bool sine = random.one_in(2);
    const integer computed = sine ? fixed_point::sine_of_short(a, scale, small, bits)
                                  : fixed_point::expm1_of_short(a, scale, small, bits);
    real exact(bits + 64);
    (sine ? mpfr_sin : mpfr_expm1)(exact, x, MPFR_RNDN);
    real value(bits + 8);
    mpfr_set_z_2exp(value, computed.backend().data(), -bits, MPFR_RNDN);
    mpfr_sub(exact, exact, value, MPFR_RNDN);
    mpfr_mul_2si(exact, exact, bits, MPFR_RNDN);
    const double missing = std::abs(mpfr_get_d(exact, MPFR_RNDN));
    ASSERT_LE(missing, 2) << bits << " bits, " << small << ", " << scale;
    greatest = std::max(greatest, missing);
  }
  if (support::effort() >= 1) {
    EXPECT_GT(greatest, 0.9);
  }
}

// The numbers that arguments are reduced by, each cut off, and the same where fewer limbs are asked
// for after more.
TEST(FixedPointErrors, OfPrimeNumbersAreBelowAUnit) {
  random_source random(1806);
  for (repeat trial(60); trial.again();) {
    const long w = random.between(2, 200);
    const auto logarithms = fixed_point::logarithms_of_primes(w);
    const auto angles = fixed_point::angles_of_primes(w);
    for (std::size_t j = 0; j < fixed_point::prime_count; ++j) {
      real exact(64 * w + 128);
      mpfr_log_ui(exact, static_cast<unsigned long>(fixed_point::primes[j]), MPFR_RNDN);
      const auto expect_cut_off = [&](const fixed_point::limb* computed) {
        mpz_t whole;
        mpz_roinit_n(whole, computed, w + 1);
        real value(64 * (w + 1));
        mpfr_set_z_2exp(value, whole, -64 * w, MPFR_RNDN);
        const double missing = units_missing(exact, value, w);
        ASSERT_TRUE(missing > 0 && missing < 1) << w << ", number " << j;
      };
      expect_cut_off(logarithms->number(j, w));
      const fixed_point::gaussian_integer prime = fixed_point::gaussian_primes[j];
      real y(64);
      mpfr_set_si(y, prime.im, MPFR_RNDN);
      mpfr_set_si(exact, prime.re, MPFR_RNDN);
      mpfr_atan2(exact, y, exact, MPFR_RNDN);
      mpfr_mul_2ui(exact, exact, 1, MPFR_RNDN);
      expect_cut_off(angles->number(j, w));
    }
  }
}

}  // namespace fixed_point_functions_test
}  // namespace polhode
