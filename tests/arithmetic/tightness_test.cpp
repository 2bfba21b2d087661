// How much more than the truth a result holds. The oracles are MPFR at the ends for a monotone
// function and MPFI for the others, far beyond the result's precision.

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "polhode/arithmetic/ball.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "support/exact_set.hpp"
#include "support/functions.hpp"
#include "support/random.hpp"

namespace polhode {
namespace tightness_test {

using support::described;
using support::elementary_function;
using support::elementary_functions;
using support::exact;
using support::exact_set;
using support::kind;
using support::random_source;
using support::real;
using support::repeat;
using support::to_rational;

rational ulp_of(const ball& x) { return support::ulp(exact(x).greatest_size(), x.precision()); }

/// The result may be kept by midpoint and radius: its ends are this close together.
bool is_narrow(const exact_set& s, precision p) {
  return s.width() <=
         s.greatest_size() * support::power_of_two(-std::max<precision>(p / 2, 24) + 2);
}

/// Ends drawn so that both are numbers of p bits: a set given exactly, with a width above 2^-16.
ball wide_operand(random_source& random, const elementary_function& f, precision p) {
  for (;;) {
    real a = random.any_real(p, -12, 5);
    real b = random.one_in(8) ? real(p, random.between(-2, 2)) : random.any_real(p, -12, 5);
    if (mpfr_greater_p(a, b) != 0) std::swap(a, b);
    const ball x = ball::from_end_points(a, b, p);
    const exact_set s = exact(x);
    if (s.width() * support::power_of_two(16) > s.greatest_size() && f.defined_on(s)) return x;
  }
}

class Tightness : public ::testing::TestWithParam<elementary_function> {};

// A wide set's image is the range itself, each end rounded once.
TEST_P(Tightness, OfWideSets) {
  const elementary_function& f = GetParam();
  if (!support::has_range(f)) GTEST_SKIP() << "needs MPFI";
  random_source random(500);
  long judged = 0;
  for (repeat trial(400); trial.again();) {
    const precision p = random.between(32, 300);
    const ball x = wide_operand(random, f, p);
    SCOPED_TRACE(std::string(f.name) + " of " + described(x));
    const ball y = f.of(x);
    ASSERT_FALSE(y.is_undefined());
    const support::range truth = support::range_over(f, exact(x), p + 200);
    const exact_set got = exact(y);
    ASSERT_TRUE(got.is_bounded());
    EXPECT_LE(*got.lower, to_rational(truth.lower.lower));
    EXPECT_GE(*got.upper, to_rational(truth.upper.upper));
    if (is_narrow(got, p)) continue;
    ++judged;
    // Rounded from the truth outward, and no further.
    real end(p);
    mpfr_set(end, truth.lower.lower, MPFR_RNDD);
    EXPECT_EQ(to_rational(end), *got.lower) << "the lower end";
    mpfr_set(end, truth.upper.upper, MPFR_RNDU);
    EXPECT_EQ(to_rational(end), *got.upper) << "the upper end";
  }
  EXPECT_GT(judged, 20 * support::effort() / 2);
}

// A thin set's radius is what the function makes of it, and two units in the last place. "What the
// function makes of it" is the greatest change |f(m +- r) - f(m)|; the bounds are of first order,
// so 2^-8 of it is granted. For sin and cos (sinpi, cospi) it is 3/8: where the value is +-1 but
// for its rounding, the slope is known as sqrt(1 - value^2) <= sqrt(u) only, u the unit in the last
// place; with r = k sqrt(u) the radius is (k + k^2/2 + 1/2) u for a change of k^2/2 u, at worst a
// third more, beyond the two units.
TEST_P(Tightness, OfThinSets) {
  const elementary_function& f = GetParam();
  const std::string name = f.name;
  const rational factor =
      1 + (support::is_circular(name) ? rational(3, 8) : support::power_of_two(-8));
  random_source random(501);
  long judged = 0;
  for (repeat trial(1500); trial.again();) {
    const precision p = random.between(64, 300);
    ball x = random.any_ball(p, random.one_in(4) ? kind::half_turns : kind::thin);
    if (random.one_in(2) && x.is_bounded()) x = scale(x, -random.between(0, 40));
    if (random.one_in(8)) {
      // Near the ends of domains: 1 - 2^-k and 1 + 2^-k, with radii around that distance.
      const long k = random.between(2, p - 1);
      real m = real::power_of_two(-k);
      real one(p, 1);
      if (random.one_in(2)) {
        mpfr_sub(one, one, m, MPFR_RNDN);
      } else {
        mpfr_add(one, one, m, MPFR_RNDN);
      }
      if (random.one_in(2)) mpfr_neg(one, one, MPFR_RNDN);
      x = ball::from_midpoint_radius(one, random.any_magnitude(-k - 31 - 40, -k - 31));
    }
    if (x.is_exact() || !x.is_bounded() || x.radius() > magnitude::power_of_two(-3)) continue;
    const exact_set s = exact(x);
    if (is_narrow(s, 40) == false || !f.defined_on(s)) continue;
    if (f.grows && s.greatest_size() > 1 << 12) continue;
    SCOPED_TRACE(name + " of " + described(x));
    const ball y = f.of(x);
    ASSERT_FALSE(y.is_undefined());
    ++judged;
    const precision high = support::bits_of_ends(x) + 2 * p + 200;
    const auto value = [&](const rational& q) {
      return to_rational(support::value_at(f, q, high).lower);
    };
    const rational centre = value((*s.lower + *s.upper) / 2);
    const rational change = std::max(abs(value(*s.lower) - centre), abs(value(*s.upper) - centre));
    EXPECT_LE(to_rational(y.radius()), change * factor + 2 * ulp_of(y))
        << "units: " << described(to_rational(y.radius()) / ulp_of(y)) << " for "
        << described(change / ulp_of(y));
  }
  EXPECT_GT(judged, 100 * support::effort() / 2);
}

// The range is at least the hull of the values at many members: a second opinion on the width.
TEST_P(Tightness, NotWithinASampledHull) {
  const elementary_function& f = GetParam();
  random_source random(502);
  for (repeat trial(12); trial.again();) {
    const precision p = random.between(32, 128);
    const ball x = wide_operand(random, f, p);
    const exact_set s = exact(x);
    const exact_set got = exact(f.of(x));
    rational least = *got.upper;
    rational most = *got.lower;
    constexpr int steps = 200;
    for (int i = 0; i <= steps; ++i) {
      const rational a = *s.lower + s.width() * integer(i * 82) * support::power_of_two(-14);
      if (!s.holds(a)) break;
      const support::enclosure v = support::value_at(f, a, p + 64);
      least = std::min(least, to_rational(v.lower));
      most = std::max(most, to_rational(v.upper));
    }
    EXPECT_LE(*got.lower, least) << f.name;
    EXPECT_GE(*got.upper, most) << f.name;
    // 200 samples of a function without poles see most of its range.
    if (support::is_circular(f.name)) {
      EXPECT_LE(got.width(), (most - least) * rational(5, 4) + 2 * support::ulp(1, p));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Functions, Tightness, ::testing::ValuesIn(elementary_functions()),
                         [](const auto& tested) { return std::string(tested.param.name); });

// -------------------------------------------------------------------------------------------------
// Field operations.

TEST(TightnessOfArithmetic, WideSets) {
  random_source random(510);
  const auto rounded = [](const rational& low, const rational& high, precision p) {
    return exact_set{to_rational(real(p, low, MPFR_RNDD)), to_rational(real(p, high, MPFR_RNDU))};
  };
  for (repeat trial(4000); trial.again();) {
    const precision p = random.between(32, 300);
    const auto draw = [&] {
      static constexpr std::array kinds = {kind::wide, kind::across_zero, kind::touching_zero};
      return random.any_ball(p, random.choose(kinds));
    };
    const ball x = draw();
    const ball y = draw();
    SCOPED_TRACE(described(x) + ", " + described(y));
    const exact_set a = exact(x);
    const exact_set b = exact(y);
    const auto check = [&](const ball& got, std::array<rational, 4> corners) {
      std::sort(corners.begin(), corners.end());
      const exact_set set = exact(got);
      if (set.width() != 0 && !is_narrow(set, p)) {
        EXPECT_EQ(set, rounded(corners.front(), corners.back(), p));
      }
    };
    // Operands that are narrow themselves do not carry their ends exactly.
    if (support::bits_of_ends(x) > p + 64 || support::bits_of_ends(y) > p + 64) continue;
    if (is_narrow(a, p) || is_narrow(b, p)) continue;
    check(x + y,
          {*a.lower + *b.lower, *a.lower + *b.lower, *a.upper + *b.upper, *a.upper + *b.upper});
    check(x - y,
          {*a.lower - *b.upper, *a.lower - *b.upper, *a.upper - *b.lower, *a.upper - *b.lower});
    check(x * y,
          {*a.lower * *b.lower, *a.lower * *b.upper, *a.upper * *b.lower, *a.upper * *b.upper});
    if (!b.holds(0)) {
      check(x / y,
            {*a.lower / *b.lower, *a.lower / *b.upper, *a.upper / *b.lower, *a.upper / *b.upper});
    }
    const rational l2 = *a.lower * *a.lower;
    const rational u2 = *a.upper * *a.upper;
    const rational least = a.holds(0) ? rational(0) : std::min(l2, u2);
    check(square(x), {least, least, std::max(l2, u2), least});
  }
}

TEST(TightnessOfArithmetic, ThinSets) {
  random_source random(511);
  for (repeat trial(4000); trial.again();) {
    const precision p = random.between(64, 300);
    const ball x = random.any_ball(p, random.one_in(4) ? kind::exact : kind::thin);
    const ball y = random.any_ball(p, random.one_in(4) ? kind::exact : kind::thin);
    if (contains_zero(x) || contains_zero(y)) continue;
    if (!is_narrow(exact(x), 48) || !is_narrow(exact(y), 48)) continue;
    SCOPED_TRACE(described(x) + ", " + described(y));
    const rational mx = (*exact(x).lower + *exact(x).upper) / 2;
    const rational my = (*exact(y).lower + *exact(y).upper) / 2;
    const rational rx = to_rational(x.radius());
    const rational ry = to_rational(y.radius());
    const rational sx = abs(mx);
    const rational sy = abs(my);
    const auto check = [&](const ball& got, const rational& propagated) {
      EXPECT_LE(to_rational(got.radius()),
                propagated * (1 + support::power_of_two(-18)) + 2 * ulp_of(got));
    };
    check(x + y, rx + ry);
    check(x - y, rx + ry);
    check(x * y, sx * ry + sy * rx);
    check(x / y, (rx + sx / sy * ry) / sy);
    check(square(x), 2 * sx * rx);
    check(x + 3L, rx);
    check(2L - x, rx);
    check(x * 7L, 7 * rx);
    check(x / 7L, rx / 7);
    check(x * rational(1, 3), rx / 3 + sx * support::ulp(rational(1, 3), p) / 2);
    check(-x, rx);
    check(abs(x), rx);
    check(scale(x, 9), 512 * rx);
    check(x.with_precision(p), rx);
    const long n = random.between(-20, 20);
    // |n| |m|^(n-1) r
    rational power = 1;
    for (long i = 0; i < std::abs(n); ++i) power *= sx;
    if (n < 0) power = 1 / power;
    check(pow(x, n), std::abs(n) * power / sx * rx * (1 + support::power_of_two(-8)));
    // The partial derivatives of hypot and agm are at most 1 and at most agm / operand.
    check(hypot(x, y), (sx * rx + sy * ry) / *exact(hypot(x, y)).lower);
    const ball mean = agm(abs(x), abs(y));
    check(mean, *exact(mean).upper * std::max(rx / sx, ry / sy));
    if (sx > 0) {
      const ball root = sqrt(abs(x));
      check(root, rx / (2 * *exact(root).lower));
    }
  }
}

// x^n for a thin x and an n so great that x^n is anything from thin to wide.
TEST(TightnessOfArithmetic, GreatPowers) {
  random_source random(513);
  for (repeat trial(500); trial.again();) {
    const precision p = random.between(64, 200);
    real m = real::power_of_two(-random.between(18, 30));
    mpfr_add_ui(m, m, 1, MPFR_RNDN);
    const ball x = ball::from_midpoint_radius(real(p, to_rational(m), MPFR_RNDN),
                                              random.any_magnitude(-90, -25 - 31));
    const long n = random.between(1, 1L << random.between(1, 27)) * (random.one_in(2) ? 1 : -1);
    SCOPED_TRACE(described(x) + " to the " + std::to_string(n));
    const exact_set s = exact(x);
    const auto power = [&](const rational& q) {
      const real base = support::exact_real(q);
      return support::enclose(
          [&](mpfr_ptr r, mpfr_rnd_t rounding) { mpfr_pow_si(r, base, n, rounding); }, p + 200);
    };
    const support::enclosure a = power(n > 0 ? *s.lower : *s.upper);
    const support::enclosure b = power(n > 0 ? *s.upper : *s.lower);
    const exact_set got = exact(pow(x, n));
    EXPECT_TRUE(got.holds(exact_set{to_rational(a.lower), to_rational(b.upper)}));
    EXPECT_LE(got.width(),
              (to_rational(b.upper) - to_rational(a.lower)) * (1 + support::power_of_two(-8)) +
                  4 * support::ulp(got.greatest_size(), p));
  }
}

TEST(TightnessOfArithmetic, SineAndCosineStayInTheUnitInterval) {
  random_source random(512);
  for (repeat trial(3000); trial.again();) {
    const precision p = random.any_precision();
    static constexpr std::array kinds = {kind::wide,  kind::across_zero, kind::touching_zero,
                                         kind::huge,  kind::tiny,        kind::half_infinite,
                                         kind::entire};
    const ball x = random.any_ball(p, random.choose(kinds));
    if (x.is_bounded() && is_narrow(exact(x), 24)) continue;
    SCOPED_TRACE(described(x));
    const auto [s, c] = sin_cos(x);
    for (const ball& y : {sin(x), cos(x), s, c}) {
      const exact_set got = exact(y);
      // A result thin enough to be kept by midpoint and radius may pass 1 by their rounding, but
      // not by more than that.
      const rational slack =
          is_narrow(got, p)
              ? rational(got.width() * support::power_of_two(-20) + 2 * support::ulp(1, p))
              : rational(0);
      EXPECT_TRUE((exact_set{-1 - slack, 1 + slack}).holds(got)) << described(y);
    }
  }
}

}  // namespace tightness_test
}  // namespace polhode
