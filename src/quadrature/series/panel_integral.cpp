#include "panel_integral.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "hyperexponential.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "quadrature/base/approximate.hpp"

namespace polhode::detail {

namespace {

const double_interval log_of_2 = log(double_interval(2));
const magnitude three = magnitude::from_integer_up(3);

/// At least 2^e for each e of the interval.
magnitude power_of_two_above(const double_interval& e) {
  constexpr double greatest = 0x1p+50;
  if (!(e.upper() < greatest)) return magnitude::infinity();
  const double exponent = std::max(e.upper(), -greatest);
  const double whole = std::floor(exponent);
  const double_interval rest = double_interval(exponent) - double_interval(whole);
  constexpr int bits = 52;
  const double factor = std::ldexp(exp(rest * log_of_2).upper(), bits);
  return magnitude::from_bits_up(static_cast<std::uint64_t>(std::ceil(factor)),
                                 static_cast<long>(whole) - bits);
}

magnitude times(long count) {
  return magnitude::from_integer_up(static_cast<std::uint64_t>(count));
}

}  // namespace

std::optional<panel_value> panel_integral::to(double log2_goal, precision most_bits,
                                              long most_terms) {
  if (!is_prepared_ && !prepare()) return std::nullopt;
  const ball size = constant(64) * maximum_ * length_factor();
  const double_interval log2_greatest = log_greatest_ / log_of_2;
  const double log2_size = estimated_log2(size.magnitude_upper()) + log2_greatest.upper();
  if (!(log2_size < 1e15)) return std::nullopt;
  if (log2_size <= log2_goal) {
    // A bound over the whole panel is one over each part of it.
    const magnitude most = multiply_up(size.magnitude_upper(), power_of_two_above(log2_greatest));
    return panel_value{ball(0, 64).enlarged(most), panel_.piece()};
  }
  const double lost = ((log_greatest_ - log_least_ - log_least_q_) / log_of_2).upper();
  const double bits = estimated_log2(size.magnitude_upper()) + lost - log2_goal + 5;
  const double log2_terms = std::log2(std::max(bits, 16.0)) + 1;
  // Only a cut panel's powers of z add up to errors of the square of the number of terms.
  const double f = std::ceil(std::max(bits + (panel_.is_cut() ? 2 : 1) * log2_terms, 64.0));
  if (!(f < static_cast<double>(most_bits))) return std::nullopt;
  return in_units(static_cast<long>(f),
                  std::max(static_cast<long>(log2_size - log2_goal) + 32, 64L), most_terms);
}

std::optional<panel_value> panel_integral::in_units(long f, precision p, long most_terms) {
  if (!is_prepared_ && !prepare()) return std::nullopt;
  const std::optional<ball> value = sum(f, p, most_terms);
  if (!value) return std::nullopt;
  return panel_value{*value, panel_.piece()};
}

bool panel_integral::prepare() {
  power_ = 0;
  for (const smooth_factor& f : range_.factors) {
    local_factor local{at_panel(f.base, panel_.centre, panel_.radius), f.exponent};
    if (panel_.at_end) power_ += without_zeros(local.p.coefficients) * f.exponent;
    if (local.p.coefficients.front() <= 0) return false;
    factors_.push_back(std::move(local));
  }
  numerator_ = at_panel(range_.numerator, panel_.centre, panel_.radius);
  if (panel_.at_end) power_ += without_zeros(numerator_.coefficients);
  if (power_ <= -1) return false;
  integer most = 0;
  for (const integer& x : numerator_.coefficients) most += abs(x);
  maximum_ = ball(most, 64);
  if (!range_.exponent.is_zero()) exponent_ = local(range_.exponent);
  if (!range_.phase.is_zero()) phase_ = local(range_.phase);
  if (!prepare_bounds()) return false;
  prepare_recurrence();
  is_prepared_ = true;
  return true;
}

local_polynomial panel_integral::local(const rational_polynomial& p) const {
  integer below = 1;
  for (const rational& c : p.coefficients()) below = lcm(below, denominator(c));
  local_polynomial result =
      at_panel(p * rational_polynomial({rational(below)}), panel_.centre, panel_.radius);
  result.content /= rational(below);
  return result;
}

bool panel_integral::prepare_bounds() {
  std::vector<polynomial_range> ranges;
  std::vector<double_interval> exponents;
  for (const local_factor& f : factors_) {
    std::vector<double_interval> c;
    for (const integer& x : f.p.coefficients) {
      c.push_back(quotient(x, f.p.coefficients.front()));
    }
    ranges.emplace_back(std::move(c));
    exponents.emplace_back(f.exponent);
  }
  std::vector<double_interval> s{double_interval(0)};  // without s(c)
  for (std::size_t k = 1; k < exponent_.coefficients.size(); ++k) {
    s.emplace_back(rational(exponent_.coefficients[k] * exponent_.content));
  }
  const polynomial_range range_of_s(std::move(s));
  for (int pieces = 4; pieces <= 64; pieces *= 4) {
    bool are_positive = true;
    const double start = panel_.at_end ? 0 : -1;
    const double step = (1 - start) / pieces;  // a power of 2
    double_interval all(0);
    double_interval all_q(0);
    for (int k = 0; k < pieces && are_positive; ++k) {
      const double_interval z(start + k * step, start + (k + 1) * step);
      double_interval log_g = range_of_s.over(z);
      double_interval log_q(0);
      for (std::size_t i = 0; i < ranges.size(); ++i) {
        const double_interval value = ranges[i].over(z);
        if (!certainly_positive(value)) {
          are_positive = false;
          break;
        }
        if (factors_[i].exponent == 0) continue;
        const double_interval log_of_it = log(value);
        log_q = log_q + log_of_it;
        log_g = log_g + exponents[i] * log_of_it;
      }
      all = hull(all, log_g);
      all_q = hull(all_q, log_q);
    }
    if (!are_positive) continue;
    if (!all.is_bounded() || !all_q.is_bounded()) return false;
    log_least_ = double_interval(all.lower(), all.lower());
    log_greatest_ = double_interval(all.upper(), all.upper());
    log_least_q_ = double_interval(all_q.lower(), all_q.lower());
    return true;
  }
  return false;
}

void panel_integral::prepare_recurrence() {
  integer common = 1;
  for (const local_factor& f : factors_) common = lcm(common, denominator(f.exponent));
  q_ = {integer(1)};
  s_ = {};
  for (const local_factor& f : factors_) {
    if (f.exponent == 0) continue;
    integers part = product(derivative(f.p.coefficients), q_);
    multiply_by(part, numerator(f.exponent) * (common / denominator(f.exponent)));
    s_ = product(s_, f.p.coefficients);
    add_to(s_, part);
    q_ = product(q_, f.p.coefficients);
  }
  multiply_by(q_, common);
  if (!exponent_.coefficients.empty()) add_derivative(exponent_, s_);
  if (!phase_.coefficients.empty()) add_derivative(phase_, t_);
  integer divisor = 0;
  for (const integers* p : {&q_, &s_, &t_}) {
    for (const integer& x : *p) divisor = gcd(divisor, x);
  }
  if (divisor > 1) {
    for (integers* p : {&q_, &s_, &t_}) {
      for (integer& x : *p) x /= divisor;
    }
  }
}

void panel_integral::add_derivative(const local_polynomial& p, integers& part) {
  integers sum = product(derivative(p.coefficients), q_);
  multiply_by(sum, numerator(p.content));
  for (integers* all : {&q_, &s_, &t_}) multiply_by(*all, denominator(p.content));
  add_to(part, sum);
}

ball panel_integral::constant(precision p) const {
  std::vector<std::pair<rational, rational>> values;  // exponents and their bases
  for (const local_factor& f : factors_) {
    if (f.exponent == 0) continue;
    const rational value = f.p.content * rational(f.p.coefficients.front());
    const auto same = std::find_if(values.begin(), values.end(),
                                   [&](const auto& v) { return v.first == f.exponent; });
    if (same == values.end()) {
      values.emplace_back(f.exponent, value);
    } else {
      same->second *= value;
    }
  }
  ball result(rational(abs(panel_.radius) * numerator_.content), p);
  for (const auto& [exponent, value] : values) {
    result = result * power_of_positive(ball(value, p), exponent);
  }
  if (!exponent_.coefficients.empty()) {
    const rational at_centre = exponent_.coefficients.front() * exponent_.content;
    result = result * exp(ball(at_centre, p));
  }
  return result;
}

ball panel_integral::length_factor() const {
  return panel_.at_end ? ball(rational(1 / (power_ + 1)), 64) : ball(2, 64);
}

ball panel_integral::coordinate(const end_point& end, precision p) const {
  return (end.at(p) - panel_.centre) / ball(panel_.radius, p);
}

panel_integral::cut_ends panel_integral::cut_ends_in_z(precision bits) const {
  cut_ends cut;
  const bool falls = panel_.radius < 0;
  if (panel_.from_lower) (falls ? cut.high : cut.low) = coordinate(range_.lower, bits);
  if (panel_.to_upper) (falls ? cut.low : cut.high) = coordinate(range_.upper, bits);
  return cut;
}

bool panel_integral::add_cut_ends(const cut_ends& cut, long f, series_part& own) const {
  for (const auto& [z, at] :
       {std::pair(&cut.low, &own.at_low), std::pair(&cut.high, &own.at_high)}) {
    if (!*z) continue;
    fixed_point_number number = in_fixed_point(**z, f);
    const bool is_inside =
        (*z)->magnitude_upper() <= magnitude::power_of_two(0) &&
        mpz_sizeinbase(number.value.backend().data(), 2) <= static_cast<std::size_t>(f);
    if (!is_inside || (panel_.at_end && !certainly_positive(**z))) return false;
    at->emplace(std::move(number), f);
  }
  return true;
}

magnitude panel_integral::error_of_coefficients(long count_of_divisions, std::size_t parts,
                                                long f) const {
  const magnitude unit = magnitude::power_of_two(-f);
  const magnitude relative =
      power_of_two_above((log_greatest_ - log_least_ - log_least_q_) / log_of_2);
  const magnitude divisions = times(count_of_divisions);
  const magnitude steps = parts == 1 ? divisions : scale(multiply_up(divisions, three), -1);
  const magnitude of_a = multiply_up(steps, multiply_up(unit, relative));
  return multiply_up(multiply_up(of_a, maximum_.magnitude_upper()),
                     length_factor().magnitude_upper());
}

ball panel_integral::integral_of(const series_part& own, const cut_ends& ends, long f,
                                 precision p) const {
  const magnitude unit = magnitude::power_of_two(-f);
  const auto from_units = [&](const integer& units, const magnitude& error) {
    ball value(units, p);
    scale(value, value, -f);
    return value.enlarged(error);
  };
  // Each b_n is off by less than a unit, and 0 where e_n is.
  const magnitude of_terms = multiply_up(times(own.terms), unit);
  const auto at = [&](const std::optional<antiderivative>& cut, const ball& z) {
    // b_n z^n is off by less than a unit for b_n and another one for the product; z^n by at most n
    // - 1 units, as 1 and z are not rounded and each product by z adds less than one; and z by its
    // own error, with |G'(z)| <= sum of |e_n|.
    const magnitude of_powers =
        multiply_up(scale(ball(own.of_powers, 64).magnitude_upper(), -f), unit);
    const magnitude size = scale(ball(own.sum_of_sizes, 64).magnitude_upper(), -f);
    const magnitude of_products = scale(of_terms, 1);
    const ball value = from_units(
        cut->sum(), add_up(of_products, add_up(of_powers, multiply_up(size, cut->error_of_z()))));
    const ball power = z.with_precision(p);
    return value * (power_ == 0 ? power : power_of_positive(power, rational(power_ + 1)));
  };
  if (!ends.is_cut() && !panel_.at_end) return from_units(own.at_plus * 2, scale(of_terms, 1));
  ball value = own.at_high ? at(own.at_high, *ends.high) : from_units(own.at_plus, of_terms);
  if (own.at_low) {
    value = value - at(own.at_low, *ends.low);
  } else if (!panel_.at_end) {
    value = value + from_units(own.at_minus, of_terms);
  }
  return value;
}

std::optional<ball> panel_integral::sum(long f, precision p, long most_terms) {
  bits_ = f;
  const cut_ends ends = cut_ends_in_z(f + 32);
  // The real part and, where g is complex, the imaginary one.
  const std::size_t parts = phase_.coefficients.empty() ? 1 : 2;
  std::vector<series_part> part(parts);
  for (series_part& own : part) {
    if (!add_cut_ends(ends, f, own)) return std::nullopt;
  }
  const taylor_recurrence recurrence{q_, s_, t_, numerator_.coefficients, power_};
  const bool only_even = !panel_.at_end && !ends.is_cut();
  const std::optional<computed_terms> terms =
      add_terms(recurrence, {f, most_terms, only_even, ends.is_cut()}, part);
  if (!terms) return std::nullopt;
  terms_ = terms->count;

  const magnitude of_series = error_of_coefficients(terms->divisions, parts, f);
  const ball real = integral_of(part[0], ends, f, p);
  if (parts == 1) return real.enlarged(of_series) * constant(p);
  // The part of (real + i imaginary) e^(i t(c)) that is meant. What A is off by is a complex
  // number, and turned with it.
  const ball imaginary = integral_of(part[1], ends, f, p);
  const ball angle(rational(phase_.coefficients.front() * phase_.content), p);
  const ball result = range_.is_sine ? real * sin(angle) + imaginary * cos(angle)
                                     : real * cos(angle) - imaginary * sin(angle);
  return result.enlarged(of_series) * constant(p);
}

}  // namespace polhode::detail
