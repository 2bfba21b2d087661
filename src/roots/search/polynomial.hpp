#pragma once

#include <functional>

#include "state.hpp"

namespace polhode::detail {

/// Finds all roots of the polynomial factor that is the problem of that number, and settles its
/// range. Returns false, and changes nothing, where go_on returned false; it is called with the
/// steps done.
bool settle_polynomial(root_search::state& s, std::size_t problem,
                       const std::function<bool(long)>& go_on);

}  // namespace polhode::detail
