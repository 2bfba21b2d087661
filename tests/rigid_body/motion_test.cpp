// A motion: its numbers against Euler's equations in rationals, its period and phase against the
// rotor's theta functions, the half phases of balls, where a motion starts, refusals.

#include "polhode/rigid_body/motion.hpp"

#include <gtest/gtest.h>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/elliptic/jacobi.hpp"
#include "polhode/rigid_body/half_phase.hpp"
#include "polhode/rigid_body/jacobi_start.hpp"
#include "polhode/rigid_body/montgomery_phase.hpp"
#include "rigid_body/rotor_states.hpp"

namespace polhode {
namespace motion_test {

using support::any_small;
using support::meet;

/// With a = 0 or b = 0 now and then; never an equilibrium, and never both 0.
motion random_motion(support::random_source& random) {
  rational a(random.between(1, 4000), random.between(1, 400));
  rational b(random.between(1, 999), 1000);
  bool oscillating = random.one_in(2);
  if (random.one_in(6)) {
    (oscillating ? a : b) = 0;
  }
  const rational part(random.one_in(2) ? rational(random.between(1, 99), 100)
                                       : any_small(random, 60));
  const rational c(oscillating ? -b * part : a * part);
  return {a, b, c};
}

exact_real square_of(const exact_real& q) { return q * q; }

/// J_x' = a J_y J_z, J_y' = -(a+b) J_x J_z, J_z' = b J_x J_y for the motion's functions, squared:
/// sn' = cn dn, cn' = -sn dn, dn' = -m sn cn.
void expect_solution(const motion& of) {
  const auto [x2, y2, z2] = of.greatest_squares();
  const exact_real l2 = of.lambda2();
  const exact_real m2 = square_of(1 - of.m1());
  const bool oscillating = of.regime() == regime::oscillating;
  EXPECT_EQ(x2 * l2 * (oscillating ? m2 : exact_real(1)), square_of(of.a()) * y2 * z2);
  EXPECT_EQ(y2 * l2, square_of(of.a() + of.b()) * x2 * z2);
  EXPECT_EQ(z2 * l2 * (oscillating ? exact_real(1) : m2), square_of(of.b()) * x2 * y2);
  EXPECT_EQ(x2 + z2, 1);
  EXPECT_EQ(of.a() * z2 - of.b() * x2, of.c());
  // J_x^2 + J_y^2 at sn^2 = 1.
  EXPECT_EQ((oscillating ? x2 * of.m1() : exact_real(0)) + y2, x2 * (1 + of.kappa()));
  EXPECT_GE(of.m1(), 0);
  EXPECT_LE(of.m1(), 1);
}

TEST(Motion, SolvesEulersEquations) {
  support::random_source random(3301);
  for (support::repeat trial(300); trial.again();) {
    const motion of = random_motion(random);
    SCOPED_TRACE(to_text(of.a()) + " " + to_text(of.b()) + " " + to_text(of.c()));
    ASSERT_TRUE(is_periodic(of.regime()));
    expect_solution(of);
    const bool turns = of.regime() == regime::oscillating;
    EXPECT_EQ(of.c() + of.b() * of.turning_point(), turns ? rational(0) : of.c());
  }
  const motion on(body::from_moments({3, 2, 1}), 0);
  ASSERT_EQ(on.regime(), regime::separatrix);
  expect_solution(on);
  EXPECT_EQ(on.m1(), 0);
}

TEST(Motion, HasTheRotorsPeriodAndPhase) {
  support::random_source random(3302);
  for (support::repeat trial(40); trial.again();) {
    const motion of = random_motion(random);
    const auto [x2, y2, z2] = of.greatest_squares();
    const initial_state state = initial_state::from_squared_momentum(
        {(1 / (1 - of.b())).exact(), 1, (1 / (1 + of.a())).exact()}, {x2.exact(), 0, z2.exact()},
        {-1, 0, 1});
    ASSERT_EQ(state.regime(), of.regime());
    const rotor<ball> turning(state, 300);
    EXPECT_TRUE(meet(of.period(200), *turning.period())) << of.a() << " " << of.b();
    EXPECT_TRUE(meet(of.phase(200), *turning.phase_per_period())) << of.a() << " " << of.b();
  }
}

TEST(Motion, CountsTheWorkOfAPeriod) {
  const motion of(body::from_moments({3, 2, 1}), rational(-1, 4));
  work_count work;
  const ball counted = of.period(500, &work);
  EXPECT_TRUE(meet(counted, of.period(500)));
  EXPECT_EQ(work.integrals, 1);
  EXPECT_GT(work.agm_steps, 3);
}

TEST(Motion, OfAnEquilibriumIsTheLimit) {
  const body rigid(3, rational(1, 4));
  const motion low(rigid, rational(-1, 4));
  EXPECT_EQ(low.lambda2(), rational(13, 16));  // b (a+b)
  EXPECT_EQ(low.m1(), 1);
  EXPECT_EQ(low.turning_point(), 1);
  const motion high(rigid, 3);
  EXPECT_EQ(high.lambda2(), rational(39, 4));  // a (a+b)
  EXPECT_EQ(high.m1(), 1);
  EXPECT_EQ(high.turning_point(), 0);
}

/// The message of the input_error that f throws.
template <class F>
std::string refusal_of(const F& f) {
  try {
    f();
  } catch (const input_error& error) {
    return error.what();
  }
  return "";
}

TEST(Motion, RefusesWhatThereIsNot) {
  const body rigid = body::from_moments({3, 2, 1});
  EXPECT_NE(refusal_of([&] { (void)motion(rigid, 2); }).find("c = 2"), std::string::npos);
  EXPECT_NE(refusal_of([&] { (void)motion(rigid, rational(-1, 2)); }).find("-b = -1/3"),
            std::string::npos);
  EXPECT_THROW((void)motion(-1, rational(1, 2), 0), input_error);
  EXPECT_THROW((void)motion(1, 1, 0), input_error);
  EXPECT_THROW((void)motion(1, rational(-1, 2), 1), input_error);
  for (const rational& c : {rational(-1, 3), rational(1)}) {
    const motion still(rigid, c);
    EXPECT_NE(refusal_of([&] { (void)still.period(64); }).find("does not move"), std::string::npos);
    EXPECT_NE(refusal_of([&] { (void)still.phase(64); }).find("does not move"), std::string::npos);
    EXPECT_THROW(still.refuse_equilibrium(), input_error);
  }
  const motion on(rigid, 0);
  EXPECT_NE(refusal_of([&] { (void)on.period(64); }).find("infinite"), std::string::npos);
  EXPECT_NE(refusal_of([&] { (void)on.phase(64); }).find("infinite"), std::string::npos);
  EXPECT_NO_THROW(on.refuse_equilibrium());
  // Equal moments: b = 0 and c = 0, a = 0 and c = 0, a spherical top.
  for (const motion& still : {motion(1, 0, 0), motion(0, rational(1, 2), 0), motion(0, 0, 0)}) {
    EXPECT_TRUE(is_equilibrium(still.regime()));
    EXPECT_EQ(still.turning_point(), 0);
    EXPECT_NE(refusal_of([&] { (void)still.lambda2(); }).find("equal"), std::string::npos);
    EXPECT_THROW((void)still.m1(), input_error);
    EXPECT_THROW((void)still.kappa(), input_error);
    EXPECT_THROW((void)still.greatest_squares(), input_error);
  }
}

// ---------------------------------------------------------------------------------------------

TEST(HalfPhaseOfBalls, HoldsTheExactOnes) {
  support::random_source random(3303);
  for (support::repeat trial(60); trial.again();) {
    const body rigid(rational(random.between(1, 4000), random.between(1, 400)),
                     rational(random.between(1, 999), 1000));
    const rational share(random.between(1, 98), 100);
    const rational next(share + rational(1, 100));
    const precision p = 200;
    // Rotating, between two motions.
    const rational low(rigid.a().exact() * share);
    const rational high(rigid.a().exact() * next);
    const ball range = hull(ball(low, p), ball(high, p));
    const ball at_low = motion(rigid, low).phase(p) / 2;
    const ball at_high = phase_integral(rigid, high, 0, p);
    const rational middle((low + high) / 2);
    EXPECT_TRUE(contains(rotating_half_phase(rigid, range), phase_integral(rigid, middle, 0, p)));
    EXPECT_TRUE(overlaps(rotating_half_phase(rigid, range), at_low));
    EXPECT_TRUE(overlaps(rotating_half_phase(rigid, range), at_high));
    EXPECT_TRUE(meet(rotating_half_phase(rigid, ball(low, p)), at_low));
    // The mean value theorem.
    EXPECT_TRUE(
        overlaps(rotating_half_phase_slope(rigid, range), (at_high - at_low) / (high - low)));
    // Oscillating.
    const ball left = hull(ball(rational(1 - next), p), ball(rational(1 - share), p));
    const turning_point between{hull(ball(share, p), ball(next, p)), left};
    const ball g_low = phase_integral(rigid, rational(-rigid.b().exact() * share), share, p);
    const ball g_high = oscillating_half_phase(rigid, {ball(next, p), ball(rational(1 - next), p)});
    const rational u(share + rational(1, 200));
    EXPECT_TRUE(contains(oscillating_half_phase(rigid, between),
                         phase_integral(rigid, rational(-rigid.b().exact() * u), u, p)));
    EXPECT_TRUE(overlaps(oscillating_half_phase(rigid, between), g_low));
    EXPECT_TRUE(overlaps(oscillating_half_phase(rigid, between), g_high));
    EXPECT_TRUE(
        meet(oscillating_half_phase(rigid, {ball(share, p), ball(rational(1 - share), p)}), g_low));
    EXPECT_TRUE(overlaps(oscillating_half_phase_slope(rigid, between), (g_high - g_low) * 100));
  }
}

TEST(HalfPhaseOfBalls, IsUndefinedBeyondItsMotions) {
  const body rigid = body::from_moments({3, 2, 1});
  const precision p = 100;
  for (const ball& c : {ball(0, p), ball(-1, p), ball(rational(-1, 5), p), ball(rational(-1, 3), p),
                        hull(ball(-1, p), ball(1, p)), hull(ball(0, p), ball(1, p))}) {
    EXPECT_FALSE(rotating_half_phase(rigid, c).is_bounded()) << c;
    EXPECT_FALSE(rotating_half_phase_slope(rigid, c).is_bounded()) << c;
    EXPECT_FALSE(oscillating_half_phase(rigid, {c, 1 - c}).is_bounded()) << c;
    EXPECT_FALSE(oscillating_half_phase_slope(rigid, {c, 1 - c}).is_bounded()) << c;
  }
}

TEST(JacobiStart, IsAPointOfTheFunctions) {
  support::random_source random(3304);
  int seen = 0;
  for (support::repeat trial(60); trial.again();) {
    const initial_state state = support::random_state(random, 30).state;
    if (is_equilibrium(state.regime())) {
      EXPECT_THROW((void)jacobi_start_of(state), input_error);
      continue;
    }
    ++seen;
    const jacobi_start at = jacobi_start_of(state);
    const rational m1 = state.motion().m1().exact();
    EXPECT_EQ(at.sine2 + at.cosine2, 1);
    EXPECT_EQ(at.delta2, 1 - (1 - m1) * at.sine2);
    EXPECT_EQ(at.sine == 0, at.sine2 == 0);
    EXPECT_EQ(at.cosine == 0, at.cosine2 == 0);
    if (m1 == 0) continue;
    const precision p = 300;
    const auto w =
        jacobi_elliptic(at.distance(p), elliptic_parameter<ball>::with_complement(ball(m1, p)));
    EXPECT_TRUE(meet(square(w.sn), at.sine2.at(p)));
    EXPECT_FALSE(certainly_negative(w.cn));  // in [0, K]
  }
  EXPECT_GT(seen, 0);
  for (const triple<rational>& j : {triple<rational>{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}) {
    EXPECT_THROW((void)jacobi_start_of(initial_state::from_momentum({3, 2, 1}, j)), input_error);
  }
}

}  // namespace motion_test
}  // namespace polhode
