#pragma once

// The value of a formula without variables where formal rules show that it is a rational number.

#include <optional>
#include <vector>

#include "graph.hpp"

namespace polhode::detail {

/// The values of a program's instructions without variables, in their order, with p bits.
[[nodiscard]] std::vector<ball> values_of_constants(const program& f, precision p);

/// The rational number that the root is, where the rules of exact_number.hpp show it; f is what g
/// is compiled to. None where they do not, in a time that is bounded but for one evaluation with
/// exact_field::bits.
[[nodiscard]] std::optional<rational> rational_value(const graph& g, const program& f);

/// The same for a node without variables, and its value with p bits.
[[nodiscard]] std::optional<rational> rational_value_at(const graph& g, node_id i);
[[nodiscard]] ball value_at(const graph& g, node_id i, precision p);
/// The value at a great x of a node of a formula of one variable, to see where it tends to: at
/// 2^20, or where that is no number, as of exp(x^2)/exp(x), at less.
[[nodiscard]] ball value_far_out(graph& g, node_id i);

}  // namespace polhode::detail
