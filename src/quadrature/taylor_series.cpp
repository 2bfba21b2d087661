#include "taylor_series.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <complex>
#include <utility>

#include "polhode/arithmetic/double_interval.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "tiling.hpp"

namespace polhode::detail {

namespace {

using clock = std::chrono::steady_clock;

/// To search with.
double approximate_log2(const magnitude& x) {
  if (x.is_zero()) return -1e18;
  if (x.is_infinite()) return 1e18;
  return std::log2(static_cast<double>(x.fraction())) + static_cast<double>(x.exponent());
}
double approximately(const ball& x) {
  mpfr_cell middle(64);
  x.midpoint(middle.get());
  return mpfr_get_d(middle.get(), MPFR_RNDN);
}
double approximately(const rational& q) { return mpq_get_d(q.backend().data()); }
/// 2^-bits of about r; 1 where r is no positive number.
double unit_of(double r, int bits) {
  return r > 0 && std::isfinite(r) ? std::ldexp(1.0, std::ilogb(r) - bits) : 1;
}
/// 0 where x is no number: what is chosen in doubles proves itself, or fails to.
rational exactly(double x) {
  rational q = 0;
  if (!std::isfinite(x)) return q;
  mpq_set_d(q.backend().data(), x);
  return q;
}

/// 2^e, e >= the bound of the interval.
magnitude power_of_two_above(const double_interval& e) {
  constexpr double greatest = 0x1p+50;
  if (!(e.upper() < greatest)) return magnitude::infinity();
  return magnitude::power_of_two(static_cast<long>(std::ceil(std::max(e.upper(), -greatest))));
}

// Polynomials with integer coefficients, that of z^k at [k], in the coordinate of a panel.

using integers = std::vector<integer>;

/// content * (the polynomial with coprime integer coefficients), content > 0.
struct local_polynomial {
  integers coefficients;
  rational content;
};

/// p(c + r z), where all of p's coefficients are integers.
local_polynomial at_panel(const rational_polynomial& p, const rational& c, const rational& r) {
  // c = C/T, r = R/T: T^n p(c + r z) = sum p_j T^(n-j) (C + R z)^j by Horner's rule.
  const integer t = lcm(denominator(c), denominator(r));
  const integer shift = numerator(c) * (t / denominator(c));
  const integer scale = numerator(r) * (t / denominator(r));
  const auto n = static_cast<std::size_t>(p.degree());
  integers v{numerator(p.coefficients()[n])};
  integer power = 1;
  for (std::size_t j = n; j-- > 0;) {
    power *= t;
    v.emplace_back(0);
    for (std::size_t k = v.size(); k-- > 0;) {
      v[k] *= shift;
      if (k > 0) v[k] += v[k - 1] * scale;
    }
    v[0] += numerator(p.coefficients()[j]) * power;
  }
  integer common = 0;
  for (const integer& x : v) common = gcd(common, x);
  if (common > 1) {
    for (integer& x : v) x /= common;
  }
  return {std::move(v), rational(common, power)};
}

integers product(const integers& p, const integers& q) {
  if (p.empty() || q.empty()) return {};
  integers result(p.size() + q.size() - 1);
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (std::size_t j = 0; j < q.size(); ++j) result[i + j] += p[i] * q[j];
  }
  return result;
}
integers derivative(const integers& p) {
  integers result;
  for (std::size_t k = 1; k < p.size(); ++k) result.push_back(p[k] * static_cast<long>(k));
  return result;
}
void multiply_by(integers& p, const integer& factor) {
  for (integer& x : p) x *= factor;
}
void add_to(integers& p, const integers& q) {
  if (p.size() < q.size()) p.resize(q.size());
  for (std::size_t k = 0; k < q.size(); ++k) p[k] += q[k];
}
/// Divides by z as often as that can be done; how often.
long without_zeros(integers& p) {
  const auto first = std::find_if(p.begin(), p.end(), [](const integer& x) { return x != 0; });
  const long zeros = first - p.begin();
  p.erase(p.begin(), first);
  return zeros;
}

/// x/y, y > 0.
double_interval quotient(const integer& x, const integer& y) {
  if (x == 0) return double_interval(0);
  // |x| = m 2^e with 1/2 <= m < 1, cut off after 53 bits.
  const auto parts_of = [](const integer& n) {
    long e = 0;
    const double m = mpz_get_d_2exp(&e, n.backend().data());
    constexpr double unit = 0x1p-52;
    return std::pair(m < 0 ? double_interval(m - unit, m) : double_interval(m, m + unit), e);
  };
  const auto [above, above_exponent] = parts_of(x);
  const auto [below, below_exponent] = parts_of(y);
  return scale(above / below, above_exponent - below_exponent);
}

/// The range of a polynomial over [low, high].
class polynomial_range {
 public:
  explicit polynomial_range(std::vector<double_interval> c) : c_(std::move(c)) {}
  [[nodiscard]] double_interval over(const double_interval& z) const {
    double_interval value(0);
    for (std::size_t k = c_.size(); k-- > 0;) value = value * z + c_[k];
    return value;
  }

 private:
  std::vector<double_interval> c_;
};

/// A rational function's power, one factor of h.
struct factor {
  rational_polynomial base;
  rational exponent;  // 0: it must only be positive
};

/// P h over part of the line, with P and h as above: from lower to upper, both finite.
struct smooth_range {
  std::vector<factor> factors;
  rational_polynomial numerator;  // P
  rational_polynomial exponent;   // s
  rational_polynomial phase;      // t
  bool is_sine = false;           // the imaginary part is meant
  range_end lower;
  range_end upper;
  bool begins_at_0 = false;
  std::optional<rational> greatest;
  bool is_inverted = false;  // the line is that of 1/y

