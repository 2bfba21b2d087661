#pragma once

// A function near an end as a sum of oscillations, with its constants to as many bits as are asked
// for: what oscillation.hpp needs of waves.hpp.

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "polhode/expression/wave_amplitudes.hpp"
#include "quadrature/formula/arithmetics.hpp"
#include "quadrature/formula/integrand.hpp"
#include "quadrature/pieces/waves.hpp"

namespace polhode::detail::oscillations {

/// P and Q at slope y + shift.
struct known_amplitudes;
[[nodiscard]] wave_amplitudes<region> amplitudes_at(const known_amplitudes& a, const region& y);
[[nodiscard]] wave_amplitudes<analytic_ball> amplitudes_at(const known_amplitudes& a,
                                                           const analytic_ball& y);
[[nodiscard]] wave_amplitudes<ball> amplitudes_at(const known_amplitudes& a, const ball& y);
/// For y = c t^-1 with c > 0, Re t >= 0: bounds only, a power of y times a number.
[[nodiscard]] wave_amplitudes<end_series> amplitudes_at(const known_amplitudes& a,
                                                        const end_series& y);
[[nodiscard]] wave_amplitudes<tail_series> amplitudes_at(const known_amplitudes& a,
                                                         const tail_series& y);
[[nodiscard]] wave_amplitudes<growth_bound> amplitudes_at(const known_amplitudes& a,
                                                          const growth_bound& y);

/// u and v of an amplitude W = u + i v, and W, as formulas in the variables of waves.hpp.
struct amplitude_formulas {
  std::optional<expression> re;
  std::optional<expression> im;
  std::optional<expression> whole;  // where one of them is not 0
};

/// Those of functions that oscillate, with the constants to some precision: slope > 0, shift >= 0.
struct known_amplitudes {
  std::size_t variable;
  wave_function of;
  ball slope;
  ball shift;
};

/// The values of the variables of waves.hpp but y and i.
struct variable_values {
  std::vector<possibly_exact_constant> numbers;  // 0 in the place of amplitudes
  std::vector<known_amplitudes> amplitudes;
};

/// One frequency, or none, with the constants to some precision.
class oscillation {
 public:
  oscillation(const amplitude_formulas& w, ball frequency, variable_values values, precision p);

  [[nodiscard]] const ball& frequency() const { return frequency_; }
  /// The series of parts() are bounds, not what W is.
  [[nodiscard]] bool has_bounds_only() const { return !values_.amplitudes.empty(); }
  /// Of the arguments of amplitudes; infinite where there are none.
  [[nodiscard]] double least_slope_of_amplitudes() const;
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
    for (const possibly_exact_constant& c : values_.numbers) {
      result.push_back(constant_beside(y, c));
    }
    for (const known_amplitudes& a : values_.amplitudes) {
      const wave_amplitudes<T> at = amplitudes_at(a, y);
      result[a.variable] = at.p;
      result[a.variable + 1] = at.q;
    }
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
  variable_values values_;
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
  [[nodiscard]] variable_values values_at(precision p) const;
  [[nodiscard]] std::vector<std::shared_ptr<const oscillation>> make(precision p) const;

  rational theta_;
  bool found_ = false;
  std::vector<std::function<possibly_exact_constant(precision)>> numbers_;
  struct amplitudes_of_constants {
    std::size_t variable;
    wave_function of;
    expression slope;
    expression shift;
  };
  std::vector<amplitudes_of_constants> amplitudes_;
  std::vector<wave_of_frequency> waves_;
  std::optional<amplitude_formulas> steady_;
  mutable std::mutex mutex_;
  mutable std::map<precision, std::vector<std::shared_ptr<const oscillation>>> made_;
};

}  // namespace polhode::detail::oscillations
