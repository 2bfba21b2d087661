#pragma once

// Cheap bounds of non-negative reals, with directed rounding in the name of every operation.
//
// A magnitude is 0, or fraction * 2^exponent with 2^30 <= fraction < 2^31, or infinity. Radii of
// balls are magnitudes: 31 bits are plenty for a bound, and one bound costs a few integer
// instructions where a multiple-precision number would cost a call.
//
// An operation named ..._up returns a magnitude that is >= the exact result, by a relative excess
// of at most 2^-29; one named ..._down returns one that is <= the exact result, likewise.
// Exponents beyond +-2^60 saturate to the sound side: up to infinity or to the least magnitude.

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include <mpfr.h>

#include "polhode/language.hpp"

namespace polhode {

class magnitude {
 public:
  /// Zero.
  constexpr magnitude() = default;

  static constexpr magnitude infinity() {
    magnitude result;
    result.fraction_ = least_fraction;
    result.exponent_ = infinite_exponent;
    return result;
  }

  /// 2^exponent, exactly.
  static constexpr magnitude power_of_two(std::int64_t exponent) {
    return normalised_up(least_fraction, saturated(exponent) - (fraction_bits - 1));
  }

  /// The integer n, rounded up to 31 bits.
  static constexpr magnitude from_integer_up(std::uint64_t n) { return from_bits_up(n, 0); }
  static constexpr magnitude from_integer_down(std::uint64_t n) { return from_bits_down(n, 0); }

  /// An upper (lower) bound of |x|. Hypothesis: x is not a NaN.
  static magnitude abs_up(mpfr_srcptr x);
  static magnitude abs_down(mpfr_srcptr x);

  /// bits * 2^exponent, rounded up or down.
  static constexpr magnitude from_bits_up(std::uint64_t bits, std::int64_t exponent) {
    if (bits == 0) return {};
    const int shift = static_cast<int>(std::bit_width(bits)) - fraction_bits;
    if (shift <= 0) return normalised_up(bits << -shift, exponent + shift);
    const std::uint64_t kept = bits >> shift;
    const bool inexact = (kept << shift) != bits;
    return normalised_up(kept + (inexact ? 1 : 0), exponent + shift);
  }
  static constexpr magnitude from_bits_down(std::uint64_t bits, std::int64_t exponent) {
    if (bits == 0) return {};
    const int shift = static_cast<int>(std::bit_width(bits)) - fraction_bits;
    return normalised_down(shift <= 0 ? bits << -shift : bits >> shift, exponent + shift);
  }

  [[nodiscard]] constexpr bool is_zero() const { return fraction_ == 0; }
  [[nodiscard]] constexpr bool is_infinite() const { return exponent_ == infinite_exponent; }

  /// The value is fraction() * 2^exponent() when it is neither zero nor infinite.
  [[nodiscard]] constexpr std::uint32_t fraction() const { return fraction_; }
  [[nodiscard]] constexpr std::int64_t exponent() const { return exponent_; }

  /// bits * 2^exponent rounded up, for 2^30 <= bits < 2^63 and an exponent of at most +-2^62.
  static constexpr magnitude from_many_bits_up(std::uint64_t bits, std::int64_t exponent) {
    const int shift = 64 - fraction_bits - std::countl_zero(bits);
    // Rounding up by one unit, whether or not bits are lost, costs 2^-30 and saves a branch.
    return normalised_up((bits >> shift) + 1, exponent + shift);
  }

  /// floor(log2(value)) for a finite, positive value.
  [[nodiscard]] constexpr std::int64_t log2_floor() const { return exponent_ + fraction_bits - 1; }

  /// Exact comparison (a magnitude is a definite number, so a total order is right here).
  friend constexpr bool operator==(const magnitude&, const magnitude&) = default;
  friend constexpr bool operator<(const magnitude& x, const magnitude& y) {
    if (x.is_zero() || y.is_zero()) return x.is_zero() && !y.is_zero();
    if (x.exponent_ != y.exponent_) return x.exponent_ < y.exponent_;
    return x.fraction_ < y.fraction_;
  }
  friend constexpr bool operator>(const magnitude& x, const magnitude& y) { return y < x; }
  friend constexpr bool operator<=(const magnitude& x, const magnitude& y) { return !(y < x); }
  friend constexpr bool operator>=(const magnitude& x, const magnitude& y) { return !(x < y); }

