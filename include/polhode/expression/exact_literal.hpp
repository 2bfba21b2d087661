#pragma once

// Exact numbers as literals of C++: 0.5, which is the number it looks like; and "0.1"_r or "1/3"_r,
// for what a double is not.

#include <concepts>
#include <string_view>
#include <utility>

#include "polhode/arithmetic/exact.hpp"

namespace polhode {

/// A double literal whose decimal is the number that the double is. The compiler refuses others,
/// and doubles that it does not know: a captured variable, say.
///
/// Whether the decimal was exact cannot be seen in general; what is accepted is an odd number below
/// 2^26 times a power of two, and a whole number up to 2^53. A decimal that is not exact, N/10^n in
/// lowest terms with n >= 1 and 5 in its denominator, is next to j/2^m with odd j < 2^26 only if
/// |N/10^n - j/2^m| <= 2^-53 |j/2^m|. The difference is at least 1/(5^n 2^max(m,n)), so that 5^n j
/// >= 2^53 for m >= n, and more else: n is 12 or more. So a literal of less than 12 decimals is
/// judged rightly, and one of more is off by less than a unit in its 16th digit.
class exact_double {
 public:
  template <std::floating_point N>
  consteval exact_double(N value)  // NOLINT(google-explicit-constructor): exact
      : value_(static_cast<double>(value)) {
    if (!is_exact(value_) || static_cast<N>(value_) != value) {
      // The compiler shows this line.
      throw "Polhode: this double is not the decimal it looks like; write \"0.1\"_r for 0.1, or rational(1, 10)";
    }
  }
  [[nodiscard]] constexpr double value() const { return value_; }

  /// Whether a literal of this value is accepted.
  [[nodiscard]] static constexpr bool is_exact(double x) {
    constexpr double most_whole = 0x1p53;
    constexpr double most_odd = 0x1p26;
    if (!(x - x == 0)) return false;  // infinite, or no number
    if (x < 0) x = -x;
    if (x == 0) return true;
    if (x <= most_whole && x == static_cast<double>(static_cast<long long>(x))) return true;
    while (x >= most_odd) x /= 2;
    while (x < most_odd / 2) x *= 2;  // in [2^25, 2^26)
    return x == static_cast<double>(static_cast<long long>(x));
  }

 private:
  double value_;
};

/// A rational number that stands beside a number of any type: it is converted to that type.
class rational_literal {
 public:
  explicit rational_literal(rational q) : value_(std::move(q)) {}
  [[nodiscard]] const rational& value() const { return value_; }
  /// So that balls and their like take it as they take rationals.
  [[nodiscard]] const rational::backend_type& backend() const { return value_.backend(); }
  operator rational() const { return value_; }  // NOLINT(google-explicit-constructor): the same

  friend rational_literal operator-(const rational_literal& x) {
    return rational_literal(rational(-x.value_));
  }
  friend rational_literal operator+(const rational_literal& x, const rational_literal& y) {
    return rational_literal(rational(x.value_ + y.value_));
  }
  friend rational_literal operator-(const rational_literal& x, const rational_literal& y) {
    return rational_literal(rational(x.value_ - y.value_));
  }
  friend rational_literal operator*(const rational_literal& x, const rational_literal& y) {
    return rational_literal(rational(x.value_ * y.value_));
  }
  /// Throws std::overflow_error for y = 0.
  friend rational_literal operator/(const rational_literal& x, const rational_literal& y) {
    return rational_literal(rational(x.value_ / y.value_));
  }

 private:
  rational value_;
};

inline namespace literals {
/// "0.1"_r and 0.1_r: the decimal, or the quotient "1/3"_r, exactly. Throws input_error as
/// parse_rational does.
[[nodiscard]] inline rational_literal operator""_r(const char* text, std::size_t length) {
  return rational_literal(parse_rational(std::string_view(text, length)));
}
[[nodiscard]] inline rational_literal operator""_r(const char* text) {
  return rational_literal(parse_rational(text));
}
}  // namespace literals

}  // namespace polhode
