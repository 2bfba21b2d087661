// The closed-form rotation: against a Taylor integration with a proved remainder, against Jacobi's
// functions and the Montgomery phase, against elementary closed forms where there are some, and for
// what a rotation keeps.

#include "polhode/rigid_body/rotor.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <thread>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/elliptic/jacobi.hpp"
#include "polhode/rigid_body/montgomery_phase.hpp"
#include "rigid_body/rotor_states.hpp"

namespace polhode {
namespace rotor_test {

using support::agrees;
using support::any_state;
using support::meet;
using support::power_of_ten;
using support::random_state;

triple<ball> cross(const triple<ball>& x, const triple<ball>& y) {
  return {x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
}
ball dot(const triple<ball>& x, const triple<ball>& y) {
  return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
}
triple<ball> column(const matrix3<ball>& m, std::size_t j) { return {m[0][j], m[1][j], m[2][j]}; }
matrix3<ball> product(const matrix3<ball>& x, const matrix3<ball>& y) {
  matrix3<ball> r;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) r[i][j] = dot(x[i], column(y, j));
  }
  return r;
}
matrix3<ball> transposed(const matrix3<ball>& x) {
  return {column(x, 0), column(x, 1), column(x, 2)};
}
/// The rotation by an angle about an axis of length 1 (O. Rodrigues).
matrix3<ball> rotation(const triple<ball>& axis, const ball& angle) {
  const auto [s, c] = sin_cos(angle);
  const triple<ball> along{axis[0] * s, axis[1] * s, axis[2] * s};
  const ball rest = 1 - c;
  matrix3<ball> r;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      r[i][j] = axis[i] * axis[j] * rest;
      if (i == j) r[i][j] += c;
    }
  }
  r[0][1] -= along[2];
  r[0][2] += along[1];
  r[1][0] += along[2];
  r[1][2] -= along[0];
  r[2][0] -= along[1];
  r[2][1] += along[0];
  return r;
}
::testing::AssertionResult matrices_meet(const matrix3<ball>& x, const matrix3<ball>& y,
                                         const magnitude& apart = {}) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      auto met = meet(x[i][j].enlarged(apart), y[i][j]);
      if (!met) return met << " at " << i << ", " << j;
    }
  }
  return ::testing::AssertionSuccess();
}
magnitude two_to(long n) { return magnitude::power_of_two(n); }

std::string described(const initial_state& s) {
  std::string text = to_text(s.regime()) + " c = " + to_text(s.motion().c());
  for (const exact_real& moment : s.tensor().moments()) text += " " + to_text(moment);
  return text;
}

/// 1/rho or a little less, rho = |J|/(least moment): an upper bound of |omega|, and a time.
rational shortest_time(const initial_state& s) {
  const rational least = rational_below(s.tensor().moments()[2], 32);
  const rational squared(least * least / rational_below(s.squared_momentum(), 32));
  return support::root_near(squared, 30);
}

// ---------------------------------------------------------------------------------------------

struct body_at {
  triple<ball> momentum;
  matrix3<ball> attitude;
};

/// T^-1 J.
triple<ball> solved(const initial_state& s, const triple<ball>& j) {
  triple<ball> r{ball(0, 64), ball(0, 64), ball(0, 64)};
  for (std::size_t i = 0; i < 3; ++i) {
    triple<exact_real> unit{0, 0, 0};
    unit[i] = 1;
    const triple<exact_real> column = s.tensor().solved(unit);
    for (std::size_t k = 0; k < 3; ++k) r[k] += j[i] * column[k];
  }
  return r;
}

/// The motion by a time h later. J and the rows of R obey x' = x x omega: x_(k+1) = sum of x_i x
/// omega_(k-i) over (k+1). With rho = |J|/(least moment), |x_k| <= |x| rho^k by induction, at every
/// time, since |J| and |x| stay: what n terms leave out is at most |x| (rho h)^n in each component
/// (Lagrange).
body_at by_taylor(const body_at& at, const initial_state& s, const rational& h, int n) {
  std::array<std::vector<triple<ball>>, 4> x{
      std::vector{at.momentum}, {at.attitude[0]}, {at.attitude[1]}, {at.attitude[2]}};
  std::vector<triple<ball>> omega;
  for (int k = 0; k + 1 < n; ++k) {
    const triple<ball>& j = x[0].back();
    omega.push_back(solved(s, j));
    for (auto& series : x) {
      triple<ball> sum{ball(0, 64), ball(0, 64), ball(0, 64)};
      for (int i = 0; i <= k; ++i) {
        const triple<ball> part =
            cross(series[static_cast<std::size_t>(i)], omega[static_cast<std::size_t>(k - i)]);
        for (std::size_t d = 0; d < 3; ++d) sum[d] += part[d];
      }
      for (ball& one : sum) one /= k + 1;
      series.push_back(sum);
    }
  }
  const rational ratio(h / shortest_time(s));  // rho h, or a little more
  const magnitude left = pow(ball(ratio, 64), n).magnitude_upper();
  const magnitude size = sqrt(s.squared_momentum().at(64)).magnitude_upper();
  const auto sum = [&](const std::vector<triple<ball>>& series, const magnitude& scale_of) {
    triple<ball> r = series.back();
    for (std::size_t k = series.size() - 1; k-- > 0;) {
      for (std::size_t d = 0; d < 3; ++d) r[d] = r[d] * h + series[k][d];
    }
    for (ball& one : r) one = one.enlarged(multiply_up(left, scale_of));
    return r;
  };
  return {sum(x[0], size), {sum(x[1], two_to(0)), sum(x[2], two_to(0)), sum(x[3], two_to(0))}};
}

