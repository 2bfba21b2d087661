#pragma once

// Calls of functions that are not this room's (further_function), as nodes of a graph.

#include "graph.hpp"

namespace polhode::detail {

/// The function of the operands, as many as it takes: by its simpler formula where it has one for
/// them. Throws undefined_operation where it is certain that it is not defined there.
[[nodiscard]] node_id call_further(graph& g, const further_function& f,
                                   const std::vector<node_id>& operands);

}  // namespace polhode::detail