  /// Where it lies in the range of y that it was cut from, of which it keeps the ends that are not exact.
  [[nodiscard]] piece_done piece() const {
    const place from = lower.exact ? place(*lower.exact) : place::lower_end();
    const place to = upper.exact ? place(*upper.exact) : place::upper_end();
    if (!is_inverted) return {from, to};
    const auto inverse = [](const range_end& end, const place& otherwise) {
      return end.exact && *end.exact != 0 ? place(rational(1 / *end.exact)) : otherwise;
    };
    return {inverse(upper, place::lower_end()), inverse(lower, place::upper_end())};
  }
};

/// A panel: y = centre + radius z, -1 <= z <= 1 or, at an end, 0 <= z <= 1.
struct taylor_panel {
  rational centre;
  rational radius;  // negative where y falls as z grows
  bool at_end = false;
  bool from_lower = false;  // it is cut off at the range's lower, or upper, end, which is not exact
  bool to_upper = false;

  /// The values of y on the whole of it.
  [[nodiscard]] closed_interval interval() const {
    const rational other = at_end ? centre : rational(centre - radius);
    const rational end = centre + radius;
    return {std::min(other, end), std::max(other, end)};
  }
  /// What is to be integrated over.
  [[nodiscard]] piece_done piece() const {
    const closed_interval all = interval();
    return {from_lower ? place::lower_end() : place(all.lower),
            to_upper ? place::upper_end() : place(*all.upper)};
  }
  [[nodiscard]] bool is_cut() const { return from_lower || to_upper; }
};

/// Those of the panels, which follow one another, that meet the range, with the ones that its ends cut marked. Returns
/// nullopt where it is not clear which those are.
std::optional<std::vector<taylor_panel>> cut_to(const smooth_range& range,
                                                const std::vector<taylor_panel>& panels) {
  std::vector<taylor_panel> result;
  for (taylor_panel p : panels) {
    const closed_interval all = p.interval();
    // Panels before the lower end are left out, and those after the upper end.
    if (!range.lower.exact && result.empty()) {
      const std::optional<int> at_upper = side_of(range.lower, *all.upper);
      if (!at_upper) return std::nullopt;
      if (*at_upper > 0) continue;
      const std::optional<int> at_lower = side_of(range.lower, all.lower);
      if (!at_lower) return std::nullopt;
      p.from_lower = *at_lower > 0;
    }
    if (!range.upper.exact) {
      const std::optional<int> at_lower = side_of(range.upper, all.lower);
      if (!at_lower) return std::nullopt;
      if (*at_lower < 0) break;
      const std::optional<int> at_upper = side_of(range.upper, *all.upper);
      if (!at_upper) return std::nullopt;
      p.to_upper = *at_upper < 0;
    }
    result.push_back(std::move(p));
  }
  return result;
}

/// The integral over a panel, or over the part of it that is in the range, and which part that was.
struct panel_value {
  ball value;
  piece_done done;
};

/// z as an integer in units of 2^-F.
struct fixed_point_number {
  integer value;
  magnitude error;  // of z
};
fixed_point_number in_fixed_point(const ball& z, long f) {
  fixed_point_number result;
  ball units;
  scale(units, z.with_precision(f + 64), f);
  detail::mpfr_cell middle(f + 64);
  units.midpoint(middle.get());
  mpfr_get_z(result.value.backend().data(), middle.get(), MPFR_RNDN);
  result.error = scale((units - ball(result.value, f + 64)).magnitude_upper(), -f);
  return result;
}

/// G(z) = sum of e_n z^n / (n + p + 1), at one z with |z| <= 1, term by term.
class antiderivative {
 public:
  antiderivative(fixed_point_number z, long f) : z_(std::move(z)), f_(f) {
    mpz_setbit(power_.backend().data(), static_cast<mp_bitcnt_t>(f));
  }
  /// b_n = e_n / (n + p + 1), for n = 0, 1, ...
  void add(const integer& b) {
    mpz_ptr term = term_.backend().data();
    mpz_ptr power = power_.backend().data();
    const auto shift = static_cast<mp_bitcnt_t>(f_);
    mpz_mul(term, b.backend().data(), power);
    mpz_tdiv_q_2exp(term, term, shift);
    sum_ += term_;
    mpz_mul(power, power, z_.value.backend().data());
    mpz_tdiv_q_2exp(power, power, shift);
  }
  [[nodiscard]] const integer& sum() const { return sum_; }
  [[nodiscard]] const magnitude& error_of_z() const { return z_.error; }

 private:
  fixed_point_number z_;
  long f_;
  integer power_;  // z^n
  integer term_;
  integer sum_;
};

/// The real or the imaginary part of a series, and of its integral.
struct series_part {
  std::vector<integer> a;   // the last of the a_n, in a ring
  integer at_plus;          // the sum of the b_n, which is G(1)
  integer at_minus;         // G(-1)
  integer sum_of_sizes;     // of the |e_n|
  std::size_t longest = 0;  // of the b_n, in bits
  std::optional<antiderivative> at_low;
  std::optional<antiderivative> at_high;

  /// b_n, and for sums that are cut off e_n, at least.
  void add(const integer& b, integer& e, long n, bool is_cut) {
    at_plus += b;
    if (!is_cut) return;
    if (n % 2 == 0) {
      at_minus += b;
    } else {
      at_minus -= b;
    }
    if (at_low) at_low->add(b);
    if (at_high) at_high->add(b);
    longest = std::max(longest, mpz_sizeinbase(b.backend().data(), 2));
    mpz_abs(e.backend().data(), e.backend().data());
    sum_of_sizes += e;
  }
};

/// The integral of P h over one panel.
class panel_integral {
 public:
  panel_integral(const smooth_range& range, const taylor_panel& panel)
      : range_(range), panel_(panel) {}

