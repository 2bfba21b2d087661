#pragma once

// What lies beyond the range of doubles: a rectangle times a power of two, and its functions, which
// a region tries before those of balls.

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "arithmetic/complex/hardware_rectangle.hpp"
#include "polhode/arithmetic/region.hpp"

namespace polhode {

/// 2^exponent times an interval.
struct region::scaled_interval {
  double_interval m;
  long exponent = 0;

  [[nodiscard]] double_interval over(long e) const { return scale(m, exponent - e); }
};

/// 2^exponent times a rectangle: what lies beyond the range of doubles, without balls. Each form
/// below is the function's usual one, whose factors beyond the range have the exponent split off.
/// Nothing where a function has no such form.
struct region::scaled {
  rectangle<double_interval> m;
  long exponent = 0;
  std::optional<scaled_interval> modulus = std::nullopt;

  static constexpr long largest_exponent = 1L << 40;  // sums of a few do not overflow

  static scaled of(const region& z) { return {z.hardware_, z.exponent_}; }

  /// About 1 in size, but for a set that is {0} or unbounded.
  [[nodiscard]] scaled normalised() const {
    const double size = std::max(m.re.magnitude(), m.im.magnitude());
    if (!(size > 0 && size < detail::infinity)) return *this;
    const int k = std::ilogb(size);
    return {{scale(m.re, -k), scale(m.im, -k)}, exponent + k};
  }

  /// A region in the hardware; nothing where the rectangle's parts differ by more than doubles
  /// hold.
  [[nodiscard]] std::optional<region> to_region() const {
    if (is_undefined(m) || std::abs(exponent) > largest_exponent) return std::nullopt;
    scaled r = normalised();
    if (r.exponent > -900 && r.exponent < 900) {
      r = {{scale(r.m.re, r.exponent), scale(r.m.im, r.exponent)}, 0};
    }
    if (detail::regions::left_range(r.m)) return std::nullopt;
    region result;
    result.hardware_ = r.m;
    result.exponent_ = r.exponent;
    if (modulus) return std::move(result).with_modulus(*modulus);
    return result;
  }

  static std::optional<scaled> sum(const scaled& z, const scaled& w) {
    const scaled& large = z.exponent >= w.exponent ? z : w;
    const scaled& small = z.exponent >= w.exponent ? w : z;
    const long shift = small.exponent - large.exponent;
    return scaled{{large.m.re + scale(small.m.re, shift), large.m.im + scale(small.m.im, shift)},
                  large.exponent};
  }
  static std::optional<scaled> difference(const scaled& z, const scaled& w) {
    return sum(z, {{-w.m.re, -w.m.im}, w.exponent});
  }
  static std::optional<scaled> product(const scaled& z, const scaled& w) {
    const scaled x = z.normalised();
    const scaled y = w.normalised();
    return scaled{x.m * y.m, x.exponent + y.exponent};
  }
  static std::optional<scaled> quotient(const scaled& z, const scaled& w) {
    const scaled x = z.normalised();
    const scaled y = w.normalised();
    return scaled{x.m / y.m, x.exponent - y.exponent};
  }
  static std::optional<scaled> square(const scaled& z) {
    const scaled x = z.normalised();
    return scaled{polhode::square(x.m), 2 * x.exponent};
  }
  static std::optional<scaled> sqrt(const scaled& z) {
    scaled x = z.normalised();
    if (x.exponent % 2 != 0) x = {{scale(x.m.re, 1), scale(x.m.im, 1)}, x.exponent - 1};
    return scaled{polhode::sqrt(x.m), x.exponent / 2};
  }