void expect_met(const rotor<ball>& r, const rational& t, const body_at& at, const char* what) {
  const auto sample = r.sample(t);
  const auto attitude = r.attitude(t);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_TRUE(meet(sample.momentum[i], at.momentum[i])) << what << " " << described(r.state());
    EXPECT_TRUE(meet(sample.angular_velocity[i], solved(r.state(), at.momentum)[i]));
  }
  EXPECT_TRUE(matrices_meet(attitude.matrix, at.attitude)) << what << " " << described(r.state());
}

TEST(Rotor, FollowsTheTaylorIntegrationFromItsStart) {
  support::random_source random(901);
  for (support::repeat trial(8); trial.again();) {
    const any_state any = random_motion(random, 12);
    const rotor<ball> r(any.state, 90);
    const rational h(shortest_time(any.state) / 2);
    constexpr precision bits = 300;
    body_at at{{}, any.state.attitude(bits)};
    for (std::size_t i = 0; i < 3; ++i) at.momentum[i] = ball(any.momentum[i], bits);
    expect_met(r, 0, at, any.kind);
    for (int step = 1; step <= 4; ++step) {
      at = by_taylor(at, any.state, h, 40);
      expect_met(r, rational(step * h), at, any.kind);
    }
    // Back in time too.
    EXPECT_TRUE(matrices_meet(
        by_taylor({r.sample(-h).momentum, r.attitude(-h).matrix}, any.state, h, 40).attitude,
        any.state.attitude(bits)));
  }
}

TEST(Rotor, FollowsTheTaylorIntegrationFromAnyTime) {
  support::random_source random(902);
  for (support::repeat trial(25); trial.again();) {
    const any_state any = random_motion(random, 300);
    const rotor<ball> r(any.state, 70);
    const rational h(shortest_time(any.state) / 3);
    const rational t(h * random.any_rational(20) * power_of_ten(random.between(0, 40)));
    const body_at at{r.sample(t).momentum, r.attitude(t).matrix};
    expect_met(r, rational(t + h), by_taylor(at, any.state, h, 40), any.kind);
  }
}

/// About the axis 0, 1 or 2.
matrix3<ball> turn_about(std::size_t axis, const ball& angle) {
  const ball zero(0, angle.precision());
  triple<ball> unit{zero, zero, zero};
  unit[axis] = ball(1, angle.precision());
  return rotation(unit, angle);
}

/// The tensor's axes are turned against the body axes: the integration is done in those, J' = Q^T J
/// and R' = R Q, where nothing of the turn is left.
TEST(Rotor, FollowsTheTaylorIntegrationWithATurnedTensor) {
  support::random_source random(4104);
  constexpr precision bits = 300;
  for (support::repeat trial(16); trial.again();) {
    const auto tensor =
        random.one_in(2)
            ? std::make_shared<const principal_axes>(support::random_tensor(random, 12))
            : std::make_shared<const principal_axes>(std::array<rational, 6>{
                  random.between(2, 9), random.between(2, 9), random.between(2, 9), 0, 0, 0});
    const auto unit = random.one_in(3) ? angle_unit::degrees : angle_unit::radians;
    exact_rotation turn;
    matrix3<ball> q = turn_about(0, ball(0, bits));
    const triple<std::size_t> axes{2, random.one_in(2) ? 1U : 0U, random.one_in(2) ? 2U : 0U};
    for (const std::size_t axis : axes) {
      const rational angle = random.one_in(4) ? rational(0)
                             : unit == angle_unit::degrees
                                 ? rational(15 * random.between(-24, 24))
                                 : rational(random.between(-50, 50), random.between(1, 20));
      turn = turn * exact_rotation::about(axis, angle, unit);
      const ball x = unit == angle_unit::degrees ? ball(rational(angle / 180), bits) * pi(bits)
                                                 : ball(angle, bits);
      q = product(q, turn_about(axis, x));
    }
    const triple<rational> given{random.between(1, 9), rational(random.between(-9, 9), 7),
                                 rational(random.between(10, 19), 3)};
    const bool by_omega = random.one_in(2);
    initial_state state = by_omega ? initial_state::from_tensor_and_velocity(tensor, given, turn)
                                   : initial_state::from_tensor(tensor, given, turn);
    state.set_euler_angles({1, 2, 3});
    triple<ball> inner;
    for (std::size_t i = 0; i < 3; ++i)
      inner[i] = q[0][i] * given[0] + q[1][i] * given[1] + q[2][i] * given[2];
    if (by_omega) {
      const auto& [xx, yy, zz, xy, xz, yz] = tensor->tensor();
      inner = {inner[0] * xx + inner[1] * xy + inner[2] * xz,
               inner[0] * xy + inner[1] * yy + inner[2] * yz,
               inner[0] * xz + inner[1] * yz + inner[2] * zz};
    }
    const rotor<ball> r(state, 90);
    const rational h(shortest_time(state) / 2);
    body_at at{inner, product(state.attitude(bits), q)};
    for (int step = 0; step <= 4; ++step) {
      if (step > 0) at = by_taylor(at, state, h, 40);
      const auto sample = r.sample(rational(step * h));
      const triple<ball> omega = solved(state, at.momentum);
      for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_TRUE(meet(sample.momentum[i], q[i][0] * at.momentum[0] + q[i][1] * at.momentum[1] +
                                                 q[i][2] * at.momentum[2]))
            << described(state);
        EXPECT_TRUE(meet(sample.angular_velocity[i],
                         q[i][0] * omega[0] + q[i][1] * omega[1] + q[i][2] * omega[2]))
            << described(state);
      }
      EXPECT_TRUE(
          matrices_meet(r.attitude(rational(step * h)).matrix, product(at.attitude, transposed(q))))
          << described(state);
    }
    if (by_omega) {
      const auto start = r.sample(rational(0));
      for (std::size_t i = 0; i < 3; ++i)
        EXPECT_TRUE(contains(start.angular_velocity[i], given[i])) << described(state);
    }
  }
}

