#include "decomposition.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace polhode::detail::oscillations {

namespace {

constexpr precision least_bits = 192;

/// A formula in the variables of waves.hpp.
expression formula_in(const symbol& f, std::size_t numbers) {
  expression_names names{{"y", "i"}, {}};
  for (std::size_t k = 0; k < numbers; ++k) names.variables.push_back(fmt::format("c{}", k));
  return expression(f, names);
}

amplitude_formulas formulas_of(const amplitude& w, std::size_t numbers) {
  amplitude_formulas result;
  std::optional<symbol> whole = w.re;
  if (w.im) {
    const symbol imaginary = symbol::variable(variable_unit) * *w.im;
    whole = whole ? *whole + imaginary : imaginary;
    result.im = formula_in(*w.im, numbers);
  }
  if (w.re) result.re = formula_in(*w.re, numbers);
  if (whole) result.whole = formula_in(*whole, numbers);
  return result;
}

symbol symbol_of(const frequency& w, const std::map<std::string, symbol>& constants) {
  symbol sum = 0;
  for (const auto& [name, q] : w) sum += name.empty() ? symbol(q) : constants.at(name) * q;
  return sum;
}

/// Of a constant.
ball value_of(const expression& w, const std::vector<possibly_exact_constant>& numbers,
              precision p) {
  std::vector<ball> values(first_number, ball(1, p));  // it depends on none of these
  for (const possibly_exact_constant& c : numbers) {
    values.push_back(constant_beside(values.front(), c));
  }
  return w.evaluator<ball>(p)(std::span<const ball>(values));
}

}  // namespace

namespace {

/// slope y + shift over a type T.
template <class T>
T argument_of(const known_amplitudes& a, const T& y) {
  return y * value_as<T>(a.slope, y) + value_as<T>(a.shift, y);
}

constexpr const char* name_of_amplitudes = "a function that oscillates";

/// A function of y of at most that size, for slope y + shift with shift >= 0, where `inverse` is
/// 1/y and at most `greatest`: |slope y + shift| >= slope |y|.
template <class Series, class Bounded>
wave_amplitudes<Series> bounds_over(const known_amplitudes& a, const Series& inverse,
                                    const ball& greatest, const Bounded& bounded) {
  const wave_amplitudes<amplitude_bound> bounds =
      bounds_of_wave_amplitudes(a.of, a.slope / greatest);
  const auto over = [&](const amplitude_bound& bound) {
    const ball size =
        ball(0, least_bits).enlarged(bound.factor) / pow(a.slope, ball(bound.exponent, least_bits));
    return pow(inverse, inverse.constant_like(bound.exponent)) * bounded(size);
  };
  return {over(bounds.p), over(bounds.q)};
}

/// For real y > 0.
template <class Series>
wave_amplitudes<Series> bounds_for_reals(const known_amplitudes& a, const Series& y) {
  const Series inverse = y.constant_like(rational(1)) / y;
  const ball values = inverse.values();  // of 1/y
  if (!values.is_bounded()) {
    const Series none = inverse.bounded_like(name_of_amplitudes, values);
    return {none, none};
  }
  const ball greatest(upper_rational(values), least_bits);
  return bounds_over(a, inverse, greatest, [&](const ball& size) {
    return inverse.bounded_like(name_of_amplitudes, size);
  });
}

}  // namespace

wave_amplitudes<region> amplitudes_at(const known_amplitudes& a, const region& y) {
  return wave_amplitudes_at(a.of, argument_of(a, y));
}

wave_amplitudes<analytic_ball> amplitudes_at(const known_amplitudes& a, const analytic_ball& y) {
  const auto [p, q] = wave_amplitudes_at(a.of, argument_of(a, y).value());
  return {analytic_ball(p), analytic_ball(q)};
}

wave_amplitudes<ball> amplitudes_at(const known_amplitudes& a, const ball& y) {
  const auto [p, q] = wave_amplitudes_at(a.of, complex_ball(argument_of(a, y)));
  return {p.re, q.re};
}

// A bound of a function of t at some t is a bound of that function with the constant P y^e of this
// t.
wave_amplitudes<end_series> amplitudes_at(const known_amplitudes& a, const end_series& y) {
  const end_series inverse = 1 / y;
  const double greatest = inverse.real_range().upper();  // of 1/y = |t|/c
  if (inverse.is_blocked() || !(greatest > 0)) {
    const end_series none = end_series::blocked(name_of_amplitudes);
    return {none, none};
  }
  return bounds_over(a, inverse, ball::exactly(greatest, 64), [&](const ball& size) {
    return inverse.bounded_like(size.magnitude_upper());
  });
}

