#pragma once

#include "state.hpp"

namespace polhode::detail {

/// Examines boxes until none is left, or a limit is reached, and keeps in s what was found.
void search(root_search::state& s, const isolate_options& options);

}  // namespace polhode::detail