TEST(Rotor, KeepsEnergyMomentumAndOrthogonality) {
  support::random_source random(903);
  for (support::repeat trial(100); trial.again();) {
    const any_state any = random_motion(random, 300);
    const initial_state& s = any.state;
    const precision p = random.between(30, 300);
    const rotor<ball> r(s, p);
    const rational t(shortest_time(s) * random.any_rational(12) *
                     power_of_ten(random.between(0, 30)));
    const auto [j, omega] = r.sample(t);
    const auto attitude = r.attitude(t);
    EXPECT_TRUE(contains(dot(j, j), s.squared_momentum().exact())) << described(s);
    EXPECT_TRUE(contains(dot(j, omega), s.twice_energy().exact())) << described(s);
    const magnitude size = r.momentum_size().magnitude_lower();
    for (const ball& one : j) EXPECT_LE(one.radius(), scale(size, -p)) << described(s);
    const matrix3<ball>& m = attitude.matrix;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_TRUE(contains(dot(m[i], m[k]), i == k ? 1L : 0L));
        EXPECT_LE(m[i][k].radius(), two_to(-p));
      }
    }
    EXPECT_TRUE(contains(dot(cross(m[0], m[1]), m[2]), 1L));
    // R J is what it was.
    const auto j0 = r.sample(0).momentum;
    const auto m0 = s.attitude(p);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_TRUE(meet(dot(m[i], j), dot(m0[i], j0)));
    // The other forms.
    const auto q = attitude.quaternion();
    ball norm = square(q[0]);
    for (std::size_t i = 1; i < 4; ++i) norm += square(q[i]);
    EXPECT_TRUE(contains(norm, 1L));
    EXPECT_TRUE(meet(2 * (q[1] * q[2] - q[0] * q[3]), m[0][1]));
    EXPECT_TRUE(meet(2 * (q[1] * q[3] + q[0] * q[2]), m[0][2]));
    EXPECT_TRUE(meet(2 * (q[2] * q[3] - q[0] * q[1]), m[1][2]));
    EXPECT_TRUE(meet(2 * (square(q[0]) + square(q[3])) - 1, m[2][2]));
    const auto [phi, theta, psi] = attitude.angles();
    EXPECT_TRUE(meet(cos(theta), attitude.direction[2]));
    EXPECT_TRUE(meet(-sin(theta) * cos(psi), attitude.direction[0]));
    EXPECT_TRUE(meet(sin(theta) * sin(psi), attitude.direction[1]));
    EXPECT_FALSE(phi.is_undefined());
    // mpfr_float takes the same way.
    const auto middle = rotor<mpfr_float>(s, p).attitude(t).matrix;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_TRUE(overlaps(m[i][k].enlarged(two_to(8 - p)), ball(middle[i][k])));
      }
    }
  }
}

// The attitude from phi, theta, psi: R = M R_z(phi) R_y(theta) R_z(psi) P, M the same at all times.
TEST(Rotor, AnglesMakeTheAttitude) {
  support::random_source random(904);
  for (support::repeat trial(40); trial.again();) {
    const any_state any = random_motion(random, 20);
    const rotor<ball> r(any.state, 120);
    const ball zero(0, 200);
    const ball one(1, 200);
    const auto frame = [&](const rational& t) {
      const auto attitude = r.attitude(t);
      const auto [phi, theta, psi] = attitude.angles();
      const matrix3<ball> turned =
          product(product(rotation({zero, zero, one}, phi), rotation({zero, one, zero}, theta)),
                  rotation({zero, zero, one}, psi));
      const matrix3<ball> in_body = product(turned, any.state.frame(200));
      return product(attitude.matrix, transposed(in_body));
    };
    const rational h = shortest_time(any.state);
    const auto start = frame(0);
    EXPECT_TRUE(contains_zero(r.attitude(0).angles().phi));
    for (const long k : {1L, 7L, -30L, 100000L}) {
      EXPECT_TRUE(matrices_meet(frame(rational(k * h)), start)) << described(any.state);
    }
  }
}

// ---------------------------------------------------------------------------------------------
// Known values

TEST(Rotor, HardCaseNearTheSeparatrix) {
  const body rigid(2, rational(1, 4));
  const auto state = initial_state::at_middle_of_twist(rigid, power_of_ten(-40));
  EXPECT_EQ(state.regime(), regime::rotating);
  const rotor<ball> r(state, 300);
  const auto at = r.attitude(1000);
  EXPECT_TRUE(agrees(at.direction[0], "-9.13622210279417205598462990997087478776004749e-18", 40));
  EXPECT_TRUE(agrees(at.direction[1], "-0.999999999999999999999999999999999953047788200", 44));
  EXPECT_TRUE(agrees(at.direction[2], "3.23015004124391958147258262043207995369734090e-18", 40));
  const ball phi = at.angles().phi;
  EXPECT_TRUE(agrees(phi - 316 * pi(300), "2.15916782381350758935880318280062758316458501", 43));
  // In double, where it would be lost with m in the place of 1 - m.
  const auto d = rotor<double>(state).sample(1000.0);
  EXPECT_NEAR(d.momentum[0], -9.136222102794172e-18, 1e-30);
  EXPECT_EQ(d.momentum[1], -1);
}