  /// e^x = 2^k e^(x - k log 2), for any k. Bounded x.
  static std::optional<scaled_interval> exp(double_interval x, long k) {
    if (!(x.magnitude() < 0x1p39)) return std::nullopt;
    static const double_interval log_2 = log(double_interval(2));
    return scaled_interval{polhode::exp(x - k * log_2), k};
  }
  /// A k for which exp(x - k log 2) stays in the hardware's range.
  static long exponent_of_exp(double x) {
    return std::abs(x) < 0x1p39 ? std::lround(x / 0.6931471805599453) : 0;
  }
  /// cosh x and sinh x, with one exponent.
  static std::optional<std::pair<double_interval, double_interval>> cosh_sinh(double_interval x,
                                                                              long k) {
    const auto up = exp(x, k);
    const auto down = exp(-x, k);
    if (!up || !down) return std::nullopt;
    return std::pair{scale(up->m + down->m, -1), scale(up->m - down->m, -1)};
  }

  static std::optional<scaled> exp(const scaled& z) {
    // In a wider one the lower end would underflow.
    if (z.exponent != 0 || !(z.m.re.width() < 600)) return std::nullopt;
    const auto size = exp(z.m.re, exponent_of_exp(z.m.re.upper()));
    if (!size) return std::nullopt;
    const auto [sine, cosine] = sin_cos(z.m.im);
    return scaled{{size->m * cosine, size->m * sine}, size->exponent, size};
  }
  /// cosh z = cosh x cos y + i sinh x sin y and sinh z = sinh x cos y + i cosh x sin y. |cosh z|^2
  /// = sinh^2 x + cos^2 y = cosh^2 x - sin^2 y and |sinh z|^2 = sinh^2 x + sin^2 y = cosh^2 x -
  /// cos^2 y: both between |sinh x| and cosh x.
  static std::optional<scaled> hyperbolic(const scaled& z, bool is_cosh) {
    if (z.exponent != 0) return std::nullopt;
    const long k = exponent_of_exp(z.m.re.magnitude());
    const auto both = cosh_sinh(z.m.re, k);
    if (!both) return std::nullopt;
    const auto& [c, s] = *both;
    const auto [sine, cosine] = sin_cos(z.m.im);
    const scaled_interval modulus{hull(abs(s), c), k};
    if (is_cosh) return scaled{{c * cosine, s * sine}, k, modulus};
    return scaled{{s * cosine, c * sine}, k, modulus};
  }
  static std::optional<scaled> cosh(const scaled& z) { return hyperbolic(z, true); }
  static std::optional<scaled> sinh(const scaled& z) { return hyperbolic(z, false); }
  /// cos z = cosh(iz), sin z = -i sinh(iz).
  static std::optional<scaled> cos(const scaled& z) {
    return hyperbolic({{-z.m.im, z.m.re}, z.exponent}, true);
  }
  static std::optional<scaled> sin(const scaled& z) {
    const std::optional<scaled> s = hyperbolic({{-z.m.im, z.m.re}, z.exponent}, false);
    if (!s) return s;
    return scaled{{s->m.im, -s->m.re}, s->exponent, s->modulus};
  }
  /// |z|^n e^(i n arg z).
  static std::optional<scaled> pow(const scaled& z, long n) {
    const scaled x = z.normalised();
    static const double_interval log_2 = log(double_interval(2));
    if (contains_zero(x.m)) {  // in a disc
      const double_interval most(hypot(x.m.re, x.m.im).upper());
      if (n < 1 || !(most.lower() > 0)) return std::nullopt;
      const double_interval l = n * (log(most) + x.exponent * log_2);
      const auto size = exp(l, exponent_of_exp(l.upper()));
      if (!size) return std::nullopt;
      const double_interval side(-size->m.upper(), size->m.upper());
      return scaled{{side, side}, size->exponent};
    }
    const rectangle<double_interval> l = log(x.m);
    const double_interval size = n * (l.re + x.exponent * log_2);
    const auto modulus = exp(size, exponent_of_exp(size.upper()));
    if (!modulus) return std::nullopt;
    const auto [sine, cosine] = sin_cos(n * l.im);
    return scaled{{modulus->m * cosine, modulus->m * sine}, modulus->exponent, modulus};
  }
};

/// The form of a function without one.
struct region::not_scaled {
  std::optional<scaled> operator()(const scaled&, const scaled&) const { return std::nullopt; }
};

}  // namespace polhode
