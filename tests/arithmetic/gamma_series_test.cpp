// Gamma, log Gamma and erf by their series: remainders beside the values, functional equations,
// Arb, and sets beside their members.

#include <array>

#include <gtest/gtest.h>

#include "arithmetic/functions/bernoulli.hpp"
#include "arithmetic/functions/erf_series.hpp"
#include "arithmetic/functions/gamma_series.hpp"
#include "arithmetic/functions/reciprocal_gamma.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "polhode/arithmetic/mpfr_cell.hpp"
#include "polhode/arithmetic/special_functions.hpp"
#include "support/random.hpp"
#include "support/real.hpp"

#ifdef POLHODE_HAVE_ARB
#include <acb_hypgeom.h>
#endif

namespace polhode {
namespace gamma_series_test {

using support::random_source;
using support::repeat;

constexpr precision bits = 200;

rational fraction(random_source& random, long low, long high) {
  constexpr long parts = 1024;
  return {random.between(low * parts, high * parts), parts};
}
complex_ball point(const rational& re, const rational& im, precision p = bits) {
  return {ball(re, p), ball(im, p)};
}
/// By MPFR, which shares no formula.
ball by_mpfr(int (*f)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t), const rational& x, precision many = 300) {
  detail::mpfr_cell low(many);
  detail::mpfr_cell high(many);
  detail::mpfr_cell argument(many);
  mpfr_set_q(argument.get(), x.backend().data(), MPFR_RNDN);
  f(low.get(), argument.get(), MPFR_RNDD);
  f(high.get(), argument.get(), MPFR_RNDU);
  return ball::from_end_points(low.get(), high.get(), many);
}
int log_gamma_of(mpfr_ptr r, mpfr_srcptr x, mpfr_rnd_t rounding) {
  int sign = 0;
  return mpfr_lgamma(r, &sign, x, rounding);
}

// B_2k = (-1)^(k-1) 2 (2k)! zeta(2k)/(2 pi)^(2k) (DLMF 25.6.2).
TEST(BernoulliNumbers, AreThoseOfZeta) {
  ball factorial(1, 400);
  for (long k = 1; k <= 150; ++k) {
    factorial = factorial * (2 * k - 1) * (2 * k);
    const ball size =
        2 * factorial * zeta(static_cast<unsigned long>(2 * k), 400) / pow(2 * pi(400), 2 * k);
    const rational b = detail::bernoulli_number(static_cast<std::size_t>(k));
    EXPECT_TRUE(contains(k % 2 == 0 ? -size : size, b)) << k;
  }
  EXPECT_EQ(detail::bernoulli_number(8), rational(-3617, 510));
}

// The remainder is nearly the first term left out, for real w: a bound that is too small is seen.
TEST(StirlingSeries, HoldsLogGammaAfterAnyNumberOfTerms) {
  random_source random(3);
  int attained = 0;
  for (repeat trial(300); trial.again();) {
    const rational x = fraction(random, 1, 9) + rational(1, 4);
    const auto terms = static_cast<std::size_t>(random.between(1, 9));
    const ball value = detail::log_gamma_by_terms(ball(x, bits), terms);
    const ball known = by_mpfr(log_gamma_of, x);
    ASSERT_TRUE(overlaps(value, known)) << x << ' ' << terms;
    const ball error = abs(value.middle() - known);
    const rational bound = upper_rational(value) - lower_rational(value.middle());
    if (lower_rational(error) > bound * rational(9, 10)) ++attained;
  }
  EXPECT_GT(attained, 0);
}

// Beside the imaginary axis the remainder is greater than the first term left out.
TEST(StirlingSeries, HoldsLogGammaOffTheRealAxis) {
  random_source random(4);
  for (repeat trial(200); trial.again();) {
    const rational x = fraction(random, 0, 3) + rational(1, 1024);
    const rational y = fraction(random, -6, 6);
    if (abs(y) < 1) continue;
    const complex_ball w = point(x, y);
    const complex_ball known = log_gamma(w);
    for (const std::size_t terms : {1UL, 2UL, 3UL, 5UL}) {
      EXPECT_TRUE(overlaps(detail::log_gamma_by_terms(w, terms), known)) << x << ' ' << y;
    }
  }
}

TEST(ComplexGamma, HasItsFunctionalEquations) {
  random_source random(5);
  for (repeat trial(200); trial.again();) {
    const rational x = fraction(random, -8, 12);
    const rational y = fraction(random, -9, 9);
    if (y == 0) continue;
    const precision p =
        std::array{40, 100, 333, 800}.at(static_cast<std::size_t>(random.between(0, 3)));
    const complex_ball z = point(x, y, p);
    const complex_ball g = gamma(z);
    ASSERT_FALSE(g.is_undefined()) << x << ' ' << y;
    EXPECT_TRUE(overlaps(gamma(z + 1), z * g));
    EXPECT_TRUE(overlaps(g * gamma(1 - z) * sin(z * pi(p)), complex_ball(pi(p))));
    EXPECT_TRUE(overlaps(gamma(conj(z)), conj(g)));
    // DLMF 5.5.5: Gamma(z) Gamma(z + 1/2) = 2^(1 - 2z) sqrt(pi) Gamma(2z).
    EXPECT_TRUE(overlaps(g * gamma(z + rational(1, 2)),
                         exp((1 - 2 * z) * log_2(p)) * sqrt(pi(p)) * gamma(2 * z)));
    const magnitude error = max(g.re.radius(), g.im.radius());
    EXPECT_LE(multiply_up(error, magnitude::power_of_two(p - 8)), g.magnitude_upper());
  }
}

// The branch that is continuous: log Gamma(z + 1) = log Gamma(z) + log z, with the principal
// logarithm where Re z > 0.
TEST(ComplexLogGamma, IsOneBranch) {
  random_source random(6);
  for (repeat trial(300); trial.again();) {
    const rational x = fraction(random, 0, 5) + rational(1, 4096);
    const rational y = fraction(random, -1, 1) * random.between(1, 300);
    if (y == 0) continue;
    const complex_ball z = point(x, y, 160);
    const complex_ball value = log_gamma(z);
    ASSERT_FALSE(value.is_undefined()) << x << ' ' << y;
    EXPECT_TRUE(overlaps(log_gamma(z + 1), value + log(z))) << x << ' ' << y;
    EXPECT_TRUE(overlaps(exp(value), gamma(z)));
    EXPECT_TRUE(overlaps(log_gamma(conj(z)), conj(value)));
  }
  EXPECT_TRUE(log_gamma(point(-1, 1)).is_undefined());
  EXPECT_TRUE(contains(log_gamma(point(1, 0)), rational(0), rational(0)));
  // Beside the zero at 1: log Gamma(1 + i h) = -i euler_gamma h + O(h^2).
  const complex_ball beside = log_gamma(complex_ball(ball(1, 60), scale(ball(1, 60), -50)));
  EXPECT_LE(multiply_up(beside.re.radius(), magnitude::power_of_two(50)),
            magnitude::power_of_two(0));
  EXPECT_TRUE(certainly_negative(beside.im));
}

TEST(GammaOfRealBalls, IsThatOfMpfr) {
  random_source random(7);
  for (repeat trial(400); trial.again();) {
    rational x = fraction(random, -12, 40);
    if (random.between(0, 3) == 0) x /= integer(1) << static_cast<unsigned>(random.between(1, 90));
    if (denominator(x) == 1) continue;
    const precision p =
        std::array{30, 60, 128, 250}.at(static_cast<std::size_t>(random.between(0, 3)));
    const ball set(x, p);
    const ball value = gamma(set);
    ASSERT_TRUE(overlaps(value, by_mpfr(mpfr_gamma, x))) << x << ' ' << p;
    EXPECT_LE(multiply_up(value.radius(), magnitude::power_of_two(p - 6)), value.magnitude_upper())
        << x << ' ' << p;
    if (x <= 0) continue;
    ASSERT_TRUE(overlaps(log_gamma(set), by_mpfr(log_gamma_of, x))) << x << ' ' << p;
  }
  EXPECT_TRUE(gamma(ball(5, bits)).is_exact());
  EXPECT_TRUE(gamma(ball(0, bits)).is_undefined());
  EXPECT_TRUE(gamma(ball(-3, bits)).is_undefined());
}

TEST(ReciprocalGamma, HoldsItsRest) {
  random_source random(9);
  for (repeat trial(200); trial.again();) {
    rational t = fraction(random, 0, 1) - rational(1, 2);
    if (random.between(0, 9) == 0) t = random.between(0, 1) == 0 ? rational(1, 2) : rational(-1, 2);
    const ball known = 1 / by_mpfr(mpfr_gamma, 1 + t);
    for (std::size_t terms = 1; terms <= 30; ++terms) {
      ASSERT_TRUE(overlaps(detail::reciprocal_gamma_by_terms(ball(t, bits), terms), known))
          << t << ' ' << terms;
    }
  }
}

// With all precisions for which the series is in use, in bits that no guard hides.
TEST(ReciprocalGamma, IsThatOfMpfrAtAnyPrecision) {
  random_source random(10);
  constexpr precision many = 600;
  for (repeat trial(2000); trial.again();) {
    rational x = fraction(random, 0, 12) + rational(random.between(1, 1000), 1024 * 1024);
    if (random.between(0, 3) == 0) x /= integer(1) << static_cast<unsigned>(random.between(1, 60));
    if (denominator(x) == 1) continue;
    const precision p = random.between(53, 440);
    const std::optional<ball> value = detail::gamma_by_taylor_series(ball(x, p), p);
    ASSERT_TRUE(value) << x << ' ' << p;
    const ball known = by_mpfr(mpfr_gamma, x, many);
    ASSERT_TRUE(overlaps(*value, known)) << x << ' ' << p;
    EXPECT_LE(multiply_up(value->radius(), magnitude::power_of_two(p + 4)),
              value->magnitude_upper())
        << x << ' ' << p;
  }
}

TEST(GammaOfSets, HoldsThatOfMembers) {
  random_source random(8);
  for (repeat trial(200); trial.again();) {
    const rational x = fraction(random, 0, 9) + rational(1, 512);
    const rational y = fraction(random, -5, 5);
    const auto radius = magnitude::power_of_two(-static_cast<long>(random.between(5, 60)));
    const complex_ball set = point(x, y, 90).enlarged(radius);
    const ball real_set = ball(x, 90).enlarged(radius);
    const complex_ball value = gamma(set);
    const complex_ball logarithm = log_gamma(set);
    for (const rational& re : {lower_rational(set.re), upper_rational(set.re)}) {
      if (re <= 0) continue;
      EXPECT_TRUE(overlaps(gamma(real_set), gamma(ball(re, 300))));
      EXPECT_TRUE(overlaps(log_gamma(real_set), log_gamma(ball(re, 300))));
      EXPECT_TRUE(overlaps(erf(real_set), by_mpfr(mpfr_erf, re)));
      for (const rational& im : {lower_rational(set.im), upper_rational(set.im)}) {
        const complex_ball member = point(re, im, 300);
        if (!value.is_undefined()) {
          EXPECT_TRUE(overlaps(value, gamma(member))) << x << ' ' << y;
        }
        if (!logarithm.is_undefined()) {
          EXPECT_TRUE(overlaps(logarithm, log_gamma(member)));
        }
        EXPECT_TRUE(overlaps(erf(set), erf(member)));
      }
    }
  }
}

// Of a narrow set nothing is lost but what the derivative asks for, and little is given away.
TEST(GammaOfSets, AreAsWideAsTheDerivativeMakesThem) {
  for (const rational& x : {rational(1, 2), rational(9, 10), rational(13, 10), rational(5, 2),
                            rational(7), rational(401, 20), rational(1'000'001, 10)}) {
    SCOPED_TRACE(x);
    // The widest of narrow sets, where that is not too wide for a linear bound.
    const ball center = ball(x, 200).middle();
    const bool is_large = x > 1000;
    const ball radius = is_large ? ball(rational(1, 23), 200) : scale(center, -22);
    const ball set = hull(center - radius, center + radius);
    const ball value = gamma(set);
    const ball slope = abs(digamma(ball(x, 200)) * gamma(ball(x, 200)));
    for (const rational& end : {lower_rational(set), upper_rational(set)}) {
      EXPECT_TRUE(contains(value, gamma(ball(end, 400)).middle()));
    }
    const rational widest(is_large ? 16 : 11, 10);
    EXPECT_TRUE(certainly_less(value - value.middle(), slope * radius * widest));
  }
}

/// (2/sqrt(pi)) times the sum of (-1)^k z^(2k+1)/(k! (2k+1)), another series, in so many bits that
/// nothing is lost; what is left out is at most the last term once terms fall by half.
complex_ball erf_by_powers(const complex_ball& z) {
  constexpr precision many = 900;
  const complex_ball own = z.with_precision(many);
  const complex_ball factor = -square(own);
  complex_ball power = own;
  complex_ball sum = own;
  constexpr long terms = 900;
  for (long k = 1; k < terms; ++k) {
    power = power * factor / k;
    sum += power / (2 * k + 1);
  }
  return scale(sum.enlarged(power.magnitude_upper()), 1) / sqrt(pi(many));
}

TEST(ComplexErf, IsThatOfAnotherSeries) {
  random_source random(9);
  for (repeat trial(60); trial.again();) {
    const rational x = fraction(random, -6, 6);
    const rational y = fraction(random, -6, 6);
    const precision p = std::array{40, 100, 300}.at(static_cast<std::size_t>(random.between(0, 2)));
    const complex_ball z = point(x, y, p);
    const complex_ball value = erf(z);
    ASSERT_TRUE(overlaps(value, erf_by_powers(z))) << x << ' ' << y;
    const magnitude error = max(value.re.radius(), value.im.radius());
    EXPECT_LE(multiply_up(error, magnitude::power_of_two(p - 8)), value.magnitude_upper())
        << x << ' ' << y << ' ' << p;
    EXPECT_TRUE(overlaps(erfc(z), 1 - value));
  }
  EXPECT_TRUE(erf(point(1000, 1)).is_undefined());
}

// The sum ended early: what follows the last term is as large as it may be where terms fall by
// half, and none may be left out.
TEST(ErfSeries, HoldsTheRest) {
  random_source random(10);
  for (repeat trial(200); trial.again();) {
    const complex_ball w = point(fraction(random, -20, 20), fraction(random, -20, 20));
    const complex_ball whole = detail::sum_of_erf(w, bits, bits);
    const ball real_whole = detail::sum_of_erf(abs(w.re), bits, bits);
    for (const long small : {1L, 3L, 10L}) {
      EXPECT_TRUE(overlaps(detail::sum_of_erf(w, bits, small), whole));
      EXPECT_TRUE(overlaps(detail::sum_of_erf(abs(w.re), bits, small), real_whole));
    }
  }
}

#ifdef POLHODE_HAVE_ARB
ball from_arb(const arb_struct* x, precision p) {
  detail::mpfr_cell low(p + 30);
  detail::mpfr_cell high(p + 30);
  arb_get_interval_mpfr(low.get(), high.get(), x);
  return ball::from_end_points(low.get(), high.get(), p + 30);
}

TEST(ComplexGamma, IsThatOfArb) {
  random_source random(11);
  for (repeat trial(300); trial.again();) {
    const rational x(random.between(-9000, 9000), 512);
    const rational y(random.between(-9000, 9000), 1024);
    if (y == 0) continue;
    const precision p = std::array{50, 120, 400}.at(static_cast<std::size_t>(random.between(0, 2)));
    acb_t z;
    acb_t w;
    acb_init(z);
    acb_init(w);
    arf_set_mpfr(arb_midref(acb_realref(z)), support::exact_real(x).get());
    arf_set_mpfr(arb_midref(acb_imagref(z)), support::exact_real(y).get());
    const complex_ball own = point(x, y, p);
    const auto by_arb = [&] {
      return complex_ball(from_arb(acb_realref(w), p), from_arb(acb_imagref(w), p));
    };
    acb_gamma(w, z, p + 20);
    EXPECT_TRUE(overlaps(gamma(own), by_arb())) << x << ' ' << y;
    if (x > 0) {
      acb_lgamma(w, z, p + 20);
      EXPECT_TRUE(overlaps(log_gamma(own), by_arb())) << x << ' ' << y;
    }
    acb_hypgeom_erf(w, z, p + 20);
    const complex_ball error_function = by_arb();
    if (error_function.is_bounded()) {
      EXPECT_TRUE(overlaps(erf(own), error_function)) << x << ' ' << y;
    }
    acb_clear(z);
    acb_clear(w);
  }
}
#endif

}  // namespace gamma_series_test
}  // namespace polhode