TEST(Rotor, IsJacobisFunctionsAtAnyTime) {
  support::random_source random(905);
  for (support::repeat trial(40); trial.again();) {
    const body rigid(rational(random.between(1, 4000), random.between(1, 400)),
                     rational(random.between(1, 999), 1000));
    const rational& a = rigid.a().exact();
    const rational& b = rigid.b().exact();
    const bool oscillating = random.one_in(2);
    const rational part(oscillating ? rational(random.between(1, 99), 100)
                                    : rational(support::any_small(random, 300)));
    const rational c(random.one_in(2) ? -b * part : a * part);
    const precision p = 100;
    const rotor<ball> r(initial_state::at_middle_of_twist(rigid, c), p);
    const rational t(random.any_rational(30) * power_of_ten(random.between(0, 60)));
    const precision bits = 500;
    const rational first(c < 0 ? a - c : a);
    const rational second(c < 0 ? b : b + c);
    const ball u = sqrt(ball(rational(first * second), bits)) * t;
    const auto w = jacobi_elliptic(u, elliptic_parameter<ball>::with_complement(ball(
                                          rational(abs(c) * (a + b) / (first * second)), bits)));
    const auto j = r.sample(t).momentum;
    const ball x = sqrt(ball(rational((a - c) / (a + b)), bits));
    const ball y = sqrt(ball(c < 0 ? rational((b + c) / b) : rational((a - c) / a), bits));
    const ball z = sqrt(ball(rational((b + c) / (a + b)), bits));
    EXPECT_TRUE(meet(j[0], -x * (c < 0 ? w.dn : w.cn))) << c << " " << t;
    EXPECT_TRUE(meet(j[1], y * w.sn));
    EXPECT_TRUE(meet(j[2], z * (c < 0 ? w.cn : w.dn)));
  }
}

TEST(Rotor, PhaseOfAPeriodIsMontgomerys) {
  support::random_source random(906);
  for (support::repeat trial(40); trial.again();) {
    const any_state any = random_state(random, 30);
    const motion& of = any.state.motion();
    if (of.a() == 0 || of.b() == 0) continue;
    const rotor<ball> r(any.state, 400);
    if (!r.period()) continue;
    const body rigid(of.a().exact(), of.b().exact());
    const rational& c = of.c().exact();
    EXPECT_TRUE(meet(*r.phase_per_period(), montgomery_phase(rigid, c, 150)));
    const exact_real& middle = any.state.tensor().moments()[1];
    EXPECT_TRUE(meet(*r.period() * r.momentum_size() / middle, rotation_period(rigid, c, 150)));
    EXPECT_TRUE(meet(r.mean_precession() * *r.period(), *r.phase_per_period()));
    // After a period the body has turned by the phase about J, which is where it was in the body. t
    // is within 2^-100 T of T.
    const rational t = lower_rational(*r.period());
    const auto at = r.attitude(t);
    const auto start = any.state.attitude(200);
    const auto j0 = r.sample(0).momentum;
    const ball length = r.momentum_size();
    const triple<ball> axis{dot(start[0], j0) / length, dot(start[1], j0) / length,
                            dot(start[2], j0) / length};
    const ball late = *r.period() - t;
    const magnitude moved = multiply_up(late.magnitude_upper(),
                                        (1 / ball(shortest_time(any.state), 64)).magnitude_upper());
    EXPECT_LE(moved, two_to(-90)) << described(any.state);
    EXPECT_TRUE(matrices_meet(at.matrix, product(rotation(axis, *r.phase_per_period()), start),
                              scale(moved, 1)))
        << described(any.state);
    const ball precise = at.angles().phi - *r.phase_per_period();
    EXPECT_LE(precise.magnitude_upper(), two_to(-80));
  }
}

// From the middle of a twist, phi is half of F(c, cos^2 psi), which decreases in the second
// argument.
TEST(Rotor, PhaseOnTheFirstQuarter) {
  support::random_source random(907);
  for (support::repeat trial(40); trial.again();) {
    const body rigid(rational(random.between(1, 4000), random.between(1, 400)),
                     rational(random.between(1, 999), 1000));
    const rational c(random.one_in(2) ? -rigid.b().exact() * support::any_small(random, 60)
                                      : rigid.a().exact() * support::any_small(random, 60));
    const rotor<ball> r(initial_state::at_middle_of_twist(rigid, c), 120);
    const rational t(lower_rational(*r.period()) * random.between(1, 99) / 400);
    const auto at = r.attitude(t);
    const ball x2 = square(at.direction[0]);
    const ball x = x2 / (x2 + square(at.direction[1]));
    const rational low =
        std::max(lower_rational(x), rational(c < 0 ? -c / rigid.b().exact() : rational(0)));
    const rational high = upper_rational(x);
    if (high >= 1) continue;
    const ball phi = at.angles().phi;
    const ball most = phase_integral(rigid, c, low, 200) / 2;
    const ball least = phase_integral(rigid, c, high, 200) / 2;
    EXPECT_TRUE(meet(phi, hull(least, most))) << rigid.a() << " " << rigid.b() << " " << c;
  }
}

