// Oscillations over rays on which they decay.

#include "polhode/arithmetic/end_point.hpp"
#include "quadrature/turned.hpp"
#include "rules.hpp"

namespace polhode::detail {

namespace {

class turned_rays_strategy final : public quadrature_strategy {
 public:
  [[nodiscard]] std::string_view name() const override { return "turned rays"; }
  [[nodiscard]] std::string_view purpose() const override {
    return "for sines and cosines of polynomials or exponentials that turn often";
  }
  [[nodiscard]] bool is_automatic() const override { return true; }
  /// Unless it is asked for, only over a range in which panels would be many; what oscillates as a
  /// polynomial up to infinity is tried by panels first (integrate_function).
  [[nodiscard]] std::optional<integral> attempt(const integrand& f, const end_point& a,
                                                const end_point& b,
                                                const integrate_options& options) const override {
    constexpr double many = 1000;
    const bool insisted = !options.rule.is_automatic();
    const bool infinite = a.infinite_sign() != 0 || b.infinite_sign() != 0;
    const double least_turns = insisted ? 0 : many;
    if (!infinite) {
      if (auto found = integrate_between_turned_rays(f, a, b, least_turns, options)) return found;
      return integrate_by_exponential(f, a, b, least_turns, options);
    }
    if (auto found = integrate_by_exponential(f, a, b, least_turns, options)) return found;
    return insisted ? integrate_over_turned_rays(f, a, b, options) : std::nullopt;
  }
  [[nodiscard]] std::string_view need() const override {
    return "turned rays need sines or cosines of polynomials, or of exponentials of linear forms";
  }
};

}  // namespace

const quadrature_strategy& turned_rays_rule() {
  static const turned_rays_strategy rule;
  return rule;
}

}  // namespace polhode::detail
