#include "taylor_ranges.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

#include "panel_choice.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "quadrature/base/approximate.hpp"

namespace polhode::detail {

namespace {

rational pow_of(const rational& x, long n) {
  rational result = 1;
  for (long k = 0; k < n; ++k) result *= x;
  return result;
}
rational_polynomial reversed(const rational_polynomial& p) {
  std::vector<rational> c = p.coefficients();
  std::reverse(c.begin(), c.end());
  return rational_polynomial(std::move(c));
}
/// p(y + shift)
rational_polynomial shifted(const rational_polynomial& p, const rational& shift) {
  const rational_polynomial y({shift, rational(1)});
  rational_polynomial result;
  const std::vector<rational>& c = p.coefficients();
  for (std::size_t k = c.size(); k-- > 0;) result = result * y + rational_polynomial({c[k]});
  return result;
}
end_point inverse(const end_point& y) {
  if (y.is_infinite()) return 0;
  if (y.exact()) return rational(1 / *y.exact());
  return end_point([y](precision p) { return 1 / y.at(p); });
}

/// The same integral over w = 1/y; s must be constant, t 0, and the range one of y > 0.
smooth_range inverted(const smooth_range& range) {
  smooth_range result;
  rational power = -2 - range.numerator.degree();  // dy = -dw/w^2
  result.numerator = reversed(range.numerator);
  result.exponent = range.exponent;
  for (const smooth_factor& f : range.factors) {
    power -= f.base.degree() * f.exponent;
    rational_polynomial base = reversed(f.base);
    if (base.degree() > 0) result.factors.push_back({std::move(base), f.exponent});
  }
  if (power != 0) result.factors.push_back({rational_polynomial::variable(), power});
  result.lower = inverse(range.upper);
  result.upper = inverse(range.lower);
  result.begins_at_0 = true;
  result.is_inverted = true;
  return result;
}

/// The coefficients of (1 + w)^n p(inner + (outer - inner) w/(1 + w)), n the degree; of p(inner +
/// w) where outer is infinite. Where all have one sign, or are 0, p has that sign between the two,
/// or is 0.
std::vector<rational> coefficients_between(const rational_polynomial& p, const rational& inner,
                                           const std::optional<rational>& outer) {
  std::vector<rational> at_inner = shifted(p, inner).coefficients();
  if (!outer) return at_inner;
  // Sum of c_k length^k w^k (1 + w)^(n-k), by Horner's rule from the last.
  const rational_polynomial w = rational_polynomial::variable();
  const rational_polynomial one_and_w({rational(1), rational(1)});
  const rational length = *outer - inner;
  rational_polynomial sum;
  rational_polynomial power({rational(1)});  // (1 + w)^(n-k)
  rational power_of_length = pow_of(length, static_cast<long>(at_inner.size()) - 1);
  for (std::size_t k = at_inner.size(); k-- > 0;) {
    std::vector<rational> monomial(k + 1);
    monomial[k] = at_inner[k] * power_of_length;
    sum = sum + power * rational_polynomial(std::move(monomial));
    power = power * one_and_w;
    power_of_length /= length;
  }
  return sum.coefficients();
}

/// A bound of the integral between two points, between which the integrand falls from the inner to
/// the outer; outer is infinite where it is not given. Nothing where none is proved.
///
/// With P^ >= |P|, of the absolute values of P's coefficients, y >= 0, let |(log (P^ h))'| be at
/// least lambda > 0 between the two, with the sign that makes P^ h fall. Then P^ h is at most (P^
/// h)(inner) e^(-lambda |y - inner|), and its integral at most (P^ h)(inner)/lambda. With Q the
/// product of the p_i and d the direction, the condition is that
///   d (P^' Q + P^ (sum of e_i p_i' Q/p_i) + s' P^ Q) + lambda P^ Q <= 0:
/// it is proved, as is p_i > 0, by the signs of coefficients.
std::optional<ball> bound_by_slope(const smooth_range& range, const rational& inner,
                                   const std::optional<rational>& outer) {
  if (inner < 0 || (outer && (*outer < 0 || *outer == inner))) return std::nullopt;
  const long direction = outer && *outer < inner ? -1 : 1;
  std::vector<rational> sizes = range.numerator.coefficients();
  for (rational& c : sizes) c = abs(c);
  const rational_polynomial p(std::move(sizes));
  rational_polynomial q({rational(1)});
  rational_polynomial sum = p.derivative();
  ball bound(p(inner), 64);
  for (const smooth_factor& f : range.factors) {
    const std::vector<rational> c = coefficients_between(f.base, inner, outer);
    const bool is_positive =
        !c.empty() && c.front() > 0 &&
        std::all_of(c.begin(), c.end(), [](const rational& x) { return x >= 0; });
    if (!is_positive) return std::nullopt;
    sum = sum * f.base + p * q * f.base.derivative() * rational_polynomial({f.exponent});
    q = q * f.base;
    bound = bound * power_of_positive(ball(f.base(inner), 64), f.exponent);
  }
  const rational_polynomial all = p * q;
  if (all(inner) == 0) return std::nullopt;
  sum = sum + range.exponent.derivative() * all;
  const double slope =
      -static_cast<double>(direction) * approximately(rational(sum(inner) / all(inner)));
  if (!(slope > 0) || !std::isfinite(slope)) return std::nullopt;
  const rational lambda = exact_double(slope / 2);
  const rational_polynomial condition =
      sum * rational_polynomial({rational(direction)}) + all * rational_polynomial({lambda});
  for (const rational& c : coefficients_between(condition, inner, outer)) {
    if (c > 0) return std::nullopt;
  }
  return bound * exp(ball(range.exponent(inner), 64)) / ball(lambda, 64);
}

/// The greatest absolute value of a root, about; 0 where all roots are 0.
double size_of_roots(const smooth_range& range) {
  double size = 0;
  for (const smooth_factor& f : range.factors) {
    for (const std::complex<double>& root : approximate_roots(f.base)) {
      if (std::isfinite(std::abs(root))) size = std::max(size, std::abs(root));
    }
  }
  return size;
}

/// The zeros of the logarithmic derivative P'/P + sum of e_i p_i'/p_i + s' are those of this
/// polynomial.
rational_polynomial slope_of(const smooth_range& range) {
  rational_polynomial q({rational(1)});
  rational_polynomial slope = range.numerator.derivative();
  for (const smooth_factor& f : range.factors) {
    slope = slope * f.base +
            range.numerator * q * f.base.derivative() * rational_polynomial({f.exponent});
    q = q * f.base;
  }
  return slope + range.exponent.derivative() * range.numerator * q;
}

/// Searches in doubles for points beyond which the integrand is too small to count for so many
/// bits. What it finds is proposed only: bound_by_slope has to prove that it is so.
class cut_search {
 public:
  cut_search(const smooth_range& range, double bits)
      : range_(range),
        bits_(bits),
        choice_(range, bits),
        low_(approximately(range.lower.at(64))),
        high_(range.upper.is_infinite() ? 1e300 : approximately(range.upper.at(64))) {}

