#pragma once

// The motion in time of a scene's body.

#include <functional>

#include "scene/effect_context.hpp"

namespace polhode::detail {

/// J_x^2, J_y^2, J_z^2 over J^2.
[[nodiscard]] rational_vector direction_squares(const scene& what);

/// Calls back with what is conserved, less its value at time 0, at about 1, 10 and 100 I_y/J, computed with p bits.
void audit_motion(const effect_context& x, precision p,
                  const std::function<void(const std::string&, const ball&)>& expect_zero);

}  // namespace polhode::detail
