#include <algorithm>
#include <cmath>

#include "polhode/quadrature/error_bounds.hpp"
#include "polhode/quadrature/gauss_legendre.hpp"
#include "rule_estimates.hpp"
#include "rules.hpp"

namespace polhode::detail {

namespace {

class gauss_legendre_on_panels final : public panel_rule {
 public:
  [[nodiscard]] std::string_view name() const override { return "Gauss-Legendre"; }
  [[nodiscard]] std::string_view purpose() const override {
    return "on panels; the rule for most integrands";
  }
  [[nodiscard]] bool is_automatic() const override { return true; }
  [[nodiscard]] long nodes_for(double rho, double log2_supremum, double log2_goal) const override {
    return gauss_legendre_degree_at_least(
        static_cast<long>(estimated_gauss_nodes(rho, log2_supremum, log2_goal)));
  }
  [[nodiscard]] magnitude truncation_error(long n, const ball& rho,
                                           const magnitude& supremum) const override {
    return gauss_legendre_error(n, rho, supremum);
  }
  [[nodiscard]] std::shared_ptr<const symmetric_nodes> nodes(long n, precision p) const override {
    return gauss_legendre(n, p);
  }
};

}  // namespace

const panel_rule& gauss_legendre_panels() {
  static const gauss_legendre_on_panels rule;
  return rule;
}

}  // namespace polhode::detail
