#pragma once

// The attitude of a scene at time 0, where it is a rational number.

#include <array>
#include <optional>

#include "polhode/scene/scene.hpp"

namespace polhode::detail {

/// A quaternion's components w, x, y, z, those that are known to be rational; of both signs of the
/// whole, any.
using exact_quaternion = std::array<std::optional<rational>, 4>;

/// That of the attitude with which the motion begins.
[[nodiscard]] exact_quaternion quaternion_at_0(const scene_state& state);

/// A rotation by its quaternion w, x, y, z, and the square of its distance from a matrix in the
/// Frobenius norm.
struct projected_rotation {
  std::array<rational, 4> quaternion;
  rational squared_distance;
};

/// The rotation nearest to a matrix, its orthogonal polar factor (N. J. Higham, SIAM J. Sci. Stat.
/// Comput. 7, 1986), but for some 2^-120: a rational rotation beside it, whose distance is exact.
/// Throws input_error where Newton's iteration does not find it.
[[nodiscard]] projected_rotation nearest_rotation(const matrix3<rational>& rows);

}  // namespace polhode::detail
