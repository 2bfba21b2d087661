#pragma once

#include <optional>
#include <vector>

#include "polhode/arithmetic/exact.hpp"
#include "roots/settled_pieces.hpp"

namespace polhode::detail {

/// The greatest k with p(x) = r(x^k); 1 for a constant.
[[nodiscard]] long common_exponent(const std::vector<integer>& p);

/// The values of a polynomial with integer coefficients at rational points.
class polynomial_values {
 public:
  /// Values are computed with so many bits first, and with more where these do not tell the sign.
  explicit polynomial_values(const std::vector<integer>& p, precision bits = 64);

  /// With a radius of at most 2^-relative_bits of its size, or exact where it is exactly 0.
  [[nodiscard]] ball at(const rational& x, precision relative_bits);
  [[nodiscard]] int sign_at(const rational& x) { return signum(at(x, 1)); }
  /// The bits that the last value was computed with.
  [[nodiscard]] precision last_precision() const { return bits_; }
  [[nodiscard]] int evaluations() const { return evaluations_; }
  /// -1, 0 or 1. Hypothesis: the value is exact or has a sign.
  [[nodiscard]] static int signum(const ball& value);

 private:
  void set_precision(precision bits);
  [[nodiscard]] ball fixed_point_value(const rational& y);

  long exponent_;                 // the polynomial is r(x^exponent_)
  std::vector<integer> p_;        // r's coefficients
  std::vector<integer> shifted_;  // these times 2^bits_
  precision bits_ = 0;
  int evaluations_ = 0;
  std::size_t longest_ = 0;  // bits of the longest coefficient
};

/// The part of the bracket that holds the root, with a width of at most 2^-bits of its size; the
/// root itself where it was met. By quadratic interval refinement (J. Abbott, Quadratic interval
/// refinement for real roots, 2006): the bracket is divided into N parts, and the one at which the
/// secant points is tested by the signs at its ends; N is squared where they differ. Hypothesis: p
/// has exactly one root in the closed bracket; it is simple, and not 0 unless it is an end of the
/// bracket.
[[nodiscard]] exact_interval narrowed(polynomial_values& p, exact_interval bracket, long bits);

/// A point inside the bracket: the middle, or about the geometric one where both ends have one sign
/// and differ much in size.
[[nodiscard]] rational inner_point(const exact_interval& b);

}  // namespace polhode::detail
