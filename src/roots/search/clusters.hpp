#pragma once

// Boxes that stay open and lie beside each other, taken together.

#include <vector>

#include "state.hpp"

namespace polhode::detail {

/// Neighbours become one cluster, where no root that is known lies between them.
[[nodiscard]] std::vector<work_box> joined(std::vector<work_box> boxes,
                                           const std::vector<found_root>& found);

/// The boxes that each cluster, made by `joined`, has in it. Proves that every box is in one.
[[nodiscard]] std::vector<std::vector<const exact_box*>> parts_of(
    const std::vector<work_box>& clusters, const std::vector<work_box>& boxes);

}  // namespace polhode::detail
