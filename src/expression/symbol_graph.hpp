#pragma once

// Symbols as nodes of a graph.

#include "graph.hpp"
#include "polhode/expression/symbol.hpp"

namespace polhode::detail {

/// The node of a symbol's formula, made with the same simplifications as that of a text. Throws input_error where an operation in it is not
/// defined, and where it has a variable beyond the first `variables`.
[[nodiscard]] node_id node_of(graph& g, const symbol& formula, std::size_t variables);

}  // namespace polhode::detail
