// Half the Montgomery phase and its slope: against mpmath, against each other, at the ends of the
// range.

#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/quadrature/periodic_trapezoid.hpp"
#include "polhode/rigid_body/phase_integrands.hpp"
#include "support/random.hpp"
#include "support/reference.hpp"

namespace polhode {
namespace phase_integrands_test {

using support::agrees;
using support::as_narrow_as;
using support::meet;

/// "1e-40", "1/4", or "1-1e-100".
rational number(std::string_view text) {
  return text.starts_with("1-") ? rational(1 - parse_rational(text.substr(2)))
                                : parse_rational(text);
}
oscillating_motion motion_of(std::string_view a, std::string_view b, std::string_view u) {
  return {number(a), number(b), number(u)};
}

TEST(OscillatingMotion, NamesTheParameterThatIsOutOfRange) {
  const auto message = [](const char* a, const char* b, const char* u) -> std::string {
    const oscillating_motion motion = motion_of(a, b, u);
    std::string said;
    try {
      check(motion);
    } catch (const input_error& e) {
      said = e.what();
    }
    // What check refuses nothing else takes: the bounds are false there.
    if (said.empty()) {
      EXPECT_NO_THROW(half_phase_integrand{motion});
      EXPECT_NO_THROW(half_phase_slope_integrand{motion});
      EXPECT_NO_THROW((void)half_phase_slope(motion, 64));
    } else {
      EXPECT_THROW(half_phase_integrand{motion}, input_error);
      EXPECT_THROW(half_phase_slope_integrand{motion}, input_error);
      EXPECT_THROW((void)half_phase_slope(motion, 64), input_error);
    }
    return said;
  };
  EXPECT_EQ(message("1", "1/2", "1/2"), "");
  EXPECT_EQ(message("1", "1/2", "1"), "");
  EXPECT_EQ(message("1e-300", "1-1e-300", "1e-300"), "");
  EXPECT_EQ(message("0", "1/2", "1/2").substr(0, 6), "a = 0:");
  EXPECT_EQ(message("-3/2", "1/2", "1/2").substr(0, 9), "a = -3/2:");
  EXPECT_EQ(message("1", "0", "1/2").substr(0, 6), "b = 0:");
  EXPECT_EQ(message("1", "1", "1/2").substr(0, 6), "b = 1:");
  EXPECT_EQ(message("1", "-1", "1/2").substr(0, 7), "b = -1:");
  EXPECT_EQ(message("1", "5/4", "1/2").substr(0, 8), "b = 5/4:");
  EXPECT_EQ(message("1", "1/2", "0").substr(0, 6), "u = 0:");
  EXPECT_EQ(message("1", "1/2", "-1").substr(0, 7), "u = -1:");
  EXPECT_EQ(message("1", "1/2", "2").substr(0, 6), "u = 2:");
  EXPECT_NE(message("1", "1/2", "2").find("above 0 and at most 1"), std::string::npos);
}

struct row {
  std::string_view a, b, u, value;
};

TEST(HalfPhase, ByQuadratureIsMpmaths) {
  // mpmath 1.3.0, R_F and R_J of Carlson's form of G(u), checked there by quad.
  for (const row& r :
       {row{"12.65", "0.0629", "0.25",
            "4.657934819236146098591265092106788774519182015333042168029985059402464"},
        row{"12.65", "0.0629", "0.5",
            "3.959439401276455698135320224370100285792041052705469429905969440641763"},
        row{"0.87", "0.3", "0.9",
            "3.918941213870422738367405074503980862712384583897678722592041363558260"},
        row{"2", "0.1", "0.01",
            "15.96945470949664326024047997284121183208929377473076280744807126312486"}}) {
    const periodic_integral q =
        integrate_periodic(half_phase_integrand(motion_of(r.a, r.b, r.u)), 230);
    EXPECT_EQ(q.verdict, status::certified);
    EXPECT_TRUE(agrees(q.enclosure, r.value, 68)) << r.a << " " << r.b << " " << r.u;
  }
}

TEST(HalfPhaseSlope, IsMpmathsToTheEndsOfTheRange) {
  // mpmath 1.3.0 with 1200 digits: Carlson's form, by elliprd.
  for (const row& r :
       {row{"12.65", "0.0629", "0.25",
            "-4.10957116620648290635581535933359655217305123632116739122251"},
        row{"1e-40", "0.5", "0.25",
            "-25.1327412287183459077011470662360230735622755502636155602549"},
        row{"1e40", "0.5", "0.25",
            "-5.95937955780214019564209077012924579876181415178338839110660e-20"},
        row{"2", "1e-40", "0.25", "-253399583984013949337.707531044389564029800769949491231358050"},
        row{"2", "1-1e-40", "0.25",
            "-3.36316253264694774923412149716901646752770844738476694842596"},
        row{"2", "0.5", "1e-300",
            "-1.00000000000000000000000000000000000000000000000000000000000e+300"},
        row{"2", "0.5", "1", "-1.12397035696651622290501994291278316791464146993075238719836"},
        row{"2", "0.5", "1-1e-100",
            "-1.12397035696651622290501994291278316791464146993075238719836"},
        row{"1e40", "1e-40", "1e-300",
            "-1.00000000000000000000000000000000000000000000000000000000000e+300"},
        row{"1e-40", "1-1e-40", "1-1e-100",
            "-1.57079632679489661923132169163975144209866323950389265531843"},
        row{"1e-40", "1e-40", "1e-300",
            "-1.00000000000000000000000000000000000000000000000000000000000e+340"},
        row{"0.87", "0.3", "0.9",
            "-2.18765248947063563225319125821914218519153774111560348852988"}}) {
    const oscillating_motion motion = motion_of(r.a, r.b, r.u);
    for (const precision p : {64L, 230L, 1000L}) {
      const ball slope = half_phase_slope(motion, p);
      EXPECT_TRUE(agrees(slope, r.value, p == 64 ? 14 : 56)) << r.a << " " << r.b << " " << r.u;
      EXPECT_TRUE(certainly_negative(slope));
      EXPECT_TRUE(as_narrow_as(slope, p - 20));
    }
  }
}

TEST(HalfPhaseSlope, AtOneIsElementary) {
  // x = 1: dG/du = -(pi/4) (a + (a + 2) b)/(sqrt(b) (a + b)^(3/2)).
  support::random_source random(13);
  for (support::repeat trial(50); trial.again();) {
    const rational a(random.between(1, 5000), random.between(1, 500));
    const rational b(random.between(1, 999), 1000);
    const ball total(rational(a + b), 200);
    const ball expected = -scale(pi(200), -2) * rational(a + (a + 2) * b) /
                          (sqrt(ball(b, 200)) * total * sqrt(total));
    EXPECT_TRUE(meet(half_phase_slope({a, b, 1}, 200), expected)) << a << " " << b;
    const periodic_integral q = integrate_periodic(half_phase_slope_integrand({a, b, 1}), 100);
    EXPECT_EQ(q.verdict, status::certified);
    EXPECT_TRUE(meet(q.enclosure, expected)) << a << " " << b;
  }
}

TEST(HalfPhaseSlope, ByAgmAndByQuadratureMeet) {
  support::random_source random(14);
  for (support::repeat trial(60); trial.again();) {
    const oscillating_motion motion{rational(random.between(1, 4000), random.between(1, 400)),
                                    rational(random.between(1, 999), 1000),
                                    rational(random.between(1, 1000), 1000)};
    const long bits = random.between(4, 250);
    const periodic_integral q = integrate_periodic(half_phase_slope_integrand(motion), bits);
    EXPECT_EQ(q.verdict, status::certified);
    EXPECT_TRUE(q.enclosure.radius() <= magnitude::power_of_two(-bits));
    EXPECT_TRUE(meet(q.enclosure, half_phase_slope(motion, bits + 100)))
        << motion.a << " " << motion.b << " " << motion.u << " " << bits;
  }
  const oscillating_motion typical = motion_of("12.65", "0.0629", "0.25");
  const periodic_integral q = integrate_periodic(half_phase_slope_integrand(typical), 3322);
  EXPECT_TRUE(meet(q.enclosure, half_phase_slope(typical, 3400)));
  EXPECT_LE(q.evaluations, 1062);
}

TEST(HalfPhaseSlope, LiesBetweenDifferenceQuotients) {
  // G is convex in u: each -G'(u) term, 1/(x^(3/2) ...), falls as u grows. So
  // (G(u) - G(u-h))/h <= G'(u) <= (G(u+h) - G(u))/h, both from the other integrand, and h^2 apart.
  for (const auto& base : {motion_of("12.65", "0.0629", "0.25"), motion_of("0.87", "0.3", "0.9"),
                           motion_of("2", "0.9", "0.1")}) {
    const rational h = support::power_of_two(-80);
    const auto half_phase = [&](const rational& u) {
      return integrate_periodic(half_phase_integrand({base.a, base.b, u}), 260).enclosure;
    };
    const ball middle = half_phase(base.u);
    const ball before = (middle - half_phase(base.u - h)) / h;
    const ball after = (half_phase(base.u + h) - middle) / h;
    const ball slope = half_phase_slope(base, 260);
    EXPECT_TRUE(certainly_less(before, slope));
    EXPECT_TRUE(certainly_less(slope, after));
    EXPECT_TRUE((after - before).magnitude_upper() <= magnitude::power_of_two(-60));
  }
}

TEST(HalfPhaseSlope, DeliversItsDigitsForAnyMotion) {
  support::random_source random(15);
  const auto extreme = [&] { return support::power_of_ten(-random.between(1, 300)); };
  for (support::repeat trial(400); trial.again();) {
    oscillating_motion motion{rational(random.between(1, 1000), random.between(1, 1000)),
                              rational(random.between(1, 999), 1000),
                              rational(random.between(1, 1000), 1000)};
    if (random.one_in(3)) motion.a = random.one_in(2) ? extreme() : rational(1 / extreme());
    if (random.one_in(3)) motion.b = random.one_in(2) ? extreme() : rational(1 - extreme());
    if (random.one_in(3)) motion.u = random.one_in(2) ? extreme() : rational(1 - extreme());
    const precision p = random.between(40, 300);
    const ball slope = half_phase_slope(motion, p);
    EXPECT_TRUE(certainly_negative(slope)) << motion.a << " " << motion.b << " " << motion.u;
    EXPECT_TRUE(as_narrow_as(slope, p - 24)) << motion.a << " " << motion.b << " " << motion.u;
    EXPECT_TRUE(meet(slope, half_phase_slope(motion, 2 * p + 50)));
  }
}

TEST(RangeOnStrip, HoldsTheStripAndTouchesItsEdge) {
  // x(t) = ((1 + u) + (1 - u) cos t)/2 at t = s + i h: Re x = mean + half cos s cosh h and
  // |x| <= mean + half |cos t|; x(i h) = above, x(pi + i h) = below.
  support::random_source random(16);
  for (support::repeat trial(500); trial.again();) {
    const precision p = 80;
    rational u(random.between(1, 1000), 1000);
    if (random.one_in(4)) u = support::power_of_ten(-random.between(1, 60));
    const ball h(rational(random.between(1, 3000), random.between(1000, 100'000)), p);
    const detail::strip_range range = detail::range_on_strip(ball(u, p), h);
    const ball height = h * rational(random.between(0, 16), 16);
    const ball along(rational(random.between(0, 6300), 1000), p);
    const ball real_part =
        rational((1 + u) / 2) + rational((1 - u) / 2) * cos(along) * cosh(height);
    const ball imaginary_part = rational((1 - u) / 2) * sin(along) * sinh(height);
    EXPECT_FALSE(certainly_less(real_part, range.below)) << u;
    EXPECT_FALSE(certainly_less(range.above, hypot(real_part, imaginary_part))) << u;
    const ball edge = rational((1 - u) / 2) * cosh(h.with_precision(400));
    EXPECT_TRUE(meet(range.above, rational((1 + u) / 2) + edge)) << u;
    EXPECT_TRUE(meet(range.below, rational((1 + u) / 2) - edge)) << u;
  }
}

/// The greatest of |f| over points of the strip's edge, in complex arithmetic by pairs of balls, is
/// below the bound: the supremum is proved, and here seen.
TEST(BoundOnStrip, IsAboveTheIntegrandOnTheStripsEdge) {
  struct complex_ball {
    ball re, im;
  };
  const auto product = [](const complex_ball& x, const complex_ball& y) {
    return complex_ball{x.re * y.re - x.im * y.im, x.re * y.im + x.im * y.re};
  };
  const auto size = [](const complex_ball& x) { return hypot(x.re, x.im); };
  support::random_source random(17);
  long proved = 0;
  for (support::repeat trial(300); trial.again();) {
    const precision p = 80;
    const oscillating_motion motion{rational(random.between(1, 4000), random.between(1, 400)),
                                    rational(random.between(1, 999), 1000),
                                    rational(random.between(1, 1000), 1000)};
    const ball h(rational(random.between(1, 2000), random.between(500, 20'000)), p);
    const auto value = half_phase_integrand(motion).bound_on_strip(h);
    const auto slope = half_phase_slope_integrand(motion).bound_on_strip(h);
    ASSERT_EQ(value.has_value(), slope.has_value());
    // sinh^2(H/2) (1 - u) < u is where x has no zero.
    const ball spread = rational(1 - motion.u) * square(sinh(scale(h, -1)));
    if (certainly_less(ball(motion.u, p), spread)) {
      EXPECT_FALSE(value.has_value());
    }
    if (certainly_less(spread, ball(motion.u, p))) {
      EXPECT_TRUE(value.has_value());
    }
    if (!value) continue;
    ++proved;
    EXPECT_TRUE(support::identical(value->half_width, h));
    for (long k = 0; k <= 8; ++k) {
      const ball along = k * pi(p) / 8;
      const complex_ball cosine{cos(along) * cosh(h), -(sin(along) * sinh(h))};
      const complex_ball x{rational((1 + motion.u) / 2) + rational((1 - motion.u) / 2) * cosine.re,
                           rational((1 - motion.u) / 2) * cosine.im};
      const complex_ball y{motion.a + motion.b * x.re, motion.b * x.im};
      const complex_ball numerator{1 - motion.b * x.re, motion.b * x.im};
      const ball xy = size(product(x, y));
      EXPECT_FALSE(certainly_less(value->supremum, size(numerator) / sqrt(motion.b * xy)));
      const complex_ball slope_numerator = product(
          {1 - cosine.re, cosine.im},  // of x(pi - t)
          {motion.a + ((motion.a + 2) * motion.b) * x.re, ((motion.a + 2) * motion.b) * x.im});
      EXPECT_FALSE(certainly_less(slope->supremum, size({slope_numerator.re, slope_numerator.im}) /
                                                       (4 * sqrt(motion.b.at(p)) * xy * sqrt(xy))));
    }
  }
  EXPECT_GT(proved, 50 * support::effort() / 2);
}

TEST(BoundOnStrip, RefusesAnEmptyStrip) {
  const oscillating_motion motion = motion_of("2", "1/2", "1/4");
  for (const ball& h : {ball(0, 64), ball(-1, 64), ball::undefined(64), ball(64, 64),
                        hull(ball(0, 64), ball(1, 64))}) {
    EXPECT_FALSE(half_phase_integrand(motion).bound_on_strip(h).has_value());
    EXPECT_FALSE(half_phase_slope_integrand(motion).bound_on_strip(h).has_value());
  }
}

}  // namespace phase_integrands_test
}  // namespace polhode
