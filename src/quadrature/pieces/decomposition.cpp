#include "decomposition.hpp"

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

ball value_of(const expression& w, const std::vector<possibly_exact_constant>& numbers,
              precision p) {
  std::vector<ball> values(first_number, ball(1, p));  // it depends on none of these
  for (const possibly_exact_constant& c : numbers) {
    values.push_back(constant_beside(values.front(), c));
  }
  return w.evaluator<ball>(p)(std::span<const ball>(values));
}

}  // namespace

oscillation::oscillation(const amplitude_formulas& w, ball frequency,
                         std::vector<possibly_exact_constant> numbers, precision p)
    : formulas_(w), frequency_(std::move(frequency)), numbers_(std::move(numbers)), precision_(p) {
  if (w.re) real_over_balls_ = w.re->evaluator<ball>(p);
  if (!w.whole) return;
  over_regions_ = w.whole->evaluator<region>(p);
  over_analytic_balls_ = w.whole->evaluator<analytic_ball>(p);
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
  const std::vector<possibly_exact_constant> numbers = numbers_at(least_bits);
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

std::vector<possibly_exact_constant> decomposition::numbers_at(precision p) const {
  std::vector<possibly_exact_constant> result;
  result.reserve(numbers_.size());
  for (const auto& number : numbers_) result.push_back(number(p));
  return result;
}

std::vector<std::shared_ptr<const oscillation>> decomposition::make(precision p) const {
  const std::vector<possibly_exact_constant> numbers = numbers_at(p);
  std::vector<std::shared_ptr<const oscillation>> result;
  result.reserve(waves_.size() + 1);
  for (const wave_of_frequency& w : waves_) {
    result.push_back(std::make_shared<const oscillation>(
        w.amplitude, value_of(w.frequency, numbers, p), numbers, p));
  }
  if (steady_)
    result.push_back(std::make_shared<const oscillation>(*steady_, ball(0, p), numbers, p));
  return result;
}

}  // namespace polhode::detail::oscillations