TEST(Rotor, SeparatrixIsElementary) {
  // a = 1, b = 1/4: J_x^2 : J_z^2 = 4, from any start on it.
  for (const triple<int>& sense :
       {triple<int>{1, 1, 1}, {-1, 1, 1}, {1, -1, -1}, {-1, -1, 1}, {-1, 0, 1}, {1, 0, 1}}) {
    const auto state = initial_state::from_momentum({rational(4, 3), 1, rational(1, 2)},
                                                    {2 * sense[0], 3 * sense[1], sense[2]});
    ASSERT_EQ(state.regime(), regime::separatrix);
    EXPECT_EQ(state.motion().c(), 0);
    const rotor<ball> r(state, 200);
    EXPECT_FALSE(r.period());
    const precision p = 260;
    const ball size = sqrt(state.squared_momentum().at(p));
    EXPECT_TRUE(meet(r.mean_precession(), size));
    const ball ratio = ball(rational(1, 2), p);  // sqrt(b/a) and sqrt(a b) are both 1/2
    const ball start = atanh(3 * ball(state.direction_signs()[1], p) / size);
    for (const rational& t : {rational(0), rational(7, 3), rational(-5), rational(1, 1000),
                              rational(90), rational("1000000000000000000000000000000")}) {
      const ball u = ratio * size * t + start;
      const auto at = r.attitude(t);
      EXPECT_TRUE(meet(at.direction[1], tanh(u)));
      EXPECT_TRUE(meet(at.direction[0], -sqrt(ball(rational(4, 5), p)) / cosh(u)));
      EXPECT_TRUE(meet(at.direction[2], sqrt(ball(rational(1, 5), p)) / cosh(u)));
      const ball lag = atan(ratio * tanh(u)) - atan(ratio * tanh(start));
      EXPECT_TRUE(meet(at.angles().phi, size * t - lag));
    }
  }
}

/// A symmetric top with its axis k, moment across I and along I_k: omega = J/I + J_k (1/I_k - 1/I)
/// e_k, and both parts turn steadily, so R = rotation about J in space by t |J|/I, times R at 0,
/// times rotation about e_k by t J_k (1/I_k - 1/I).
TEST(Rotor, SymmetricTopsAreElementary) {
  support::random_source random(908);
  const precision p = 200;
  for (support::repeat trial(60); trial.again();) {
    const rational across(random.between(1, 50), random.between(1, 9));
    const rational along(random.one_in(5) ? across : rational(random.between(1, 50), 7));
    const auto k = static_cast<std::size_t>(random.between(0, 2));
    triple<rational> moments{across, across, across};
    moments[k] = along;
    triple<rational> j{random.between(-9, 9), random.between(-9, 9), random.between(-9, 9)};
    if (random.one_in(4)) j[k] = 0;
    if (random.one_in(4)) j[k] = power_of_ten(-300);
    if (random.one_in(4)) j[(k + 1) % 3] = j[(k + 2) % 3] = power_of_ten(-300);
    if (j[0] == 0 && j[1] == 0 && j[2] == 0) j[k] = 1;
    auto exact = initial_state::from_momentum(moments, j);
    exact.set_quaternion({1, -2, 3, 4});
    // And beside it: the motions part by less than 1e-280 in such times.
    triple<rational> near = moments;
    near[(k + 1) % 3] *= 1 + power_of_ten(-300);
    auto beside = initial_state::from_momentum(near, j);
    beside.set_quaternion({1, -2, 3, 4});
    const rational t(random.between(-400, 400), 7);
    const auto start = exact.attitude(p);
    triple<ball> in_space;
    triple<ball> body_axis{ball(0, p), ball(0, p), ball(0, p)};
    body_axis[k] = ball(1, p);
    const ball size = sqrt(exact.squared_momentum().at(p));
    for (std::size_t i = 0; i < 3; ++i) {
      in_space[i] = (start[i][0] * j[0] + start[i][1] * j[1] + start[i][2] * j[2]) / size;
    }
    const matrix3<ball> expected =
        product(product(rotation(in_space, size * t / across), start),
                rotation(body_axis, ball(rational(t * j[k] * (1 / along - 1 / across)), p)));
    EXPECT_TRUE(matrices_meet(rotor<ball>(exact, 150).attitude(t).matrix, expected))
        << described(exact);
    EXPECT_TRUE(matrices_meet(rotor<ball>(beside, 150).attitude(t).matrix, expected, two_to(-900)))
        << described(beside);
  }
}

TEST(Rotor, OrderAndSenseOfTheAxesDoNotMatter) {
  support::random_source random(909);
  for (support::repeat trial(8); trial.again();) {
    const triple<rational> moments{random.between(1, 9), random.between(1, 9),
                                   random.between(1, 9)};
    const triple<rational> j{random.between(-9, 9), random.between(-9, 9), random.between(1, 9)};
    const rotor<ball> r(initial_state::from_momentum(moments, j), 100);
    const rational t(random.between(-400, 400), 7);
    const auto plain = r.attitude(t).matrix;
    // Other body axes, i of them along +- axis order[i] of the old, right-handed.
    triple<std::size_t> order{0, 1, 2};
    do {
      for (int signs = 0; signs < 8; ++signs) {
        triple<int> sense{(signs & 1) != 0 ? -1 : 1, (signs & 2) != 0 ? -1 : 1,
                          (signs & 4) != 0 ? -1 : 1};
        const bool even = (order[0] + 1) % 3 == order[1];
        if ((sense[0] * sense[1] * sense[2] > 0) != even) continue;
        triple<rational> other_moments;
        triple<rational> other_j;
        matrix3<rational> turned{};
        for (std::size_t i = 0; i < 3; ++i) {
          other_moments[i] = moments[order[i]];
          other_j[i] = sense[i] * j[order[i]];
          turned[order[i]][i] = sense[i];
        }
        auto state = initial_state::from_momentum(other_moments, other_j);
        state.set_matrix(turned);
        const auto other = rotor<ball>(state, 100).attitude(t).matrix;
        for (std::size_t i = 0; i < 3; ++i) {
          for (std::size_t row = 0; row < 3; ++row) {
            ASSERT_TRUE(meet(other[row][i], sense[i] * plain[row][order[i]])) << described(state);
          }
        }
      }
    } while (std::next_permutation(order.begin(), order.end()));
  }
}