  /// To about 2^log2_goal. Returns nullopt where the theorem's hypotheses are not proved, or where it takes more bits or
  /// terms than allowed.
  std::optional<panel_value> to(double log2_goal, precision most_bits, long most_terms) {
    if (!is_prepared_ && !prepare()) return std::nullopt;
    const ball size = constant(64) * maximum_ * length_factor();
    const double_interval log2_greatest = log_greatest_ / log_of_2;
    const double log2_size = approximate_log2(size.magnitude_upper()) + log2_greatest.upper();
    if (!(log2_size < 1e15)) return std::nullopt;
    if (log2_size <= log2_goal) {
      // A bound over the whole panel is one over each part of it.
      const magnitude most = multiply_up(size.magnitude_upper(), power_of_two_above(log2_greatest));
      return panel_value{ball(0, 64).enlarged(most), panel_.piece()};
    }
    const double lost = ((log_greatest_ - log_least_ - log_least_q_) / log_of_2).upper();
    const double bits = approximate_log2(size.magnitude_upper()) + lost - log2_goal + 5;
    const double log2_terms = std::log2(std::max(bits, 16.0)) + 1;
    // Only a cut panel's powers of z add up to errors of the square of the number of terms.
    const double f = std::ceil(std::max(bits + (panel_.is_cut() ? 2 : 1) * log2_terms, 64.0));
    if (!(f < static_cast<double>(most_bits))) return std::nullopt;
    const std::optional<ball> value =
        sum(static_cast<long>(f), std::max(static_cast<long>(log2_size - log2_goal) + 32, 64L),
            most_terms);
    if (!value) return std::nullopt;
    return panel_value{*value, panel_.piece()};
  }
  [[nodiscard]] long terms() const { return terms_; }
  [[nodiscard]] long bits() const { return bits_; }

 private:
  struct local_factor {
    local_polynomial p;
    rational exponent;
  };

