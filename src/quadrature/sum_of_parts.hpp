#pragma once

// An integral as a sum of others.

#include <optional>
#include <vector>

#include "polhode/quadrature/integrate.hpp"

namespace polhode::detail {

/// sign times the integral of f over [lower, upper].
struct part {
  integrand f;
  end_point lower;
  end_point upper;
  int sign = 1;
};

/// A rational number that is at least side * x, as near as its bits allow.
[[nodiscard]] rational bound_beyond(const end_point& x, int side);

/// The sum of the parts and of a number of at most `rest` in size, first to few digits for its
/// size, then to what it needs. Returns nullopt where a part has no enclosure, or the goal is not
/// met with twice the digits.
[[nodiscard]] std::optional<integral> sum_to_goal(const std::vector<part>& parts,
                                                  const integrate_options& options,
                                                  const magnitude& rest = {});

}  // namespace polhode::detail
