#pragma once

// Functions that are periodic, or even about both ends of a range: the strip in which they are
// analytic, and the nodes that the trapezoidal rule takes then (mean_trapezoid_error in
// error_bounds.hpp).

#include <optional>

#include "quadrature/formula/integrand.hpp"

namespace polhode::detail {

/// F is analytic where mean_trapezoid_error asks for it with H = half_width, and bounded there by
/// the supremum.
struct periodic_strip {
  double half_width = 0;
  magnitude supremum;
  double nodes = 0;  // for the goal it was looked for with
};

/// An upper bound of |F| on Im t = h, 0 <= Re t <= 1, from so many pieces.
[[nodiscard]] magnitude supremum_along(const segment& s, double h, long pieces, long& evaluations);

/// About how many nodes such a strip takes for an error of the mean of F of 2^log2_goal.
[[nodiscard]] double nodes_in_strip(double half_width, const magnitude& supremum, double log2_goal);

/// The strip of a segment with equidistant points that takes the fewest nodes of those tried;
/// nothing where none was proved that takes less than most_nodes. The search is heuristic; what is
/// said of the strip is proved.
[[nodiscard]] std::optional<periodic_strip> find_strip(const segment& s, double log2_goal,
                                                       double most_nodes, long& evaluations);

}  // namespace polhode::detail
