#pragma once

// The operations on a real scalar T that the templates of elliptic integrals and of rotations
// share. They are in polhode::detail: for the rooms of this library, not for programs that use it.
// T is one of three:
//   ball          every result is an enclosure; truncation errors are added to the radius
//   mpfr_float    the same steps without radii: the uncertified value
//   long double   the same, in which values for `double` are computed (11 bits more than its 53 on
//                 x86)
// The working precision q is an argument; a long double ignores it.

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <utility>

#include "polhode/arithmetic/boost_bridge.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/scalar.hpp"

namespace polhode::detail {

template <class T>
concept elliptic_scalar =
    std::same_as<T, ball> || std::same_as<T, mpfr_float> || std::same_as<T, long double>;

inline constexpr precision long_double_bits = std::numeric_limits<long double>::digits;

[[nodiscard]] inline precision bits_in(const ball& x) { return x.precision(); }
[[nodiscard]] inline precision bits_in(const mpfr_float& x) { return precision_of(x); }
[[nodiscard]] inline precision bits_in(long double) { return long_double_bits; }

/// The integer n with q bits.
template <elliptic_scalar T>
[[nodiscard]] T whole(long n, precision q) {
  if constexpr (std::same_as<T, long double>) {
    return static_cast<long double>(n);
  } else {
    return scalar_from<T>(n, q);
  }
}
template <elliptic_scalar T>
[[nodiscard]] T pi_of(precision q) {
  if constexpr (std::same_as<T, long double>) {
    return 3.14159265358979323846264338327950288L;
  } else {
    return scalar_pi<T>(q);
  }
}
template <elliptic_scalar T>
[[nodiscard]] T undefined_of(precision q) {
  if constexpr (std::same_as<T, ball>) {
    return ball::undefined(q);
  } else if constexpr (std::same_as<T, mpfr_float>) {
    T r = zero_of_precision(q);
    mpfr_set_nan(r.backend().data());
    return r;
  } else {
    return std::numeric_limits<long double>::quiet_NaN();
  }
}
/// The same number (set) with q bits.
[[nodiscard]] inline ball raised(const ball& x, precision q) { return x.with_precision(q); }
[[nodiscard]] inline mpfr_float raised(const mpfr_float& x, precision q) {
  mpfr_float r = zero_of_precision(q);
  mpfr_set(r.backend().data(), x.backend().data(), MPFR_RNDN);
  return r;
}
[[nodiscard]] inline long double raised(long double x, precision) { return x; }

// x * 2^n.
[[nodiscard]] inline ball scaled(const ball& x, long n) { return scale(x, n); }
[[nodiscard]] inline ball scaled(ball&& x, long n) {
  scale(x, x, n);
  return std::move(x);
}
[[nodiscard]] inline mpfr_float scaled(const mpfr_float& x, long n) {
  mpfr_float r = zero_of_precision(precision_of(x));
  mpfr_mul_2si(r.backend().data(), x.backend().data(), n, MPFR_RNDN);
  return r;
}
[[nodiscard]] inline long double scaled(long double x, long n) {
  if (n >= -60 && n <= 60) {  // 2^n is 2^60 2^(n-60), without a division
    return n >= 0 ? x * static_cast<long double>(1ULL << n)
                  : x * (static_cast<long double>(1ULL << (60 + n)) * 0x1p-60L);
  }
  return std::ldexp(x, static_cast<int>(n));
}

// Functions under one name for all three.
#define POLHODE_OF_REALS(name, on_ball, on_mpfr, on_long_double)       \
  [[nodiscard]] inline ball name(const ball& x) { return on_ball(x); } \
  [[nodiscard]] inline mpfr_float name(const mpfr_float& x) {          \
    mpfr_float r = zero_of_precision(precision_of(x));                 \
    on_mpfr(r.backend().data(), x.backend().data(), MPFR_RNDN);        \
    return r;                                                          \
  }                                                                    \
  [[nodiscard]] inline long double name(long double x) { return on_long_double(x); }
POLHODE_OF_REALS(root_of, polhode::sqrt, mpfr_sqrt, std::sqrt)
POLHODE_OF_REALS(log_of, polhode::log, mpfr_log, std::log)
POLHODE_OF_REALS(log1p_of, polhode::log1p, mpfr_log1p, std::log1p)
POLHODE_OF_REALS(exp_of, polhode::exp, mpfr_exp, std::exp)
POLHODE_OF_REALS(atan_of, polhode::atan, mpfr_atan, std::atan)
POLHODE_OF_REALS(tanh_of, polhode::tanh, mpfr_tanh, std::tanh)
POLHODE_OF_REALS(cosh_of, polhode::cosh, mpfr_cosh, std::cosh)
POLHODE_OF_REALS(sinh_of, polhode::sinh, mpfr_sinh, std::sinh)
#undef POLHODE_OF_REALS

[[nodiscard]] inline ball square_of(const ball& x) { return square(x); }
[[nodiscard]] inline mpfr_float square_of(const mpfr_float& x) {
  mpfr_float r = zero_of_precision(precision_of(x));
  mpfr_sqr(r.backend().data(), x.backend().data(), MPFR_RNDN);
  return r;
}
[[nodiscard]] inline long double square_of(long double x) { return x * x; }

/// The angle of the point (x, y) but for whole turns: atan2 without its cut.
[[nodiscard]] inline ball angle_of(const ball& y, const ball& x) {
  if (y.magnitude_upper() <= x.magnitude_lower() && !contains_zero(x)) {
    const ball angle = atan(y / x);
    return certainly_positive(x) ? angle : angle + pi(angle.precision());
  }
  if (contains_zero(y)) return atan2(y, x);
  const ball right = scale(pi(std::max(x.precision(), y.precision())), -1);
  return (certainly_positive(y) ? right : -right) - atan(x / y);
}
[[nodiscard]] inline mpfr_float angle_of(const mpfr_float& y, const mpfr_float& x) {
  mpfr_float r = zero_of_precision(std::max(precision_of(x), precision_of(y)));
  mpfr_atan2(r.backend().data(), y.backend().data(), x.backend().data(), MPFR_RNDN);
  return r;
}
[[nodiscard]] inline long double angle_of(long double y, long double x) { return std::atan2(y, x); }

[[nodiscard]] inline ball agm_of(const ball& x, const ball& y) { return agm(x, y); }
[[nodiscard]] inline mpfr_float agm_of(const mpfr_float& x, const mpfr_float& y) {
  mpfr_float r = zero_of_precision(std::max(precision_of(x), precision_of(y)));
  mpfr_agm(r.backend().data(), x.backend().data(), y.backend().data(), MPFR_RNDN);
  return r;
}
/// For x, y > 0: the distance is squared at each step, after the ratio's logarithm was halved.
[[nodiscard]] inline long double agm_of(long double x, long double y) {
  for (int n = 0; n < 40 && std::abs(x - y) > x * 0x1p-30L; ++n) {
    const long double product = x * y;
    x = (x + y) / 2;
    y = std::sqrt(product);
  }
  return (x + y) / 2 - (x - y) * (x - y) / (16 * x);
}

[[nodiscard]] inline std::pair<ball, ball> sine_cosine(const ball& x) { return sin_cos(x); }
[[nodiscard]] inline std::pair<mpfr_float, mpfr_float> sine_cosine(const mpfr_float& x) {
  return sin_cos(x);
}
[[nodiscard]] inline std::pair<long double, long double> sine_cosine(long double x) {
  return {std::sin(x), std::cos(x)};
}

// Bounds of |x|, for the tests that end an iteration: those of a number where there is no radius.
[[nodiscard]] inline magnitude size_up(const ball& x) { return x.magnitude_upper(); }
[[nodiscard]] inline magnitude size_up(const mpfr_float& x) {
  return magnitude::abs_up(x.backend().data());
}
[[nodiscard]] inline magnitude size_up(long double x) {
  if (x == 0) return {};
  if (!(std::abs(x) <= std::numeric_limits<long double>::max())) return magnitude::infinity();
  int exponent = 0;
  const long double fraction = std::frexp(std::abs(x), &exponent);  // in [1/2, 1)
  return magnitude::from_bits_up(static_cast<std::uint64_t>(std::ldexp(fraction, 62)) + 1,
                                 exponent - 62);
}
[[nodiscard]] inline magnitude size_down(const ball& x) { return x.magnitude_lower(); }
[[nodiscard]] inline magnitude size_down(const mpfr_float& x) {
  return magnitude::abs_down(x.backend().data());
}
[[nodiscard]] inline magnitude size_down(long double x) {
  if (x == 0) return {};
  if (!(std::abs(x) <= std::numeric_limits<long double>::max())) return magnitude::infinity();
  int exponent = 0;
  const long double fraction = std::frexp(std::abs(x), &exponent);
  return magnitude::from_bits_down(static_cast<std::uint64_t>(std::ldexp(fraction, 62)),
                                   exponent - 62);
}

/// A small integer as a factor, and a quotient by one, which a long double has as a product.
template <elliptic_scalar T>
[[nodiscard]] auto times(long n) {
  if constexpr (std::same_as<T, long double>) {
    return static_cast<long double>(n);
  } else {
    return n;
  }
}
inline constexpr std::size_t listed_reciprocals = 64;
inline constexpr auto reciprocals = [] {
  std::array<long double, listed_reciprocals> result{};
  for (std::size_t n = 1; n < listed_reciprocals; ++n)
    result[n] = 1.0L / static_cast<long double>(n);
  return result;
}();
template <elliptic_scalar T>
[[nodiscard]] T over(const T& x, long n) {
  if constexpr (std::same_as<T, long double>) {
    const auto i = static_cast<std::size_t>(n);
    return i < listed_reciprocals ? x * reciprocals[i] : x / static_cast<long double>(n);
  } else {
    return T(x / n);
  }
}

/// About log2 |x|, for heuristic decisions; a very small number for 0.
template <elliptic_scalar T>
[[nodiscard]] std::int64_t exponent_of(const T& x) {
  constexpr std::int64_t of_zero = -(std::int64_t{1} << 40);
  if constexpr (std::same_as<T, long double>) {
    if (x == 0) return of_zero;
    return std::isfinite(x) ? std::ilogb(x) : -of_zero;
  }
  const magnitude m = size_up(x);
  return m.is_zero() ? of_zero : (m.is_infinite() ? -of_zero : m.log2_floor());
}

/// Multiplies numbers of which only the ratios matter by one power of two, where their exponent,
/// about so great, has left the middle of the range: repeated squaring would leave the range.
template <elliptic_scalar T, class... Rest>
void keep_in_range(std::int64_t exponent, T& x, Rest&... rest) {
  constexpr std::int64_t moderate = std::same_as<T, long double> ? 1 << 11 : 1 << 24;
  constexpr std::int64_t most = std::int64_t{1} << 31;
  if (std::abs(exponent) <= moderate || std::abs(exponent) >= most) return;
  x = scaled(x, -static_cast<long>(exponent));
  ((rest = scaled(rest, -static_cast<long>(exponent))), ...);
}

/// The set, grown by a truncation error; a number without radius stays as it is.
template <elliptic_scalar T>
[[nodiscard]] T with_error(const T& x, const magnitude& error) {
  if constexpr (std::same_as<T, ball>) {
    return x.enlarged(error);
  } else {
    return x;
  }
}

/// A number between x and y: for balls the hull.
template <elliptic_scalar T>
[[nodiscard]] T between(const T& x, const T& y) {
  if constexpr (std::same_as<T, ball>) {
    return hull(x, y);
  } else {
    return x;
  }
}

[[nodiscard]] inline bool is_below(const ball& x, const ball& y) { return certainly_less(x, y); }
[[nodiscard]] inline bool is_below(const mpfr_float& x, const mpfr_float& y) {
  return mpfr_less_p(x.backend().data(), y.backend().data()) != 0;
}
[[nodiscard]] inline bool is_below(long double x, long double y) { return x < y; }

/// The sign where it is known, 2 where it is not.
[[nodiscard]] inline int sign_in(const ball& x) { return static_cast<int>(sign_of(x)); }
[[nodiscard]] inline int sign_in(const mpfr_float& x) {
  if (mpfr_nan_p(x.backend().data()) != 0) return 2;
  const int s = mpfr_sgn(x.backend().data());
  return s > 0 ? 1 : (s < 0 ? -1 : 0);
}
[[nodiscard]] inline int sign_in(long double x) {
  if (x > 0) return 1;
  if (x < 0) return -1;
  return x == 0 ? 0 : 2;  // NOLINT: the sign of the number that it is
}

/// Neither undefined, NaN nor infinite.
[[nodiscard]] inline bool is_number(const ball& x) { return x.is_bounded(); }
[[nodiscard]] inline bool is_number(const mpfr_float& x) {
  return mpfr_number_p(x.backend().data()) != 0;
}
[[nodiscard]] inline bool is_number(long double x) { return std::isfinite(x); }

/// How many of about q leading bits are lost in `value`, which is a sum of terms of the size of
/// `term`: read off the radius of a ball, and guessed by cancellation for numbers without.
template <elliptic_scalar T>
[[nodiscard]] std::int64_t bits_lost(const T& value, const T& term, precision q) {
  constexpr std::int64_t all = std::int64_t{1} << 40;
  if constexpr (std::same_as<T, ball>) {
    if (!value.is_bounded()) return all;
    if (value.is_exact()) return 0;
    const magnitude low = value.magnitude_lower();
    if (low.is_zero()) return all;
    const std::int64_t kept = low.log2_floor() - value.radius().log2_floor();
    return std::max<std::int64_t>(0, q - kept);
  } else {
    const std::int64_t lost = exponent_of(term) - exponent_of(value);
    return std::max<std::int64_t>(0, lost);
  }
}

}  // namespace polhode::detail
