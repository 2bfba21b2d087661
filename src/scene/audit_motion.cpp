// What a motion conserves.

#include "polhode/arithmetic/elementary.hpp"
#include "scene/motion.hpp"
#include "scene/scene_motion.hpp"

namespace polhode::detail {
namespace {

triple<ball> product(const matrix3<ball>& x, const triple<ball>& v) {
  triple<ball> result;
  for (std::size_t i = 0; i < 3; ++i) result[i] = x[i][0] * v[0] + x[i][1] * v[1] + x[i][2] * v[2];
  return result;
}

}  // namespace

work_count audit_motion(const effect_context& x, precision p,
                        const std::function<void(const std::string&, const ball&)>& expect_zero) {
  const initial_state& start = x.start();
  const rotor<ball> turning(start, p);
  const rotor_sample<ball> begin = turning.sample(rational(0));
  const triple<ball> in_space = product(turning.attitude(rational(0)).matrix, begin.momentum);
  // The hull of the differences; or the first that does not hold 0, which no hull may hide.
  const auto note = [](std::optional<ball>& all, const ball& difference) {
    if (all && !contains_zero(*all)) return;
    all = all && contains_zero(difference) ? hull(*all, difference) : difference;
  };
  std::optional<ball> energy;
  std::optional<ball> momentum;
  std::optional<ball> direction;
  const rational size = lower_rational(sqrt(start.squared_momentum().at(32)));  // about |J|
  const rational middle = rational_below(start.tensor().moments()[1], 32);
  for (const long time : {1L, 10L, 100L}) {
    const rational t(time * middle / size);
    const rotor_sample<ball> sample = turning.sample(t);
    ball twice_energy(0, p);
    ball square(0, p);
    for (std::size_t i = 0; i < 3; ++i) {
      twice_energy += sample.momentum[i] * sample.angular_velocity[i];
      square += polhode::square(sample.momentum[i]);
    }
    note(energy, twice_energy / start.twice_energy() - 1);
    note(momentum, square / start.squared_momentum() - 1);
    const triple<ball> there = product(turning.attitude(t).matrix, sample.momentum);
    for (std::size_t i = 0; i < 3; ++i)
      note(direction, (there[i] - in_space[i]) / turning.momentum_size());
  }
  expect_zero("energy", *energy);
  expect_zero("squared_momentum", *momentum);
  expect_zero("momentum_in_space", *direction);
  return turning.work();
}

}  // namespace polhode::detail
