// The Montgomery phase: the hard members of the family to all their digits, certified quadrature of
// the defining integral, the limits at both ends and at the separatrix, and F with its slope.

#include "polhode/rigid_body/montgomery_phase.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <string_view>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/quadrature/integrate.hpp"
#include "polhode/quadrature/periodic_trapezoid.hpp"
#include "polhode/rigid_body/phase_integrands.hpp"
#include "support/random.hpp"
#include "support/reference.hpp"

namespace polhode {
namespace montgomery_phase_test {

using support::agrees;
using support::as_narrow_as;
using support::meet;

/// "1e-40", "1/4", "-1e-300"
body body_of(std::string_view a, std::string_view b) {
  return {parse_rational(a), parse_rational(b)};
}

// 45 digits, by two routes each at 400 digits.
TEST(MontgomeryPhase, HardCases) {
  struct row {
    std::string_view what;
    body rigid;
    rational c;
    std::string_view value;
  };
  const rational ten40 = support::power_of_ten(40);
  for (const row& r :
       {row{"A20", body_of("12.65", "0.0629"), parse_rational("1e-20"),
            "102.975164284404355122425504729123529135833048"},
        row{"A300", body_of("12.65", "0.0629"), parse_rational("-1e-300"),
            "1548.52520485065930647559490297550123901693553"},
        row{"D nearly prolate", body_of("1e-40", "0.3"), parse_rational("5e-41"),
            "1.35402469874276398074558805696826317388153546e+21"},
        row{"D planar", body(ten40 - 2, rational(1 / ten40)), parse_rational("5e-41"),
            "6.62655268094637666579387349173224396001646263"}}) {
    for (const long digits : {1L, 17L, 44L, 200L}) {
      const certain_number phase = montgomery_phase_to_digits(r.rigid, r.c, digits);
      EXPECT_EQ(phase.verdict, status::certified) << r.what;
      EXPECT_GE(to_decimal_enclosure(phase.enclosure, digits).digits, digits) << r.what;
      EXPECT_TRUE(agrees(phase.enclosure, r.value, std::min(digits, 44L) - 1)) << r.what;
    }
  }
  // E planar: G = half the phase.
  const ball twice_g = montgomery_phase(body_of("2", "1/4"), rational(-1, 8), 200);
  EXPECT_TRUE(agrees(scale(twice_g, -1), "4.10904599344479484657288135890226228812386130", 44));
}

TEST(MontgomeryPhase, ExcessOverTheLimitThatCancels) {
  const body rigid = body_of("12.65", "0.0629");
  const rational b = rigid.b().exact();
  const certain_number excess =
      montgomery_phase_excess_to_digits(rigid, -b * (1 - parse_rational("1e-30")), 50);
  EXPECT_EQ(excess.verdict, status::certified);
  EXPECT_TRUE(agrees(excess.enclosure, "1.87523188616904116434869829886662936366536591e-30", 44));
  // To first order in 1 - u it is -2 G'(1) (1 - u), elementary: G'(1) = -(pi/4)(a + (a+2)b)/(sqrt b
  // (a+b)^(3/2)). Where 1 - u = 1e-1000 it is that to 1000 digits.
  const rational a = rigid.a().exact();
  const rational gap = support::power_of_ten(-1000);
  const certain_number tiny = montgomery_phase_excess_to_digits(rigid, -b * (1 - gap), 30);
  const ball total(rational(a + b), 200);
  const ball slope =
      scale(pi(200), -1) * rational(a + (a + 2) * b) / (sqrt(ball(b, 200)) * total * sqrt(total));
  EXPECT_EQ(tiny.verdict, status::certified);
  EXPECT_TRUE(meet(tiny.enclosure.with_precision(150), slope * gap));
  // Near c = a as well; there the limit is 2 pi J.
  const certain_number rotating =
      montgomery_phase_excess_to_digits(rigid, a - support::power_of_ten(-100), 30);
  EXPECT_EQ(rotating.verdict, status::certified);
  EXPECT_TRUE(certainly_positive(rotating.enclosure));
  EXPECT_TRUE(rotating.enclosure.magnitude_upper() <= magnitude::power_of_two(-330));
}

TEST(MontgomeryPhase, IsTheQuadratureOfItsIntegral) {
  support::random_source random(81);
  for (support::repeat trial(60); trial.again();) {
    const body rigid(rational(random.between(1, 4000), random.between(1, 400)),
                     rational(random.between(1, 999), 1000));
    const rational u(random.between(1, 999), 1000);
    const precision p = random.between(20, 300);
    const periodic_integral q =
        integrate_periodic(half_phase_integrand({rigid.a().exact(), rigid.b().exact(), u}), 200);
    ASSERT_EQ(q.verdict, status::certified);
    const ball phase = montgomery_phase(rigid, -rigid.b().exact() * u, p);
    EXPECT_TRUE(meet(phase, scale(q.enclosure, 1)))
        << rigid.a().exact() << " " << rigid.b().exact() << " " << u;
    EXPECT_TRUE(as_narrow_as(phase, p - 8));
  }
  // Rotating: x = sin^2 t gives 4 times the integral of (1 - b x)/sqrt((a + b x)(c + b x)) over (0,
  // pi/2).
  for (support::repeat trial(12); trial.again();) {
    const body rigid(rational(random.between(1, 4000), random.between(1, 400)),
                     rational(random.between(1, 999), 1000));
    const rational c(rigid.a().exact() * rational(random.between(1, 999), 1000));
    const rational a = rigid.a().exact();
    const rational b = rigid.b().exact();
    const integral q = integrate(
        [&](const auto& t) {
          const auto bx = b * square(sin(t));
          return (1 - bx) / sqrt((a + bx) * (c + bx));
        },
        0, end_point::pi(rational(1, 2)), {.digits = 40});
    ASSERT_EQ(q.verdict, status::certified);
    EXPECT_TRUE(meet(montgomery_phase(rigid, c, 160), scale(q.enclosure, 2))) << a << " " << b;
  }
}

TEST(MontgomeryPhase, IsAboveItsBoundAndMonotone) {
  support::random_source random(82);
  for (support::repeat trial(100); trial.again();) {
    const body rigid(rational(random.between(1, 4000), random.between(1, 400)),
                     rational(random.between(1, 999), 1000));
    const bool oscillating = random.one_in(2);
    const rational end = oscillating ? rational(-rigid.b().exact()) : rigid.a().exact();
    const rational share(random.between(1, 998), 1000);
    const ball nearer = montgomery_phase(rigid, end * (share + rational(1, 1000)), 120);
    const ball farther = montgomery_phase(rigid, end * share, 120);
    const ball bound = montgomery_phase_limit(rigid, end * share, 120);
    EXPECT_TRUE(certainly_less(bound, nearer))
        << rigid.a().exact() << " " << rigid.b().exact() << " " << share;
    EXPECT_TRUE(certainly_less(nearer, farther))
        << rigid.a().exact() << " " << rigid.b().exact() << " " << share;
    EXPECT_TRUE(meet(bound, montgomery_phase_limit(rigid, end, 120)));
  }
  // The theorem's bounds themselves.
  const body planar = body_of("2", "1/4");
  EXPECT_TRUE(meet(montgomery_phase_limit(planar, rational(-1, 4), 100), 2 * pi(100)));
}

TEST(MontgomeryPhase, NearTheSeparatrixIsTheLogarithm) {
  // half the phase = ln(16ab/(|c|(a+b)))/sqrt(ab) - 2 arctan sqrt(b/a) + O(c ln c), on both sides
  const body rigid = body_of("2", "1/4");
  const rational a = rigid.a().exact();
  const rational b = rigid.b().exact();
  const rational distance = support::power_of_ten(-500);
  const precision p = 400;
  const ball half =
      log(ball(rational(16 * a * b / (distance * (a + b))), p)) / sqrt(ball(rational(a * b), p)) -
      2 * atan(sqrt(ball(rational(b / a), p)));
  EXPECT_TRUE(meet(montgomery_phase(rigid, distance, p), scale(half, 1)));
  EXPECT_TRUE(meet(montgomery_phase(rigid, -distance, p), scale(half, 1)));
}

TEST(MontgomeryPhase, DeliversItsDigitsForAnyBody) {
  support::random_source random(83);
  const auto tiny = [&] { return support::power_of_ten(-random.between(1, 400)); };
  for (support::repeat trial(200); trial.again();) {
    rational a(random.between(1, 1000), random.between(1, 1000));
    rational b(random.between(1, 999), 1000);
    rational share(random.between(1, 999), 1000);
    if (random.one_in(3)) a = random.one_in(2) ? tiny() : rational(1 / tiny());
    if (random.one_in(3)) b = random.one_in(2) ? tiny() : rational(1 - tiny());
    if (random.one_in(3)) share = random.one_in(2) ? tiny() : rational(1 - tiny());
    const body rigid(a, b);
    const rational c(share * (random.one_in(2) ? rational(-b) : a));
    const long digits = random.between(1, 80);
    const certain_number phase = montgomery_phase_to_digits(rigid, c, digits);
    EXPECT_EQ(phase.verdict, status::certified) << a << " " << b << " " << c;
    EXPECT_TRUE(meet(phase.enclosure, montgomery_phase(rigid, c, 700)));
    const certain_number excess = montgomery_phase_excess_to_digits(rigid, c, digits);
    EXPECT_EQ(excess.verdict, status::certified) << a << " " << b << " " << c;
    EXPECT_TRUE(certainly_positive(excess.enclosure)) << a << " " << b << " " << c;
  }
}

TEST(MontgomeryPhase, RefusesOtherRegimes) {
  const body rigid = body_of("2", "1/4");
  for (const char* c : {"0", "-1/4", "2", "-1", "3"}) {
    EXPECT_THROW((void)montgomery_phase(rigid, parse_rational(c), 64), input_error) << c;
    EXPECT_THROW((void)montgomery_phase_to_digits(rigid, parse_rational(c), 10), input_error) << c;
  }
  EXPECT_THROW((void)montgomery_phase_limit(rigid, 0, 64), input_error);
}

// ---------------------------------------------------------------------------------------------

TEST(PhaseIntegral, AtTheCornerOfTheHardCases) {
  const body rigid = body_of("2", "1/4");
  const rational c = parse_rational("0.001");
  const ball difference =
      phase_integral(rigid, c, 0, 400) - phase_integral(rigid, c, parse_rational("1e-60"), 400);
  EXPECT_TRUE(agrees(difference, "4.47213595499957939281834733746255247088123672e-29", 44));
}

TEST(PhaseIntegral, IsTheQuadratureOfItsIntegral) {
  support::random_source random(84);
  for (support::repeat trial(12); trial.again();) {
    const body rigid(rational(random.between(1, 400), random.between(1, 40)),
                     rational(random.between(1, 99), 100));
    const rational a = rigid.a().exact();
    const rational b = rigid.b().exact();
    const rational u(random.between(2, 90), 100);
    const rational c(-b * u + (a + b * u) * rational(random.between(1, 99), 100));
    const integral q = integrate(
        [&](const auto& x) {
          return (1 - b * x) / (sqrt(x * (a + b * x) * (c + b * x)) * sqrt(1 - x));
        },
        u, 1, {.digits = 30});
    ASSERT_EQ(q.verdict, status::certified);
    EXPECT_TRUE(meet(phase_integral(rigid, c, u, 160), q.enclosure)) << a << " " << b << " " << c;
    // F is decreasing in u, and its slope the limit of difference quotients with an error of h max
    // |F''|.
    const rational h = support::power_of_two(-120);
    const ball quotient =
        (phase_integral(rigid, c, u + h, 400) - phase_integral(rigid, c, u - h, 400)) / (2 * h);
    const ball slope = phase_integral_slope(rigid, c, u, 200);
    EXPECT_TRUE(certainly_negative(slope));
    EXPECT_TRUE((quotient - slope).magnitude_upper() <= scale(slope.magnitude_upper(), -100));
  }
}

TEST(PhaseIntegral, OnTheSeparatrixIsElementary) {
  // F(0,u) = (2/sqrt(ab)) artanh(sqrt(a) w) - 2 arctan(sqrt(b) w), w = sqrt((1-u)/(a+bu))
  for (const char* at : {"1e-100", "0.25", "0.999"}) {
    const rational u = parse_rational(at);
    const body rigid = body_of("12.65", "0.0629");
    const precision p = 500;
    const ball a(rigid.a().exact(), p);
    const ball b(rigid.b().exact(), p);
    const ball w = sqrt(ball(rational((1 - u) / (rigid.a().exact() + rigid.b().exact() * u)), p));
    const ball expected = 2 / sqrt(a * b) * atanh(sqrt(a) * w) - 2 * atan(sqrt(b) * w);
    EXPECT_TRUE(meet(phase_integral(rigid, 0, u, 200), expected)) << at;
  }
}

TEST(PhaseIntegral, RefusesWhatIsOutsideItsDomain) {
  const body rigid = body_of("2", "1/4");
  const auto refused = [&](const char* c, const char* u) {
    EXPECT_THROW((void)phase_integral(rigid, parse_rational(c), parse_rational(u), 64), input_error)
        << c << " " << u;
    EXPECT_THROW((void)phase_integral_slope(rigid, parse_rational(c), parse_rational(u), 64),
                 input_error)
        << c << " " << u;
  };
  refused("0", "0");
  refused("1", "1");
  refused("1", "-1/2");
  refused("-1/8", "1/4");  // below -c/b = 1/2
  refused("-1/4", "1/2");
  refused("3", "1/2");
  EXPECT_NO_THROW((void)phase_integral(rigid, rational(-1, 8), rational(1, 2), 64));
  EXPECT_THROW((void)phase_integral_slope(rigid, rational(-1, 8), rational(1, 2), 64), input_error);
  EXPECT_THROW((void)phase_integral_slope(rigid, 1, 0, 64), input_error);
  EXPECT_NO_THROW((void)phase_integral(rigid, 2, rational(1, 2), 64));
}

}  // namespace montgomery_phase_test
}  // namespace polhode
