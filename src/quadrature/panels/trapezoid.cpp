#include "quadrature/panels/integrate_on_panels.hpp"
#include "quadrature/rules/rules.hpp"

namespace polhode::detail {

namespace {

/// Over a whole segment; the planner takes it by itself where it needs fewer nodes (plan_segment in
/// plan.cpp).
class trapezoid_on_circles final : public quadrature_strategy {
 public:
  [[nodiscard]] std::string_view name() const override { return "trapezoid"; }
  [[nodiscard]] std::string_view purpose() const override {
    return "where periodic, or even about both limits";
  }
  [[nodiscard]] std::optional<integral> attempt(const integrand& f, const end_point& a,
                                                const end_point& b,
                                                const integrate_options& options) const override {
    return integrate_on_panels(f, a, b, options);
  }
};

}  // namespace

const quadrature_strategy& trapezoid_rule() {
  static const trapezoid_on_circles rule;
  return rule;
}

}  // namespace polhode::detail