TEST(Rotor, EquilibriaDoNotMove) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    triple<rational> omega{0, 0, 0};
    omega[axis] = -2;
    const auto state = initial_state::from_angular_velocity({3, 2, 1}, omega);
    constexpr std::array kinds{regime::equilibrium_x, regime::equilibrium_y, regime::equilibrium_z};
    EXPECT_EQ(state.regime(), kinds.at(axis));
    const rotor<ball> r(state, 100);
    EXPECT_FALSE(r.period());
    EXPECT_FALSE(r.phase_per_period());
    EXPECT_TRUE(contains(r.mean_precession(), 2L));
    // Exactly on it: J is the same at all times, and no component comes from nowhere.
    for (const rational& t : {rational(1), rational(power_of_ten(30))}) {
      const auto at = r.sample(t);
      for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_TRUE(contains(at.angular_velocity[i], omega[i]));
        EXPECT_TRUE(i == axis || at.momentum[i].is_exact());
      }
    }
    triple<ball> about{ball(0, 150), ball(0, 150), ball(0, 150)};
    about[axis] = ball(-1, 150);
    EXPECT_TRUE(matrices_meet(r.attitude(rational(7, 3)).matrix,
                              rotation(about, ball(rational(14, 3), 150))));
    const auto d = rotor<double>(state).attitude(7.0 / 3);
    EXPECT_NEAR(d.angles().phi, 14.0 / 3, 1e-14);
  }
  // Beside the unstable one a body does turn over, however near.
  const auto beside = initial_state::from_momentum({3, 2, 1}, {0, 1, power_of_ten(-300)});
  EXPECT_EQ(beside.regime(), regime::rotating);
  const rotor<ball> r(beside, 60);
  const rational half = lower_rational(*r.period()) / 2;
  EXPECT_TRUE(certainly_negative(r.sample(half).momentum[1]));
}

// ---------------------------------------------------------------------------------------------
// double

struct norm_error {
  double momentum = 0;  // in units of 2^-52 |J|
  double attitude = 0;  // of 2^-52, by columns
};
double upper_bound_of(const ball& x) { return mpfr_get_d(upper(x).backend().data(), MPFR_RNDU); }

norm_error error_of(const rotor<double>& d, const rotor<ball>& r, double t) {
  const auto sample = d.sample(t);
  const auto attitude = d.attitude(t);
  const auto exact_sample = r.sample(rational(t));
  const auto exact = r.attitude(rational(t));
  norm_error e;
  ball sum(0, 64);
  for (std::size_t i = 0; i < 3; ++i) {
    sum += square(exact_sample.momentum[i] - ball::exactly(sample.momentum[i]));
  }
  e.momentum = upper_bound_of(scale(sqrt(sum) / r.momentum_size(), 52));
  for (std::size_t k = 0; k < 3; ++k) {
    sum = ball(0, 64);
    for (std::size_t i = 0; i < 3; ++i) {
      sum += square(exact.matrix[i][k] - ball::exactly(attitude.matrix[i][k]));
    }
    e.attitude = std::max(e.attitude, upper_bound_of(scale(sqrt(sum), 52)));
  }
  return e;
}

// Over the first period within 8 units in the last place of the norm, in every regime; later less
// than one more for each period.
TEST(Rotor, DoubleIsWithinEightUnits) {
  support::random_source random(910);
  norm_error worst;
  for (support::repeat trial(150); trial.again();) {
    const any_state any =
        random_state(random, random.choose(std::array{15L, 15L, 300L, 300L, 6000L}));
    const rotor<double> d(any.state);
    const rotor<ball> r(any.state, 80);
    if (!std::isfinite(d.momentum_size())) continue;  // no double has it
    const rational span =
        r.period() ? lower_rational(*r.period()) : rational(40 * shortest_time(any.state));
    for (int i = 0; i < 4; ++i) {
      const double t =
          static_cast<double>(rational(span * random.between(-1000000, 1000000) / 1000000));
      if (!std::isfinite(t)) continue;
      const norm_error e = error_of(d, r, t);
      EXPECT_LE(e.momentum, 8) << any.kind << " " << described(any.state);
      EXPECT_LE(e.attitude, 8) << any.kind << " " << described(any.state);
      worst.momentum = std::max(worst.momentum, e.momentum);
      worst.attitude = std::max(worst.attitude, e.attitude);
    }
    const long power = random.between(1, 30);
    const double later = static_cast<double>(
        rational(span * random.between(1, 999999) / 1000000 * power_of_ten(power)));
    if (!std::isfinite(later)) continue;
    const norm_error e = error_of(d, r, later);
    const double allowed = 8 + std::pow(10.0, static_cast<double>(power));
    EXPECT_LE(e.momentum, allowed);
    EXPECT_LE(e.attitude, allowed);
    if (power < 12) {  // more than was asked for: the period is known to three doubles
      EXPECT_LE(e.momentum, 8);
      EXPECT_LE(e.attitude, 8);
    }
  }
  RecordProperty("worst_momentum", std::to_string(worst.momentum));
  RecordProperty("worst_attitude", std::to_string(worst.attitude));
}

TEST(Rotor, DoubleTakesRationalTimes) {
  const auto state = initial_state::from_angular_velocity({3, 2, 1}, {1, 2, 3});
  const rotor<double> d(state);
  const rotor<ball> r(state, 80);
  const rational t(parse_rational("123456789012345678901234567890.1"));
  const auto exact = r.sample(t).momentum;
  const auto fast = d.sample(t).momentum;
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_LE((exact[i] - ball::exactly(fast[i])).magnitude_upper(), two_to(-50));
  }
  EXPECT_NEAR(d.sample(0.5).momentum[0], d.sample(rational(1, 2)).momentum[0], 8e-15);
  EXPECT_THROW((void)d.sample(std::numeric_limits<double>::infinity()), input_error);
  EXPECT_THROW((void)d.attitude(std::numeric_limits<double>::quiet_NaN()), input_error);
  // Times at which a double is beyond all periods.
  EXPECT_TRUE(std::isfinite(d.sample(1e300).momentum[0]));
  EXPECT_TRUE(std::isfinite(d.attitude(-1e300).matrix[0][0]));
}