  /// False where no value is found that counts.
  [[nodiscard]] bool prepare() {
    if (!choice_.prepare()) return false;
    const std::vector<double> peaks = possible_peaks();
    greatest_ = greatest_near(peaks);
    const auto first =
        std::find_if(peaks.begin(), peaks.end(), [&](double y) { return counts(y); });
    const auto last =
        std::find_if(peaks.rbegin(), peaks.rend(), [&](double y) { return counts(y); });
    if (first == peaks.end() || last == peaks.rend()) return false;
    first_ = *first;
    last_ = *last;
    return true;
  }

  /// A bound of so little does not count.
  [[nodiscard]] bool is_small(const std::optional<ball>& bound) const {
    return bound && estimated_log2(bound->magnitude_upper()) <= greatest_ - bits_;
  }
  /// Of an infinite range: proposes points farther and farther out, from the first beyond which
  /// little is left, until one is taken; false where none is.
  template <class Take>
  [[nodiscard]] bool propose_towards_infinity(const Take& take) const {
    double outside = std::max(std::abs(last_), 1e-3);
    while (outside < 1e100 && counts(last_ + outside)) outside *= 2;
    double step = crossing(last_, last_ + outside) - last_;
    constexpr int most_attempts = 60;
    for (int k = 0; k < most_attempts; ++k, step *= 1.1) {
      if (take(short_number(last_ + step, last_))) return true;
    }
    return false;
  }
  /// Between the last value that counts and the upper end, which is a number; nothing where a cut
  /// is not worth a proof.
  [[nodiscard]] std::optional<rational> upper_cut() const {
    if (!range_.upper.exact() || !(size(high_) < least() - much)) return std::nullopt;
    const rational t = short_number(crossing(last_, high_), last_);
    if (t >= *range_.upper.exact() || t <= exact_double(last_)) return std::nullopt;
    return t;
  }
  /// Between the lower end, which is a number, and the first value that counts.
  [[nodiscard]] std::optional<rational> lower_cut() const {
    if (!range_.lower.exact() || !(first_ > low_) || !(size(low_) < least() - much)) {
      return std::nullopt;
    }
    const rational t = short_number(crossing(first_, low_), first_);
    if (t <= *range_.lower.exact() || t >= exact_double(first_)) return std::nullopt;
    return t;
  }

