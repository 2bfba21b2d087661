#pragma once

// Symbols as graphs.

#include <span>

#include "graph.hpp"
#include "polhode/expression/symbol.hpp"

namespace polhode::detail {

/// A symbol's formula, made with the same simplifications as that of a text. Throws input_error
/// where an operation in it is not defined, and for a variable that has no name; the imaginary
/// unit's is i.
[[nodiscard]] graph graph_of(const symbol& formula, const expression_names& names);

/// The symbol of a graph with symbols in the places of its variables. Functions beyond the table
/// must live as long as the program, as symbol::call says.
[[nodiscard]] symbol symbol_of(const graph& g, std::span<const symbol> variables);

/// Whether the imaginary unit is in it.
[[nodiscard]] bool has_imaginary_unit(const symbol& formula);

}  // namespace polhode::detail
