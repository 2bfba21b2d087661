#pragma once

// The rules of this library, each in a file of its own.

#include "polhode/quadrature/rule.hpp"

namespace polhode::detail {

[[nodiscard]] const quadrature_strategy& antiderivative_rule();
[[nodiscard]] const quadrature_strategy& turned_rays_rule();
[[nodiscard]] const quadrature_strategy& taylor_series_rule();
[[nodiscard]] const panel_rule& gauss_legendre_panels();
[[nodiscard]] const quadrature_strategy& double_exponential_rule();
[[nodiscard]] const panel_rule& clenshaw_curtis_panels();
[[nodiscard]] const quadrature_strategy& trapezoid_rule();

}  // namespace polhode::detail
