#pragma once

// The ends of the interval that is searched.

#include <optional>

#include "polhode/roots/isolate.hpp"
#include "roots/settled_pieces.hpp"

namespace polhode::detail {

/// An interval with rational ends, or none, around the one from lower to upper. Throws input_error
/// where an end is not defined, or they are the wrong way round.
[[nodiscard]] exact_interval range_around(const end_point& lower, const end_point& upper);

enum class side { inside, outside, undecided };

/// On which side of the lower (or upper) end of the interval the root of the region lies; the
/// region's copy is made as sharp as that takes.
[[nodiscard]] side side_of(const root_region& given, const end_point& end, bool is_lower,
                           const real_function& f, root_region& sharper);

}  // namespace polhode::detail
