#include "insisted_double_exponential.hpp"
#include "rules.hpp"

namespace polhode::detail {

namespace {

class double_exponential final : public quadrature_strategy {
 public:
  [[nodiscard]] std::string_view name() const override { return "double exponential"; }
  [[nodiscard]] std::string_view purpose() const override {
    return "tanh-sinh, between rational limits";
  }
  [[nodiscard]] std::optional<integral> attempt(const integrand& f, const end_point& a,
                                                const end_point& b,
                                                const integrate_options& options) const override {
    return integrate_by_double_exponential(f, a, b, options);
  }
};

}  // namespace

const quadrature_strategy& double_exponential_rule() {
  static const double_exponential rule;
  return rule;
}

}  // namespace polhode::detail
