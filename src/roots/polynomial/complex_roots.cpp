#include "polhode/roots/complex_roots.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "complex_values.hpp"
#include "polhode/arithmetic/boost_bridge.hpp"
#include "polhode/arithmetic/double_interval.hpp"
#include "polhode/arithmetic/interval.hpp"
#include "polhode/arithmetic/text.hpp"
#include "real_roots.hpp"
#include "root_bracket.hpp"

namespace polhode {
namespace detail {
namespace {

// What is computed with this type is a guess of a root; nothing rests on it.
using approximate = std::complex<long double>;

constexpr long bits_at_start = 128;
constexpr long most_bits = 1L << 17;

integer rounded(long double x, long bits) {
  int exponent = 0;
  const long double fraction = std::frexp(x, &exponent);
  constexpr int digits = 62;
  const auto whole = static_cast<long>(std::ldexp(fraction, digits));
  const long shift = bits + exponent - digits;
  const integer n(whole);
  return shift >= 0 ? integer(n << static_cast<unsigned long>(shift))
                    : integer(n >> static_cast<unsigned long>(-shift));
}

fixed_point fixed_point_near(approximate z, long bits) {
  fixed_point r;
  r.is_reciprocal = std::abs(z) > 1;
  const approximate u = r.is_reciprocal ? 1.0L / z : z;
  r.re = rounded(u.real(), bits);
  r.im = rounded(u.imag(), bits);
  return r;
}

/// n as fraction times 2^exponent.
struct scaled {
  long double fraction = 0;
  long exponent = 0;
};
scaled scaled_from(const integer& n) {
  scaled r;
  r.fraction = mpz_get_d_2exp(&r.exponent, n.backend().data());
  return r;
}
/// (re + i im) 2^-exponent, with the exponent that makes the greater part about 1.
approximate normalised(const integer& re, const integer& im, long& exponent) {
  const scaled x = scaled_from(re);
  const scaled y = scaled_from(im);
  exponent = re == 0 ? y.exponent : (im == 0 ? x.exponent : std::max(x.exponent, y.exponent));
  const auto part = [&](const scaled& s) {
    return s.fraction == 0
               ? 0.0L
               : std::ldexp(s.fraction, static_cast<int>(std::max(s.exponent - exponent, -300L)));
  };
  return {part(x), part(y)};
}
approximate value_of(const integer& re, const integer& im, long bits) {
  long exponent = 0;
  const approximate z = normalised(re, im, exponent);
  const auto e = static_cast<int>(std::clamp(exponent - bits, -16'000L, 16'000L));
  return {std::ldexp(z.real(), e), std::ldexp(z.imag(), e)};
}
approximate quotient(const fixed_value& x, const fixed_value& y) {
  long of_x = 0;
  long of_y = 0;
  const approximate a = normalised(x.re, x.im, of_x);
  const approximate b = normalised(y.re, y.im, of_y);
  if (b == approximate()) return {1, 0};
  const approximate q = a / b;
  const auto e = static_cast<int>(std::clamp(of_x - of_y, -16'000L, 16'000L));
  return {std::ldexp(q.real(), e), std::ldexp(q.imag(), e)};
}

/// A root in the upper half-plane that is looked for.
struct guess {
  fixed_point x;
  approximate z;
  bool settled = false;
  magnitude radius;  // of its disc, once that is proved
};

/// The pairs of conjugate roots of a polynomial without multiple and rational roots, not 0 at 0,
/// whose real roots are known.
class pair_search {
 public:
  pair_search(std::vector<integer> p, std::vector<exact_interval> real,
              const std::function<bool()>& go_on)
      : values_(std::move(p)),
        real_values_(values_.coefficients()),
        brackets_(std::move(real)),
        go_on_(go_on) {}

