#pragma once

#include "arithmetic/ball/ball_access.hpp"

namespace polhode::detail {

/// The hull of the angles of the points (x, y) other than the origin. Hypothesis: there are some.
void angles(ball& result, const end_points& y, const end_points& x, precision p);

}  // namespace polhode::detail
