#pragma once

// Which quarter turns a wide argument of a circular function passes: there sine and cosine turn,
// and the tangent has its poles.

#include <mpfr.h>

#include "arithmetic/ball/ball_access.hpp"
#include "polhode/arithmetic/ball.hpp"

namespace polhode::detail::elementary {

/// Whether x has so great an exponent that pi would be needed to more than a million bits.
[[nodiscard]] bool too_large_to_reduce(mpfr_srcptr x, precision p);

/// The multiples j of pi/2 inside (lower, upper], by their residues modulo 4.
struct quarter_turns {
  bool passed[4] = {false, false, false, false};
  bool whole_circle = false;
};

/// Of a set, for arguments in radians.
[[nodiscard]] quarter_turns turns_inside(const end_points& x, precision p);

/// The same for arguments counted in half circles: quarter turns lie at multiples of 1/2.
[[nodiscard]] quarter_turns turns_of_half_circles(const end_points& x);

}  // namespace polhode::detail::elementary
