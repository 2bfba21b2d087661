#include "quadrature/series/taylor_series.hpp"

#include "rules.hpp"

namespace polhode::detail {

namespace {

class taylor_series final : public quadrature_strategy {
 public:
  [[nodiscard]] std::string_view name() const override { return "Taylor series"; }
  [[nodiscard]] std::string_view purpose() const override {
    return "for sums of hyperexponential functions";
  }
  [[nodiscard]] bool is_automatic() const override { return true; }
  [[nodiscard]] std::optional<integral> attempt(const integrand& f, const end_point& a,
                                                const end_point& b,
                                                const integrate_options& options) const override {
    return integrate_by_taylor_series(f, a, b, options);
  }
  [[nodiscard]] std::string_view need() const override {
    return "Taylor series need a sum of hyperexponential functions of x, e^(k x) or sin^2 (k x)";
  }
};

}  // namespace

const quadrature_strategy& taylor_series_rule() {
  static const taylor_series rule;
  return rule;
}

}  // namespace polhode::detail
