// Oscillations over rays on which they decay.

#include <algorithm>

#include "polhode/arithmetic/end_point.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "quadrature/parts/turned.hpp"
#include "quadrature/rules/rules.hpp"

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
    if (insisted) return integrate_over_turned_rays(f, a, b, options);
    if (!turns_often(f, a, b, many)) return std::nullopt;
    auto found = integrate_over_turned_rays(f, a, b, options);
    return found && found->verdict == status::certified ? std::move(found) : std::nullopt;
  }
  /// Whether f turns more often than that where a search by panels would begin.
  static bool turns_often(const integrand& f, const end_point& a, const end_point& b, double many) {
    if (!f.between_turned_rays) return false;
    const bool upward = b.infinite_sign() != 0;
    const end_point& end = upward ? a : b;
    rational from = end.infinite_sign() != 0 ? rational(0) : lower_rational(end.at(64));
    if (upward ? from < 0 : from > 0) from = 0;  // rays begin on one side of 0
    const rational length = std::max(rational(64), abs(from));
    return f.between_turned_rays(upward ? from : from - length, upward ? from + length : from, many)
        .has_value();
  }
  [[nodiscard]] std::string_view need() const override {
    return "turned rays need sines or cosines of polynomials, of polynomials times log(x), or of "
           "exponentials of linear forms";
  }
};

}  // namespace

const quadrature_strategy& turned_rays_rule() {
  static const turned_rays_strategy rule;
  return rule;
}

}  // namespace polhode::detail
