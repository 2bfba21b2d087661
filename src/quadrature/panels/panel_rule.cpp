#include "polhode/quadrature/rule.hpp"
#include "quadrature/formula/integrand.hpp"
#include "quadrature/panels/integrate_on_panels.hpp"

namespace polhode {

std::optional<integral> panel_rule::attempt(const detail::integrand& f, const end_point& a,
                                            const end_point& b,
                                            const integrate_options& options) const {
  return detail::integrate_on_panels(f, a, b, options);
}

}  // namespace polhode
