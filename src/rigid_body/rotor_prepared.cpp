#include "rigid_body/rotor_prepared.hpp"

#include <algorithm>
#include <utility>

#include "polhode/arithmetic/elementary.hpp"

namespace polhode::detail {
namespace {

prepared<ball> prepare(const initial_state& state, precision bits, precision spare) {
  prepared<ball> r;
  r.bits = bits;
  r.kind = state.regime();
  r.along = state.along_body_axes();
  r.axes = state.frame(bits);
  rotor_tables tables(state, bits + spare);
  r.rates = std::move(tables.rates);
  rotor_tables working(state, bits);
  r.work = tables.work;
  r.work += working.work;
  r.series = std::move(working.series);
  r.amplitude = std::move(working.amplitude);
  r.across = ball(1, bits);
  if (!is_equilibrium(r.kind)) {
    const auto power =
        static_cast<long>(std::max(exponent_of(r.amplitude[0]), exponent_of(r.amplitude[1])));
    r.across = scale(r.across, power);
    r.amplitude[0] = scale(r.amplitude[0], -power);
    r.amplitude[1] = scale(r.amplitude[1], -power);
  }
  r.size = std::move(working.size);
  for (std::size_t i = 0; i < 3; ++i) r.moments[i] = state.tensor().moments()[i].at(bits);

  const moment<ball> start = reduced(r.rates, r.kind, 0, bits);
  const theta_point<ball> at = r.point<true>(start.cycle);
  r.phase_0 = scale(pi(bits), 1) * (start.whole + start.fraction) - angle_of(at.x, at.y);
  const matrix3<ball> turned =
      frame(r.direction_at(at, start.odd), r.across, of_turns(start.fraction), at.x, at.y);
  const matrix3<ball> given = state.attitude(bits);
  for (std::size_t row = 0; row < 3; ++row) {
    const triple<ball> principal = r.in_principal(given[row]);
    for (std::size_t i = 0; i < 3; ++i) r.base[row][i] = dot(principal, turned[i]);
  }
  return r;
}

}  // namespace

bool within(const ball& x, const magnitude& size, precision p) {
  return x.is_bounded() && x.radius() <= scale(size, -p);
}
bool within(const matrix3<ball>& x, precision p) {
  bool good = true;
  for (const auto& row : x) {
    for (const ball& entry : row) good = good && within(entry, magnitude::power_of_two(0), p);
  }
  return good;
}

prepared<ball> prepare_to(const initial_state& state, precision p, precision guard,
                          precision spare) {
  prepared<ball> result = prepare(state, p + guard, spare);
  for (int i = 0; i < most_attempts && !within(result.base, p + 16); ++i) {
    guard *= 4;
    const work_count before = result.work;
    result = prepare(state, p + guard, spare);
    result.work += before;
  }
  return result;
}

}  // namespace polhode::detail
