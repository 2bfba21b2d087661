// Bessel functions as oscillations: their amplitudes, and the integrals that rest on them.

#include "polhode/expression/hankel_amplitudes.hpp"

#include <algorithm>
#include <array>
#include <string>

#include <gtest/gtest.h>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/expression/library_functions.hpp"
#include "support/integrals_as_text.hpp"
#include "support/random.hpp"

namespace polhode {
namespace hankel_amplitudes_test {

using detail::bound_of_hankel_amplitudes;
using detail::hankel_amplitudes;
using detail::hankel_amplitudes_at;

class HankelAmplitudes : public ::testing::Test {
 protected:
  void SetUp() override {
    if (arb_functions()->empty()) GTEST_SKIP() << "the library was built without Arb";
  }
  support::random_source random{20261130};

  rational order() {
    switch (random.between(0, 3)) {
      case 0:
        return random.between(-4, 9);
      case 1:
        return rational(random.between(-9, 19), 2);
      case 2:
        return random.one_in(2) ? rational(3, 2) : rational(0);
      default:
        return rational(random.between(-900, 900), 149);
    }
  }
  /// From 2^least to 2^most.
  rational scattered(long least, long most) {
    const long e = random.between(least, most);
    const rational power = e < 0 ? rational(1, 1L << -e) : rational(1L << e);
    return rational(random.between(64, 128), 64) * power;
  }
  complex_ball point(const rational& re, const rational& im, precision p) {
    return {ball(re, p), ball(im, p)};
  }
};

complex_ball bessel(const std::string& name, const rational& order, const complex_ball& z) {
  const further_functions& all = *library_functions();
  const auto f = std::find_if(all.begin(), all.end(),
                              [&](const further_function& g) { return g.what.name == name; });
  return f->over_complex(std::array{complex_ball(ball(order, z.precision())), z});
}

TEST_F(HankelAmplitudes, MakeTheBesselFunctions) {
  constexpr precision p = 256;
  for (support::repeat trial(100); trial.again();) {
    const rational nu = order();
    const rational im = random.one_in(3) ? rational(0) : rational(random.between(-300, 300), 8);
    const complex_ball z = point(scattered(-6, 8), im, p);
    const auto [P, Q] = hankel_amplitudes_at(nu, z);
    const std::string at =
        nu.str() + " at " + to_decimal(z.re, 10) + " + i " + to_decimal(z.im, 10);
    EXPECT_TRUE(overlaps(P * cos(z) + Q * sin(z), bessel("besselJ", nu, z))) << at;
    EXPECT_TRUE(overlaps(P * sin(z) - Q * cos(z), bessel("besselY", nu, z))) << at;
    const magnitude few = multiply_up(add_up(P.magnitude_upper(), Q.magnitude_upper()),
                                      magnitude::power_of_two(-200));
    EXPECT_LE(P.re.radius(), few) << at;
    EXPECT_LE(Q.im.radius(), few) << at;
    if (im != 0) continue;
    EXPECT_EQ(sign_of(P.im), certain_sign::zero);
    EXPECT_EQ(sign_of(Q.im), certain_sign::zero);
  }
  EXPECT_FALSE(hankel_amplitudes_at(1, point(0, 1, 64)).p.is_bounded());
  EXPECT_FALSE(hankel_amplitudes_at(1, point(-1, 1, 64)).q.is_bounded());
}

TEST_F(HankelAmplitudes, OverSetsHoldTheirValuesAtPoints) {
  constexpr precision p = 128;
  for (support::repeat trial(300); trial.again();) {
    const rational nu = order();
    const rational re = scattered(-6, 8);
    const rational im = random.one_in(3) ? rational(0) : rational(random.between(-300, 300), 8);
    // Up to half as wide as it is far from the imaginary axis, now and then far narrower.
    const rational width =
        re * rational(random.between(1, 63), 128) *
        (random.one_in(2) ? rational(1, 1L << random.between(0, 40)) : rational(1));
    const rational height = im == 0 ? rational(0) : scattered(-12, 3);
    const auto side = [&](const rational& x, const rational& r) {
      return hull(ball(rational(x - r), p), ball(rational(x + r), p));
    };
    const complex_ball set{side(re, width), side(im, height)};
    const hankel_amplitudes<complex_ball> over = hankel_amplitudes_at(nu, set);
    const hankel_amplitudes<region> in_balls = hankel_amplitudes_at(nu, region::in_balls(set));
    ASSERT_TRUE(over.p.is_bounded());
    for (int k = 0; k < 4; ++k) {
      const auto inside = [&](const rational& x, const rational& r) {
        return rational(x + r * rational(random.between(-64, 64), 64));
      };
      const hankel_amplitudes<complex_ball> at =
          hankel_amplitudes_at(nu, point(inside(re, width), inside(im, height), p));
      EXPECT_TRUE(overlaps(over.p, at.p)) << nu << " " << re << " " << im << " " << width;
      EXPECT_TRUE(overlaps(over.q, at.q)) << nu << " " << re << " " << im << " " << width;
      EXPECT_TRUE(overlaps(in_balls.p.to_complex_ball(), at.p));
    }
  }
}

TEST_F(HankelAmplitudes, KeepTheirBound) {
  for (support::repeat trial(500); trial.again();) {
    const rational nu = order();
    // Up to the imaginary axis, where the bound is for the other half plane of K.
    const rational re = scattered(-20, 6);
    const rational im = random.one_in(4) ? rational(0) : scattered(-6, 6);
    const complex_ball z = point(re, random.one_in(2) ? im : rational(-im), 128);
    const ball size = sqrt(square(z.re) + square(z.im));
    const auto [P, Q] = hankel_amplitudes_at(nu, z);
    const ball bound = ball(0, 64).enlarged(bound_of_hankel_amplitudes(nu, size)) / sqrt(size);
    for (const complex_ball& one : {P, Q}) {
      EXPECT_LE(one.magnitude_lower(), bound.magnitude_upper())
          << nu << " at " << to_decimal(z.re, 10) << " + i " << to_decimal(z.im, 10);
    }
  }
  // It is not far off, where |z| is large; and grows as K does, where it is small.
  EXPECT_LE(bound_of_hankel_amplitudes(0, ball(1000, 64)), magnitude::power_of_two(1));
  EXPECT_LE(bound_of_hankel_amplitudes(rational(3, 2), ball(rational(1, 1024), 64)),
            magnitude::power_of_two(13));
  EXPECT_TRUE(bound_of_hankel_amplitudes(0, ball(0, 64)).is_infinite());
  EXPECT_TRUE(bound_of_hankel_amplitudes(1'000'000, ball(1, 64)).is_infinite());
}

TEST_F(HankelAmplitudes, GiveTheTailsOfIntegrals) {
  support::expect_values({
      // A shift, from 1 on: with what is before that.
      {"besselJ(0, 2*x+1)*(2*x+1)/(1+(2*x+1)^2)", "-1/2", "inf", "besselK(0, 1)/2"},
      {"besselJ(0, x+pi)*(x+pi)/(1+(x+pi)^2)", "-pi", "inf", "besselK(0, 1)"},
      // Mirrored, of odd and even orders.
      {"besselJ(1, x)/x", "-inf", "0", "1"},
      {"besselJ(2, -x)/x^2", "0", "inf", "1/3"},
      {"besselJ(3, -x)/x", "0", "inf", "-1/3"},
      // Frequencies that are irrational, or cancel; other powers of the argument.
      {"besselJ(0, sqrt(2)*x)*cos(x)", "0", "inf", "1"},
      {"besselJ(0, pi*x)*x/(1+x^2)", "0", "inf", "besselK(0, pi)"},
      {"besselJ(0, x)*sin(x)/x", "0", "inf", "pi/2"},
      {"besselJ(0, x^2)", "0", "inf", "gamma(1/4)/(2^(3/2)*gamma(3/4))"},
      {"besselJ(0, sqrt(x))/(1+x)", "0", "inf", "2*besselK(0, 1)"},
      {"besselJ(1, 1/x)/x", "0", "inf", "1"},
      // Airy functions, by orders of thirds: derivatives of Ai(-x)/x and the like.
      {"airyAi(x)", "-inf", "0", "2/3"},
      {"airyAi(-2*x)", "0", "inf", "1/3"},
      {"airyAiPrime(-x)", "0", "inf", "airyAi(0)"},
      {"airyAiPrime(-x)/x + airyAi(-x)/x^2", "1", "inf", "airyAi(-1)"},
      {"airyBiPrime(-x)/x + airyBi(-x)/x^2", "1", "inf", "airyBi(-1)"},
      {"airyAi(-x^2)*x", "0", "inf", "1/3"},
      {"exp(x)*airyAi(x)+exp(x)*airyAiPrime(x)", "-inf", "2", "exp(2)*airyAi(2)"},
      {"exp(x)*airyBi(x)+exp(x)*airyBiPrime(x)", "-inf", "-1", "exp(-1)*airyBi(-1)"},
  });
}

/// The amplitudes are bounded in a half plane only, which a negative shift would leave.
TEST_F(HankelAmplitudes, AreNotAskedForWithANegativeShift) {
  for (const char* f : {"besselJ(0, x-1)/(1+x)", "besselJ(0, x-pi)/(1+x)"}) {
    EXPECT_NE(support::integral_of(f, "4", "inf").verdict, status::certified) << f;
  }
}

// x^(1/2) J_0 has no limit, and the squares are like 1/x.
TEST_F(HankelAmplitudes, DoNotMakeADivergentIntegralConverge) {
  for (const char* f :
       {"x*besselJ(0, x)", "sqrt(x)*besselJ(0, x)", "besselJ(0, x)^2", "besselJ(0, x)*cos(x)",
        "besselY(0, x)*sin(x)", "besselJ(0, x)*besselJ(2, x)", "besselJ(0, x)^2*cos(2*x)",
        "besselJ(1, x)*exp(x/1000)", "airyAi(-x)^2", "x*airyAiPrime(-x)", "airyBi(x)*cos(x)",
        "besselJ(0, x)*besselJ(0, 2*x)*cos(3*x)"}) {
    EXPECT_NE(support::integral_of(f, "1", "inf").verdict, status::certified) << f;
  }
}

}  // namespace hankel_amplitudes_test
}  // namespace polhode
