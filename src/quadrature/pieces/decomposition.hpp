#pragma once

// A function near an end as a sum of oscillations, with its constants to as many bits as are asked
// for: what oscillation.hpp needs of waves.hpp.

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "quadrature/formula/arithmetics.hpp"
#include "quadrature/formula/integrand.hpp"
#include "quadrature/pieces/waves.hpp"

namespace polhode::detail::oscillations {

/// u and v of an amplitude W = u + i v, and W, as formulas in the variables of waves.hpp.
struct amplitude_formulas {
  std::optional<expression> re;
  std::optional<expression> im;
  std::optional<expression> whole;  // where one of them is not 0
};

/// One frequency, or none, with the constants to some precision.
class oscillation {
 public:
  oscillation(const amplitude_formulas& w, ball frequency,
              std::vector<possibly_exact_constant> numbers, precision p);

  [[nodiscard]] const ball& frequency() const { return frequency_; }
  /// u and v, where they are not 0, over a series.
  template <class Series>
  [[nodiscard]] std::vector<std::optional<Series>> parts(const Series& y) const {
    std::vector<std::optional<Series>> result;
    for (const auto* part : {&formulas_.re, &formulas_.im}) {
      if (!*part) {
        result.push_back(std::nullopt);
        continue;
      }
      const std::vector<Series> values = arguments(y, y);  // the unit is not in it
      result.push_back(
          (*part)->template evaluator<Series>(precision_)(std::span<const Series>(values)));
    }
    return result;
  }
  /// u(z) + sign i v(z).
  [[nodiscard]] region operator()(const region& z, int sign) const;
  [[nodiscard]] analytic_ball operator()(const analytic_ball& z, int sign) const;
  /// u(y).
  [[nodiscard]] ball real_part(const ball& y) const;

 private:
  template <class T>
  [[nodiscard]] std::vector<T> arguments(const T& y, const T& unit) const {
    std::vector<T> result{y, unit};
    for (const possibly_exact_constant& c : numbers_) result.push_back(constant_beside(y, c));
    return result;
  }
  template <class T>
  [[nodiscard]] T value_of(const std::optional<compiled_expression<T>>& w, const T& z,
                           const T& unit) const {
    if (!w) return constant_beside(z, rational(0));
    const std::vector<T> values = arguments(z, unit);
    return (*w)(std::span<const T>(values));
  }

  amplitude_formulas formulas_;
  ball frequency_;
  std::vector<possibly_exact_constant> numbers_;
  precision precision_;
  std::optional<compiled_expression<ball>> real_over_balls_;
  std::optional<compiled_expression<region>> over_regions_;
  std::optional<compiled_expression<analytic_ball>> over_analytic_balls_;
};

/// f taken apart; safe to be used by several threads.
class decomposition {
 public:
  /// f between x = p + s and p, or an infinity. The power theta of y is found: x = p + s y^theta.
  decomposition(const integrand& f, const end_point& p, const end_point& s, bool infinite,
                int sign);

  /// It is a sum of oscillations, with frequencies that are certainly not 0.
  [[nodiscard]] bool is_found() const { return found_; }
  [[nodiscard]] const rational& theta() const { return theta_; }
  [[nodiscard]] bool has_steady_part() const { return steady_.has_value(); }
  /// Of positive frequencies.
  [[nodiscard]] std::size_t count() const { return waves_.size(); }
  /// Number k; or, for k = count(), the steady part.
  [[nodiscard]] std::shared_ptr<const oscillation> at(std::size_t k, precision p) const;

 private:
  struct wave_of_frequency {
    expression frequency;
    amplitude_formulas amplitude;
  };
  void choose(const separated& parts);
  [[nodiscard]] std::vector<possibly_exact_constant> numbers_at(precision p) const;
  [[nodiscard]] std::vector<std::shared_ptr<const oscillation>> make(precision p) const;

  rational theta_;
  bool found_ = false;
  std::vector<std::function<possibly_exact_constant(precision)>> numbers_;
  std::vector<wave_of_frequency> waves_;
  std::optional<amplitude_formulas> steady_;
  mutable std::mutex mutex_;
  mutable std::map<precision, std::vector<std::shared_ptr<const oscillation>>> made_;
};

}  // namespace polhode::detail::oscillations
