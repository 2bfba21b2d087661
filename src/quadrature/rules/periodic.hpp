#pragma once

// Periodic functions, and functions that are even about both ends of a range, which are so: their
// symmetry, and the trapezoidal rule that it makes fast (mean_trapezoid_error in error_bounds.hpp).

#include <optional>

#include "quadrature/integrand.hpp"

namespace polhode::detail {

/// A part [a, b] of a range whose 2^log2_copies copies have the integral over the whole range, and
/// of which f has the symmetry that the rule needs: even about a and about b, or of period b - a.
struct fundamental_range {
  pi_combination a;
  pi_combination b;
  long log2_copies = 0;
};

/// Nothing where no symmetry was found. The limits must be known as q + r pi.
[[nodiscard]] std::optional<fundamental_range> fundamental_range_of(const integrand& f,
                                                                    const end_point& a,
                                                                    const end_point& b);

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
