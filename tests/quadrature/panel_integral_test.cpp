// The integral over one panel: each of the terms that make up its error bound is nearly attained by
// a case here, so that none can be left out or halved.

#include "quadrature/series/panel_integral.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "polhode/arithmetic/elementary.hpp"
#include "quadrature/series/hyperexponential.hpp"
#include "quadrature/series/taylor_ranges.hpp"
#include "support/random.hpp"

namespace polhode {
namespace panel_integral_test {

using detail::panel_integral;
using detail::panel_value;
using detail::smooth_range;
using detail::taylor_panel;

constexpr long fraction_bits = 64;
constexpr precision many_bits = 512;
constexpr long most_terms = 10'000;

const rational_polynomial y = rational_polynomial::variable();
rational_polynomial constant(const rational& c) { return rational_polynomial({c}); }
const taylor_panel symmetric{0, 1, false};
const taylor_panel at_the_end{0, 1, true};

/// (numerator) y^power over -1 <= y <= 1, or 0 <= y <= 1.
smooth_range range_of(const rational_polynomial& numerator, const rational& power) {
  smooth_range range;
  range.numerator = numerator;
  if (power != 0) range.factors.push_back({y, power});
  range.lower = power != 0 ? 0 : -1;
  range.upper = 1;
  return range;
}
/// A range of which the panel sees the upper end only by its enclosures.
void end_inexactly(smooth_range& range, const rational& z) {
  range.upper = end_point([z](precision p) { return ball(z, std::max<precision>(p, many_bits)); });
}
taylor_panel cut(taylor_panel panel) {
  panel.to_upper = true;
  return panel;
}

ball value_of(const smooth_range& range, const taylor_panel& panel) {
  panel_integral integral(range, panel);
  const std::optional<panel_value> found = integral.in_units(fraction_bits, many_bits, most_terms);
  EXPECT_TRUE(found);
  return found ? found->value : ball();
}

/// |middle of x - y| / radius of x.
double share_of_radius(const ball& x, const ball& known) {
  const auto log2_of = [](const magnitude& m) {
    return m.is_zero()
               ? -1e9
               : std::log2(static_cast<double>(m.fraction())) + static_cast<double>(m.exponent());
  };
  return std::exp2(log2_of((x.middle() - known).magnitude_upper()) - log2_of(x.radius()));
}

/// The odd number p of 1, ..., most whose multiple p 2^f leaves most over when it is divided by n:
/// a quotient off by nearly a unit.
long numerator_for(long n, long most) {
  long best = 1;
  integer greatest = -1;
  for (long p = 1; p <= most; p += 2) {
    const integer left = (integer(p) << fraction_bits) % n;
    if (left > greatest) {
      greatest = left;
      best = p;
    }
  }
  return best;
}
/// Of b_n = P_n / (n + power + 1), each off by nearly a unit.
std::vector<rational> badly_divided(long count, long power, long most, long step = 1) {
  std::vector<rational> c;
  for (long n = 0; n < count; ++n) {
    c.emplace_back(n % step == 0 ? numerator_for(n + power + 1, most) : 0);
  }
  return c;
}

/// The integral of y^power (1 + m y) e^(s y), or of that times cos(t y + angle), from 0 to 1.
ball known_integral(long power, const rational& m, const rational& s, const rational& t,
                    const rational& angle) {
  constexpr long terms = 160;
  ball real(0, many_bits);
  ball imaginary(0, many_bits);
  ball re(1, many_bits);  // (s + i t)^k/k!
  ball im(0, many_bits);
  for (long k = 0; k < terms; ++k) {
    const rational weight = rational(1, power + k + 1) + m / rational(power + k + 2);
    real += re * weight;
    imaginary += im * weight;
    const ball next = (re * s - im * t) / (k + 1);
    im = (re * t + im * s) / (k + 1);
    re = next;
  }
  const ball phase(angle, many_bits);
  // |s|, |t| < 12: the rest is less than 2 * 24^160/160! (1 + m).
  return (real * cos(phase) - imaginary * sin(phase)).enlarged(magnitude::power_of_two(-180));
}

const rational great = rational(integer(1) << 40);  // of P: the terms' own errors do not count
constexpr long steep = 1000;                        // y^1000 counts near 1 alone

TEST(PanelIntegral, TermsAtAnEndAreOffByNearlyAUnit) {
  constexpr long count = 12;
  const std::vector<rational> c = badly_divided(count, steep, steep + count);
  rational exact = 0;
  for (long n = 0; n < count; ++n) exact += c[static_cast<std::size_t>(n)] / (n + steep + 1);
  const ball found = value_of(range_of(rational_polynomial(c), steep), at_the_end);
  EXPECT_TRUE(contains(found, exact));
  EXPECT_GT(share_of_radius(found, ball(exact, many_bits)), 0.95);
}

TEST(PanelIntegral, TermsOfAWholePanelCountTwice) {
  constexpr long count = 81;
  const std::vector<rational> c = badly_divided(count, 0, count, 2);
  rational exact = 0;
  for (long n = 0; n < count; n += 2) exact += 2 * c[static_cast<std::size_t>(n)] / (n + 1);
  const ball found = value_of(range_of(rational_polynomial(c), 0), symmetric);
  EXPECT_TRUE(contains(found, exact));
  EXPECT_GT(share_of_radius(found, ball(exact, many_bits)), 0.85);
}

TEST(PanelIntegral, TermsAtACutAreRoundedTwice) {
  // So great a power that the b_n are small, and rounding z^n does not count.
  constexpr long power = 1'000'000;
  constexpr long count = 4;
  const std::vector<rational> c = badly_divided(count, power, 4000);
  support::random_source random(1);
  double worst = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const rational z =
        1 - rational(integer(random.between(1, 1L << 30)), integer(1) << fraction_bits);
    smooth_range range = range_of(rational_polynomial(c), power);
    end_inexactly(range, z);
    rational sum = 0;
    rational z_n = 1;
    for (long n = 0; n < count; ++n) {
      sum += c[static_cast<std::size_t>(n)] * z_n / (n + power + 1);
      z_n *= z;
    }
    const ball known =
        ball(sum, many_bits) * detail::power_of_positive(ball(z, many_bits), rational(power + 1));
    const ball found = value_of(range, cut(at_the_end));
    EXPECT_TRUE(contains(found, known)) << z;
    worst = std::max(worst, share_of_radius(found, known));
  }
  EXPECT_GT(worst, 0.7);
}

TEST(PanelIntegral, PowersAtACutAreOffByNearlyAUnitEach) {
  support::random_source random(2);
  double worst = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const rational z =
        1 - rational(integer(random.between(1, 1L << 52)), integer(1) << fraction_bits);
    smooth_range range = range_of(constant(1) + constant(great) * y * y, 0);
    end_inexactly(range, z);
    const rational exact = z + great * z * z * z / 3;
    const ball found = value_of(range, cut(at_the_end));
    EXPECT_TRUE(contains(found, exact)) << z;
    worst = std::max(worst, share_of_radius(found, ball(exact, many_bits)));
  }
  EXPECT_GT(worst, 0.9);
}

