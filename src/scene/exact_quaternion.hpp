#pragma once

// The attitude of a scene at time 0, where it is a rational number.

#include <array>
#include <optional>

#include "polhode/scene/scene.hpp"

namespace polhode::detail {

/// sqrt(q) of q >= 0 where it is rational.
[[nodiscard]] std::optional<rational> rational_root(const rational& q);

/// A quaternion's components w, x, y, z, those that are known to be rational; of both signs of the whole, any.
using exact_quaternion = std::array<std::optional<rational>, 4>;

/// That of the attitude with which the motion begins.
[[nodiscard]] exact_quaternion quaternion_at_0(const scene_state& state);

}  // namespace polhode::detail
