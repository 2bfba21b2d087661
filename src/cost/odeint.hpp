#pragma once

// The free rotation by Boost.odeint, to be measured beside the closed form.

#include <array>

#include "polhode/rigid_body/rotor.hpp"

namespace polhode::cost {

/// Momentum in the body axes, and the attitude's quaternion w, x, y, z, which is 1 at time 0.
struct integrated_rotation {
  triple<double> momentum;
  std::array<double, 4> quaternion;

  /// By rows.
  [[nodiscard]] matrix3<double> matrix() const;
};

/// By dopri5 with step size control, from time 0 to t, with that relative and absolute tolerance:
/// what one who simulates a free body writes. Hypothesis: the body axes are principal axes.
[[nodiscard]] integrated_rotation rotation_by_dopri5(const initial_state& start, double t,
                                                     double tolerance);

}  // namespace polhode::cost