TEST(PanelIntegral, TheEndOfACutIsOffByHalfAUnit) {
  const rational z = 1 - rational(integer(5), integer(1) << (fraction_bits + 1));
  const rational power(-999, 1000);
  smooth_range range = range_of(constant(1) + constant(great) * y, power);
  end_inexactly(range, z);
  const ball known = (1 / ball(power + 1, many_bits) + ball(great * z / (power + 2), many_bits)) *
                     detail::power_of_positive(ball(z, many_bits), rational(power + 1));
  const ball found = value_of(range, cut(at_the_end));
  EXPECT_TRUE(contains(found, known));
  EXPECT_GT(share_of_radius(found, known), 0.95);
}

TEST(PanelIntegral, TheCoefficientsAreOffByNearlyAUnitEach) {
  support::random_source random(3);
  double worst = 0;
  for (int trial = 0; trial < 1500; ++trial) {
    const rational s(integer(random.between(10, 40)), integer(random.between(1L << 20, 1L << 21)));
    smooth_range range = range_of(constant(1) + constant(great) * y, steep);
    range.exponent = constant(s) * y;
    const ball known = known_integral(steep, great, s, 0, 0);
    const ball found = value_of(range, at_the_end);
    EXPECT_TRUE(contains(found, known)) << s;
    worst = std::max(worst, share_of_radius(found, known));
  }
  EXPECT_GT(worst, 0.8);
}

