// The difference of an antiderivative at the ends, or the closed form of one over a half-line.

#include <chrono>

#include "polhode/arithmetic/end_point.hpp"
#include "polhode/arithmetic/text.hpp"
#include "quadrature/formula/integrand.hpp"
#include "rules.hpp"

namespace polhode::detail {

namespace {

class antiderivative final : public quadrature_strategy {
 public:
  [[nodiscard]] std::string_view name() const override { return "antiderivative"; }
  [[nodiscard]] std::string_view purpose() const override {
    return "for sums of x^n exp(k x), x^n sin(k x), x^n cos(k x), from 0 to infinity also with "
           "n < 0, and of x^k log(x)^n";
  }
  [[nodiscard]] bool is_automatic() const override { return true; }
  /// With so many bits that what F(b) and F(a) have in common does not matter; nothing where that
  /// takes too many, as where the integral is 0.
  [[nodiscard]] std::optional<integral> attempt(const integrand& f, const end_point& a,
                                                const end_point& b,
                                                const integrate_options& options) const override {
    if (!f.antiderivative) return std::nullopt;
    const auto start = std::chrono::steady_clock::now();
    const auto difference = f.antiderivative(a, b);
    if (!difference) return std::nullopt;
    const precision wanted = bits_for_digits(options.digits) + 32;
    const precision most = options.most_precision.value_or(16 * wanted + 1024);
    for (precision p = wanted; p <= most; p *= 2) {
      const ball value = difference(p);
      if (!options.goal().is_met_by(value)) continue;
      integral result;
      result.enclosure = value;
      result.verdict = status::certified;
      result.account.rules = {quadrature_rule::antiderivative};
      result.account.precision = p;
      const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
      result.account.seconds_for_sums = seconds.count();
      return result;
    }
    return std::nullopt;
  }
  [[nodiscard]] std::string_view need() const override {
    return "an antiderivative needs x^n exp(k x), x^n sin(k x) or x^n cos(k x) and a finite range "
           "or one from 0 to infinity, or x^k log(x)^n and x >= 0";
  }
};

}  // namespace

const quadrature_strategy& antiderivative_rule() {
  static const antiderivative rule;
  return rule;
}

}  // namespace polhode::detail
