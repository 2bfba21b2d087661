#pragma once

// That the pieces of a path join, and that what is integrated over a piece runs from the piece's
// start to its end: checked in one place, by what assembles the integral, whatever made the pieces.

#include <optional>
#include <string>

#include "polhode/quadrature/contour.hpp"
#include "quadrature/formula/integrand.hpp"

namespace polhode::detail {

/// Where pieces do not join: the first gap, in words; nothing where there is none as far as p bits
/// tell.
[[nodiscard]] std::optional<std::string> gap_between(const std::vector<path_piece>& pieces,
                                                     precision p);

/// Whether s.along starts and ends where the piece does, as far as p bits tell; and for a line,
/// whether dz/dt is the difference.
[[nodiscard]] bool runs_over(const segment& s, const path_piece& piece, precision p);

/// What is in the way of F near an end of the segment, and where.
struct obstacle_near_end {
  obstacle why = obstacle::none;
  std::string where;
  complex_ball position;
};

/// Looks for what is not analytic within 2^-8 of an end of a segment along a path, but for the end
/// itself. There F over an interval of t is asked for: on one that reaches to the end its range may
/// count though F is not analytic there, and the end must be the only point at which it is not.
/// Intervals are halved down to 2^-deepest. Adds what it asked to `evaluations`.
[[nodiscard]] std::optional<obstacle_near_end> obstacle_near_ends(const segment& s, long deepest,
                                                                  long& evaluations);

}  // namespace polhode::detail