wave_amplitudes<tail_series> amplitudes_at(const known_amplitudes& a, const tail_series& y) {
  return bounds_for_reals(a, y);
}
wave_amplitudes<growth_bound> amplitudes_at(const known_amplitudes& a, const growth_bound& y) {
  return bounds_for_reals(a, y);
}

oscillation::oscillation(const amplitude_formulas& w, ball frequency, variable_values values,
                         precision p)
    : formulas_(w), frequency_(std::move(frequency)), values_(std::move(values)), precision_(p) {
  if (w.re) real_over_balls_ = w.re->evaluator<ball>(p);
  if (!w.whole) return;
  over_regions_ = w.whole->evaluator<region>(p);
  over_analytic_balls_ = w.whole->evaluator<analytic_ball>(p);
}

double oscillation::least_slope_of_amplitudes() const {
  double least = HUGE_VAL;
  for (const known_amplitudes& a : values_.amplitudes) {
    least = std::min(least, double_interval::from_ball(a.slope).lower());
  }
  return least;
}

region oscillation::operator()(const region& z, int sign) const {
  const region unit = times_i(constant_beside(z, rational(sign)));
  return value_of(over_regions_, z, unit);
}

analytic_ball oscillation::operator()(const analytic_ball& z, int sign) const {
  const analytic_ball unit = times_i(constant_beside(z, rational(sign)));
  return value_of(over_analytic_balls_, z, unit);
}

ball oscillation::real_part(const ball& y) const { return value_of(real_over_balls_, y, y); }

decomposition::decomposition(const integrand& f, const end_point& p, const end_point& s,
                             bool infinite, int sign)
    : theta_(infinite ? 1 : -1) {
  constexpr int most_attempts = 2;
  for (int k = 0; k < most_attempts; ++k) {
    const separated parts = separate(f.graph(), p, s, theta_, sign);
    if (parts.terms) {
      choose(parts);
      return;
    }
    if (!parts.growth) return;
    theta_ /= *parts.growth;
  }
}

std::shared_ptr<const oscillation> decomposition::at(std::size_t k, precision p) const {
  // Hardly more than asked for: constants with more bits make everything slower.
  constexpr precision step = 64;
  const precision bits = (p + step - 1) / step * step;
  const std::lock_guard lock(mutex_);
  std::vector<std::shared_ptr<const oscillation>>& all = made_[bits];
  if (all.empty()) all = make(bits);
  return all[k];
}

void decomposition::choose(const separated& parts) try {
  numbers_ = parts.numbers;
  const std::size_t count = numbers_.size();
  for (const auto& a : parts.amplitudes) {
    amplitudes_.push_back(
        {a.variable, a.of, formula_in(a.slope, count), formula_in(a.shift, count)});
  }
  const variable_values values = values_at(least_bits);
  for (const known_amplitudes& a : values.amplitudes) {
    const bool is_usable =
        certainly_positive(a.slope) && certainly_less_equal(ball(0, least_bits), a.shift);
    if (!is_usable) return;
  }
  const std::vector<possibly_exact_constant>& numbers = values.numbers;
  for (const symbol& c : parts.positive) {
    if (!certainly_positive(value_of(formula_in(c, count), numbers, least_bits))) return;
  }
  for (const auto& [w, a] : *parts.terms) {
    if (w.empty()) {
      steady_ = formulas_of({a.re, std::nullopt}, count);  // real for real y
      continue;
    }
    const expression frequency = formula_in(symbol_of(w, parts.constants), count);
    const ball value = value_of(frequency, numbers, least_bits);
    if (certainly_positive(value)) {
      waves_.push_back({frequency, formulas_of(a, count)});
    } else if (!certainly_negative(value)) {
      return;
    }
  }
  found_ = true;
} catch (const input_error&) {
  // A part of it is undefined everywhere: it is not found.
}

variable_values decomposition::values_at(precision p) const {
  variable_values result;
  result.numbers.reserve(numbers_.size());
  for (const auto& number : numbers_) {
    result.numbers.push_back(number ? number(p) : possibly_exact_constant(rational(0)));
  }
  for (const amplitudes_of_constants& a : amplitudes_) {
    result.amplitudes.push_back({a.variable, a.of, value_of(a.slope, result.numbers, p),
                                 value_of(a.shift, result.numbers, p)});
  }
  return result;
}

std::vector<std::shared_ptr<const oscillation>> decomposition::make(precision p) const {
  const variable_values values = values_at(p);
  std::vector<std::shared_ptr<const oscillation>> result;
  result.reserve(waves_.size() + 1);
  for (const wave_of_frequency& w : waves_) {
    result.push_back(std::make_shared<const oscillation>(
        w.amplitude, value_of(w.frequency, values.numbers, p), values, p));
  }
  if (steady_)
    result.push_back(std::make_shared<const oscillation>(*steady_, ball(0, p), values, p));
  return result;
}

}  // namespace polhode::detail::oscillations
