#pragma once

// The two forms of a ball, by midpoint and radius or by its end points, for the files that make
// balls.

#include <algorithm>

#include "arithmetic/ball/ball_access.hpp"

namespace polhode::detail {

[[nodiscard]] inline precision common_precision(const ball& x, const ball& y) {
  return std::max(x.precision(), y.precision());
}

[[nodiscard]] inline bool both_by_midpoint(const ball& x, const ball& y) {
  return ball_access::is_midpoint_radius(x) && ball_access::is_midpoint_radius(y);
}

/// |m - n| of two midpoints, rounded up to 64 bits, which is cheaper than ends of all bits and
/// often decides. Infinite where one of the balls has no midpoint.
[[nodiscard]] magnitude distance_of_midpoints(const ball& x, const ball& y);
/// Whether x contains y, where that distance shows it.
[[nodiscard]] bool contains_by_midpoints(const ball& x, const ball& y);

/// The middle of two finite numbers, low <= high; between them where r has no fewer bits than they.
void set_middle(mpfr_ptr r, mpfr_srcptr low, mpfr_srcptr high);

/// r = x + direction * radius, rounded in that direction.
void shifted_by_radius(mpfr_ptr r, mpfr_srcptr x, const magnitude& radius, int direction);

}  // namespace polhode::detail