 private:
  static constexpr double much = 40;  // a short way is not worth a proof

  [[nodiscard]] double size(double y) const { return choice_.log2_at(y); }
  [[nodiscard]] double least() const { return greatest_ - bits_ - 10; }
  [[nodiscard]] bool counts(double y) const { return size(y) >= least(); }

  /// Where the greatest values may be, in order: at the ends, where the logarithmic derivative is
  /// 0, and near a singular end.
  [[nodiscard]] std::vector<double> possible_peaks() const {
    std::vector<double> peaks{low_};
    if (!range_.upper.is_infinite()) peaks.push_back(high_);
    const rational_polynomial slope = slope_of(range_);
    if (slope.degree() > 0) {
      for (const std::complex<double>& y : approximate_roots(slope)) {
        const bool is_real = std::abs(y.imag()) <= 1e-6 * std::abs(y.real());
        if (is_real && y.real() > low_ && y.real() < high_) peaks.push_back(y.real());
      }
    }
    if (!(size(low_) < greatest_log2)) {  // singular there
      const double length = range_.upper.is_infinite() ? 1 : high_ - low_;
      for (int k = 1; k <= 60; ++k) peaks.push_back(low_ + std::ldexp(length, -k));
    }
    std::sort(peaks.begin(), peaks.end());
    return peaks;
  }
  /// log2 of the greatest value times the width of its peak, where that is below 1.
  [[nodiscard]] double greatest_near(const std::vector<double>& peaks) const {
    double greatest = -infinite;
    for (const double y : peaks) {
      const double value = size(y);
      if (!(value > greatest) || value > greatest_log2) continue;
      // How far it is until half of the value.
      double width = std::max(std::abs(y), 1e-3);
      while (width > 1e-300 && size(y + width) < value - 1 && size(y - width) < value - 1) {
        width /= 2;
      }
      greatest = std::max(greatest, value + std::min(std::log2(width), 0.0));
    }
    return greatest;
  }
  /// Where values begin not to count, between a point where they do and one where they do not.
  [[nodiscard]] double crossing(double inside, double outside) const {
    for (int k = 0; k < 60; ++k) {
      const double middle = (inside + outside) / 2;
      (counts(middle) ? inside : outside) = middle;
    }
    return outside;
  }
  /// A short number, not nearer to the peak than y.
  [[nodiscard]] static rational short_number(double y, double peak) {
    const double unit = unit_of(std::abs(y - peak), 6);
    return exact_double((y > peak ? std::ceil(y / unit) : std::floor(y / unit)) * unit);
  }

