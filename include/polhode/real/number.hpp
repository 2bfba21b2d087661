#pragma once

// The types that a template over Real takes, and how a Real and a ball become each other.
//
//   const auto x = nearest_as<mpfr_float_50>(b);     // near the middle of the ball
//   const auto lower = lower_as<mpfr_float_50>(b);   // no greater than any number of the ball
//   const ball exactly = ball_of(x);                 // the number that x is

#include <concepts>
#include <limits>
#include <type_traits>
#include <utility>

#include <boost/multiprecision/mpfr.hpp>
#include <boost/multiprecision/number.hpp>

#include "polhode/arithmetic/boost_bridge.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/expression/symbol.hpp"

namespace polhode {

namespace detail {
/// Whether each number has a precision of its own, as mpfr_float has.
template <class R>
inline constexpr bool has_variable_precision = [] {
  if constexpr (boost_real<R>) {
    return boost::multiprecision::detail::is_variable_precision<R>::value;
  } else {
    return false;
  }
}();
}  // namespace detail

namespace detail {
/// A cpp_bin_float of Boost's: its backend says how many binary digits it has.
template <class R>
concept binary_boost_real = boost_real<R> && std::numeric_limits<R>::radix == 2 && requires {
  requires R::backend_type::bit_count == std::numeric_limits<R>::digits;
};
}  // namespace detail

/// A floating-point type without enclosures: double, long double, and the numbers of
/// Boost.Multiprecision with a binary floating point and correct rounding: mpfr_float (with the
/// precision of its arguments), mpfr_float_50, ..., cpp_bin_float_50, ..., with expression
/// templates or without.
template <class R>
concept floating_real = std::same_as<R, double> || std::same_as<R, long double> ||
                        (detail::boost_real<R>&& mpfr_like<R>) ||
                        detail::binary_boost_real<R>;

/// What a template over Real takes.
template <class R>
concept real_or_ball = floating_real<R> || std::same_as<R, ball>;

namespace detail {

/// Made into a type where Real is none of these: one sentence.
template <class Real>
struct real_needed {
  static_assert(
      real_or_ball<Real>,
      "Polhode: Real is double, long double, mpfr_float, mpfr_float_50 (or another number "
      "of digits), cpp_bin_float_50 (or another), or polhode::ball. A float has too few "
      "digits; the numbers of cpp_dec_float, gmp_float, mpfi and rationals are not rounded "
      "in binary, as the proofs need it");
  static constexpr bool reported = true;
};

/// Whole decimal digits in so many bits; at least one.
[[nodiscard]] inline long digits_in_bits(precision p) {
  constexpr double digits_per_bit = 0.30102999;
  return std::max(1L, static_cast<long>(static_cast<double>(p) * digits_per_bit));
}

}  // namespace detail

/// The bits of a number of type R: of mpfr_float the thread's default, which
/// mpfr_float::thread_default_precision(digits) sets.
template <floating_real R>
[[nodiscard]] precision usual_bits() {
  if constexpr (detail::has_variable_precision<R>) {
    return bits_for_digits(R::thread_default_precision());
  } else {
    return std::numeric_limits<R>::digits;
  }
}

namespace detail {

/// x as an R of p bits (of R's bits, where those are fixed), rounded in one direction. Values
/// beyond the range of R become infinite, its greatest, its smallest or 0, as the direction has it.
template <floating_real R>
[[nodiscard]] R rounded_to(mpfr_srcptr x, precision p, mpfr_rnd_t direction) {
  if constexpr (std::same_as<R, double>) {
    return mpfr_get_d(x, direction);
  } else if constexpr (std::same_as<R, long double>) {
    return mpfr_get_ld(x, direction);
  } else if constexpr (mpfr_like<R>) {
    R result;
    if constexpr (has_variable_precision<R>) mpfr_set_prec(result.backend().data(), p);
    mpfr_set(result.backend().data(), x, direction);
    return result;
  } else {
    using limits = std::numeric_limits<R>;
    if (mpfr_nan_p(x) != 0) return limits::quiet_NaN();
    if (mpfr_inf_p(x) != 0) return mpfr_sgn(x) > 0 ? limits::infinity() : R(-limits::infinity());
    mpfr_float shorter = zero_of_precision(limits::digits);
    mpfr_set(shorter.backend().data(), x, direction);
    if (mpfr_zero_p(shorter.backend().data()) != 0) return R(0);
    const long exponent = mpfr_get_exp(shorter.backend().data());
    const bool up = direction == MPFR_RNDU;
    const bool down = direction == MPFR_RNDD;
    const bool positive = mpfr_sgn(x) > 0;
    if (exponent > limits::max_exponent) {
      const bool outward = positive ? !down : !up;
      const R size = outward ? limits::infinity() : (limits::max)();
      return positive ? size : R(-size);
    }
    if (exponent < limits::min_exponent) {
      const bool outward = positive ? up : down;
      const R size = outward ? (limits::min)() : R(0);
      return positive ? size : R(-size);
    }
    integer mantissa;
    const long scale = mpfr_get_z_2exp(mantissa.backend().data(), shorter.backend().data());
    return ldexp(R(mantissa), static_cast<int>(scale));
  }
}

/// The same of a bound of a ball's set.
template <floating_real R>
[[nodiscard]] R bound_as(const ball& x, precision p, mpfr_rnd_t direction) {
  mpfr_float exact = zero_of_precision(std::max<precision>(p, x.precision()) + 64);
  if (direction == MPFR_RNDD) {
    x.lower(exact.backend().data());
  } else if (direction == MPFR_RNDU) {
    x.upper(exact.backend().data());
  } else {
    x.midpoint(exact.backend().data());
  }
  return rounded_to<R>(exact.backend().data(), p, direction);
}

}  // namespace detail

/// A number near the middle of the set, with p bits where R has no precision of its own; a NaN
/// where the ball is undefined.
template <floating_real R>
[[nodiscard]] R nearest_as(const ball& x, precision p = usual_bits<R>()) {
  return detail::bound_as<R>(x, p, MPFR_RNDN);
}
/// A lower (upper) bound of the set; a NaN where the ball is undefined.
template <floating_real R>
[[nodiscard]] R lower_as(const ball& x, precision p = usual_bits<R>()) {
  return detail::bound_as<R>(x, p, MPFR_RNDD);
}
template <floating_real R>
[[nodiscard]] R upper_as(const ball& x, precision p = usual_bits<R>()) {
  return detail::bound_as<R>(x, p, MPFR_RNDU);
}

/// The number that x is, without width; undefined for an infinity and a NaN.
template <floating_real R>
[[nodiscard]] ball ball_of(const R& x) {
  if constexpr (std::same_as<R, double>) {
    return ball::exactly(x);
  } else if constexpr (std::same_as<R, long double>) {
    mpfr_float exact = zero_of_precision(std::numeric_limits<long double>::digits);
    mpfr_set_ld(exact.backend().data(), x, MPFR_RNDN);
    return ball(exact);
  } else if constexpr (mpfr_like<R>) {
    return ball(x);
  } else {
    if (!(boost::multiprecision::isfinite)(x))
      return ball::undefined(std::numeric_limits<R>::digits);
    return {rational(x), std::numeric_limits<R>::digits};
  }
}

namespace detail {
/// The half of a ball's width, as the upper end of a ball.
[[nodiscard]] inline ball truncation_of(const ball& x) { return ball(0, 64).enlarged(x.radius()); }
}  // namespace detail

}  // namespace polhode
