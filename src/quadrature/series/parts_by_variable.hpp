#pragma once

// The integral of a node over a range, in another variable: as integrals of hyperexponential
// functions of it.

#include <vector>

#include "formula_forms.hpp"

namespace polhode::detail {

struct formula_range {
  const formula_graph& f;
  const end_point& a;  // less than b, as far as is known
  const end_point& b;
  /// What nodes are in x, where the formula has exponential or circular functions of them; else
  /// null.
  const forms* plain = nullptr;
};

using hyperexponential_integrals = std::vector<hyperexponential_integral>;

// Each adds to the result, and returns whether the node is such a sum in its variable; where it is
// not, the result is of no use.

/// y = x, or -x.
bool add_in_argument(const formula_range& of, std::size_t node, hyperexponential_integrals& result);
/// y = e^(slope x + offset), of which the functions in the formula have integer powers.
bool add_in_exponential(const formula_range& of, std::size_t node,
                        hyperexponential_integrals& result);
/// With w = frequency x, and w' from 0 to a quarter of a period: y = sin^2 w'.
bool add_in_sine_squared(const formula_range& of, std::size_t node,
                         hyperexponential_integrals& result);
/// With w' from 0 to half of a period: y = sin^2(w'/2).
bool add_in_sine_of_half(const formula_range& of, std::size_t node,
                         hyperexponential_integrals& result);

/// Adds form times factor over the range, term by term.
void append(hyperexponential_integrals& all, const hyperexponential_sum& form,
            const hyperexponential& factor, const hyperexponential_integral& range);

}  // namespace polhode::detail
