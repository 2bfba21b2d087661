// The free rotation in closed form: samples in double and to 50 digits, and against integration by Boost.odeint.
//
// The peer is dopri5 with step size control, tolerances 1e-12, on the momentum in the body and the attitude's quaternion: what one
// who simulates a free body writes. Both end after 1,000 periods of the momentum; errors there are measured against the certified value:
// of the momentum over |J|, and of the attitude's matrix, the greatest norm of a column's error. Polhode's time holds the making of the
// rotor, all that does not depend on time, and one attitude.

#include <cmath>
#include <iomanip>
#include <sstream>
#include <string>
#include <vector>

#include <boost/numeric/odeint.hpp>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/rigid_body/rotor.hpp"
#include "support/measure.hpp"

namespace {

using namespace polhode;
using namespace polhode::bench;

struct motion {
  std::string name;
  initial_state state;
};

std::vector<motion> motions() {
  const triple<rational> moments{3, 2, 1};
  const body rigid(1, rational(1, 3));
  return {
      {"oscillating", initial_state::from_momentum(moments, {3, 1, rational(1, 2)})},
      {"rotating", initial_state::from_momentum(moments, {rational(1, 2), 1, 3})},
      {"c = 1e-15", initial_state::at_middle_of_twist(rigid, parse_rational("1e-15"))},
      {"c = -1e-300", initial_state::at_middle_of_twist(rigid, parse_rational("-1e-300"))},
      {"symmetric", initial_state::from_momentum({2, 2, 1}, {1, 1, 1})},
  };
}

row samples_in_double(const initial_state& state) {
  const rotor<double> r(state);
  row result;
  result.contestants = {
      warm([r, t = 0.0]() mutable { benchmark::DoNotOptimize(r.sample(t += 0.01)); }),
      warm([r, t = 0.0]() mutable { benchmark::DoNotOptimize(r.attitude(t += 0.01)); }),
      warm(
          [r, t = 0.0]() mutable { benchmark::DoNotOptimize(r.attitude(t += 0.01).quaternion()); }),
      warm([r, t = 0.0]() mutable { benchmark::DoNotOptimize(r.attitude(t += 0.01).angles()); })};
  result.ratios = {{1, 0, at_least(3)}};
  return result;
}

template <class T>
row samples_to_digits(const initial_state& state, long digits) {
  const rotor<T> r(state, bits_for_digits(digits) + 4);
  row result;
  result.contestants = {
      warm([r, n = 0L]() mutable { benchmark::DoNotOptimize(r.sample(rational(++n, 100))); }),
      warm([r, n = 0L]() mutable { benchmark::DoNotOptimize(r.attitude(rational(++n, 100))); })};
  return result;
}

// ---------------------------------------------------------------------------------------------

using odeint_state = std::array<double, 7>;  // J, then w, x, y, z

class equations {
 public:
  explicit equations(const triple<rational>& moments) {
    for (std::size_t i = 0; i < 3; ++i) inverse_[i] = static_cast<double>(1 / moments[i]);
  }
  void operator()(const odeint_state& x, odeint_state& slope, double) const {
    const auto& [jx, jy, jz, w, a, b, c] = x;
    const double ox = jx * inverse_[0];
    const double oy = jy * inverse_[1];
    const double oz = jz * inverse_[2];
    slope = {jy * oz - jz * oy,
             jz * ox - jx * oz,
             jx * oy - jy * ox,
             (-a * ox - b * oy - c * oz) / 2,
             (w * ox + b * oz - c * oy) / 2,
             (w * oy + c * ox - a * oz) / 2,
             (w * oz + a * oy - b * ox) / 2};
  }

