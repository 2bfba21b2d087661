#pragma once

// How large the integral of |f| is.

#include <vector>

#include "panel.hpp"
#include "segment_values.hpp"

namespace polhode::detail {

/// About log2 of the integral of |f|. To search with: what follows from it proves itself.
[[nodiscard]] double estimated_log2_size(const scaled_segments& of, long& region_evaluations);

/// A lower bound of the integral of |f|, from panels that cover its segments once.
[[nodiscard]] magnitude least_size(const std::vector<segment>& segments,
                                   const std::vector<panel>& panels);

}  // namespace polhode::detail
