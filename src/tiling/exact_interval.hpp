#pragma once

// Intervals with exact ends: parts of a range that are cut and put together again.

#include <optional>

#include "polhode/arithmetic/ball.hpp"
#include "polhode/arithmetic/exact.hpp"

namespace polhode::detail {

/// A closed interval whose ends are exact, or infinite where there is none.
struct exact_interval {
  std::optional<rational> lower;
  std::optional<rational> upper;

  [[nodiscard]] bool is_bounded() const { return lower && upper; }
  [[nodiscard]] bool is_point() const { return is_bounded() && *lower == *upper; }
  /// Hypothesis of these two: it is bounded.
  [[nodiscard]] rational width() const { return *upper - *lower; }
  [[nodiscard]] rational middle() const { return (*lower + *upper) / 2; }
  [[nodiscard]] bool contains(const rational& q) const {
    return (!lower || *lower <= q) && (!upper || q <= *upper);
  }
  /// The interval, its ends rounded outward.
  [[nodiscard]] ball to_ball(precision p) const;

  bool operator==(const exact_interval&) const = default;
};

/// x begins before y: its lower end is less.
[[nodiscard]] bool precedes(const exact_interval& x, const exact_interval& y);
/// x ends before y: its upper end is less.
[[nodiscard]] bool ends_before(const exact_interval& x, const exact_interval& y);
/// Every member of y is one of x. Exact; false where x is undefined.
[[nodiscard]] bool holds(const exact_interval& x, const exact_interval& y);
[[nodiscard]] bool holds(const ball& x, const exact_interval& y);

}  // namespace polhode::detail
