#pragma once

// Roots near the jumps of floor, ceil and sign.

#include <optional>

#include "exact_points.hpp"
#include "polhode/expression/expression.hpp"

namespace polhode::detail {

/// What is proved of a set x: that it has no root, that it has one alone, or neither.
struct jump_report {
  bool has_no_root = false;
  std::optional<pi_combination> only_root;
  long evaluations = 0;
};

/// The roots of f in x, where each floor and ceil of f has one of few values on x. f with these
/// values in their places has no root in x, or none on either side of a point of the box at which
/// f is known exactly. Nothing is reported of a function without steps.
[[nodiscard]] jump_report examine_jumps(const expression& f, const exact_box& box, const ball& x,
                                        precision bits);

}  // namespace polhode::detail
