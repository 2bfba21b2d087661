#pragma once

// The arithmetics in which quadrature evaluates formulas, beside those of expression.hpp.

#include "polhode/arithmetic/analytic_ball.hpp"
#include "polhode/expression/expression.hpp"
#include "quadrature/ends/end_series.hpp"
#include "quadrature/ends/growth_bound.hpp"
#include "quadrature/ends/tail_series.hpp"
#include "quadrature/formula/angle.hpp"
#include "quadrature/formula/formula_graph.hpp"
#include "quadrature/formula/symmetry.hpp"

namespace polhode {

extern template class compiled_expression<jet<region, 1>>;
extern template class compiled_expression<analytic_ball>;
extern template class compiled_expression<angle>;
extern template class compiled_expression<symmetry>;
extern template class compiled_expression<end_series>;
extern template class compiled_expression<growth_bound>;
extern template class compiled_expression<tail_series>;

namespace detail {

/// Whether analytic balls have the function.
[[nodiscard]] bool is_known_over_analytic_balls(operation what);

}  // namespace detail

}  // namespace polhode