 private:
  std::array<double, 3> inverse_{};
};

odeint_state by_dopri5(const rotor<double>& r, double t) {
  const auto j = r.sample(0.0).momentum;
  odeint_state x{j[0], j[1], j[2], 1, 0, 0, 0};
  namespace ode = boost::numeric::odeint;
  constexpr double tolerance = 1e-12;
  ode::integrate_adaptive(
      ode::make_controlled<ode::runge_kutta_dopri5<odeint_state>>(tolerance, tolerance),
      equations(r.state().moments()), x, 0.0, t, 1e-3);
  return x;
}

matrix3<double> matrix_of(const odeint_state& s) {
  const double norm = s[3] * s[3] + s[4] * s[4] + s[5] * s[5] + s[6] * s[6];
  const double k = 2 / norm;
  const auto& [jx, jy, jz, w, x, y, z] = s;
  return {{{1 - k * (y * y + z * z), k * (x * y - w * z), k * (x * z + w * y)},
           {k * (x * y + w * z), 1 - k * (x * x + z * z), k * (y * z - w * x)},
           {k * (x * z - w * y), k * (y * z + w * x), 1 - k * (x * x + y * y)}}};
}

double upper_bound_of(const ball& x) { return mpfr_get_d(upper(x).backend().data(), MPFR_RNDU); }

std::string errors(const rotor<ball>& exact, const rational& t, const triple<double>& momentum,
                   const matrix3<double>& matrix) {
  const auto sample = exact.sample(t).momentum;
  const auto attitude = exact.attitude(t).matrix;
  ball sum(0, 64);
  for (std::size_t i = 0; i < 3; ++i) sum += square(sample[i] - ball::exactly(momentum[i]));
  const double of_momentum = upper_bound_of(sqrt(sum) / exact.momentum_size());
  double of_attitude = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    sum = ball(0, 64);
    for (std::size_t i = 0; i < 3; ++i) sum += square(attitude[i][k] - ball::exactly(matrix[i][k]));
    of_attitude = std::max(of_attitude, upper_bound_of(sqrt(sum)));
  }
  std::ostringstream out;
  out << std::scientific << std::setprecision(1) << of_momentum << " / " << of_attitude;
  return out.str();
}

outcome against_odeint(const initial_state& state) {
  const rotor<double> r(state);
  const rotor<ball> exact(state, 80);
  const double t = 1000 * *r.period();
  row race;
  race.contestants = {
      warm([state, t] { benchmark::DoNotOptimize(rotor<double>(state).attitude(t)); }),
      warm([r, t] { benchmark::DoNotOptimize(by_dopri5(r, t)); })};
  race.ratios = {{1, 0, at_least(100)}};
  outcome result = polhode::bench::detail::measure(race);
  const odeint_state x = by_dopri5(r, t);
  result.remark = " " + errors(exact, rational(t), r.sample(t).momentum, r.attitude(t).matrix) +
                  "   " + errors(exact, rational(t), {x[0], x[1], x[2]}, matrix_of(x));
  return result;
}

}  // namespace

int main(int argc, char** argv) {
  suite benchmarks;
  const table in_double{"double",
                        "a sample in double: momentum and angular velocity; attitude; with its "
                        "quaternion; with its angles",
                        {"momentum", "attitude", "quaternion", "angles"},
                        {"att/mom"},
                        12};
  const table balls{
      "50 digits", "a sample to 50 digits, certified (ball)", {"momentum", "attitude"}, {}, 12};
  const table numbers{"50 digits, uncertified",
                      "a sample to 50 digits, uncertified (mpfr_float)",
                      {"momentum", "attitude"},
                      {},
                      12};
  const table races{
      "odeint",
      "the attitude after 1,000 periods: Polhode, and dopri5 with tolerances 1e-12\n(errors at "
      "the end, of momentum / attitude: Polhode's, then dopri5's)",
      {"Polhode", "dopri5"},
      {"faster"},
      12};
  for (const motion& m : motions()) {
    benchmarks.add(in_double, m.name, [m] { return samples_in_double(m.state); });
  }
  for (const motion& m : motions()) {
    benchmarks.add(balls, m.name, [m] { return samples_to_digits<ball>(m.state, 50); });
  }
  for (const motion& m : motions()) {
    benchmarks.add(numbers, m.name, [m] { return samples_to_digits<mpfr_float>(m.state, 50); });
  }
  for (const motion& m : motions()) {
    if (m.name == "c = -1e-300") continue;  // 1,000 such periods take dopri5 minutes
    benchmarks.add_measured(races, m.name, [m] { return against_odeint(m.state); });
  }
  return benchmarks.main(argc, argv);
}