  const smooth_range& range_;
  double bits_;
  panel_choice choice_;
  double low_;
  double high_;
  double greatest_ = 0;
  double first_ = 0;  // the first and the last peak that count
  double last_ = 0;
};

/// Leaves out what lies beyond t in the range, of which this is a bound.
void leave_out_above(finite_ranges& result, smooth_range& range, const rational& t,
                     const ball& bound) {
  result.rests.push_back({ball(0, 64).enlarged(bound.magnitude_upper()),
                          {piece_end(t), piece_end::upper_end()},
                          {t, range.upper.exact()}});
  range.upper = t;
}
void leave_out_below(finite_ranges& result, smooth_range& range, const rational& t,
                     const ball& bound) {
  result.rests.push_back({ball(0, 64).enlarged(bound.magnitude_upper()),
                          {piece_end::lower_end(), piece_end(t)},
                          {*range.lower.exact(), t}});
  range.lower = t;
}

/// Without what is proved to be too small to count for so many bits. Nothing where no end of an
/// infinite range is found.
std::optional<finite_ranges> cut_off(const smooth_range& whole, double bits) {
  cut_search search(whole, bits);
  if (!search.prepare()) return std::nullopt;
  finite_ranges result;
  smooth_range range = whole;
  // The cut at t, if the bound of what is beyond it, up to `end`, is proved to be small.
  const auto proved_cut = [&](const rational& t, const std::optional<rational>& end,
                              auto leave_out) {
    const std::optional<ball> bound = bound_by_slope(range, t, end);
    if (!search.is_small(bound)) return false;
    leave_out(result, range, t, *bound);
    return true;
  };
  if (whole.upper.is_infinite()) {
    const bool is_cut = search.propose_towards_infinity(
        [&](const rational& t) { return proved_cut(t, std::nullopt, leave_out_above); });
    if (!is_cut) return std::nullopt;
  } else if (const auto t = search.upper_cut()) {
    proved_cut(*t, whole.upper.exact(), leave_out_above);
  }
  if (const auto t = search.lower_cut()) proved_cut(*t, whole.lower.exact(), leave_out_below);
  result.ranges.push_back(std::move(range));
  return result;
}

}  // namespace

std::optional<finite_ranges> ranges_of(const hyperexponential_integral& part, double bits) {
  constexpr long greatest_degree = 12;  // of P
  finite_ranges result;
  smooth_range range;
  range.numerator = rational_polynomial({rational(1)});
  for (const polynomial_power& p : part.function.powers) {
    const bool is_short =
        denominator(p.exponent) == 1 && p.exponent >= 0 &&
        p.exponent * p.base.degree() + range.numerator.degree() <= greatest_degree;
    if (is_short) {
      for (long k = 0; k < p.exponent; ++k) range.numerator = range.numerator * p.base;
    }
    if (!is_short) {
      range.factors.push_back({p.base, p.exponent});
    } else if (p.must_be_positive) {
      range.factors.push_back({p.base, rational(0)});
    }
  }
  long degree = std::max(part.function.exponent.degree(), part.function.phase.degree());  // about
  for (const smooth_factor& f : range.factors) degree += f.base.degree();
  constexpr long most_degree = 64;
  if (degree > most_degree) return std::nullopt;
  range.exponent = part.function.exponent;
  range.phase = part.function.phase;
  range.is_sine = part.function.is_sine;
  range.lower = part.lower;
  range.upper = part.upper;
  range.begins_at_0 = part.begins_at_0;
  range.greatest = part.greatest;
  const bool is_steep = range.exponent.degree() >= 1 ||
                        std::any_of(range.factors.begin(), range.factors.end(),
                                    [](const smooth_factor& f) { return abs(f.exponent) >= 16; });
  if (is_steep && (range.exponent.degree() >= 1 || !range.upper.is_infinite())) {
    if (range.upper.is_infinite() && !range.lower.exact()) return std::nullopt;
    return cut_off(range, bits);
  }
  if (range.phase.degree() >= 0) {
    if (range.upper.is_infinite()) return std::nullopt;
    result.ranges.push_back(std::move(range));
    return result;
  }
  // Far out, over 1/y.
  const double low = approximately(range.lower.at(64));
  const double high = range.upper.is_infinite() ? 1e300 : approximately(range.upper.at(64));
  const double size = size_of_roots(range);
  // Without roots, and but for infinite ranges, one series serves as well.
  const double far = size > 0 ? std::exp2(std::ceil(std::log2(size)) + 1) : std::max(low, 1.0);
  if (!std::isfinite(low) || std::isnan(high) || !std::isfinite(far)) return std::nullopt;
  const bool is_far = range.upper.is_infinite() || (size > 0 && high > 16 * std::max(far, low));
  if (!is_far) {
    result.ranges.push_back(std::move(range));
    return result;
  }
  if (low < far / 2) {
    const rational cut = exact_double(far);
    smooth_range near = range;
    near.upper = cut;
    result.ranges.push_back(std::move(near));
    range.lower = cut;
  }
  const bool may_be_inverted = range.exponent.degree() <= 0 && range.phase.is_zero() &&
                               certainly_positive(range.lower.at(128));
  if (!may_be_inverted) return std::nullopt;
  result.ranges.push_back(inverted(range));
  return result;
}

}  // namespace polhode::detail
