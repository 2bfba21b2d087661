#pragma once

// How a function of regions is put together from the same function of rectangles in the hardware,
// of rectangles times a power of two, and of balls: the first that serves is taken, and a set on
// which the function may be singular is blocked.

#include <algorithm>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include "arithmetic/complex/region_scaled.hpp"
#include "polhode/arithmetic/region.hpp"

namespace polhode {

/// f in hardware, with an exponent, or in balls where an operand is kept in them or the result
/// leaves the hardware's range: also where an end may have underflowed to 0, so that the set would
/// seem to touch a pole or a branch point. (What is made of sets that end at 0, or hold it, ends at
/// 0 as a rule, and balls would not help; not so exp of [-1000, 0]: `zero_is_news` where it may
/// underflow.) An undefined result of operands without an obstacle is retried too: it may come of
/// infinity - infinity; if balls do no better, it is not analytic.
template <class Hardware, class Balls, class Scaled>
region region::combined(const region& z, const region& w, Hardware&& hardware, Balls&& balls,
                        const Scaled& scaled_form, bool zero_is_news) {
  if (!z.is_analytic()) return z;
  if (!w.is_analytic()) return w;
  if (z.is_in_hardware() && w.is_in_hardware()) {
    const bool zero_is_usual =
        detail::regions::touches_zero(z.hardware_) || detail::regions::touches_zero(w.hardware_);
    const auto suspicious = [&](const region& r, bool is_news) {
      return detail::regions::ends_at_zero(r.hardware_) && (is_news || !zero_is_usual);
    };
    if (z.exponent_ == 0 && w.exponent_ == 0) {
      region r;
      r.hardware_ = hardware(z.hardware_, w.hardware_);
      if (!is_undefined(r.hardware_) && !r.needs_balls() && !suspicious(r, zero_is_news)) {
        return r;
      }
    }
    if (const std::optional<scaled> s = scaled_form(scaled::of(z), scaled::of(w))) {
      std::optional<region> r = s->to_region();
      if (r && !suspicious(*r, false)) return *r;
    }
  }
  const bool keep_balls =
      z.precision() > detail::regions::ball_bits || w.precision() > detail::regions::ball_bits;
  return from_balls(balls(z.to_complex_ball(), w.to_complex_ball()), keep_balls);
}

/// The shapes of the functions of regions.
struct region::functions {
  /// f in hardware, in r, for operands and results that need nothing else: `combined` would do the
  /// same.
  template <class F>
  static bool quick(region& r, const region& z, const region& w, F&& f) {
    if (!z.is_moderate() || !w.is_moderate()) return false;
    r.hardware_ = f(z.hardware_, w.hardware_);
    return detail::regions::is_regular(r.hardware_) &&
           (!detail::regions::ends_at_zero(r.hardware_) ||
            detail::regions::touches_zero(z.hardware_) ||
            detail::regions::touches_zero(w.hardware_));
  }
  /// Whether the predicate holds of the set, in the form in which it is kept.
  template <class Predicate>
  static bool holds(const region& z, Predicate&& predicate) {
    if (z.is_in_hardware() && z.exponent_ == 0) return predicate(z.hardware_);
    return predicate(static_cast<const rectangle<ball>&>(z.to_complex_ball()));
  }
  /// f without singularities.
  template <class F, class Scaled>
  static region entire(const region& z, F&& f, const Scaled& scaled_form,
                       bool zero_is_news = false) {
    return combined(
        z, z, [&](const auto& x, const auto&) { return f(x); },
        [&](const complex_ball& x, const complex_ball&) { return complex_ball(f(x)); },
        [&](const scaled& x, const scaled&) { return scaled_form(x); }, zero_is_news);
  }
  /// r, a function of z and w, with what is known of its size from the sizes of z and w.
  template <class Size>
  static region sized(region r, const region& z, const region& w, Size&& size) {
    if (!z.knows_modulus() && !w.knows_modulus()) return r;
    if (!z.is_in_hardware() || !w.is_in_hardware()) return r;
    return std::move(r).with_modulus(size(z.modulus(), w.modulus()));
  }
  static scaled_interval size_of_product(const scaled_interval& x, const scaled_interval& y) {
    return {x.m * y.m, x.exponent + y.exponent};
  }
  static scaled_interval size_of_quotient(const scaled_interval& x, const scaled_interval& y) {
    return {x.m / y.m, x.exponent - y.exponent};
  }
  /// | |z| - |w| | <= |z +- w| <= |z| + |w|.
  static scaled_interval size_of_sum(const scaled_interval& x, const scaled_interval& y) {
    const long e = std::max(x.exponent, y.exponent);
    const double_interval a = x.over(e);
    const double_interval b = y.over(e);
    return {hull(abs(a - b), a + b), e};
  }
  /// By the scaled form, where the result may leave the hardware's range; nothing where that does
  /// not help.
  template <class Scaled>
  static std::optional<region> in_scale(const region& z, const Scaled& scaled_form) {
    if (!z.is_moderate()) return std::nullopt;
    const std::optional<scaled> s = scaled_form(scaled::of(z));
    std::optional<region> r = s ? s->to_region() : std::nullopt;
    if (r && detail::regions::ends_at_zero(r->hardware_) &&
        !detail::regions::ends_at_zero(z.hardware_))
      r.reset();
    return r;
  }
  static std::optional<scaled> without_scale(const scaled&) { return std::nullopt; }
  /// f where singular(z) is false, else blocked.
  template <class Singular, class F, class Scaled>
  static region away_from(const region& z, obstacle why, std::string_view name, Singular&& singular,
                          F&& f, const Scaled& scaled_form) {
    if (!z.is_analytic()) return z;
    if (holds(z, singular)) return blocked(why, name);
    return entire(z, f, scaled_form);
  }
  /// The sign of the real part, exactly: -1, 1, or 0 where it is not the same everywhere.
  static int sign_of_real_part(const region& z) {
    if (holds(z, [](const auto& x) { return certainly_positive(x.re); })) return 1;
    return holds(z, [](const auto& x) { return certainly_negative(x.re); }) ? -1 : 0;
  }
  /// The integer f(x), where it is the same for all x near the real part.
  template <class F>
  static region step(const region& z, std::string_view name, F&& f) {
    if (!z.is_analytic()) return z;
    const complex_ball w = z.to_complex_ball();
    const ball value = f(w.re);
    // Away from the jumps: the set lies between the integers on both sides, without touching them.
    const ball below = floor(w.re);
    if (!value.is_exact() || !below.is_exact() || !certainly_less(below, w.re) ||
        !certainly_less(w.re, below + 1)) {
      return blocked(obstacle::jump, name);
    }
    return region(value);
  }
};

}  // namespace polhode
