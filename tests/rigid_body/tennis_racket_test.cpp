// The tennis racket effect: hard members of the family to all their digits, the curve against the
// paper's implicit equations and against certified quadrature, its slope against difference
// quotients, counts at their boundaries, refusals.

#include "polhode/rigid_body/tennis_racket.hpp"

#include <gtest/gtest.h>

#include <string_view>
#include <vector>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/quadrature/integrate.hpp"
#include "support/random.hpp"
#include "support/reference.hpp"

namespace polhode {
namespace tennis_racket_test {

using support::agrees;
using support::as_narrow_as;
using support::meet;
using support::power_of_ten;

body body_of(std::string_view a, std::string_view b) {
  return {parse_rational(a), parse_rational(b)};
}

body random_body(support::random_source& random) {
  return {rational(random.between(1, 4000), random.between(10, 400)),
          rational(random.between(1, 999), 1000)};
}

/// The sign of x at the first precision that tells.
template <class F>
certain_sign decided(const F& f) {
  for (precision p = 128; p < 10'000; p *= 2) {
    const certain_sign s = sign_of(f(p));
    if (s != certain_sign::unknown) return s;
  }
  return certain_sign::unknown;
}

// ---------------------------------------------------------------------------------------------
// Values from elsewhere: 45 digits, by two routes each at 400 digits (a collection of hard members
// of the family, "free rigid body, hard cases 1").

TEST(TennisRacket, HardCases) {
  const certain_number c0 = perfect_twist_to_digits(body_of("1e4", "0.5"), 45);
  EXPECT_EQ(c0.verdict, status::certified);
  EXPECT_TRUE(agrees(c0.enclosure, "3.28720395293798147582017318190690497799721712e-193", 44));

  // I is below 2/3 by some 1e-41.
  const body near_two_thirds(parse_rational("18.125") + power_of_ten(-40), rational(1, 10));
  EXPECT_EQ(meeting_count(near_two_thirds), 3);
  const meeting last = meeting_to_digits(near_two_thirds, 3, 45);
  EXPECT_EQ(last.verdict, status::certified);
  EXPECT_TRUE(agrees(last.one_minus_u, "8.93854748603351955307262569832402234636866085e-42", 44));
  EXPECT_TRUE(meet(last.u + last.one_minus_u, ball(1, 300)));
  EXPECT_TRUE(meet(last.c, -near_two_thirds.b().exact() * last.u));

  // c -> 0 on the curve is the defect on the separatrix; the slope is not lost there.
  const body rigid = body_of("12.65", "0.0629");
  const certain_number at_zero = separatrix_defect_to_digits(rigid, 60);
  for (const char* c : {"1e-300", "-1e-300"}) {
    const twist near = twist_to_digits(rigid, parse_rational(c), 60);
    EXPECT_TRUE(overlaps(near.epsilon, at_zero.enclosure));
    EXPECT_TRUE(overlaps(near.slope, twist_to_digits(rigid, 0, 60).slope));
  }
}

TEST(TennisRacket, DefectOnTheSeparatrix) {
  // F(0,u) = (2/sqrt(ab)) artanh(sqrt(a) w) - 2 arctan(sqrt(b) w), w^2 = (1-u)/(a+bu), where
  // artanh y = log(1+y) - log(1-y^2)/2 and 1 - a w^2 = u (a+b)/(a+bu).
  for (const auto& [a, b] : std::vector<std::pair<const char*, const char*>>{{"12.65", "0.0629"},
                                                                             {"1e-6", "0.9"},
                                                                             {"9e5", "0.999"},
                                                                             {"1e30", "1e-30"},
                                                                             {"3", "1e-9"}}) {
    const body rigid = body_of(a, b);
    const certain_number epsilon = separatrix_defect_to_digits(rigid, 100);
    ASSERT_EQ(epsilon.verdict, status::certified) << a;
    const ball u = square(sin(epsilon.enclosure));
    const ball nearer = rigid.a().exact() + rigid.b().exact() * u;
    const ball w = sqrt((1 - u) / nearer);
    const precision p = u.precision();
    const ball artanh =
        log(1 + sqrt(ball(rigid.a().exact(), p)) * w) +
        scale(log(nearer / (u * rational(rigid.a().exact() + rigid.b().exact()))), -1);
    const ball f = 2 * artanh / sqrt(ball(rational(rigid.a().exact() * rigid.b().exact()), p)) -
                   2 * atan(sqrt(ball(rigid.b().exact(), p)) * w);
    EXPECT_TRUE(meet(f, 2 * pi(p))) << a;
    EXPECT_TRUE(as_narrow_as(f, 250)) << a;
  }
  // As small as e^(-pi sqrt(ab)).
  const ball tiny = separatrix_defect_to_digits(body_of("9e5", "0.999"), 20).enclosure;
  EXPECT_LT(tiny.magnitude_upper().log2_floor(), -4270);  // 1e-1287
  EXPECT_EQ(separatrix_defect_to_digits(body_of("1e80", "0.5"), 20).verdict, status::not_certified);
}

// ---------------------------------------------------------------------------------------------
// Two routes

/// The paper's implicit equations after n meetings with S (its appendix B), less 2 pi: with u =
/// sin^2 epsilon, 2 n G - F(c,u) for odd n and epsilon < pi/2 or even n and epsilon > pi/2, else 2
/// n G + F(c,u).
ball implicit_equation(const body& rigid, const rational& c, long n, const rational& u, bool beyond,
                       precision p) {
  const bool odd = n % 2 != 0;
  const ball f = phase_integral(rigid, c, u, p);
  const ball whole = n * montgomery_phase(rigid, c, p) - 2 * pi(p);
  return odd != beyond ? whole - f : whole + f;
}

TEST(TwistCurve, SolvesThePapersEquationsWhereItOscillates) {
  support::random_source random(91);
  long greatest_branch = 0;
  for (support::repeat trial(150); trial.again();) {
    const body rigid = random_body(random);
    const rational c(-rigid.b().exact() * rational(random.between(1, 999), 1000));
    const twist t = twist_to_digits(rigid, c, 30, with_slope::no);
    ASSERT_EQ(t.verdict, status::certified)
        << rigid.a().exact() << " " << rigid.b().exact() << " " << c;
    const auto n = static_cast<long>(t.branch);
    greatest_branch = std::max(greatest_branch, n);
    const ball u = square(sin(t.epsilon));
    const bool beyond = certainly_positive(2 * t.epsilon - pi(300));
    const rational low = lower_rational(u);
    const rational high = upper_rational(u);
    if (low <= -c / rigid.b().exact() || high >= 1)
      continue;  // nothing to compare with at the turning point
    // F decreases in u, so that the equation changes its sign between the ends.
    const certain_sign at_low =
        decided([&](precision p) { return implicit_equation(rigid, c, n, low, beyond, p); });
    const certain_sign at_high =
        decided([&](precision p) { return implicit_equation(rigid, c, n, high, beyond, p); });
    EXPECT_NE(at_low, certain_sign::unknown);
    EXPECT_NE(at_high, certain_sign::unknown);
    EXPECT_NE(at_low, at_high) << rigid.a().exact() << " " << rigid.b().exact() << " " << c << " n "
                               << n;
  }
  EXPECT_GE(greatest_branch, 3);
}

TEST(TwistCurve, IsTheQuadratureOfTheMotionWhereItRotates) {
  // The integral of dphi/dpsi from 0 to pi/2 - epsilon is pi, whatever the number of quarters.
  support::random_source random(92);
  long greatest_branch = 0;
  for (support::repeat trial(12); trial.again();) {
    const body rigid = random_body(random);
    const rational a = rigid.a().exact();
    const rational b = rigid.b().exact();
    const rational c(a * rational(random.between(1, 999), 1000));
    const twist t = twist_to_digits(rigid, c, 15, with_slope::no);
    ASSERT_EQ(t.verdict, status::certified);
    greatest_branch = std::max(greatest_branch, static_cast<long>(t.branch));
    const ball psi = scale(pi(200), -1) - t.epsilon;
    const auto phase_to = [&](const rational& end) {
      return integrate(
                 [&](const auto& x) {
                   const auto squared = b * square(cos(x));
                   return (1 - squared) / sqrt((a + squared) * (c + squared));
                 },
                 0, end, {.digits = 25})
          .enclosure;
    };
    EXPECT_TRUE(certainly_less(phase_to(lower_rational(psi)), pi(200)))
        << a << " " << b << " " << c;
    EXPECT_TRUE(certainly_less(pi(200), phase_to(upper_rational(psi))))
        << a << " " << b << " " << c;
  }
  EXPECT_GE(greatest_branch, 2);
}

TEST(TwistCurve, SlopeIsThatOfTheCurve) {
  // By Taylor's theorem (f(c+h) - f(c-h))/(2h) differs from f'(c) by at most h^2/6 times |f'''|;
  // with h = 1e-40 of the distance from the nearest end or zero the first 50 digits leave it a
  // third derivative of 1e20.
  support::random_source random(93);
  for (support::repeat trial(60); trial.again();) {
    const body rigid = random_body(random);
    const bool oscillating = random.one_in(2);
    const rational share(random.between(1, 999), 1000);
    const rational end = oscillating ? rational(-rigid.b().exact()) : rigid.a().exact();
    const rational c(end * share);
    const rational h(abs(end) * power_of_ten(-43));
    const twist middle = twist_to_digits(rigid, c, 30);
    const twist before = twist_to_digits(rigid, c - h, 100, with_slope::no);
    const twist after = twist_to_digits(rigid, c + h, 100, with_slope::no);
    ASSERT_EQ(middle.verdict, status::certified);
    if (before.branch != after.branch) continue;
    const ball quotient = (after.epsilon - before.epsilon) / rational(2 * h);
    const ball difference = quotient - middle.slope.with_precision(quotient.precision());
    EXPECT_TRUE(difference.magnitude_upper() <= scale(middle.slope.magnitude_upper(), -95))
        << rigid.a().exact() << " " << rigid.b().exact() << " " << c << " " << quotient << " "
        << middle.slope;
  }
  // Before any meeting the curve falls.
  const twist falling = twist_to_digits(body_of("12.65", "0.0629"), parse_rational("0.01"), 20);
  EXPECT_TRUE(certainly_negative(falling.slope));
}

TEST(TwistCurve, PassesItsMeetingsWithoutAJump) {
  const body rigid = body_of("39.95", "0.0629");
  ASSERT_EQ(meeting_count(rigid), 3);
  EXPECT_EQ(intersection_count(rigid), 2);
  EXPECT_EQ(crossing_count(rigid), 1);
  for (const long m : {1L, 2L, 3L}) {
    const meeting at = meeting_to_digits(rigid, m, 60);
    ASSERT_EQ(at.verdict, status::certified);
    EXPECT_TRUE(agrees(at.c, to_decimal_enclosure(at.c, 60).value, 58));
    const twist left = twist_to_digits(rigid, lower_rational(at.c) - power_of_ten(-40), 50);
    const twist right = twist_to_digits(rigid, upper_rational(at.c) + power_of_ten(-40), 50);
    ASSERT_EQ(left.verdict, status::certified);
    ASSERT_EQ(right.verdict, status::certified);
    const ball there = m == 2 ? scale(pi(300), -1) : at.epsilon;
    for (const twist& t : {left, right}) {
      EXPECT_TRUE((t.epsilon - there).magnitude_upper() <= magnitude::power_of_two(-110)) << m;
    }
    if (m != 2) {
      EXPECT_EQ(right.branch, (m - 1) / 2);
      EXPECT_EQ(left.branch, (m + 1) / 2);
      // On S: sin^2 epsilon = u.
      EXPECT_TRUE(meet(square(sin(at.epsilon)), at.u));
    }
    if (m != 2) {
      // C touches S there: its slope, found from F, is that of c = -b sin^2 epsilon. Both change by
      // less than 1e-30 over 1e-40.
      const ball of_s = -2 * rigid.b().at(300) * sin(at.epsilon) * cos(at.epsilon);
      for (const twist& t : {left, right}) {
        EXPECT_TRUE((t.slope * of_s - 1).magnitude_upper() <= magnitude::power_of_two(-99)) << m;
      }
    }
    // G(u) = 2 pi/m: half the phase changes sides between the ends of c.
    const rational low = lower_rational(at.c);
    const rational high = upper_rational(at.c);
    const auto excess = [&](const rational& c) {
      return decided([&](precision p) { return m * montgomery_phase(rigid, c, p) - 4 * pi(p); });
    };
    EXPECT_EQ(excess(low), certain_sign::negative);
    EXPECT_EQ(excess(high), certain_sign::positive);
  }
}

TEST(TennisRacket, PerfectTwistAndFullTurn) {
  support::random_source random(94);
  for (support::repeat trial(40); trial.again();) {
    const body rigid = random_body(random);
    for (const long m : {1L, 2L}) {
      const certain_number root =
          m == 1 ? perfect_twist_to_digits(rigid, 40) : full_turn_to_digits(rigid, 40);
      const bool exists = m == 1 ? has_perfect_twist(rigid) : has_full_turn(rigid);
      const ball j = rigid.second_geometric_constant(200);
      EXPECT_EQ(exists, certainly_less(m * j, ball(2, 200)));
      if (!exists) {
        EXPECT_EQ(root.why, reason::refuted);
        continue;
      }
      ASSERT_EQ(root.verdict, status::certified);
      const auto excess = [&](const rational& c) {
        return decided([&](precision p) { return m * montgomery_phase(rigid, c, p) - 4 * pi(p); });
      };
      // The phase falls with c.
      EXPECT_EQ(excess(lower_rational(root.enclosure)), certain_sign::positive);
      EXPECT_EQ(excess(upper_rational(root.enclosure)), certain_sign::negative);
      // epsilon is 0 there, and -pi/2.
      const ball expected = m == 1 ? ball(0, 100) : -scale(pi(200), -1);
      const ball steepest = twist_to_digits(rigid, lower_rational(root.enclosure), 10).slope;
      const ball epsilon = twist_at(rigid, lower_rational(root.enclosure), 200).epsilon;
      const ball width(rational(upper_rational(root.enclosure) - lower_rational(root.enclosure)),
                       64);
      EXPECT_TRUE((epsilon - expected).magnitude_upper() <=
                  (2 * width * steepest).magnitude_upper())
          << rigid.a().exact() << " " << rigid.b().exact() << " " << m;
    }
  }
}

// ---------------------------------------------------------------------------------------------
// Exact decisions

TEST(TennisRacket, CountsAtTheirBoundaries) {
  // I = 2/m exactly: (1-b)^2 m^2 = 4 b (a+b).
  for (const long m : {1L, 2L, 3L, 4L, 7L, 1000L}) {
    const rational b(1, 10);
    const rational a((1 - b) * (1 - b) * m * m / (4 * b) - b);
    const rational bit = power_of_ten(-500);
    EXPECT_EQ(*body(a, b).exact_geometric_constant(), rational(2, m));
    EXPECT_EQ(meeting_count(body(a, b)), m - 1);
    EXPECT_EQ(meeting_count(body(a + bit, b)), m);
    EXPECT_EQ(meeting_count(body(a - bit, b)), m - 1);
  }
  EXPECT_TRUE(is_injective(body_of("2", "1/4")));  // planar
  EXPECT_FALSE(is_injective(body(2 + power_of_ten(-500), rational(1, 4))));
  // The newly born meeting, 1e-500 from the end, is found all the same.
  const meeting born = meeting_to_digits(body(2 + power_of_ten(-500), rational(1, 4)), 2, 10);
  EXPECT_EQ(born.verdict, status::certified);
  EXPECT_LT(born.one_minus_u.magnitude_upper().log2_floor(), -1600);
  EXPECT_EQ(to_decimal_enclosure(born.c, 10).value, "-0.2499999999");
  // J = 2: (a+1)^2 = 9 a (a+b); J = 1: (a+1)^2 = 4 a (a+b).
  const rational a = parse_rational("0.4");
  const rational b((a + 1) * (a + 1) / (9 * a) - a);
  EXPECT_EQ(*body(a, b).exact_second_geometric_constant(), 2);
  EXPECT_FALSE(has_perfect_twist(body(a, b)));
  EXPECT_TRUE(has_perfect_twist(body(a, b + power_of_ten(-500))));
  const rational a1 = parse_rational("0.8");
  const rational b1((a1 + 1) * (a1 + 1) / (4 * a1) - a1);
  EXPECT_EQ(*body(a1, b1).exact_second_geometric_constant(), 1);
  EXPECT_FALSE(has_full_turn(body(a1, b1)));
  EXPECT_TRUE(has_full_turn(body(a1, b1 + power_of_ten(-500))));
}

TEST(TennisRacket, MeetingsFarApart) {
  // G = 2 pi at u = 1e-193 or so, and a thousand meetings beyond.
  const body rigid = body_of("1e4", "0.5");
  const meeting first = meeting_to_digits(rigid, 1, 30);
  EXPECT_EQ(first.verdict, status::certified);
  EXPECT_LT(first.u.magnitude_upper().log2_floor(), -600);
  EXPECT_EQ(meeting_count(rigid), 282);
  EXPECT_EQ(meeting_to_digits(rigid, 282, 30).verdict, status::certified);
  const meeting none = meeting_to_digits(rigid, 283, 30);
  EXPECT_EQ(none.verdict, status::not_certified);
  EXPECT_EQ(none.why, reason::refuted);
  EXPECT_THROW((void)meeting_to_digits(rigid, 0, 30), input_error);
}

// ---------------------------------------------------------------------------------------------
// The parts of the phase, and the limit

TEST(MontgomeryPhase, Parts) {
  support::random_source random(95);
  for (support::repeat trial(40); trial.again();) {
    const body rigid = random_body(random);
    const rational a = rigid.a().exact();
    const rational b = rigid.b().exact();
    const bool oscillating = random.one_in(2);
    const rational c((oscillating ? rational(-b) : a) * rational(random.between(1, 999), 1000));
    const precision p = 200;
    const ball geometric = geometric_phase(rigid, c, p);
    EXPECT_TRUE(certainly_negative(geometric));
    EXPECT_TRUE(meet(dynamic_phase(rigid, c, p) + geometric, montgomery_phase(rigid, c, p)));
    // d(phase)/dc = T/2 + (1 + c) dT/dc, by difference quotients.
    const rational h(abs(c) * power_of_ten(-20));
    const auto quotient = [&](const auto& f) {
      return (f(rigid, c + h, p) - f(rigid, c - h, p)) / rational(2 * h);
    };
    const ball left = quotient(montgomery_phase);
    const ball right =
        scale(rotation_period(rigid, c, p), -1) + rational(1 + c) * quotient(rotation_period);
    EXPECT_TRUE((left - right).magnitude_upper() <= scale(left.magnitude_upper(), -80))
        << a << " " << b << " " << c;
  }
  // Small oscillations: T = 2 pi/sqrt(b (a+b)) at c = -b.
  const body rigid = body_of("2", "1/4");
  const rational near = -rigid.b().exact() * (1 - power_of_ten(-100));
  EXPECT_TRUE((rotation_period(rigid, near, 200) - 2 * pi(200) / sqrt(ball(rational(9, 16), 200)))
                  .magnitude_upper() <= magnitude::power_of_two(-190));
  const certain_number geometric = geometric_phase_to_digits(rigid, near, 30);
  EXPECT_EQ(geometric.verdict, status::certified);
  EXPECT_LT(geometric.enclosure.magnitude_upper().log2_floor(), -330);
  EXPECT_THROW((void)rotation_period(rigid, 0, 64), input_error);
}

TEST(LimitDefect, IsTheLimit) {
  EXPECT_TRUE(
      agrees(limit_defect_to_digits(1, 0, 40).enclosure, "0.0863740970495642522702249", 20));
  // beta where it vanishes: agm(sqrt(1+beta), sqrt(beta)) = 1/2.
  const rational beta = parse_rational("0.0289732280378394600896939267034134383359332858");
  EXPECT_TRUE(limit_defect(1, beta, 300).magnitude_upper() <= magnitude::power_of_two(-140));
  // epsilon(c) of a body with a = 1e40 differs by some b.
  for (const char* text : {"0", "0.01", "2", "-0.01", "-0.3", "-0.999"}) {
    for (const rational& chi : {rational(1), rational(1, 10), rational(4)}) {
      const rational ratio = parse_rational(text);
      const body far(power_of_ten(40), chi * power_of_ten(-40));
      const ball epsilon =
          twist_to_digits(far, ratio * far.b().exact(), 50, with_slope::no).epsilon;
      const ball limit = limit_defect_to_digits(chi, ratio, 50).enclosure;
      // Beyond the first crossing of pi/2 or a perfect twist both count on.
      EXPECT_TRUE((epsilon - limit).magnitude_upper() <= magnitude::power_of_two(-120))
          << text << " " << chi;
    }
  }
  EXPECT_THROW((void)limit_defect(0, 1, 64), input_error);
  EXPECT_THROW((void)limit_defect(1, -1, 64), input_error);
}

// ---------------------------------------------------------------------------------------------
// Refusals, and limits that are said

TEST(TwistCurve, RefusesWhatIsNoMotion) {
  const body rigid = body_of("2", "1/4");
  for (const rational& c : {rational(-1, 4), rational(2), rational(-1, 3), rational(3)}) {
    EXPECT_THROW((void)twist_at(rigid, c, 64), input_error);
    EXPECT_THROW((void)twist_to_digits(rigid, c, 10), input_error);
  }
}

TEST(TwistCurve, IsCertifiedInEveryCorner) {
  for (const auto& [a, b] : std::vector<std::pair<const char*, const char*>>{{"1e-30", "1e-30"},
                                                                             {"1e30", "1e-30"},
                                                                             {"1e-30", "0.999999"},
                                                                             {"1e6", "0.999999"},
                                                                             {"1", "1e-50"},
                                                                             {"1e-50", "1/2"}}) {
    const body rigid = body_of(a, b);
    for (const char* share : {"1e-200", "1e-5", "0.5", "0.99999"}) {
      for (const rational& end : {rational(-rigid.b().exact()), rigid.a().exact()}) {
        const rational c(end * parse_rational(share));
        const twist t = twist_to_digits(rigid, c, 20);
        EXPECT_EQ(t.verdict, status::certified) << a << " " << b << " " << c;
      }
    }
  }
}

}  // namespace tennis_racket_test
}  // namespace polhode