  /// One enclosure of each pair, in the upper half-plane; std::nullopt where go_on returned false
  /// or the bits did not suffice.
  std::optional<std::vector<complex_ball>> run(precision p) && {
    const std::size_t pairs = (static_cast<std::size_t>(values_.degree()) - brackets_.size()) / 2;
    if (pairs == 0) return std::vector<complex_ball>();
    start(pairs);
    place_real_roots();
    if (!improve(true)) return std::nullopt;
    for (;; place_real_roots()) {
      for (guess& g : guesses_) g.settled = false;
      if (!improve(false)) return std::nullopt;
      if (prove()) break;
      if (bits_ > most_bits) return std::nullopt;
      for (guess& g : guesses_) {
        g.x.re <<= static_cast<unsigned long>(bits_);
        g.x.im <<= static_cast<unsigned long>(bits_);
      }
      bits_ *= 2;
      is_first_stage_ = false;
    }
    std::vector<complex_ball> result;
    for (std::size_t i = 0; i < guesses_.size(); ++i) {
      if (!go_on_()) return std::nullopt;
      auto root = narrowed_root(i, p);
      if (!root) return std::nullopt;
      result.push_back(std::move(*root));
    }
    return result;
  }

 private:
  /// Points on circles whose radii are those of Newton's polygon (D. A. Bini, Numerical computation
  /// of polynomial zeros by means of Aberth's method, 1996).
  void start(std::size_t pairs) {
    const std::vector<integer>& c = values_.coefficients();
    std::vector<std::pair<long double, long double>> hull;  // k, log2 |c_k|
    for (std::size_t k = 0; k < c.size(); ++k) {
      if (c[k] == 0) continue;
      const scaled s = scaled_from(c[k]);
      const std::pair<long double, long double> next(
          static_cast<long double>(k),
          std::log2(std::abs(s.fraction)) + static_cast<long double>(s.exponent));
      const auto is_below = [&] {
        const auto& [x0, y0] = hull[hull.size() - 2];
        const auto& [x1, y1] = hull.back();
        return (y1 - y0) * (next.first - x0) <= (next.second - y0) * (x1 - x0);
      };
      while (hull.size() > 1 && is_below()) hull.pop_back();
      hull.push_back(next);
    }
    // Where a long double holds them all, with room.
    if (std::all_of(hull.begin(), hull.end(),
                    [](const auto& corner) { return std::abs(corner.second) < 8'000; })) {
      for (const integer& x : c) rough_.push_back(value_of(x, 0, 0).real());
    }
    std::vector<approximate> above;
    std::vector<approximate> others;
    const auto log2_radius = [&](std::size_t e) {
      return (hull[e - 1].second - hull[e].second) / (hull[e].first - hull[e - 1].first);
    };
    // Bits for the smallest u.
    long double most = 0;
    for (std::size_t e = 1; e < hull.size(); ++e) most = std::max(most, std::abs(log2_radius(e)));
    bits_ += static_cast<long>(most);
    for (std::size_t e = 1; e < hull.size(); ++e) {
      const long double count = hull[e].first - hull[e - 1].first;
      const long double radius = std::exp2(std::clamp(log2_radius(e), -15'000.0L, 15'000.0L));
      for (long double k = 0; k < count; ++k) {
        const long double angle = 2 * std::numbers::pi_v<long double> * (k / count) + 0.7L +
                                  0.3L * static_cast<long double>(e);
        const approximate z = std::polar(radius, angle);
        if (z.imag() > 0) {
          above.push_back(z);
        } else {
          others.push_back(std::conj(z) * std::polar(1.0L, 0.05L));
        }
      }
    }
    above.insert(above.end(), others.begin(), others.end());
    for (std::size_t k = 0; k < pairs; ++k) {
      guess g;
      const approximate z = above[k % above.size()];
      g.x = fixed_point_near({z.real(), std::abs(z.imag())}, bits_);
      g.z = {z.real(), std::abs(z.imag())};
      guesses_.push_back(std::move(g));
    }
  }

  /// Points in the brackets of the real roots, with the bits that there are.
  void place_real_roots() {
    real_points_.clear();
    for (exact_interval& b : brackets_) {
      b = narrowed(real_values_, b, bits_ / 2);
      rational x = b.middle();
      fixed_point point;
      point.is_reciprocal = abs(x) > 1;
      if (point.is_reciprocal) x = 1 / x;
      const integer above = numerator(x) << static_cast<unsigned long>(bits_);
      mpz_fdiv_q(point.re.backend().data(), above.backend().data(), mpq_denref(x.backend().data()));
      real_points_.push_back(std::move(point));
    }
    real_guesses_.clear();
    for (const fixed_point& x : real_points_) real_guesses_.push_back(approximately(x));
  }

  [[nodiscard]] approximate approximately(const fixed_point& x) const {
    const approximate u = value_of(x.re, x.im, bits_);
    return x.is_reciprocal ? 1.0L / u : u;
  }

  /// z/w, 0 for w = 0; faster than the operator, which minds infinities.
  static approximate over(approximate z, approximate w) {
    const long double norm = w.real() * w.real() + w.imag() * w.imag();
    if (norm == 0) return {};
    return {(z.real() * w.real() + z.imag() * w.imag()) / norm,
            (z.imag() * w.real() - z.real() * w.imag()) / norm};
  }

  /// z / (z - w) for two guesses, by their difference where they are near.
  [[nodiscard]] approximate share(const guess& a, const fixed_point& y, bool conjugate,
                                  approximate w) const {
    constexpr long double near = 1e-9L;
    const approximate difference = a.z - w;
    if (std::norm(difference) > near * near * std::norm(a.z) ||
        a.x.is_reciprocal != y.is_reciprocal) {
      return over(a.z, difference);
    }
    const integer im = conjugate ? integer(-y.im) : y.im;
    const approximate exact = value_of(a.x.re - y.re, a.x.im - im, bits_);
    // Of reciprocals u, v: (1/u) / (1/u - 1/v) = v / (v - u).
    return a.x.is_reciprocal ? -over(value_of(y.re, im, bits_), exact)
                             : over(value_of(a.x.re, a.x.im, bits_), exact);
  }

  /// Newton's step relative to z, and whether rounding is all that is left of it.
  struct relative_step {
    approximate step;
    bool is_noise;
  };
  /// Of 1/u the step is that of s, with s(u) / (u s'(u)) in place of p(z) / (z p'(z)).
  [[nodiscard]] approximate step_from(approximate quotient_by_u, bool is_reciprocal) const {
    const auto n = static_cast<long double>(values_.degree());
    return is_reciprocal ? quotient_by_u / (n * quotient_by_u - 1.0L) : quotient_by_u;
  }
  relative_step exact_step(const guess& g) {
    const complex_values::values v = values_.at(g.x, bits_);
    const approximate q = quotient(v.value, v.slope) / value_of(g.x.re, g.x.im, bits_);
    return {step_from(q, g.x.is_reciprocal), v.value.abs_upper() <= scale(v.value.error, 2)};
  }
  [[nodiscard]] relative_step rough_step(const guess& g) const {
    const std::size_t n = rough_.size() - 1;
    const approximate u = value_of(g.x.re, g.x.im, bits_);
    const long double size = std::abs(u);
    approximate value = rough_[g.x.is_reciprocal ? 0 : n];
    approximate slope;
    long double sum = std::abs(value);
    for (std::size_t k = n; k-- > 0;) {
      const long double c = rough_[g.x.is_reciprocal ? n - k : k];
      slope = {slope.real() * u.real() - slope.imag() * u.imag() + value.real(),
               slope.real() * u.imag() + slope.imag() * u.real() + value.imag()};
      value = {value.real() * u.real() - value.imag() * u.imag() + c,
               value.real() * u.imag() + value.imag() * u.real()};
      sum = sum * size + std::abs(c);
    }
    constexpr long double rounding = 1e-18L;
    const approximate q = slope == approximate() ? approximate(1) : value / (slope * u);
    return {step_from(q, g.x.is_reciprocal), std::abs(value) <= rounding * sum};
  }

  /// Aberth's method until all guesses stay where they are, or the bits show no more; first with
  /// few bits, where the coefficients allow it. False where go_on returned false.
  bool improve(bool roughly) {
    if (roughly && rough_.empty()) return true;
    constexpr int most_rounds = 80;
    const long double still =
        roughly || is_first_stage_
            ? 1e-12L
            : std::ldexp(1.0L, -static_cast<int>(std::min(bits_ / 2, 16'000L)));
    for (int round = 0; round < most_rounds; ++round) {
      bool all_settled = true;
      for (guess& g : guesses_) {
        if (g.settled) continue;
        if (!go_on_()) return false;
        const auto [step, is_noise] = roughly ? rough_step(g) : exact_step(g);
        approximate sum;
        for (const guess& other : guesses_) {
          if (&other != &g) sum += share(g, other.x, false, other.z);
          sum += share(g, other.x, true, std::conj(other.z));
        }
        for (std::size_t j = 0; j < real_points_.size(); ++j) {
          sum += share(g, real_points_[j], false, real_guesses_[j]);
        }
        approximate change = step / (1.0L - step * sum);
        if (!std::isfinite(change.real()) || !std::isfinite(change.imag())) change = {0.01L, 0.02L};
        if (std::abs(change) > 0.5L) change *= 0.5L / std::abs(change);
        move(g, change);
        g.settled = is_noise || std::abs(change) < still;
        all_settled = all_settled && g.settled;
      }
      if (all_settled) return true;
    }
    return true;
  }

  /// z becomes z (1 - change).
  void move(guess& g, approximate change) const {
    const approximate z = g.z * (1.0L - change);
    const bool crosses = (std::abs(z) > 1) != g.x.is_reciprocal;
    if (crosses || z.imag() <= 0) {
      g.z = {z.real(), std::max(std::abs(z.imag()), std::abs(z) * 1e-15L)};
      g.x = fixed_point_near(g.z, bits_);
      g.z = approximately(g.x);
      return;
    }
    const approximate u = value_of(g.x.re, g.x.im, bits_);
    const approximate more = g.x.is_reciprocal ? u * change / (1.0L - change) : -u * change;
    g.x.re += rounded(more.real(), bits_);
    g.x.im += rounded(more.imag(), bits_);
    g.z = approximately(g.x);
  }

  /// The theorem's discs: true where each guess has one that meets no other. The real roots are
  /// among the theorem's numbers themselves: their w is 0, and their discs are points. They are
  /// different, as the polynomial has no multiple roots, be they ever so near to each other.
  bool prove() {
    if (!go_on_()) return false;
    const precision p = std::max<precision>(bits_ / 2 + 64, 128);
    const std::size_t m = guesses_.size();
    std::vector<complex_ball> z;
    z.reserve(m);
    for (const guess& g : guesses_) z.push_back(to_ball(g.x, bits_, p));
    std::vector<complex_ball> real;
    real.reserve(brackets_.size());
    for (const exact_interval& b : brackets_) real.emplace_back(b.to_ball(p));
    const auto n = magnitude::from_integer_up(static_cast<std::uint64_t>(values_.degree()));
    const magnitude leading = ball(values_.coefficients().back(), 64).magnitude_lower();
    std::vector<magnitude> radius;
    std::vector<std::vector<magnitude>> apart(m);     // from z[j], j < i
    std::vector<std::vector<magnitude>> mirrored(m);  // from the conjugate of z[j], j <= i
    std::vector<std::vector<magnitude>> from_real(m);
    for (std::size_t i = 0; i < m; ++i) {
      for (std::size_t j = 0; j < i; ++j) apart[i].push_back((z[i] - z[j]).magnitude_lower());
      for (std::size_t j = 0; j <= i; ++j) {
        mirrored[i].push_back((z[i] - conj(z[j])).magnitude_lower());
      }
      for (const complex_ball& r : real) from_real[i].push_back((z[i] - r).magnitude_lower());
    }
    for (std::size_t i = 0; i < m; ++i) {
      magnitude product = leading;
      for (std::size_t j = 0; j < m; ++j) {
        if (j != i) product = multiply_down(product, i > j ? apart[i][j] : apart[j][i]);
        product = multiply_down(product, i >= j ? mirrored[i][j] : mirrored[j][i]);
      }
      for (const magnitude& distance : from_real[i]) product = multiply_down(product, distance);
      const complex_values::values v = values_.at(guesses_[i].x, bits_);
      radius.push_back(
          divide_up(multiply_up(n, values_.value_bound(guesses_[i].x, v, bits_)), product));
      if (product.is_zero()) return false;
    }
    for (std::size_t i = 0; i < m; ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        const magnitude both = add_up(radius[i], radius[j]);
        if (j < i && apart[i][j] <= both) return false;
        if (mirrored[i][j] <= both) return false;
      }
      const auto is_in_disc = [&](const magnitude& distance) { return distance <= radius[i]; };
      if (std::ranges::any_of(from_real[i], is_in_disc)) return false;
    }
    for (std::size_t i = 0; i < m; ++i) guesses_[i].radius = radius[i];
    proved_bits_ = bits_;
    return true;
  }

  /// The root in the disc of the guess, to a radius of 2^-p of its size.
  std::optional<complex_ball> narrowed_root(std::size_t i, precision p) {
    const guess& g = guesses_[i];
    const auto n = magnitude::from_integer_up(static_cast<std::uint64_t>(values_.degree()));
    fixed_point x = g.x;
    long bits = proved_bits_;
    constexpr int steps_at_once = 4;
    while (true) {
      for (int k = 0; k < steps_at_once; ++k) {
        const complex_values::values v = values_.at(x, bits);
        const magnitude slope = v.slope.abs_lower();
        if (slope.is_zero()) break;
        // In the plane of u for a reciprocal: the roots of s are the reciprocals of those of p.
        const magnitude error = divide_up(multiply_up(n, v.value.abs_upper()), slope);
        const fixed_value u{x.re, x.im, {}};
        const magnitude size = scale(u.abs_lower(), -bits);
        if (error <= scale(size, -(static_cast<std::int64_t>(p) + 2))) {
          const precision work = std::max<precision>(bits, p) + 8;
          fixed_point direct = x;
          direct.is_reciprocal = false;
          complex_ball root = to_ball(direct, bits, work).enlarged(error);
          if (x.is_reciprocal) root = reciprocal(root);
          // The disc holds one root, and some root lies here.
          const complex_ball centre = to_ball(g.x, proved_bits_, work);
          const auto is_in_disc = [&](const complex_ball& z) {
            return (z - centre).magnitude_upper() <= g.radius;
          };
          if (is_in_disc(root)) {
            const complex_ball shorter = root.with_precision(p + 16);
            return is_in_disc(shorter) ? shorter : root;
          }
        }
        newton_step(x, v, bits);
      }
      if (bits > 16 * p + most_bits) return std::nullopt;
      x.re <<= static_cast<unsigned long>(bits);
      x.im <<= static_cast<unsigned long>(bits);
      bits *= 2;
    }
  }

  /// u - v/s, in integers.
  static void newton_step(fixed_point& x, const complex_values::values& v, long bits) {
    const fixed_value& a = v.value;
    const fixed_value& b = v.slope;
    const integer norm = b.re * b.re + b.im * b.im;
    if (norm == 0) return;
    const auto shift = static_cast<unsigned long>(bits);
    x.re -= ((a.re * b.re + a.im * b.im) << shift) / norm;
    x.im -= ((a.im * b.re - a.re * b.im) << shift) / norm;
  }

  complex_values values_;
  std::vector<long double> rough_;  // the coefficients, where they are not too large
  polynomial_values real_values_;
  std::vector<exact_interval> brackets_;
  std::vector<fixed_point> real_points_;
  std::vector<approximate> real_guesses_;
  std::vector<guess> guesses_;
  const std::function<bool()>& go_on_;
  long bits_ = bits_at_start;
  bool is_first_stage_ = true;
  long proved_bits_ = 0;
};

bool comes_before(const complex_root& x, const complex_root& y) {
  const auto order = [](const ball& a, const ball& b) {
    return mpfr_cmp(midpoint(a).backend().data(), midpoint(b).backend().data());
  };
  if (const int by_real = order(x.enclosure.re, y.enclosure.re); by_real != 0) return by_real < 0;
  return order(x.enclosure.im, y.enclosure.im) < 0;
}

/// The roots of a factor without multiple ones; false where they are not all found.
bool add_roots(const rational_polynomial& factor, long multiplicity, precision p,
               const std::function<bool()>& go_on, std::vector<complex_root>& roots) {
  auto real = separate_real_roots(factor, go_on);
  if (!real) return false;
  const auto add = [&](complex_ball enclosure, std::optional<rational> exact = std::nullopt) {
    roots.push_back({std::move(enclosure), multiplicity, std::move(exact)});
  };
  for (const rational& q : real->exact) add(complex_ball(ball(q, p + 16)), q);
  if (real->rest.size() == 1) return true;
  polynomial_values values(real->rest);
  std::vector<ball> enclosures;
  for (exact_interval& b : real->brackets) {
    if (!go_on()) return false;
    b = narrowed(values, b, p);
    enclosures.push_back(b.to_ball(p + 16));
    // Real roots that are nearer to each other than the digits tell are told apart by more.
    const std::size_t k = enclosures.size() - 1;
    for (precision bits = 2 * p; k > 0 && overlaps(enclosures[k - 1], enclosures[k]); bits *= 2) {
      for (const std::size_t i : {k - 1, k}) {
        if (!go_on()) return false;
        real->brackets[i] = narrowed(values, real->brackets[i], bits);
        enclosures[i] = real->brackets[i].to_ball(bits + 16);
      }
    }
  }
  for (ball& x : enclosures) add(complex_ball(std::move(x)));
  const auto pairs = pair_search(real->rest, real->brackets, go_on).run(p);
  if (!pairs) return false;
  for (const complex_ball& z : *pairs) {
    add(z);
    add(conj(z));
  }
  return true;
}

}  // namespace
}  // namespace detail

namespace detail {
namespace {

bool any_overlap(const std::vector<complex_root>& roots) {
  std::vector<std::pair<double_interval, double_interval>> about;
  about.reserve(roots.size());
  for (const complex_root& r : roots) {
    about.emplace_back(double_interval::from_ball(r.enclosure.re),
                       double_interval::from_ball(r.enclosure.im));
  }
  for (std::size_t i = 0; i < roots.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (overlaps(about[i].first, about[j].first) && overlaps(about[i].second, about[j].second) &&
          overlaps(roots[i].enclosure.re, roots[j].enclosure.re) &&
          overlaps(roots[i].enclosure.im, roots[j].enclosure.im)) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace
}  // namespace detail

complex_roots_answer complex_roots(const rational_polynomial& p, long digits,
                                   const std::function<bool(long)>& go_on) {
  if (digits < 1)
    throw std::invalid_argument("complex_roots: at least one digit must be asked for");
  if (p.is_zero()) throw input_error("the polynomial is 0 everywhere: every number is a root");
  const std::vector<repeated_factor> factors = square_free_decomposition(p);
  complex_roots_answer result;
  const std::function<bool()> ask = [&] {
    return !go_on || go_on(static_cast<long>(result.roots.size()));
  };
  // Roots that are still nearer to each other than the digits tell are told apart by more.
  for (precision bits = bits_for_digits(digits) + 8;; bits *= 2) {
    result = {};
    for (const repeated_factor& factor : factors) {
      result.complete =
          detail::add_roots(factor.factor, factor.multiplicity, bits, ask, result.roots) &&
          result.complete;
    }
    if (!result.complete || !detail::any_overlap(result.roots)) break;
  }
  std::sort(result.roots.begin(), result.roots.end(), detail::comes_before);
  return result;
}

}  // namespace polhode
