// gamma, log_gamma, zeta, pow with real exponents, root, floor, ceil, min, max.

#include "polhode/arithmetic/special_functions.hpp"

#include <array>

#include <gtest/gtest.h>
#include <boost/multiprecision/mpfr.hpp>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "polhode/arithmetic/region.hpp"
#include "support/exact_set.hpp"
#include "support/random.hpp"
#include "support/real.hpp"

namespace polhode {
namespace special_functions_test {

constexpr precision bits = 128;

ball number(const char* text) { return parse_ball(text, bits); }
ball set(const char* low, const char* high) { return hull(number(low), number(high)); }

TEST(Gamma, IsTheFactorial) {
  long factorial = 1;
  for (long n = 1; n <= 20; ++n) {
    EXPECT_TRUE(contains(gamma(ball(n, bits)), factorial)) << n;
    factorial *= n;
  }
  // Gamma(1/2) = sqrt(pi), Gamma(-1/2) = -2 sqrt(pi).
  EXPECT_TRUE(overlaps(square(gamma(number("1/2"))), pi(bits)));
  EXPECT_TRUE(overlaps(square(gamma(number("-1/2"))), 4 * pi(bits)));
  EXPECT_TRUE(certainly_negative(gamma(number("-1/2"))));
  EXPECT_TRUE(certainly_positive(gamma(number("-3/2"))));
}

TEST(Digamma, HasItsRecurrenceAndReflection) {
  support::random_source random(5);
  for (support::repeat trial(100); trial.again();) {
    const ball x = ball(random.any_rational(12), bits);
    if (digamma(x).is_undefined() || abs(x).magnitude_upper() > magnitude::power_of_two(9))
      continue;
    // DLMF 5.5.2 and 5.5.4.
    EXPECT_TRUE(overlaps(digamma(x + 1), digamma(x) + 1 / x));
    EXPECT_TRUE(overlaps((digamma(1 - x) - digamma(x)) * sinpi(x), pi(bits) * cospi(x)));
  }
  EXPECT_TRUE(digamma(ball(0, bits)).is_undefined());
  EXPECT_TRUE(digamma(set("-5/2", "-3/2")).is_undefined());
}

TEST(Digamma, OfASetHoldsThoseOfItsMembers) {
  support::random_source random(6);
  for (support::repeat trial(100); trial.again();) {
    const ball middle = ball(random.any_rational(8), bits);
    const ball x = middle.enlarged(magnitude::power_of_two(-6));
    const ball value = digamma(x);
    if (value.is_undefined()) continue;
    EXPECT_TRUE(contains(value, digamma(ball(lower_rational(x), 300))));
    EXPECT_TRUE(contains(value, digamma(ball(upper_rational(x), 300))));
    EXPECT_TRUE(contains(value, digamma(middle.with_precision(300))));
  }
}

TEST(Digamma, OfASetUpToInfinityIsKnownFromTwoOn) {
  boost::multiprecision::mpfr_float end(0);
  boost::multiprecision::mpfr_float infinity(0);
  mpfr_set_inf(infinity.backend().data(), 1);
  const auto beyond = [&](double low) {
    mpfr_set_d(end.backend().data(), low, MPFR_RNDN);
    return ball::from_end_points(end.backend().data(), infinity.backend().data(), 64);
  };
  using function = ball (*)(const ball&);
  for (const function f : {function(digamma), function(gamma), function(log_gamma)}) {
    const ball value = f(beyond(3));
    EXPECT_FALSE(value.is_undefined());
    EXPECT_TRUE(certainly_positive(value));
    EXPECT_TRUE(overlaps(value, f(ball(3, 128))));
    EXPECT_TRUE(contains(value, f(ball(1000, 128))));
    EXPECT_TRUE(f(beyond(1.25)).is_undefined());  // Gamma falls first there
    EXPECT_TRUE(f(ball::entire(64)).is_undefined());
  }
}

TEST(Gamma, HasItsRecurrenceAndReflection) {
  support::random_source random(3);
  for (support::repeat trial(100); trial.again();) {
    const ball x = ball(random.any_rational(12), bits);
    if (gamma(x).is_undefined() || abs(x).magnitude_upper() > magnitude::power_of_two(9)) continue;
    EXPECT_TRUE(overlaps(gamma(x + 1), x * gamma(x)));
    EXPECT_TRUE(overlaps(gamma(x) * gamma(1 - x) * sinpi(x), pi(bits)));
    if (certainly_positive(x)) {
      EXPECT_TRUE(overlaps(exp(log_gamma(x)), gamma(x)));
    }
  }
}

region point(const rational& re, const rational& im) {
  return region(complex_ball{ball(re, 64), ball(im, 64)});
}
bool overlap(const region& z, const region& w) {
  const complex_ball difference = (z - w).to_complex_ball();
  return contains_zero(difference.re) && contains_zero(difference.im);
}

// In the complex plane: the recurrence, the reflection, |Gamma(iy)|^2 = pi/(y sinh(pi y)), and the
// real values.
TEST(Gamma, OverRegionsHasTheSameIdentities) {
  support::random_source random(17);
  const region circle_constant(pi(64));
  int thin = 0;
  for (support::repeat trial(300); trial.again();) {
    const rational x(random.between(-400, 1200), 128);
    const rational y(random.between(1, 800), 64);
    const region z = point(x, y);
    ASSERT_TRUE(gamma(z).is_analytic());
    EXPECT_TRUE(overlap(gamma(z + 1), z * gamma(z)));
    EXPECT_TRUE(overlap(gamma(z) * gamma(1 - z) * sin(circle_constant * z), circle_constant));
    const region on_axis = gamma(point(0, y));
    const ball size = pi(64) / (ball(y, 64) * sinh(pi(64) * ball(y, 64)));
    const magnitude low = on_axis.magnitude_lower();
    const magnitude high = on_axis.magnitude_upper();
    EXPECT_TRUE(multiply_down(low, low) <= size.magnitude_upper());
    EXPECT_TRUE(size.magnitude_lower() <= multiply_up(high, high));
    if (x > 0) {
      EXPECT_TRUE(overlap(exp(log_gamma(z)), gamma(z)));
    }
    const complex_ball value = gamma(z).to_complex_ball();
    const magnitude error = max(value.re.radius(), value.im.radius());
    thin += multiply_up(error, magnitude::power_of_two(27)) <= value.magnitude_upper() ? 1 : 0;
    if (x > 0 || denominator(x) != 1) {
      EXPECT_TRUE(overlaps(gamma(point(x, 0)).to_complex_ball().re, gamma(ball(x, 128)))) << x;
    }
  }
  EXPECT_GT(thin, 0);
}

TEST(Gamma, OverRegionsHoldsTheValuesAtMembers) {
  for (const double left : {-3.75, -0.5, 0.25, 1.5, 6.5, 40.0, 500.0}) {
    for (const double width : {0.25, 0x1p-20}) {
      const region z(double_interval(left, left + width), double_interval(0.5, 0.5 + width));
      const region value = gamma(z);
      ASSERT_TRUE(value.is_analytic());
      for (const double s : {0.0, 0.5, 1.0}) {
        const region member(double_interval(left + s * width),
                            double_interval(0.5 + width - s * width));
        EXPECT_TRUE(overlap(value, gamma(member)));
        EXPECT_TRUE(gamma(member).magnitude_upper() <=
                    multiply_up(value.magnitude_upper(), magnitude::from_integer_up(2)));
      }
    }
  }
}

// In doubles the bound of Stirling's remainder is wider than the rounding, and the value needs it.
TEST(Gamma, OverRegionsHasRoomForTheRemainder) {
  for (const long quarters : {1L, 2L, 5L, 12L, 28L, 29L, 33L}) {
    const ball x(rational(quarters, 4), 256);
    const region z(x);
    const complex_ball value = gamma(z).to_complex_ball();
    const complex_ball logarithm = log_gamma(z).to_complex_ball();
    EXPECT_TRUE(overlaps(value.re, gamma(x))) << x;
    EXPECT_TRUE(overlaps(logarithm.re, log_gamma(x))) << x;
    EXPECT_TRUE(logarithm.re.radius() <= magnitude::power_of_two(-38)) << x;
    EXPECT_TRUE(overlaps(digamma(z).to_complex_ball().re, digamma(x))) << x;
    // In balls a value has all bits, and so has the slope but for its remainder.
    const region in_balls = region::in_balls({x, ball(0, 256)});
    EXPECT_TRUE(overlaps(log_gamma(in_balls).to_complex_ball().re, log_gamma(x))) << x;
    EXPECT_TRUE(log_gamma(in_balls).to_complex_ball().re.radius() <= magnitude::power_of_two(-240));
    const ball side = x + ball(0, 256).enlarged(magnitude::power_of_two(-60));
    const complex_ball wide = log_gamma(region::in_balls({side, ball(0, 256)})).to_complex_ball();
    for (const rational& end : {lower_rational(side), upper_rational(side)}) {
      EXPECT_TRUE(overlaps(wide.re, log_gamma(ball(end, 600)))) << x;
    }
  }
}

TEST(Gamma, OverRegionsIsRefusedAtPolesAndTheCut) {
  const region across(double_interval(-1.25, -0.75), double_interval(-0.5, 0.5));
  EXPECT_EQ(gamma(across).why(), obstacle::pole);
  EXPECT_EQ(gamma(region(double_interval(0, 1))).why(), obstacle::pole);
  EXPECT_TRUE(gamma(region(double_interval(-0.75, -0.25))).is_analytic());
  EXPECT_EQ(log_gamma(region(double_interval(-0.75, -0.25))).why(), obstacle::unknown);
  EXPECT_EQ(gamma(region(double_interval(-5000.5))).why(), obstacle::unknown);
}

TEST(Gamma, OverWideSetsHoldsItsMinimum) {
  // The least value on (0, inf) is 0.8856031944108887..., at 1.4616321449683623...
  const ball least = set("0.885603194410888700278815900582", "0.885603194410888700278815900583");
  for (const ball& x : {set("1", "2"), set("1.4", "1.5"), set("0.1", "10"),
                        set("1.46163214496836", "1.46163214496837")}) {
    const ball range = gamma(x);
    EXPECT_TRUE(overlaps(range, least));
    for (int i = 0; i <= 16; ++i) {
      const rational member = lower_rational(x) + (upper_rational(x) - lower_rational(x)) * i / 16;
      EXPECT_TRUE(overlaps(range, gamma(ball(member, 200))));
      EXPECT_TRUE(overlaps(log_gamma(x), log_gamma(ball(member, 200))));
    }
  }
  EXPECT_FALSE(contains(gamma(set("1", "2")), parse_rational("0.8856")));
  EXPECT_TRUE(contains(gamma(set("1", "2")), parse_rational("1")));
  EXPECT_FALSE(contains(gamma(set("1", "2")), parse_rational("1.0000000001")));
}

// The minimum is looked for by halving the set: the longer it is the less near, and with few bits
// on a coarse grid.
TEST(Gamma, OverSetsOfAllLengthsHoldsItsMinimum) {
  const ball at_least =
      gamma(parse_ball("1.46163214496836234126265954232572132846819620400644", 300));
  const ball logarithm = log(at_least);
  for (const precision p : {53L, 64L, 128L}) {
    const ball x = hull(ball(1, p), ball(1L << 20, p));
    EXPECT_TRUE(contains(gamma(x), at_least)) << p;
    EXPECT_TRUE(contains(log_gamma(x), logarithm)) << p;
  }
  for (precision p = 2; p <= 30; ++p) {
    for (long i = 0; i < 10; ++i) {
      const ball low(rational(100 + 4 * i + (i * i) % 7, 100), 60);
      for (long k = 5; k <= 29; k += 3) {
        const ball high(parse_rational("1.46163214496836234127") + support::power_of_two(-k), 100);
        const ball x = hull(low, high).with_precision(p);
        EXPECT_TRUE(contains(gamma(x), at_least)) << p << " " << i << " " << k;
        EXPECT_TRUE(contains(log_gamma(x), logarithm)) << p << " " << i << " " << k;
      }
    }
  }
}

TEST(Gamma, IsUndefinedAcrossAPole) {
  for (const ball& x : {ball(0, bits), ball(-1, bits), ball(-20, bits), set("-1/2", "1/2"),
                        set("-1.5", "-0.5"), set("0", "1"), set("-1", "-1/2")}) {
    EXPECT_TRUE(gamma(x).is_undefined());
    EXPECT_TRUE(log_gamma(x).is_undefined());
  }
  EXPECT_FALSE(gamma(set("-0.9", "-0.1")).is_undefined());
}

TEST(Zeta, IsWhatEulerFound) {
  EXPECT_TRUE(overlaps(zeta(2, bits), square(pi(bits)) / 6));
  EXPECT_TRUE(overlaps(zeta(4, bits), pow(pi(bits), 4) / 90));
  EXPECT_TRUE(zeta(1, bits).is_undefined());
  EXPECT_TRUE(zeta(0, bits).is_undefined());
}

TEST(Power, OfRealExponents) {
  EXPECT_TRUE(contains(pow(ball(4, bits), number("1/2")), 2));
  EXPECT_TRUE(overlaps(pow(number("1/3"), number("1/3")), root(number("1/3"), 3)));
  EXPECT_TRUE(overlaps(pow(ball(2, bits), pi(bits)), exp(pi(bits) * log_2(bits))));
  EXPECT_TRUE(contains(pow(ball(-2, bits), ball(3, bits)), -8));
  EXPECT_TRUE(contains_zero(pow(ball(0, bits), number("1/2"))));
  EXPECT_TRUE(pow(ball(-2, bits), number("1/2")).is_undefined());
  EXPECT_TRUE(pow(ball(0, bits), number("-1/2")).is_undefined());
  EXPECT_TRUE(pow(set("-1", "1"), number("1/2")).is_undefined());
}

TEST(Power, OverASetOfBasesAndExponentsHoldsItsMembers) {
  support::random_source random(4);
  for (support::repeat trial(200); trial.again();) {
    const rational base = abs(random.any_rational(6)) + rational(1, 8);
    const rational exponent = random.any_rational(4);
    const rational width(1, 1L << random.between(0, 40));
    const ball x = hull(ball(base, bits), ball(rational(base + width), bits));
    const ball y = hull(ball(exponent, bits), ball(rational(exponent + width), bits));
    const ball range = pow(x, y);
    for (int i = 0; i <= 3; ++i) {
      for (int j = 0; j <= 3; ++j) {
        EXPECT_TRUE(overlaps(range, pow(ball(rational(base + width * i / 3), 250),
                                        ball(rational(exponent + width * j / 3), 250))));
      }
    }
  }
}

// Balls that are so wide that the square of the change is seen, and exponents for which that
// counts: for 17/2 that of the power, for -1/8 that of the logarithm.
TEST(Power, OverWideBallsHoldsItsEnds) {
  for (const rational& y : {rational(17, 2), rational(-1, 8), rational(-17, 2), rational(1, 8)}) {
    for (const long width : {14L, 20L, 22L, 23L, 24L, 25L, 30L}) {
      const magnitude radius = magnitude::power_of_two(-width);
      const ball power = pow(ball(3, 120).enlarged(radius), ball(y, 120));
      for (const long side : {-1L, 1L}) {
        const rational end = 3 + side * support::power_of_two(-width);
        EXPECT_TRUE(contains(power, pow(ball(end, 300), ball(y, 300)))) << y << " " << width;
        // The exponent's ends.
        const ball of_exponent = pow(ball(3, 120), ball(y, 120).enlarged(radius));
        const rational exponent = y + side * support::power_of_two(-width);
        EXPECT_TRUE(contains(of_exponent, pow(ball(3, 300), ball(exponent, 300))))
            << y << " " << width;
      }
    }
  }
}

TEST(Root, IsRealWhereThereIsOne) {
  EXPECT_TRUE(contains(root(ball(-27, bits), 3), -3));
  EXPECT_TRUE(contains(root(set("-8", "27"), 3), -2) && contains(root(set("-8", "27"), 3), 3));
  EXPECT_FALSE(contains(root(set("-8", "27"), 3), parse_rational("3.0000001")));
  EXPECT_TRUE(root(ball(-16, bits), 4).is_undefined());
  EXPECT_TRUE(root(ball(16, bits), 0).is_undefined());
}

TEST(Steps, AreExactBetweenJumps) {
  EXPECT_TRUE(floor(number("7/3")).is_exact() && contains(floor(number("7/3")), 2));
  EXPECT_TRUE(ceil(number("7/3")).is_exact() && contains(ceil(number("7/3")), 3));
  EXPECT_TRUE(contains(floor(number("-7/3")), -3));
  EXPECT_TRUE(contains_zero(floor(set("1/2", "5/2"))) && contains(floor(set("1/2", "5/2")), 2));
  EXPECT_FALSE(contains(floor(set("1/2", "5/2")), 3));
  EXPECT_TRUE(contains(max(set("0", "2"), set("1", "3")), set("1", "3")));
  EXPECT_FALSE(contains(max(set("0", "2"), set("1", "3")), parse_rational("0.99")));
  EXPECT_TRUE(contains(min(set("0", "2"), set("1", "3")), set("0", "2")));
  EXPECT_FALSE(contains(min(set("0", "2"), set("1", "3")), parse_rational("2.01")));
}

TEST(SinPi, IsReducedExactly) {
  const ball huge = scale(ball(1, bits), 1'000'000);
  EXPECT_TRUE(sinpi(huge).is_exact() && contains_zero(sinpi(huge)));
  EXPECT_TRUE(contains(cospi(huge), 1));
  EXPECT_TRUE(contains(sinpi(number("1/2")), 1) && sinpi(number("1/2")).is_exact());
  EXPECT_TRUE(contains(sinpi(set("1/4", "3/4")), 1));
  EXPECT_FALSE(contains(sinpi(set("1/4", "3/4")), parse_rational("0.707")));
}

// Beside a pole, and beside a zero of log Gamma, radii far below the last place of the argument
// still count: a result is as narrow as at many more bits, to its own last place.
TEST(SpecialFunctions, BesidePolesAsNarrowAsTheOperandAllows) {
  support::random_source random(2219);
  for (support::repeat trial(300); trial.again();) {
    const precision p = random.choose(std::array<precision, 3>{53, 64, 128});
    const long place = random.between(-4, 2);
    const long distance = random.between(1, p - 4);
    support::real m(p, random.one_in(2) ? 1 : -1);
    mpfr_div_2ui(m, m, static_cast<unsigned long>(distance), MPFR_RNDN);
    mpfr_add_si(m, m, place, MPFR_RNDN);
    const ball x = ball::from_midpoint_radius(
        m, magnitude::power_of_two(-distance - random.between(2, 3 * p)));
    SCOPED_TRACE(support::described(x));
    using function = ball (*)(const ball&);
    for (const function f : {function{gamma}, function{log_gamma}}) {
      const ball y = f(x);
      const ball z = f(x.with_precision(5 * p + 1000));
      if (z.is_undefined()) continue;
      ASSERT_FALSE(y.is_undefined());
      EXPECT_TRUE(overlaps(y, z));
      const magnitude place_of_y = scale(y.magnitude_upper(), 2 - std::int64_t{p});
      EXPECT_TRUE(y.radius() <= add_up(scale(z.radius(), 2), place_of_y))
          << support::described(y) << ", not " << support::described(z);
    }
  }
}

}  // namespace special_functions_test
}  // namespace polhode