  bool prepare() {
    power_ = 0;
    for (const factor& f : range_.factors) {
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

  /// p(c + r z), where p has rational coefficients; the content is positive.
  [[nodiscard]] local_polynomial local(const rational_polynomial& p) const {
    integer below = 1;
    for (const rational& c : p.coefficients()) below = lcm(below, denominator(c));
    local_polynomial result =
        at_panel(p * rational_polynomial({rational(below)}), panel_.centre, panel_.radius);
    result.content /= rational(below);
    return result;
  }

  /// Bounds of log g, and of log(Q/q_0) from below.
  bool prepare_bounds() {
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

  /// Q and S, with integer coefficients without a common factor.
  void prepare_recurrence() {
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
  /// Adds p' to the quotient of S's part by Q.
  void add_derivative(const local_polynomial& p, integers& part) {
    integers sum = product(derivative(p.coefficients), q_);
    multiply_by(sum, numerator(p.content));
    for (integers* all : {&q_, &s_, &t_}) multiply_by(*all, denominator(p.content));
    add_to(part, sum);
  }

  /// |r| times the factors at z = 0, that of P among them, with p bits.
  [[nodiscard]] ball constant(precision p) const {
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
  /// The integral of |z|^p over the panel.
  [[nodiscard]] ball length_factor() const {
    return panel_.at_end ? ball(rational(1 / (power_ + 1)), 64) : ball(2, 64);
  }

  /// z of the range's end.
  [[nodiscard]] ball coordinate(const range_end& end, precision p) const {
    return (end.value(p) - panel_.centre) / ball(panel_.radius, p);
  }

  /// The integral, with terms in units of 2^-f and a result of p bits.
  std::optional<ball> sum(long f, precision p, long most_terms) {
    bits_ = f;
    std::optional<ball> low;  // where it is cut off, in z
    std::optional<ball> high;
    const precision bits = f + 32;
    const bool falls = panel_.radius < 0;
    if (panel_.from_lower) (falls ? high : low) = coordinate(range_.lower, bits);
    if (panel_.to_upper) (falls ? low : high) = coordinate(range_.upper, bits);
    // The real part and, where g is complex, the imaginary one.
    const std::size_t parts = phase_.coefficients.empty() ? 1 : 2;
    std::vector<series_part> part(parts);
    for (series_part& own : part) {
      for (const auto& [z, at] : {std::pair(&low, &own.at_low), std::pair(&high, &own.at_high)}) {
        if (!*z) continue;
        fixed_point_number number = in_fixed_point(**z, f);
        const bool is_inside =
            (*z)->magnitude_upper() <= magnitude::power_of_two(0) &&
            mpz_sizeinbase(number.value.backend().data(), 2) <= static_cast<std::size_t>(f);
        if (!is_inside || (panel_.at_end && !certainly_positive(**z))) return std::nullopt;
        at->emplace(std::move(number), f);
      }
    }
    const bool is_cut = low || high;

    // p = above/below
    constexpr long greatest = 1L << 31;
    if (denominator(power_) > greatest || abs(numerator(power_)) > greatest) return std::nullopt;
    const auto above = static_cast<long>(numerator(power_));
    const auto below = static_cast<unsigned long>(denominator(power_));
    // a_n and e_n = sum of P_k a_(n-k), until all that are looked back at are 0.
    const std::size_t depth = std::max({q_.size() - 1, s_.size(), t_.size()});
    const std::size_t looked_at = std::max(depth, numerator_.coefficients.size());
    const std::size_t ring = looked_at + 1;
    for (series_part& own : part) own.a.resize(ring);
    mpz_setbit(part[0].a[0].backend().data(), static_cast<mp_bitcnt_t>(f));
    // The real part of s_k - (n - k) q_(k+1), for the n of the step.
    std::vector<integer> c(depth);
    for (std::size_t k = 0; k < depth; ++k) {
      if (k < s_.size()) c[k] = s_[k];
      if (k + 1 < q_.size()) c[k] += q_[k + 1] * static_cast<long>(k);
    }
    std::vector<integer> step(depth);  // of c from one n to the next
    for (std::size_t k = 0; k < depth && k + 1 < q_.size(); ++k) step[k] = q_[k + 1];
    const integers& of_p = numerator_.coefficients;
    std::vector<integer> next(parts);
    integer e;
    integer b;
    integer divisor;
    std::size_t zeros = 0;
    std::size_t newest = 0;
    // A series that converges takes no such terms, or less than so many.
    const auto most_limbs = static_cast<std::size_t>(2 * f / GMP_NUMB_BITS + 32);
    most_terms = std::min(most_terms, 8 * f + 500);
    long n = 0;
    for (;; ++n) {
      const auto before = [&](const series_part& own, std::size_t back) -> mpz_srcptr {
        return own.a[newest >= back ? newest - back : newest + ring - back].backend().data();
      };
      const std::size_t known = std::min(static_cast<std::size_t>(n) + 1, looked_at);
      mpz_ptr const sum = e.backend().data();
      if (panel_.at_end || is_cut || n % 2 == 0) {
        // b_n = e_n / (n + p + 1)
        const auto by = static_cast<unsigned long>(above + static_cast<long>(below) * (n + 1));
        for (series_part& own : part) {
          mpz_set_ui(sum, 0);
          for (std::size_t k = 0; k < std::min(of_p.size(), known); ++k) {
            mpz_addmul(sum, before(own, k), of_p[k].backend().data());
          }
          if (below != 1) mpz_mul_ui(sum, sum, below);
          mpz_tdiv_q_ui(b.backend().data(), sum, by);
          own.add(b, e, n, is_cut);
        }
      }
      if (zeros >= looked_at) break;
      if (n >= most_terms) return std::nullopt;
      // a_(n+1)
      mpz_mul_ui(divisor.backend().data(), q_[0].backend().data(),
                 static_cast<unsigned long>(n) + 1);
      bool is_zero = true;
      for (std::size_t i = 0; i < parts; ++i) {
        mpz_set_ui(sum, 0);
        for (std::size_t k = 0; k < std::min(depth, known); ++k) {
          mpz_addmul(sum, before(part[i], k), c[k].backend().data());
        }
        for (std::size_t k = 0; k < std::min(t_.size(), known); ++k) {
          // i t_k times the other part
          (i == 0 ? mpz_submul : mpz_addmul)(sum, before(part[1 - i], k), t_[k].backend().data());
        }
        mpz_tdiv_q(next[i].backend().data(), sum, divisor.backend().data());
        if (mpz_size(next[i].backend().data()) > most_limbs) return std::nullopt;
        is_zero = is_zero && mpz_sgn(next[i].backend().data()) == 0;
      }
      zeros = is_zero ? zeros + 1 : 0;
      for (std::size_t k = 0; k < depth; ++k) {
        mpz_sub(c[k].backend().data(), c[k].backend().data(), step[k].backend().data());
      }
      newest = newest + 1 == ring ? 0 : newest + 1;
      for (std::size_t i = 0; i < parts; ++i) {
        mpz_swap(part[i].a[newest].backend().data(), next[i].backend().data());
      }
    }
    terms_ = n + 1;

    // The errors, in z: of A for g, and of the sums' terms, at most two units each; those of powers of z, which are off
    // by at most n units, and of z.
    const magnitude unit = magnitude::power_of_two(-f);
    const magnitude count = magnitude::from_integer_up(static_cast<std::uint64_t>(terms_));
    const magnitude relative =
        power_of_two_above((log_greatest_ - log_least_ - log_least_q_) / log_of_2);
    const magnitude square_of_count = multiply_up(count, count);
    // N, or sqrt(2) N < 3/2 N
    const magnitude steps = parts == 1 ? count : scale(multiply_up(count, three), -1);
    const magnitude of_a = multiply_up(steps, multiply_up(unit, relative));
    const magnitude of_series = multiply_up(multiply_up(of_a, maximum_.magnitude_upper()),
                                            length_factor().magnitude_upper());
    const magnitude of_terms = scale(multiply_up(count, unit), 1);
    const auto from_units = [&](const integer& units, const magnitude& error) {
      ball value(units, p);
      scale(value, value, -f);
      return value.enlarged(error);
    };
    const auto value_of = [&](const series_part& own) {
      const auto at = [&](const std::optional<antiderivative>& cut, const ball& z) {
        const magnitude of_powers =
            multiply_up(multiply_up(square_of_count, unit),
                        magnitude::power_of_two(std::max(0L, static_cast<long>(own.longest) - f)));
        const magnitude size = scale(ball(own.sum_of_sizes, 64).magnitude_upper(), -f);
        const ball value = from_units(
            cut->sum(), add_up(of_terms, add_up(of_powers, multiply_up(size, cut->error_of_z()))));
        const ball power = z.with_precision(p);
        return value * (power_ == 0 ? power : power_of_positive(power, rational(power_ + 1)));
      };
      if (!is_cut && !panel_.at_end) return from_units(own.at_plus * 2, scale(of_terms, 1));
      ball value = own.at_high ? at(own.at_high, *high) : from_units(own.at_plus, of_terms);
      if (own.at_low) {
        value = value - at(own.at_low, *low);
      } else if (!panel_.at_end) {
        value = value + from_units(own.at_minus, of_terms);
      }
      return value;
    };
    const ball real = value_of(part[0]).enlarged(of_series);
    if (parts == 1) return real * constant(p);
    // The part of (real + i imaginary) e^(i t(c)) that is meant.
    const ball imaginary = value_of(part[1]).enlarged(of_series);
    const ball angle(rational(phase_.coefficients.front() * phase_.content), p);
    const ball result = range_.is_sine ? real * sin(angle) + imaginary * cos(angle)
                                       : real * cos(angle) - imaginary * sin(angle);
    return result * constant(p);
  }

  inline static const double_interval log_of_2 = log(double_interval(2));
  inline static const magnitude three = magnitude::from_integer_up(3);

  const smooth_range& range_;
  const taylor_panel& panel_;
  bool is_prepared_ = false;
  std::vector<local_factor> factors_;
  local_polynomial numerator_;
  local_polynomial exponent_;
  local_polynomial phase_;
  rational power_ = 0;  // p
  ball maximum_;        // of |P|, an upper bound
  double_interval log_least_;
  double_interval log_greatest_;
  double_interval log_least_q_;
  integers q_;
  integers s_;
  integers t_;  // the imaginary part of S
  long terms_ = 0;
  long bits_ = 0;
};

/// A root of one of the factors, to search with.
struct approximate_root {
  std::complex<double> at;
  double exponent = 0;
};

/// By Aberth's iteration, in doubles: a guess at where the function is singular.
std::vector<std::complex<double>> approximate_roots(const rational_polynomial& p) {
  using complex = std::complex<double>;
  const auto n = static_cast<std::size_t>(p.degree());
  std::vector<complex> c;
  for (const rational& x : p.coefficients()) {
    c.emplace_back(approximately(rational(x / p.leading())));
  }
  if (n == 1) return {-c[0]};
  if (n == 2) {
    const complex root = std::sqrt(c[1] * c[1] - 4.0 * c[0]);
    const complex larger = (std::real(c[1]) > 0 ? -c[1] - root : -c[1] + root) / 2.0;
    return {larger, larger == 0.0 ? 0.0 : c[0] / larger};
  }
  double bound = 0;  // Fujiwara's
  for (std::size_t k = 0; k < n; ++k) {
    bound = std::max(bound, std::pow(std::abs(c[k]), 1.0 / static_cast<double>(n - k)));
  }
  std::vector<complex> roots;
  for (std::size_t k = 0; k < n; ++k) {
    const double angle = 6.2831853 * static_cast<double>(k) / static_cast<double>(n) + 0.7;
    const double size = bound * (0.5 + 0.5 * static_cast<double>(k + 1) / static_cast<double>(n));
    roots.emplace_back(size * std::cos(angle), size * std::sin(angle));
  }
  for (int step = 0; step < 100; ++step) {
    double moved = 0;
    for (std::size_t k = 0; k < n; ++k) {
      complex value = 0;
      complex slope = 0;
      for (std::size_t j = n + 1; j-- > 0;) {
        slope = slope * roots[k] + value;
        value = value * roots[k] + c[j];
      }
      if (value == 0.0) continue;
      complex others = 0;
      for (std::size_t j = 0; j < n; ++j) {
        if (j != k && roots[j] != roots[k]) others += 1.0 / (roots[k] - roots[j]);
      }
      const complex newton = value / slope;
      const complex change = newton / (1.0 - newton * others);
      if (!std::isfinite(std::abs(change))) continue;
      roots[k] -= change;
      moved = std::max(moved, std::abs(change) / (std::abs(roots[k]) + 1e-300));
    }
    if (moved < 1e-12) break;
  }
  return roots;
}

/// The panels that cover a range, chosen in doubles.
class panel_choice {
 public:
  panel_choice(const smooth_range& range, double bits)
      : range_(range), bits_(bits), ratio_(bits < 600 ? 0.58 : 0.5) {}

  /// The roots; false where they are not found.
  bool prepare() {
    for (const factor& f : range_.factors) {
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
  /// Nothing where the range is not understood.
  std::optional<std::vector<taylor_panel>> panels() {
    if (!prepare()) return std::nullopt;
    const double low = approximately(range_.lower.value(64));
    const double high = approximately(range_.upper.value(64));
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

  /// About log2 of the greatest contribution of a panel.
  [[nodiscard]] double log2_of_size(const std::vector<taylor_panel>& panels) const {
    double size = -1e18;
    for (const taylor_panel& p : panels) {
      const double c = approximately(p.centre);
      const double r = approximately(p.radius);
      for (const double z : {-0.9, -0.5, 0.0, 0.5, 0.9}) {
        if (p.at_end && z <= 0) continue;
        const double value = log2_at(c + r * z) + std::log2(std::abs(r));
        if (value < 1e17) size = std::max(size, value);
      }
    }
    return size;
  }
  /// About log2 |P h|.
  [[nodiscard]] double log2_at(double y) const {
    double numerator = 0;
    for (std::size_t k = numerator_.size(); k-- > 0;) numerator = numerator * y + numerator_[k];
    return (log_size({y, 0}, std::nullopt) + log_of_constant_ + std::log(std::abs(numerator))) /
           std::log(2.0);
  }

 private:
  struct end {
    rational at;
    bool is_singular = false;
  };

  [[nodiscard]] bool is_singular_at(const rational& y) const {
    return std::any_of(range_.factors.begin(), range_.factors.end(),
                       [&](const factor& f) { return f.base(y) == 0; });
  }
  /// The range is singular at y, and integrable there.
  [[nodiscard]] bool is_integrable_at(const rational& y) const {
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
    for (const factor& f : range_.factors) power += multiplicity(f.base) * f.exponent;
    return power > -1;
  }
  /// Where panels begin: at the range's end or, if that is not exact, a little before it, or at the singular point before
  /// it that a series begins at and reaches it from.
  [[nodiscard]] end lower_end(double low, double length) const {
    if (range_.lower.exact) return {*range_.lower.exact, is_singular_at(*range_.lower.exact)};
    if (range_.begins_at_0 && low < ratio_ / 2 * distance(0, rational(0)) && is_integrable_at(0) &&
        low < length_at(0, 1, exactly(low + length))) {
      return {0, true};
    }
    const double unit = unit_of(std::min(distance(low), length), 12);
    return {exactly((std::floor(low / unit) - 1) * unit), false};
  }
  [[nodiscard]] end upper_end(double high, double length) const {
    if (range_.upper.exact) return {*range_.upper.exact, is_singular_at(*range_.upper.exact)};
    if (range_.greatest) {
      const rational& most = *range_.greatest;
      const double y = approximately(most);
      const double rest = y - high;
      if (rest < ratio_ / 2 * distance(y, most) && is_integrable_at(most) &&
          rest < length_at(most, -1, exactly(rest + length))) {
        return {most, is_singular_at(most)};
      }
    }
    const double unit = unit_of(std::min(distance(high), length), 12);
    return {exactly((std::ceil(high / unit) + 1) * unit), false};
  }

  /// From y to the next root, but for those at the given place.
  [[nodiscard]] double distance(double y,
                                const std::optional<rational>& except = std::nullopt) const {
    double least = 1e300;
    for (const approximate_root& root : roots_) {
      if (except && is_at(root, *except)) continue;
      least = std::min(least, std::abs(root.at - y));
    }
    return least;
  }
  /// The root is taken for the exact number.
  [[nodiscard]] static bool is_at(const approximate_root& root, const rational& y) {
    const double x = approximately(y);
    return std::abs(root.at - x) <= 1e-13 * std::abs(x) || (x == 0 && std::abs(root.at) < 1e-290);
  }

  /// log of |h| up to a constant, at a complex y, without the roots at a place.
  [[nodiscard]] double log_size(std::complex<double> y,
                                const std::optional<rational>& except) const {
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
  /// log2 of how much |g| varies on a panel's circle and on the panel.
  [[nodiscard]] double spread(double c, double r, const std::optional<rational>& except) const {
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
    return std::isfinite(most) && std::isfinite(least) ? (most - least) / log_of_2 : 1e18;
  }
  [[nodiscard]] double most_spread() const { return std::max(20.0, bits_ / 4); }

  /// Of a panel that begins at a singular end.
  [[nodiscard]] double length_at(const rational& y, int direction, const rational& all) const {
    const double start = approximately(y);
    const double whole = approximately(all);
    double r = std::min(ratio_ * distance(start, y), whole);
    if (ratio_ * 1.2 * distance(start, y) >= whole) r = whole;
    for (int k = 0; k < 200 && spread(start, direction * r, y) > most_spread(); ++k) r *= 0.75;
    return r;
  }

  /// A number of few bits near r.
  [[nodiscard]] static rational rounded(double r) {
    const double unit = unit_of(r, 3);
    return exactly(std::floor(r / unit) * unit);
  }

  /// Panels from one point to the other, neither of which is singular.
  bool cover(rational from, const rational& to, std::vector<taylor_panel>& panels) const {
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
        next = exactly(std::floor((start + 2 * r) / unit) * unit);
        if (next <= from || next >= to || !(start + 2 * r < goal)) return false;
      }
      panels.push_back(
          {rational((from + next) / 2), rational((next - from) / 2), false, false, false});
      from = next;
    }
    return true;
  }

  const smooth_range& range_;
  double bits_;
  double ratio_;
  std::vector<approximate_root> roots_;
  std::vector<double> exponent_;
  std::vector<double> phase_;
  std::vector<double> numerator_;
  double log_of_constant_ = 0;
};

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
range_end inverse(const range_end& y) {
  range_end w;
  if (y.is_infinite) {
    w.exact = 0;
  } else if (y.exact) {
    w.exact = rational(1) / *y.exact;
  } else {
    w.at = [at = y.at](precision p) { return 1 / at(p); };
  }
  return w;
}

/// The same integral over w = 1/y; s must be constant, t 0, and the range one of y > 0.
smooth_range inverted(const smooth_range& range) {
  smooth_range result;
  rational power = -2 - range.numerator.degree();  // dy = -dw/w^2
  result.numerator = reversed(range.numerator);
  result.exponent = range.exponent;
  for (const factor& f : range.factors) {
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

/// The coefficients of (1 + w)^n p(inner + (outer - inner) w/(1 + w)), n the degree; of p(inner + w) where outer is infinite.
/// Where all have one sign, or are 0, p has that sign between the two, or is 0.
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

/// A bound of the integral between two points, between which the integrand falls from the inner to the outer; outer is
/// infinite where it is not given. Nothing where none is proved.
///
/// With P^ >= |P|, of the absolute values of P's coefficients, y >= 0, let |(log (P^ h))'| be at least lambda > 0 between
/// the two, with the sign that makes P^ h fall. Then P^ h is at most (P^ h)(inner) e^(-lambda |y - inner|), and its integral
/// at most (P^ h)(inner)/lambda. With Q the product of the p_i and d the direction, the condition is that
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
  for (const factor& f : range.factors) {
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
  const rational lambda = exactly(slope / 2);
  const rational_polynomial condition =
      sum * rational_polynomial({rational(direction)}) + all * rational_polynomial({lambda});
  for (const rational& c : coefficients_between(condition, inner, outer)) {
    if (c > 0) return std::nullopt;
  }
  return bound * exp(ball(range.exponent(inner), 64)) / ball(lambda, 64);
}

/// A part of a range, and a ball that holds its integral.
struct bounded_part {
  ball value;
  piece_done done;
  closed_interval within;
};
/// The finite ranges that a range is made up of, and what is left out.
struct finite_ranges {
  std::vector<smooth_range> ranges;
  std::vector<bounded_part> rests;
};

/// The greatest absolute value of a root, about; 0 where all roots are 0.
double size_of_roots(const smooth_range& range) {
  double size = 0;
  for (const factor& f : range.factors) {
    for (const std::complex<double>& root : approximate_roots(f.base)) {
      if (std::isfinite(std::abs(root))) size = std::max(size, std::abs(root));
    }
  }
  return size;
}

/// Without what is too small to count for so many bits. Nothing where no end of an infinite range is found.
std::optional<finite_ranges> cut_off(smooth_range range, double bits) {
  panel_choice choice(range, bits);
  if (!choice.prepare()) return std::nullopt;
  const auto size = [&](double y) { return choice.log2_at(y); };
  const double low = approximately(range.lower.value(64));
  const double high = range.upper.is_infinite ? 1e300 : approximately(range.upper.value(64));
  // The greatest values, in doubles: at the ends and where the logarithmic derivative is 0.
  rational_polynomial q({rational(1)});
  rational_polynomial slope = range.numerator.derivative();
  for (const factor& f : range.factors) {
    slope = slope * f.base +
            range.numerator * q * f.base.derivative() * rational_polynomial({f.exponent});
    q = q * f.base;
  }
  slope = slope + range.exponent.derivative() * range.numerator * q;
  std::vector<double> peaks{low};
  if (!range.upper.is_infinite) peaks.push_back(high);
  if (slope.degree() > 0) {
    for (const std::complex<double>& y : approximate_roots(slope)) {
      const bool is_real = std::abs(y.imag()) <= 1e-6 * std::abs(y.real());
      if (is_real && y.real() > low && y.real() < high) peaks.push_back(y.real());
    }
  }
  if (!(size(low) < 1e17)) {  // singular there
    const double length = range.upper.is_infinite ? 1 : high - low;
    for (int k = 1; k <= 60; ++k) peaks.push_back(low + std::ldexp(length, -k));
  }
  std::sort(peaks.begin(), peaks.end());
  double greatest = -1e18;
  for (const double y : peaks) {
    const double value = size(y);
    if (!(value > greatest) || value > 1e17) continue;
    // How far it is until half of the value.
    double width = std::max(std::abs(y), 1e-3);
    while (width > 1e-300 && size(y + width) < value - 1 && size(y - width) < value - 1) width /= 2;
    greatest = std::max(greatest, value + std::min(std::log2(width), 0.0));
  }
  const double least = greatest - bits - 10;
  // From the first and the last peak that counts outward, to where it does not any more.
  const auto counts = [&](double y) { return size(y) >= least; };
  const auto first = std::find_if(peaks.begin(), peaks.end(), counts);
  const auto last = std::find_if(peaks.rbegin(), peaks.rend(), counts);
  if (first == peaks.end() || last == peaks.rend()) return std::nullopt;
  const auto crossing = [&](double inside, double outside) {
    for (int k = 0; k < 60; ++k) {
      const double middle = (inside + outside) / 2;
      (counts(middle) ? inside : outside) = middle;
    }
    return outside;
  };
  finite_ranges result;
  // What lies beyond t in the range, of which this is a bound, is left out.
  const auto leave_out_above = [&](const rational& t, const ball& bound) {
    result.rests.push_back({ball(0, 64).enlarged(bound.magnitude_upper()),
                            {place(t), place::upper_end()},
                            {t, range.upper.exact}});
    range.upper = exact_end(t);
  };
  const auto leave_out_below = [&](const rational& t, const ball& bound) {
    result.rests.push_back({ball(0, 64).enlarged(bound.magnitude_upper()),
                            {place::lower_end(), place(t)},
                            {*range.lower.exact, t}});
    range.lower = exact_end(t);
  };
  const auto is_small = [&](const std::optional<ball>& bound) {
    return bound && approximate_log2(bound->magnitude_upper()) <= greatest - bits;
  };
  // A short number, not nearer to the peak than y.
  const auto short_number = [](double y, double peak) {
    const double unit = unit_of(std::abs(y - peak), 6);
    return exactly((y > peak ? std::ceil(y / unit) : std::floor(y / unit)) * unit);
  };
  // A short way is not worth a proof.
  constexpr double much = 40;
  if (range.upper.is_infinite) {
    double outside = std::max(std::abs(*last), 1e-3);
    while (outside < 1e100 && counts(*last + outside)) outside *= 2;
    double step = crossing(*last, *last + outside) - *last;
    for (int k = 0;; ++k, step *= 1.1) {
      if (k == 60) return std::nullopt;
      const rational t = short_number(*last + step, *last);
      const std::optional<ball> bound = bound_by_slope(range, t, std::nullopt);
      if (!is_small(bound)) continue;
      leave_out_above(t, *bound);
      break;
    }
  } else if (range.upper.exact && size(high) < least - much) {
    const double y = crossing(*last, high);
    const rational t = short_number(y, *last);
    const std::optional<ball> bound = bound_by_slope(range, t, range.upper.exact);
    if (t < *range.upper.exact && t > exactly(*last) && is_small(bound)) {
      leave_out_above(t, *bound);
    }
  }
  if (range.lower.exact && *first > low && size(low) < least - much) {
    const double y = crossing(*first, low);
    const rational t = short_number(y, *first);
    const std::optional<ball> bound = bound_by_slope(range, t, range.lower.exact);
    if (t > *range.lower.exact && t < exactly(*first) && is_small(bound)) {
      leave_out_below(t, *bound);
    }
  }
  result.ranges.push_back(std::move(range));
  return result;
}

/// The ranges of an integral, for so many bits; without the function's constant.
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
  for (const factor& f : range.factors) degree += f.base.degree();
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
                                    [](const factor& f) { return abs(f.exponent) >= 16; });
  if (is_steep && (range.exponent.degree() >= 1 || !range.upper.is_infinite)) {
    if (range.upper.is_infinite && !range.lower.exact) return std::nullopt;
    return cut_off(std::move(range), bits);
  }
  if (range.phase.degree() >= 0) {
    if (range.upper.is_infinite) return std::nullopt;
    result.ranges.push_back(std::move(range));
    return result;
  }
  // Far out, over 1/y.
  const double low = approximately(range.lower.value(64));
  const double high = range.upper.is_infinite ? 1e300 : approximately(range.upper.value(64));
  const double size = size_of_roots(range);
  // Without roots, and but for infinite ranges, one series serves as well.
  const double far = size > 0 ? std::exp2(std::ceil(std::log2(size)) + 1) : std::max(low, 1.0);
  if (!std::isfinite(low) || std::isnan(high) || !std::isfinite(far)) return std::nullopt;
  const bool is_far = range.upper.is_infinite || (size > 0 && high > 16 * std::max(far, low));
  if (!is_far) {
    result.ranges.push_back(std::move(range));
    return result;
  }
  if (low < far / 2) {
    const rational cut = exactly(far);
    smooth_range near = range;
    near.upper = exact_end(cut);
    result.ranges.push_back(std::move(near));
    range.lower = exact_end(cut);
  }
  const bool may_be_inverted = range.exponent.degree() <= 0 && range.phase.is_zero() &&
                               certainly_positive(range.lower.value(128));
  if (!may_be_inverted) return std::nullopt;
  result.ranges.push_back(inverted(range));
  return result;
}

/// One attempt at the sum of all parts.
class taylor_sum {
 public:
  taylor_sum(const formula& f, const std::vector<hyperexponential_integral>& parts,
             const integrate_options& options)
      : f_(f), parts_(parts), options_(options) {}

  /// To about 2^-bits of the greatest part, or to the absolute goal. Returns nullopt where it is not found, or where the
  /// pieces are not proved to tile their ranges.
  std::optional<ball> to(double bits) {
    struct covered_range {
      const smooth_range* range;
      std::vector<taylor_panel> panels;
    };
    std::vector<finite_ranges> prepared;
    std::vector<std::vector<covered_range>> covered;
    std::vector<double> log2_constants;
    double size = -1e18;
    for (const hyperexponential_integral& part : parts_) {
      const hyperexponential& h = part.function;
      if (h.coefficient == 0) return std::nullopt;
      const double constant = approximate_log2(h.constant(f_, 64).magnitude_upper());
      if (!(std::abs(constant) < 1e17)) return std::nullopt;
      log2_constants.push_back(constant);
      auto one = ranges_of(part, bits);
      if (!one) return std::nullopt;
      prepared.push_back(std::move(*one));
    }
    long count = 0;
    for (std::size_t i = 0; i < prepared.size(); ++i) {
      covered.emplace_back();
      for (const smooth_range& range : prepared[i].ranges) {
        panel_choice choice(range, bits);
        auto panels = choice.panels();
        if (!panels) return std::nullopt;
        size = std::max(size, log2_constants[i] + choice.log2_of_size(*panels));
        count += static_cast<long>(panels->size());
        covered.back().push_back({&range, std::move(*panels)});
      }
    }
    if (!(std::abs(size) < 1e15)) return std::nullopt;
    double goal = size - bits;
    if (options_.absolute_exponent) {
      goal = std::max(goal, static_cast<double>(*options_.absolute_exponent) - 2);
    }
    goal -= std::log2(static_cast<double>(count)) + 1;
    const auto result_bits = static_cast<precision>(std::max(size - goal, 0.0)) + 64;
    const precision most_bits =
        options_.most_precision.value_or(static_cast<precision>(64 * (bits + 64)));
    ball total(0, result_bits);
    for (std::size_t i = 0; i < prepared.size(); ++i) {
      const double own_goal = goal - log2_constants[i];
      tiled_sum<ball> of_part(parts_[i].lower, parts_[i].upper, ball(0, result_bits));
      for (const bounded_part& rest : prepared[i].rests) {
        of_part.add(rest.done, rest.within, rest.value.with_precision(result_bits));
      }
      for (const covered_range& own : covered[i]) {
        const smooth_range& range = *own.range;
        tiled_sum<ball> of_range(range.lower, range.upper, ball(0, result_bits));
        for (const taylor_panel& panel : own.panels) {
          if (!add_panel(of_range, range, panel, own_goal, most_bits, 0)) return std::nullopt;
        }
        const std::optional<ball> value = of_range.total();
        if (!value) return std::nullopt;
        of_part.add_tiled(range.piece(), *value);
      }
      const std::optional<ball> value = of_part.total();
      if (!value) return std::nullopt;
      total += *value * parts_[i].function.constant(f_, result_bits);
    }
    if (!total.is_bounded()) return std::nullopt;
    return total;
  }
  [[nodiscard]] const integral_account& account() const { return account_; }

 private:
  /// Adds the integral over a panel, by its halves where that is needed. Returns false where it is not found.
  bool add_panel(tiled_sum<ball>& sum, const smooth_range& range, const taylor_panel& panel,
                 double goal, precision most_bits, int depth) {
    panel_integral own(range, panel);
    const long left = options_.most_evaluations - account_.terms;
    if (const std::optional<panel_value> found = own.to(goal, most_bits, left)) {
      sum.add(found->done, panel.interval(), found->value);
      ++account_.panels;
      account_.terms += own.terms();
      account_.most_nodes = std::max(account_.most_nodes, own.terms());
      account_.precision = std::max<precision>(account_.precision, own.bits());
      return true;
    }
    constexpr int deepest = 8;
    if (depth >= deepest || left <= 0) return false;
    const auto halves = cut_to(range, halves_of(panel));
    return halves && std::all_of(halves->begin(), halves->end(), [&](const taylor_panel& half) {
             return add_panel(sum, range, half, goal - 1, most_bits, depth + 1);
           });
  }
  /// In the order of y.
  [[nodiscard]] static std::vector<taylor_panel> halves_of(const taylor_panel& p) {
    const rational half = p.radius / 2;
    if (!p.at_end) return {{p.centre - half, half}, {p.centre + half, half}};
    const taylor_panel inner{p.centre, half, true};
    const rational quarter = abs(rational(half / 2));
    const taylor_panel outer{p.centre + half + half / 2, quarter};
    return p.radius > 0 ? std::vector{inner, outer} : std::vector{outer, inner};
  }

  const formula& f_;
  const std::vector<hyperexponential_integral>& parts_;
  const integrate_options& options_;
  integral_account account_;
};

}  // namespace

std::optional<integral> integrate_by_taylor_series(const integrand& f, const limit& a,
                                                   const limit& b,
                                                   const integrate_options& options) {
  if (!f.record) return std::nullopt;
  const auto start = clock::now();
  const formula recorded(f.record);
  const auto parts = hyperexponential_parts(recorded, a, b);
  if (!parts || parts->empty()) return std::nullopt;
  const double digits = static_cast<double>(options.digits) * std::log2(10.0);
  double bits = digits + 6;
  for (int attempts = 0; attempts < 4; ++attempts) {
    taylor_sum sum(recorded, *parts, options);
    const std::optional<ball> value = sum.to(bits);
    if (!value) return std::nullopt;
    const magnitude radius = value->radius();
    const bool is_reached =
        multiply_up(radius, pow(ball(10, 64), options.digits).magnitude_upper()) <=
            value->magnitude_lower() ||
        (options.absolute_exponent &&
         radius <= magnitude::power_of_two(*options.absolute_exponent));
    if (is_reached) {
      integral result;
      result.enclosure = *value;
      result.verdict = status::certified;
      result.account = sum.account();
      result.account.rules = {quadrature_rule::taylor_series};
      result.account.seconds_for_sums = std::chrono::duration<double>(clock::now() - start).count();
      return result;
    }
    // The value is smaller than its parts, or their bounds are larger than was expected.
    const double missing =
        approximate_log2(radius) + digits - approximate_log2(value->magnitude_upper());
    if (!(missing < digits + 64)) return std::nullopt;
    bits += std::max(missing, 0.0) + 8;
  }
  return std::nullopt;
}

}  // namespace polhode::detail
