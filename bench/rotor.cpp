// The free rotation in closed form: samples in double and to 50 digits, and against integration by
// Boost.odeint.
//
// The peer is dopri5 with step size control, tolerances 1e-12, on the momentum in the body and the
// attitude's quaternion: what one who simulates a free body writes. Both end after 1,000 periods of
// the momentum; errors there are measured against the certified value: of the momentum over |J|,
// and of the attitude's matrix, the greatest norm of a column's error. Polhode's time holds the
// making of the rotor, all that does not depend on time, and one attitude.

#include <cmath>
#include <iomanip>
#include <sstream>
#include <string>
#include <vector>

#include "cost/odeint.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/rigid_body/rotor.hpp"
#include "support/measure.hpp"

namespace {

using namespace polhode;
using namespace polhode::bench;

struct measured_motion {
  std::string name;
  initial_state state;
};

std::vector<measured_motion> motions() {
  const triple<rational> moments{3, 2, 1};
  const body rigid(1, rational(1, 3));
  return {
      {"oscillating", initial_state::from_momentum(moments, {3, 1, rational(1, 2)})},
      {"rotating", initial_state::from_momentum(moments, {rational(1, 2), 1, 3})},
      {"c = 1e-15", initial_state::at_middle_of_twist(rigid, parse_rational("1e-15"))},
      {"c = -1e-300", initial_state::at_middle_of_twist(rigid, parse_rational("-1e-300"))},
      {"symmetric", initial_state::from_momentum({2, 2, 1}, {1, 1, 1})},
      {"tensor", initial_state::from_tensor(
                     std::make_shared<const principal_axes>(std::array<rational, 6>{
                         3, 2, rational(3, 2), rational(1, 10), rational(1, 5), rational(-3, 10)}),
                     {3, 1, rational(1, 2)})},
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
  const auto by_dopri5 = [state, t] {
    constexpr double tolerance = 1e-12;
    return cost::rotation_by_dopri5(state, t, tolerance);
  };
  row race;
  race.contestants = {
      warm([state, t] { benchmark::DoNotOptimize(rotor<double>(state).attitude(t)); }),
      warm([by_dopri5] { benchmark::DoNotOptimize(by_dopri5()); })};
  race.ratios = {{1, 0, at_least(100)}};
  outcome result = polhode::bench::detail::measure(race);
  const cost::integrated_rotation x = by_dopri5();
  result.remark = " " + errors(exact, rational(t), r.sample(t).momentum, r.attitude(t).matrix) +
                  "   " + errors(exact, rational(t), x.momentum, x.matrix());
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
  for (const measured_motion& m : motions()) {
    benchmarks.add(in_double, m.name, [m] { return samples_in_double(m.state); });
  }
  for (const measured_motion& m : motions()) {
    benchmarks.add(balls, m.name, [m] { return samples_to_digits<ball>(m.state, 50); });
  }
  for (const measured_motion& m : motions()) {
    benchmarks.add(numbers, m.name, [m] { return samples_to_digits<mpfr_float>(m.state, 50); });
  }
  for (const measured_motion& m : motions()) {
    if (m.name == "c = -1e-300") continue;  // 1,000 such periods take dopri5 minutes
    benchmarks.add_measured(races, m.name, [m] { return against_odeint(m.state); });
  }
  return benchmarks.main(argc, argv);
}
