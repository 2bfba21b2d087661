#pragma once

#include "quadrature/formula/integrand.hpp"

namespace polhode::detail {

/// The integral from a to b, a < b, by options.rule on panels; automatic stands for Gauss and
/// Legendre's rule, and the trapezoidal rule where it takes fewer nodes. The range is cut where the
/// function asks for it.
[[nodiscard]] integral integrate_on_panels(const integrand& f, const end_point& a,
                                           const end_point& b, const integrate_options& options);

}  // namespace polhode::detail
