// Special functions as oscillations: their amplitudes, and the integrals that rest on them.

#include "polhode/expression/wave_amplitudes.hpp"

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
namespace wave_amplitudes_test {

using detail::amplitude_bound;
using detail::bounds_of_wave_amplitudes;
using detail::wave_amplitudes;
using detail::wave_amplitudes_at;
using detail::wave_function;

class WaveAmplitudes : public ::testing::Test {
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
  static wave_function hankel(const rational& nu) { return {wave_function::family::bessel, nu}; }
  /// Of Bessel functions, or of the integrals of t^(a-1) sin t and t^(a-1) cos t.
  wave_function function() {
    if (random.one_in(2)) return hankel(order());
    const rational a = random.one_in(2) ? rational(random.between(0, 1), 2)
                                        : rational(random.between(-300, 148), 149);
    return {wave_function::family::integral_of_power, a};
  }
  static std::string described(const wave_function& f) {
    const bool is_bessel = f.of == wave_function::family::bessel;
    return (is_bessel ? "Bessel " : "integral ") + f.order.str();
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

TEST_F(WaveAmplitudes, MakeTheBesselFunctions) {
  constexpr precision p = 256;
  for (support::repeat trial(100); trial.again();) {
    const rational nu = order();
    const rational im = random.one_in(3) ? rational(0) : rational(random.between(-300, 300), 8);
    const complex_ball z = point(scattered(-6, 8), im, p);
    const auto [P, Q] = wave_amplitudes_at(hankel(nu), z);
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
  EXPECT_FALSE(wave_amplitudes_at(hankel(1), point(0, 1, 64)).p.is_bounded());
  EXPECT_FALSE(wave_amplitudes_at(hankel(1), point(-1, 1, 64)).q.is_bounded());
}

TEST_F(WaveAmplitudes, OverSetsHoldTheirValuesAtPoints) {
  constexpr precision p = 128;
  for (support::repeat trial(300); trial.again();) {
    const wave_function f = function();
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
    const wave_amplitudes<complex_ball> over = wave_amplitudes_at(f, set);
    const wave_amplitudes<region> in_balls = wave_amplitudes_at(f, region::in_balls(set));
    ASSERT_TRUE(over.p.is_bounded());
    for (int k = 0; k < 4; ++k) {
      const auto inside = [&](const rational& x, const rational& r) {
        return rational(x + r * rational(random.between(-64, 64), 64));
      };
      const wave_amplitudes<complex_ball> at =
          wave_amplitudes_at(f, point(inside(re, width), inside(im, height), p));
      EXPECT_TRUE(overlaps(over.p, at.p)) << described(f) << " " << re << " " << im << " " << width;
      EXPECT_TRUE(overlaps(over.q, at.q)) << described(f) << " " << re << " " << im << " " << width;
      EXPECT_TRUE(overlaps(in_balls.p.to_complex_ball(), at.p));
    }
  }
}

TEST_F(WaveAmplitudes, KeepTheirBounds) {
  for (support::repeat trial(800); trial.again();) {
    const wave_function f = function();
    // Up to the imaginary axis, where the bound is for the other half plane of K.
    const rational re = scattered(-20, 6);
    const rational im = random.one_in(4) ? rational(0) : scattered(-6, 6);
    const complex_ball z = point(re, random.one_in(2) ? im : rational(-im), 128);
    const ball size = sqrt(square(z.re) + square(z.im));
    const auto [P, Q] = wave_amplitudes_at(f, z);
    const auto bounds = bounds_of_wave_amplitudes(f, size);
    const std::string at =
        described(f) + " at " + to_decimal(z.re, 10) + " + i " + to_decimal(z.im, 10);
    EXPECT_LE(P.magnitude_lower(), bounds.p.beyond(size).magnitude_upper()) << at;
    EXPECT_LE(Q.magnitude_lower(), bounds.q.beyond(size).magnitude_upper()) << at;
  }
  // They are not far off, where |z| is large; and grow as K does, where it is small.
  const auto bound = [](const rational& order, const ball& least) {
    return bounds_of_wave_amplitudes(hankel(order), least).q.factor;
  };
  EXPECT_LE(bound(0, ball(1000, 64)), magnitude::power_of_two(1));
  EXPECT_LE(bound(rational(3, 2), ball(rational(1, 1024), 64)), magnitude::power_of_two(13));
  EXPECT_TRUE(bound(0, ball(0, 64)).is_infinite());
  EXPECT_TRUE(bound(1'000'000, ball(1, 64)).is_infinite());
}

TEST_F(WaveAmplitudes, MakeSineCosineAndFresnelsIntegrals) {
  constexpr precision p = 256;
  const auto value = [](const char* name, const complex_ball& z) {
    const further_functions& all = *library_functions();
    const auto f = std::find_if(all.begin(), all.end(),
                                [&](const further_function& g) { return g.what.name == name; });
    return f->over_complex(std::array{z});
  };
  const auto integral = [](const rational& a) {
    return wave_function{wave_function::family::integral_of_power, a};
  };
  for (support::repeat trial(60); trial.again();) {
    const rational im = random.one_in(3) ? rational(0) : rational(random.between(-40, 40), 16);
    const complex_ball z = point(scattered(-4, 4), im, p);
    const auto [f, g] = wave_amplitudes_at(integral(0), z);
    EXPECT_TRUE(overlaps(pi(p) / 2 - (f * cos(z) + g * sin(z)), value("Si", z)));
    EXPECT_TRUE(overlaps(f * sin(z) - g * cos(z), value("Ci", z)));
    const complex_ball phase = z * z * (pi(p) / 2);
    if (!certainly_positive(phase.re)) continue;
    const auto [P, Q] = wave_amplitudes_at(integral(rational(1, 2)), phase);
    const ball root = sqrt(2 * pi(p));
    const ball half(rational(1, 2), p);
    const complex_ball sine = (P * cos(phase) + Q * sin(phase)) / root;
    const complex_ball cosine = (P * sin(phase) - Q * cos(phase)) / root;
    EXPECT_TRUE(overlaps(half - sine, value("fresnelS", z)));
    EXPECT_TRUE(overlaps(half + cosine, value("fresnelC", z)));
  }
}

TEST_F(WaveAmplitudes, GiveTheTailsOfIntegrals) {
  support::expect_values({
      {"Si(x)-pi/2", "0", "inf", "-1"},
      {"Si(2*x)-pi/2", "0", "inf", "-1/2"},
      {"Si(x)+pi/2", "-inf", "0", "1"},
      {"Ci(x)", "1", "inf", "sin(1)-Ci(1)"},
      {"Ci(x)*cos(x)", "0", "inf", "-pi/4"},
      {"Ci(x)^2", "0", "inf", "pi/2"},
      {"(Si(x)-pi/2)^2", "0", "inf", "pi/2"},
      {"(Si(x)-pi/2)*sin(x)", "0", "inf", "-pi/4"},
      {"fresnelS(x)-1/2", "0", "inf", "-1/pi"},
      {"fresnelC(x)-1/2", "1", "inf", "1/2+1/pi-fresnelC(1)"},
      {"fresnelS(x*sqrt(2/pi))-1/2", "0", "inf", "-1/sqrt(2*pi)"},
      {"fresnelS(x)+1/2", "-inf", "0", "1/pi"},
      {"fresnelS(-x)+1/2", "0", "inf", "1/pi"},
      {"fresnelS(-x*sqrt(2/pi))+1/2", "0", "inf", "1/sqrt(2*pi)"},
      {"besselJ(1,-x*sqrt(2))/x", "0", "inf", "-1"},
      {"(fresnelS(sqrt(x))-1/2)/sqrt(x)", "0", "inf", "-2/pi"},
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
TEST_F(WaveAmplitudes, AreNotAskedForWithANegativeShift) {
  for (const char* f : {"besselJ(0, x-1)/(1+x)", "besselJ(0, x-pi)/(1+x)", "Ci(x-1)", "Ci(pi-x)"}) {
    EXPECT_NE(support::integral_of(f, "4", "inf").verdict, status::certified) << f;
  }
}

// x^(1/2) J_0 has no limit, and the squares are like 1/x.
TEST_F(WaveAmplitudes, DoNotMakeADivergentIntegralConverge) {
  for (const char* f : {"x*besselJ(0, x)",
                        "sqrt(x)*besselJ(0, x)",
                        "besselJ(0, x)^2",
                        "besselJ(0, x)*cos(x)",
                        "besselY(0, x)*sin(x)",
                        "besselJ(0, x)*besselJ(2, x)",
                        "besselJ(0, x)^2*cos(2*x)",
                        "besselJ(1, x)*exp(x/1000)",
                        "airyAi(-x)^2",
                        "x*airyAiPrime(-x)",
                        "airyBi(x)*cos(x)",
                        "besselJ(0, x)*besselJ(0, 2*x)*cos(3*x)",
                        "Si(x)",
                        "Si(x)-3/2",
                        "Si(x)-pi/2+1/x",
                        "Ci(x)*sin(x)",
                        "fresnelC(x)-1/3",
                        "(fresnelS(x)-1/2)*x^2",
                        "x*Ci(x)^2",
                        "Si(-x)-pi/2",
                        "fresnelS((1-sqrt(2))*x)-1/2"}) {
    EXPECT_NE(support::integral_of(f, "1", "inf").verdict, status::certified) << f;
  }
}

}  // namespace wave_amplitudes_test
}  // namespace polhode