// ---------------------------------------------------------------------------------------------
// Input

template <class F>
void expect_refusal(const F& f, std::string_view words) {
  try {
    f();
    ADD_FAILURE() << "accepted: " << words;
  } catch (const input_error& error) {
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
}

/// Where the turn is rational, it is the turned tensor's own motion; along a principal axis the
/// motion is steady, whatever the turn; and what is not decided is refused.
TEST(Rotor, DecidesTheRegimeOfATurnedTensor) {
  const auto of = [](const std::array<rational, 6>& t) {
    return std::make_shared<const principal_axes>(t);
  };
  const auto tensor = of({3, 2, 1, 0, 0, 0});
  const auto about = [](std::size_t axis, const rational& angle) {
    return exact_rotation::about(axis, angle, angle_unit::radians);
  };
  const exact_rotation quarter = exact_rotation::about({1, 2, 2}, 180, angle_unit::degrees);
  const auto turned = initial_state::from_tensor(tensor, {1, 2, 4}, quarter);
  const auto own = initial_state::from_tensor(
      of({rational(3 * 49 + 2 * 16 + 16, 81), rational(3 * 16 + 2 + 64, 81),
          rational(3 * 16 + 2 * 64 + 1, 81), rational(-3 * 28 - 2 * 4 + 32, 81),
          rational(-3 * 28 + 2 * 32 - 4, 81), rational(3 * 16 - 2 * 8 - 8, 81)}),
      {1, 2, 4});
  EXPECT_EQ(turned.motion().c(), own.motion().c());
  EXPECT_EQ(turned.regime(), own.regime());
  EXPECT_EQ(turned.squared_momentum(), 21);
  // About z: the axis z of both is one.
  EXPECT_EQ(initial_state::from_tensor(tensor, {0, 0, 5}, about(2, rational(3, 10))).regime(),
            regime::equilibrium_z);
  const auto along_x =
      initial_state::from_tensor_and_velocity(tensor, {5, 0, 0}, about(0, rational(3, 10)));
  EXPECT_EQ(along_x.regime(), regime::equilibrium_x);
  EXPECT_EQ(along_x.motion().c(), rational(-1, 3));
  EXPECT_EQ(initial_state::from_tensor(tensor, {0, 5, 0}, about(1, rational(3, 10))).regime(),
            regime::equilibrium_y);
  // Near them, and still decided.
  EXPECT_EQ(
      initial_state::from_tensor(tensor, {0, 0, 5}, about(1, rational(1, 1) * power_of_ten(-60)))
          .regime(),
      regime::rotating);
  // A symmetric top: in the plane of its equal moments it is steady.
  const auto top = of({2, 2, 1, 0, 0, 0});
  EXPECT_EQ(initial_state::from_tensor(top, {1, 2, 0}, about(2, 1)).regime(),
            regime::equilibrium_x);
  EXPECT_EQ(initial_state::from_tensor_and_velocity(top, {0, 0, 2}, about(2, 1)).regime(),
            regime::equilibrium_z);
  EXPECT_EQ(initial_state::from_tensor_and_velocity(top, {1, 0, 2}, about(2, 1)).regime(),
            regime::rotating);
  EXPECT_EQ(initial_state::from_tensor(of({3, 3, 3, 0, 0, 0}), {1, 2, 3}, about(2, 1)).regime(),
            regime::equilibrium_x);
  // By 45 degrees (1, 1, 0) is along an axis, which is known; and along (1, 1, 0) by 22.5 twice,
  // which is not.
  const auto degrees = [](const rational& angle) {
    return exact_rotation::about(2, angle, angle_unit::degrees);
  };
  const auto diagonal = initial_state::from_tensor(tensor, {1, 1, 0}, degrees(45));
  EXPECT_EQ(diagonal.regime(), regime::equilibrium_x);
  ASSERT_TRUE(diagonal.motion().c().is_rational());
  EXPECT_EQ(diagonal.motion().c(), rational(-1, 3));
  expect_refusal(
      [&] {
        (void)initial_state::from_tensor(tensor, {1, 1, 0},
                                         degrees(rational(45, 2)) * degrees(rational(45, 2)));
      },
      "is not decided");
}

TEST(Rotor, RefusesWhatIsNoState) {
  expect_refusal([] { (void)initial_state::from_momentum({1, 0, 1}, {1, 1, 1}); }, "not positive");
  expect_refusal([] { (void)initial_state::from_momentum({1, -2, 1}, {1, 1, 1}); }, "-2");
  expect_refusal([] { (void)initial_state::from_momentum({1, 2, 3}, {0, 0, 0}); }, "rests");
  expect_refusal(
      [] {
        (void)initial_state::from_angular_velocity({1, 2, 3}, {0, 0, 0});
      },
      "angular velocity");
  const body rigid(1, rational(1, 2));
  expect_refusal([&] { (void)initial_state::at_middle_of_twist(rigid, 2); }, "from -b");
  expect_refusal([&] { (void)initial_state::at_middle_of_twist(rigid, -1); }, "-1/2");
  auto state = initial_state::from_momentum({1, 2, 3}, {1, 1, 1});
  expect_refusal([&] { state.set_quaternion({0, 0, 0, 0}); }, "must not be 0");
  expect_refusal([&] { state.set_matrix({{{1, 0, 0}, {0, 1, 0}, {0, 0, -1}}}); }, "reflection");
  expect_refusal([&] { state.set_matrix({{{1, 0, 0}, {0, 1, 0}, {0, 0, 2}}}); }, "rows 3 and 3");
  expect_refusal(
      [&] {
        const rational s = parse_rational("0.70710678");
        state.set_matrix({{{s, -s, 0}, {s, s, 0}, {0, 0, 1}}});
      },
      "quaternion");
  // A refused attitude leaves the last one.
  EXPECT_TRUE(contains(state.attitude(64)[0][0], 1L));
}

TEST(Rotor, AttitudesGivenInThreeWays) {
  auto state = initial_state::from_momentum({1, 2, 3}, {1, 1, 1});
  const rational three(3, 5);
  const rational four(4, 5);
  // About z by the angle with cosine 3/5: its quaternion is (2, 0, 0, 1) but for the norm.
  state.set_matrix({{{three, -four, 0}, {four, three, 0}, {0, 0, 1}}});
  const auto by_matrix = state.attitude(100);
  state.set_quaternion({2, 0, 0, 1});
  EXPECT_TRUE(matrices_meet(by_matrix, state.attitude(100)));
  // z-x-z, against products of rotations.
  const ball zero(0, 150);
  const ball one(1, 150);
  const triple<ball> x{one, zero, zero};
  const triple<ball> z{zero, zero, one};
  const triple<rational> degrees{36 * 1000000 + 50, 70, rational(-401, 2)};
  state.set_euler_angles(degrees, angle_unit::degrees);
  const auto angle = [](const rational& q) { return pi(200) * rational(q / 180); };
  EXPECT_TRUE(matrices_meet(state.attitude(100), product(product(rotation(z, angle(degrees[0])),
                                                                 rotation(x, angle(degrees[1]))),
                                                         rotation(z, angle(degrees[2])))));
  EXPECT_LE(state.attitude(100)[0][0].radius(), two_to(-90));
  state.set_euler_angles({1, 2, 3});
  EXPECT_TRUE(matrices_meet(state.attitude(100),
                            product(product(rotation(z, ball(1, 150)), rotation(x, ball(2, 150))),
                                    rotation(z, ball(3, 150)))));
}

TEST(Rotor, StateBySquaresIsThatByComponents) {
  const triple<rational> moments{2, 3, 1};
  for (const triple<rational>& j : {triple<rational>{1, -2, 3}, triple<rational>{-5, 2, 0},
                                    triple<rational>{0, -1, 0}, triple<rational>{-1, 1, -9}}) {
    const initial_state known = initial_state::from_momentum(moments, j);
    triple<rational> squares;
    triple<int> senses{};
    for (std::size_t i = 0; i < 3; ++i) {
      squares[i] = j[i] * j[i];
      senses[i] = j[i].sign();
    }
    const initial_state by_squares = initial_state::from_squared_momentum(moments, squares, senses);
    EXPECT_EQ(by_squares.motion().c(), known.motion().c());
    EXPECT_EQ(by_squares.regime(), known.regime());
    EXPECT_EQ(by_squares.squared_momentum(), known.squared_momentum());
    EXPECT_EQ(by_squares.direction_squares(), known.direction_squares());
    EXPECT_EQ(by_squares.direction_signs(), known.direction_signs());
  }
  // sqrt 2 along the second axis: no rational has it.
  EXPECT_EQ(initial_state::from_squared_momentum(moments, {0, 2, 1}, {0, 1, -1}).motion().c(),
            2 * (rational(2, 3) + 1) / 3 - 1);
  const auto refused = [&](const triple<rational>& squares, const triple<int>& senses) {
    EXPECT_THROW((void)initial_state::from_squared_momentum(moments, squares, senses), input_error);
  };
  refused({0, 0, 0}, {0, 0, 0});
  refused({1, -4, 0}, {1, 1, 0});
  refused({1, 4, 0}, {1, 0, 0});
  refused({1, 4, 0}, {1, -1, 1});
  refused({1, 4, 0}, {1, 2, 0});
}

TEST(Rotor, CountsWhatItIntegrates) {
  // 2K, the other period, the pole and the start, each at two precisions; no start where J_y is 0.
  EXPECT_EQ(rotor<ball>(initial_state::from_momentum({3, 2, 1}, {1, 2, 3}), 100).work().integrals,
            8);
  EXPECT_EQ(rotor<ball>(initial_state::from_momentum({3, 2, 1}, {1, 0, 3}), 100).work().integrals,
            6);
  EXPECT_EQ(rotor<double>(initial_state::from_momentum({3, 2, 1}, {1, 0, 3})).work().integrals, 6);
  EXPECT_EQ(rotor<ball>(initial_state::from_momentum({3, 2, 1}, {0, 0, 3}), 100).work(),
            work_count{});
}

TEST(Rotor, ManyThreadsMayAskOne) {
  const rotor<ball> r(initial_state::from_momentum({3, 2, 1}, {1, 2, 3}), 100);
  const auto expected = to_exact_text(r.attitude(rational(17, 3)).matrix[1][2]);
  std::array<std::string, 4> found;
  std::array<std::thread, 4> threads;
  for (std::size_t i = 0; i < threads.size(); ++i) {
    threads[i] =
        std::thread([&, i] { found[i] = to_exact_text(r.attitude(rational(17, 3)).matrix[1][2]); });
  }
  for (std::thread& thread : threads) thread.join();
  for (const std::string& text : found) EXPECT_EQ(text, expected);
}

}  // namespace rotor_test
}  // namespace polhode
