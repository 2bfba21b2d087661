#pragma once

// The motion in time of a scene's body.

#include <functional>

#include "scene/effect_context.hpp"

namespace polhode::detail {

/// Checks that a result's table has one row for each of the times, in their order, and throws
/// std::logic_error where it has not. Where a number's radius is more than 10^-digits of its own
/// size or of its column's scale, makes the result not certified, and says where; `scales` are
/// those of the columns from the second on. Of tables of doubles only the rows are checked.
void check_rows(effect_result& result, const scene_time& time,
                const std::vector<magnitude>& scales);

/// The work done. Calls back with what is conserved, less its value at time 0, at about 1, 10 and
/// 100 I_y/J, computed with p bits.
[[nodiscard]] work_count audit_motion(
    const effect_context& x, precision p,
    const std::function<void(const std::string&, const ball&)>& expect_zero);

}  // namespace polhode::detail