  friend constexpr magnitude add_up(const magnitude& x, const magnitude& y) {
    if (x.is_zero()) return y;
    if (y.is_zero()) return x;
    if (x.is_infinite() || y.is_infinite()) return infinity();
    const magnitude& large = x.exponent_ >= y.exponent_ ? x : y;
    const magnitude& small = x.exponent_ >= y.exponent_ ? y : x;
    const std::int64_t gap = large.exponent_ - small.exponent_;
    // The small one in units of the large one's last place, rounded up.
    const std::uint64_t shifted =
        gap >= fraction_bits ? 1 : (small.fraction_ + (std::uint64_t{1} << gap) - 1) >> gap;
    return from_bits_up(large.fraction_ + shifted, large.exponent_);
  }

  friend constexpr magnitude add_down(const magnitude& x, const magnitude& y) {
    if (x.is_zero()) return y;
    if (y.is_zero()) return x;
    if (x.is_infinite() || y.is_infinite()) return infinity();
    const magnitude& large = x.exponent_ >= y.exponent_ ? x : y;
    const magnitude& small = x.exponent_ >= y.exponent_ ? y : x;
    const std::int64_t gap = large.exponent_ - small.exponent_;
    const std::uint64_t shifted = gap >= fraction_bits ? 0 : small.fraction_ >> gap;
    return from_bits_down(large.fraction_ + shifted, large.exponent_);
  }

  /// max(x - y, 0), rounded up or down. Hypothesis of both: y is finite.
  friend constexpr magnitude subtract_up(const magnitude& x, const magnitude& y) {
    if (y.is_zero() || x.is_infinite()) return x;
    if (x <= y) return {};
    const std::int64_t gap = x.exponent_ - y.exponent_;  // >= 0, since x > y
    if (gap > 32) return x;
    return from_bits_up((std::uint64_t{x.fraction_} << gap) - y.fraction_, y.exponent_);
  }
  friend constexpr magnitude subtract_down(const magnitude& x, const magnitude& y) {
    if (y.is_zero() || x.is_infinite()) return x;
    if (x <= y) return {};
    const std::int64_t gap = x.exponent_ - y.exponent_;
    // Beyond 32 places y is less than one unit of x's last place.
    if (gap > 32) return from_bits_down((std::uint64_t{x.fraction_} << 2) - 1, x.exponent_ - 2);
    return from_bits_down((std::uint64_t{x.fraction_} << gap) - y.fraction_, y.exponent_);
  }

  /// x * y; 0 * infinity is 0 (the factor 0 is an exact bound).
  friend constexpr magnitude multiply_up(const magnitude& x, const magnitude& y) {
    if (x.is_zero() || y.is_zero()) return {};
    if (x.is_infinite() || y.is_infinite()) return infinity();
    return from_bits_up(std::uint64_t{x.fraction_} * y.fraction_, x.exponent_ + y.exponent_);
  }
  friend constexpr magnitude multiply_down(const magnitude& x, const magnitude& y) {
    if (x.is_zero() || y.is_zero()) return {};
    if (x.is_infinite() || y.is_infinite()) return infinity();
    return from_bits_down(std::uint64_t{x.fraction_} * y.fraction_, x.exponent_ + y.exponent_);
  }

  /// x / y. Division by 0 gives infinity upwards. Division by infinity gives 0.
  friend constexpr magnitude divide_up(const magnitude& x, const magnitude& y) {
    if (x.is_zero()) return {};
    if (y.is_zero() || x.is_infinite()) return infinity();
    if (y.is_infinite()) return {};
    const std::uint64_t numerator = std::uint64_t{x.fraction_} << 32;
    const std::uint64_t quotient = numerator / y.fraction_;
    const bool inexact = quotient * y.fraction_ != numerator;
    return from_bits_up(quotient + (inexact ? 1 : 0), x.exponent_ - y.exponent_ - 32);
  }
  friend constexpr magnitude divide_down(const magnitude& x, const magnitude& y) {
    if (x.is_zero() || y.is_infinite()) return {};
    if (y.is_zero() || x.is_infinite()) return infinity();
    const std::uint64_t numerator = std::uint64_t{x.fraction_} << 32;
    return from_bits_down(numerator / y.fraction_, x.exponent_ - y.exponent_ - 32);
  }

  friend magnitude sqrt_up(const magnitude& x) {
    if (x.is_zero() || x.is_infinite()) return x;
    const std::uint64_t root = x.integer_sqrt();
    const bool inexact = root * root != x.even_bits();
    return from_bits_up(root + (inexact ? 1 : 0), x.even_exponent() / 2);
  }
  friend magnitude sqrt_down(const magnitude& x) {
    if (x.is_zero() || x.is_infinite()) return x;
    return from_bits_down(x.integer_sqrt(), x.even_exponent() / 2);
  }

