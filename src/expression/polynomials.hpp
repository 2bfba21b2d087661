#pragma once

// Polynomials of a number and a degree, as nodes of a formula. Each function throws
// undefined_operation where the degree is no whole number from 0 to 1000.

#include <vector>

#include "graph.hpp"

namespace polhode::detail {

/// x(x - 1)...(x - k + 1)/k! of {x, k}.
[[nodiscard]] node_id binomial_of(graph& g, const std::vector<node_id>& x);

// The orthogonal polynomials of {n, x} in the standardization of DLMF 18.3.1.
[[nodiscard]] node_id chebyshev_t(graph& g, const std::vector<node_id>& x);
[[nodiscard]] node_id chebyshev_u(graph& g, const std::vector<node_id>& x);
[[nodiscard]] node_id legendre_p(graph& g, const std::vector<node_id>& x);
[[nodiscard]] node_id hermite_h(graph& g, const std::vector<node_id>& x);
[[nodiscard]] node_id laguerre_l(graph& g, const std::vector<node_id>& x);

}  // namespace polhode::detail