TEST(PanelIntegral, BothPartsOfComplexCoefficientsCount) {
  support::random_source random(4);
  const rational angle(-7854, 10'000);
  double worst = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    const rational s(integer(random.between(10, 40)), integer(random.between(1L << 20, 1L << 21)));
    const rational t = s * rational(random.between(200, 500), 1013);
    smooth_range range = range_of(constant(1) + constant(great) * y, steep);
    range.exponent = constant(s) * y;
    range.phase = constant(t) * y + constant(angle);
    const ball known = known_integral(steep, great, s, t, angle);
    const ball found = value_of(range, at_the_end);
    EXPECT_TRUE(contains(found, known)) << s << ' ' << t;
    worst = std::max(worst, share_of_radius(found, known));
  }
  EXPECT_GT(worst, 0.7);
}

TEST(PanelIntegral, AnEarlyErrorGrowsWithTheFunction) {
  const rational s(31, 3);
  smooth_range range = range_of(constant(1) + constant(great) * y, steep);
  range.exponent = constant(s) * y;
  EXPECT_TRUE(contains(value_of(range, at_the_end), known_integral(steep, great, s, 0, 0)));
}

TEST(PanelIntegral, AnErrorGrowsWhereTheDenominatorIsSmall) {
  // (10 - 9 y)^(-1/1000), which is nearly constant.
  const rational power(-1, 1000);
  smooth_range range = range_of(constant(1) + constant(great) * y, steep);
  range.factors.push_back({constant(10) - constant(9) * y, power});
  panel_integral closer(range, at_the_end);
  const std::optional<panel_value> known =
      closer.in_units(8 * fraction_bits, 2 * many_bits, most_terms);
  ASSERT_TRUE(known);
  EXPECT_TRUE(contains(value_of(range, at_the_end), known->value));
}

TEST(PanelIntegral, APanelTooSmallToBeSummedIsBounded) {
  const rational s(20);
  smooth_range range = range_of(constant(1), steep);
  range.exponent = constant(s) * y;
  panel_integral closer(range, at_the_end);
  const std::optional<panel_value> known =
      closer.in_units(8 * fraction_bits, 2 * many_bits, most_terms);
  panel_integral integral(range, at_the_end);
  const std::optional<panel_value> found = integral.to(40, 1000, most_terms);
  ASSERT_TRUE(known && found);
  EXPECT_EQ(integral.terms(), 0);
  EXPECT_TRUE(contains(found->value, known->value));
  EXPECT_GT(share_of_radius(found->value, known->value), 0.9);
}

/// What is left out of the integral of y^500 from 0 to 1, and of that of e^(-y) from 0 to infinity.
TEST(TaylorRanges, WhatIsLeftOutIsBounded) {
  detail::hyperexponential_integral part;
  part.lower = 0;
  part.upper = 1;
  part.function.powers.push_back({y, 500});
  const std::optional<detail::finite_ranges> of_power = detail::ranges_of(part, 64);
  ASSERT_TRUE(of_power);
  ASSERT_EQ(of_power->rests.size(), 1U);
  const detail::bounded_part& below = of_power->rests.front();
  EXPECT_EQ(below.within.lower, 0);
  ASSERT_TRUE(below.within.upper);
  EXPECT_EQ(below.done.to, detail::piece_end(*below.within.upper));
  const ball t(*below.within.upper, many_bits);
  EXPECT_TRUE(contains(below.value, pow(t, 501) / 501));
  EXPECT_GT(share_of_radius(below.value, pow(t, 501) / 501), 0.45);

  part = {};
  part.lower = 0;
  part.upper = end_point::infinity();
  part.function.exponent = constant(-1) * y;
  const std::optional<detail::finite_ranges> of_exponential = detail::ranges_of(part, 64);
  ASSERT_TRUE(of_exponential);
  ASSERT_EQ(of_exponential->rests.size(), 1U);
  const detail::bounded_part& above = of_exponential->rests.front();
  EXPECT_FALSE(above.within.upper);
  const ball from(*above.within.lower, many_bits);
  EXPECT_TRUE(contains(above.value, exp(-from)));
  EXPECT_GT(share_of_radius(above.value, exp(-from)), 0.45);
}

}  // namespace panel_integral_test
}  // namespace polhode
