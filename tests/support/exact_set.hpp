#pragma once

// A ball as a set of reals with exact ends: what the tests of the inclusion principle decide by.

#include <optional>
#include <ostream>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "polhode/arithmetic/ball.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "support/real.hpp"

namespace polhode::support {

/// Ends without a value are infinite.
struct exact_set {
  std::optional<rational> lower;
  std::optional<rational> upper;

  [[nodiscard]] bool holds(const rational& q) const {
    return (!lower || *lower <= q) && (!upper || q <= *upper);
  }
  [[nodiscard]] bool holds(const exact_set& inner) const {
    return (!lower || (inner.lower && *lower <= *inner.lower)) &&
           (!upper || (inner.upper && *inner.upper <= *upper));
  }
  [[nodiscard]] bool is_bounded() const { return lower && upper; }
  [[nodiscard]] rational width() const { return upper.value() - lower.value(); }
  [[nodiscard]] rational greatest_size() const {
    const rational a = abs(lower.value());
    const rational b = abs(upper.value());
    return a < b ? b : a;
  }
  friend bool operator==(const exact_set&, const exact_set&) = default;
};

/// Bits in which both ends of a bounded ball are exact.
inline precision bits_of_ends(const ball& x) {
  constexpr long most = 1L << 24;
  long bits = x.precision() + 64;
  const magnitude radius = x.radius();
  if (!radius.is_infinite() && !radius.is_zero()) {
    real middle(x.precision());
    x.midpoint(middle);
    if (mpfr_regular_p(middle) != 0) {
      const long top =
          std::max<long>(mpfr_get_exp(middle), static_cast<long>(radius.log2_floor()) + 1);
      const long bottom = std::min<long>(mpfr_get_exp(middle) - x.precision(),
                                         static_cast<long>(radius.exponent()));
      bits = std::max(bits, top - bottom + 2);
    }
  }
  if (bits > most) throw std::length_error("a ball with ends too long for an exact test");
  return bits;
}

/// The set itself. Hypothesis: x is defined.
inline exact_set exact(const ball& x) {
  if (x.is_undefined()) throw std::logic_error("exact: the ball is undefined");
  real end(bits_of_ends(x));
  exact_set result;
  x.lower(end);
  if (end.is_finite()) result.lower = to_rational(end);
  x.upper(end);
  if (end.is_finite()) result.upper = to_rational(end);
  return result;
}

inline std::string described(const ball& x) {
  if (x.is_undefined()) return "undefined (" + std::to_string(x.precision()) + " bits)";
  real lower(53);
  real upper(53);
  x.lower(lower);
  x.upper(upper);
  char text[200];
  mpfr_snprintf(text, sizeof text, "[%.17Rg, %.17Rg]", lower.get(), upper.get());
  const magnitude r = x.radius();
  std::string result = text;
  if (!r.is_infinite() && !r.is_zero()) result += " radius 2^" + std::to_string(r.log2_floor());
  return result + " (" + std::to_string(x.precision()) + " bits)";
}

inline std::string described(const rational& q) {
  const real x(53, q, MPFR_RNDN);
  char text[100];
  mpfr_snprintf(text, sizeof text, "%.17Rg", x.get());
  return text;
}

/// The inclusion principle for one number, decided in rationals; the library's own answer to the
/// same question must agree.
inline ::testing::AssertionResult holds(const ball& x, const rational& q) {
  if (x.is_undefined()) return ::testing::AssertionFailure() << "the ball is undefined";
  const bool inside = exact(x).holds(q);
  if (inside != contains(x, q)) {
    return ::testing::AssertionFailure()
           << "contains() is wrong about " << described(q) << " in " << described(x);
  }
  if (inside) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << described(q) << " is not in " << described(x);
}

/// The same set with the same precision, to the last bit.
inline ::testing::AssertionResult identical(const ball& x, const ball& y) {
  const auto same_ends = [&] {
    const precision p = std::max(bits_of_ends(x), bits_of_ends(y));
    real end(p);
    real other(p);
    x.lower(end);
    y.lower(other);
    if (mpfr_equal_p(end, other) == 0) return false;
    x.upper(end);
    y.upper(other);
    return mpfr_equal_p(end, other) != 0;
  };
  const bool same = x.precision() == y.precision() && x.is_undefined() == y.is_undefined() &&
                    (x.is_undefined() || (x.radius() == y.radius() && same_ends()));
  if (same) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << described(x) << " is not " << described(y);
}

}  // namespace polhode::support
