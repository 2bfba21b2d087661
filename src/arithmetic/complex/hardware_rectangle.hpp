#pragma once

// Rectangles in the hardware: whether they have left the range of doubles, or may have, and
// products of their parts.

#include <algorithm>
#include <cmath>

#include "polhode/arithmetic/region.hpp"

namespace polhode::detail::regions {

constexpr precision ball_bits = 64;  // of a set that only left the hardware's range

[[nodiscard]] inline bool left_range(const rectangle<double_interval>& z) {
  return z.re.is_out_of_range() || z.im.is_out_of_range();
}

/// One end is 0, and not the other: it is 0, or it underflowed to it.
[[nodiscard]] inline bool ends_at_zero(double_interval x) {
  return (x.lower() == 0) != (x.upper() == 0);
}
[[nodiscard]] inline bool ends_at_zero(const rectangle<double_interval>& z) {
  return ends_at_zero(z.re) || ends_at_zero(z.im);
}
/// What is made of it ends at 0 as a rule: x^2 of [-4, 4] does.
[[nodiscard]] inline bool touches_zero(const rectangle<double_interval>& z) {
  return ends_at_zero(z) || contains_zero(z);
}

/// Every end is 0 or a normal double.
[[nodiscard]] inline bool is_regular(double_interval x) {
  const auto is_kept = [](double end) {
    const double size = std::abs(end);
    return (size >= detail::least_normal_double && size < detail::infinity) || end == 0;
  };
  return is_kept(x.lower()) && is_kept(x.upper());
}
[[nodiscard]] inline bool is_regular(const rectangle<double_interval>& z) {
  return is_regular(z.re) && is_regular(z.im);
}

using hardware_rectangle = rectangle<double_interval>;

/// x * y. Where every end is 0 or far from a double's limits, a product of two of them is 0 only if
/// a factor is.
[[nodiscard]] inline double_interval times(double_interval x, double_interval y) {
  const auto is_plain = [](double end) {
    const double size = std::abs(end);
    return end == 0 || (size >= 0x1p-500 && size <= 0x1p500);
  };
  const double x1 = x.lower();
  const double x2 = x.upper();
  const double y1 = y.lower();
  const double y2 = y.upper();
  if (!is_plain(x1) || !is_plain(x2) || !is_plain(y1) || !is_plain(y2)) return x * y;
  const double low = std::min(std::min(x1 * y1, x1 * y2), std::min(x2 * y1, x2 * y2));
  const double high = std::max(std::max(x1 * y1, x1 * y2), std::max(x2 * y1, x2 * y2));
  return {detail::unchecked{}, low == 0 ? 0 : detail::next_down(low),
          high == 0 ? 0 : detail::next_up(high)};
}

}  // namespace polhode::detail::regions