  /// x * 2^n, exactly (but for saturation).
  friend constexpr magnitude scale(const magnitude& x, std::int64_t n) {
    if (x.is_zero() || x.is_infinite()) return x;
    return normalised_up(x.fraction_, x.exponent_ + saturated(n));
  }

  friend constexpr magnitude max(const magnitude& x, const magnitude& y) { return x < y ? y : x; }
  friend constexpr magnitude min(const magnitude& x, const magnitude& y) { return y < x ? y : x; }

 private:
  static constexpr int fraction_bits = 31;
  static constexpr std::uint32_t least_fraction = std::uint32_t{1} << (fraction_bits - 1);
  static constexpr std::int64_t infinite_exponent = std::numeric_limits<std::int64_t>::max();
  // Two exponents within the limit can be added and offset without overflow.
  static constexpr std::int64_t exponent_limit = std::int64_t{1} << 60;

  /// n, or the nearest number that can be added to an exponent without overflow.
  static constexpr std::int64_t saturated(std::int64_t n) {
    constexpr std::int64_t most = std::int64_t{1} << 62;
    return n > most ? most : (n < -most ? -most : n);
  }
  /// fraction in [2^30, 2^31].
  static constexpr magnitude normalised_up(std::uint64_t fraction, std::int64_t exponent) {
    if (fraction == std::uint64_t{least_fraction} * 2) {
      fraction = least_fraction;
      ++exponent;
    }
    if (exponent > exponent_limit) return infinity();
    magnitude result;
    result.fraction_ = static_cast<std::uint32_t>(fraction);
    result.exponent_ = exponent < -exponent_limit ? -exponent_limit : exponent;
    return result;
  }
  /// fraction in [2^30, 2^31).
  static constexpr magnitude normalised_down(std::uint64_t fraction, std::int64_t exponent) {
    if (exponent < -exponent_limit) return {};
    magnitude result;
    result.fraction_ = static_cast<std::uint32_t>(fraction);
    result.exponent_ = exponent > exponent_limit ? exponent_limit : exponent;
    return result;
  }

  // value = even_bits() * 2^even_exponent(), with 60 to 62 bits and an even exponent.
  [[nodiscard]] constexpr std::int64_t even_exponent() const {
    return (exponent_ & 1) != 0 ? exponent_ - 31 : exponent_ - 30;
  }
  [[nodiscard]] constexpr std::uint64_t even_bits() const {
    return std::uint64_t{fraction_} << ((exponent_ & 1) != 0 ? 31 : 30);
  }
  /// floor(sqrt(even_bits())): the hardware's estimate, set right in integers.
  [[nodiscard]] std::uint64_t integer_sqrt() const {
    const std::uint64_t n = even_bits();
    auto root = static_cast<std::uint64_t>(std::sqrt(static_cast<double>(n)));
    while (root * root > n) --root;
    while ((root + 1) * (root + 1) <= n) ++root;
    return root;
  }

  std::uint32_t fraction_ = 0;
  std::int64_t exponent_ = 0;
};

inline magnitude magnitude::abs_up(mpfr_srcptr x) {
  if (mpfr_regular_p(x) == 0) return mpfr_zero_p(x) != 0 ? magnitude{} : infinity();
  const mpfr_prec_t precision = mpfr_get_prec(x);
  const auto limbs = (precision - 1) / GMP_NUMB_BITS;
  const auto* significand = static_cast<const mp_limb_t*>(mpfr_custom_get_significand(x));
  const std::uint64_t top = significand[limbs];
  const std::uint64_t kept = top >> 33;
  const bool maybe_more = limbs > 0 || (kept << 33) != top;
  return normalised_up(kept + (maybe_more ? 1 : 0),
                       static_cast<std::int64_t>(mpfr_get_exp(x)) - fraction_bits);
}

inline magnitude magnitude::abs_down(mpfr_srcptr x) {
  if (mpfr_regular_p(x) == 0) return mpfr_zero_p(x) != 0 ? magnitude{} : infinity();
  const auto limbs = (mpfr_get_prec(x) - 1) / GMP_NUMB_BITS;
  const auto* significand = static_cast<const mp_limb_t*>(mpfr_custom_get_significand(x));
  return normalised_down(std::uint64_t{significand[limbs]} >> 33,
                         static_cast<std::int64_t>(mpfr_get_exp(x)) - fraction_bits);
}

/// About log2(x), to search with: -infinity for 0, infinity for an infinite one.
[[nodiscard]] inline double estimated_log2(const magnitude& x) {
  if (x.is_zero()) return -std::numeric_limits<double>::infinity();
  if (x.is_infinite()) return std::numeric_limits<double>::infinity();
  return std::log2(static_cast<double>(x.fraction())) + static_cast<double>(x.exponent());
}

}  // namespace polhode
