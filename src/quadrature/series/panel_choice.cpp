#include "panel_choice.hpp"

#include <algorithm>
#include <cmath>

#include "quadrature/base/approximate.hpp"

namespace polhode::detail {

bool panel_choice::prepare() {
  for (const smooth_factor& f : range_.factors) {
    for (const std::complex<double>& root : approximate_roots(f.base)) {
      if (!std::isfinite(std::abs(root))) return false;
      roots_.push_back({root, approximately(f.exponent)});
    }
    if (f.exponent != 0) {
      log_of_constant_ +=
          approximately(f.exponent) * std::log(std::abs(approximately(f.base.leading())));
    }
  }
  for (const rational& c : range_.exponent.coefficients()) exponent_.push_back(approximately(c));
  for (const rational& c : range_.phase.coefficients()) phase_.push_back(approximately(c));
  for (const rational& c : range_.numerator.coefficients()) {
    numerator_.push_back(approximately(c));
  }
  return true;
}

std::optional<std::vector<taylor_panel>> panel_choice::panels() {
  if (!prepare()) return std::nullopt;
  const double low = approximately(range_.lower.at(64));
  const double high = approximately(range_.upper.at(64));
  if (!std::isfinite(low) || !std::isfinite(high) || !(low < high)) return std::nullopt;

  // The ends, as rational numbers: where they are not, a little beyond them.
  const end lower = lower_end(low, high - low);
  const end upper = upper_end(high, high - low);
  if (!(lower.at < upper.at)) return std::nullopt;
  const rational length = upper.at - lower.at;
  rational from = lower.at;
  rational to = upper.at;
  double left = lower.is_singular ? length_at(lower.at, 1, length) : 0;
  double right = upper.is_singular ? length_at(upper.at, -1, length) : 0;
  const double whole = approximately(length);
  std::vector<taylor_panel> result;
  if (left > 0 && right > 0 && left + right >= whole) {
    from = to = lower.at + rounded(whole * left / (left + right));
  } else {
    if (left > 0) from = left >= whole ? to : rational(lower.at + rounded(left));
    if (right > 0) to = right >= whole ? from : rational(upper.at - rounded(right));
  }
  if (from > lower.at) {
    result.push_back({lower.at, rational(from - lower.at), true, false, false});
  }
  if (!cover(from, to, result)) return std::nullopt;
  if (upper.at > to) {
    result.push_back({upper.at, rational(to - upper.at), true, false, false});
  }
  return cut_to(range_, result);
}

double panel_choice::log2_of_size(const std::vector<taylor_panel>& panels) const {
  double size = -infinite;
  for (const taylor_panel& p : panels) {
    const double c = approximately(p.centre);
    const double r = approximately(p.radius);
    for (const double z : {-0.9, -0.5, 0.0, 0.5, 0.9}) {
      if (p.at_end && z <= 0) continue;
      const double value = log2_at(c + r * z) + std::log2(std::abs(r));
      if (std::isfinite(value)) size = std::max(size, value);
    }
  }
  return size;
}

double panel_choice::log2_at(double y) const {
  double numerator = 0;
  for (std::size_t k = numerator_.size(); k-- > 0;) numerator = numerator * y + numerator_[k];
  return (log_size({y, 0}, std::nullopt) + log_of_constant_ + std::log(std::abs(numerator))) /
         std::log(2.0);
}

bool panel_choice::is_singular_at(const rational& y) const {
  return std::any_of(range_.factors.begin(), range_.factors.end(),
                     [&](const smooth_factor& f) { return f.base(y) == 0; });
}

bool panel_choice::is_integrable_at(const rational& y) const {
  const rational_polynomial root({-y, rational(1)});
  const auto multiplicity = [&](rational_polynomial p) {
    long m = 0;
    while (p.degree() > 0 && p(y) == 0) {
      p = divide(p, root).first;
      ++m;
    }
    return m;
  };
  rational power = multiplicity(range_.numerator);
  for (const smooth_factor& f : range_.factors) power += multiplicity(f.base) * f.exponent;
  return power > -1;
}

panel_choice::end panel_choice::lower_end(double low, double length) const {
  if (range_.lower.exact()) return {*range_.lower.exact(), is_singular_at(*range_.lower.exact())};
  if (range_.begins_at_0 && low < ratio_ / 2 * distance(0, rational(0)) && is_integrable_at(0) &&
      low < length_at(0, 1, exact_double(low + length))) {
    return {0, true};
  }
  const double unit = unit_of(std::min(distance(low), length), 12);
  return {exact_double((std::floor(low / unit) - 1) * unit), false};
}

panel_choice::end panel_choice::upper_end(double high, double length) const {
  if (range_.upper.exact()) return {*range_.upper.exact(), is_singular_at(*range_.upper.exact())};
  if (range_.greatest) {
    const rational& most = *range_.greatest;
    const double y = approximately(most);
    const double rest = y - high;
    if (rest < ratio_ / 2 * distance(y, most) && is_integrable_at(most) &&
        rest < length_at(most, -1, exact_double(rest + length))) {
      return {most, is_singular_at(most)};
    }
  }
  const double unit = unit_of(std::min(distance(high), length), 12);
  return {exact_double((std::ceil(high / unit) + 1) * unit), false};
}

double panel_choice::distance(double y, const std::optional<rational>& except) const {
  double least = 1e300;
  for (const approximate_root& root : roots_) {
    if (except && is_at(root, *except)) continue;
    least = std::min(least, std::abs(root.at - y));
  }
  return least;
}

bool panel_choice::is_at(const approximate_root& root, const rational& y) {
  const double x = approximately(y);
  return std::abs(root.at - x) <= 1e-13 * std::abs(x) || (x == 0 && std::abs(root.at) < 1e-290);
}

double panel_choice::log_size(std::complex<double> y, const std::optional<rational>& except) const {
  double sum = 0;
  for (const approximate_root& root : roots_) {
    if (root.exponent == 0 || (except && is_at(root, *except))) continue;
    sum += root.exponent * std::log(std::abs(y - root.at));
  }
  std::complex<double> s = 0;
  for (std::size_t k = exponent_.size(); k-- > 0;) s = s * y + exponent_[k];
  std::complex<double> t = 0;
  for (std::size_t k = phase_.size(); k-- > 0;) t = t * y + phase_[k];
  return sum + s.real() + std::abs(t.imag());
}

double panel_choice::spread(double c, double r, const std::optional<rational>& except) const {
  const double own = log_size({c, 0}, except);
  double most = own;
  double least = own;
  for (int k = 0; k <= 6; ++k) {
    const double angle = 3.14159265 * k / 6;
    const double value = log_size({c + r * std::cos(angle), r * std::sin(angle)}, except);
    most = std::max(most, value);
    if (k == 0 || (k == 6 && !except)) least = std::min(least, value);
  }
  const double log_of_2 = std::log(2.0);
  return std::isfinite(most) && std::isfinite(least) ? (most - least) / log_of_2 : infinite;
}

double panel_choice::length_at(const rational& y, int direction, const rational& all) const {
  const double start = approximately(y);
  const double whole = approximately(all);
  double r = std::min(ratio_ * distance(start, y), whole);
  if (ratio_ * 1.2 * distance(start, y) >= whole) r = whole;
  for (int k = 0; k < 200 && spread(start, direction * r, y) > most_spread(); ++k) r *= 0.75;
  return r;
}

rational panel_choice::rounded(double r) {
  const double unit = unit_of(r, 3);
  return exact_double(std::floor(r / unit) * unit);
}

bool panel_choice::cover(rational from, const rational& to,
                         std::vector<taylor_panel>& panels) const {
  constexpr std::size_t most_panels = 2000;
  const double goal = approximately(to);
  while (from < to) {
    if (panels.size() >= most_panels) return false;
    const double start = approximately(from);
    const double rest = approximately(rational(to - from)) / 2;
    double r = ratio_ * distance(start);
    for (int k = 0; k < 12; ++k) r = ratio_ * distance(start + r);
    if (rest <= 1.15 * r) r = rest;
    for (int k = 0; k < 200 && spread(start + r, r, std::nullopt) > most_spread(); ++k) {
      r *= 0.75;
    }
    rational next = to;
    if (r < rest) {
      if (2 * rest < 3 * r) r = rest / 2;
      const double unit = unit_of(r, 3);
      next = exact_double(std::floor((start + 2 * r) / unit) * unit);
      if (next <= from || next >= to || !(start + 2 * r < goal)) return false;
    }
    panels.push_back(
        {rational((from + next) / 2), rational((next - from) / 2), false, false, false});
    from = next;
  }
  return true;
}

}  // namespace polhode::detail
