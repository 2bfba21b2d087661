#include "polhode/quadrature/clenshaw_curtis.hpp"
#include "polhode/quadrature/error_bounds.hpp"
#include "polhode/quadrature/gauss_legendre.hpp"
#include "rule_estimates.hpp"
#include "rules.hpp"

namespace polhode::detail {

namespace {

class clenshaw_curtis_on_panels final : public panel_rule {
 public:
  [[nodiscard]] std::string_view name() const override { return "Clenshaw-Curtis"; }
  [[nodiscard]] std::string_view purpose() const override {
    return "on panels, with their ends as nodes";
  }
  /// With the 2n + 1 nodes of its degree 2n it is about as exact as Gauss and Legendre's rule with
  /// n.
  [[nodiscard]] long nodes_for(double rho, double log2_supremum, double log2_goal) const override {
    return 2 * gauss_legendre_degree_at_least(
                   static_cast<long>(estimated_gauss_nodes(rho, log2_supremum, log2_goal))) +
           1;
  }
  [[nodiscard]] magnitude truncation_error(long n, const ball& rho,
                                           const magnitude& supremum) const override {
    return clenshaw_curtis_error(n - 1, rho, supremum);
  }
  [[nodiscard]] std::shared_ptr<const symmetric_nodes> nodes(long n, precision p) const override {
    return std::make_shared<const symmetric_nodes>(
        symmetric_half(clenshaw_curtis_rule<ball>(n - 1, p), p));
  }
  [[nodiscard]] bool has_ends_as_nodes() const override { return true; }
};

}  // namespace

const panel_rule& clenshaw_curtis_panels() {
  static const clenshaw_curtis_on_panels rule;
  return rule;
}

}  // namespace polhode::detail
