#pragma once

// Intervals in fixed point: [low, high] * 2^-bits with whole low and high. Every operation returns
// an interval that holds the results for all members of its operands; ends are rounded outward by
// whole-number division. Both operands have the same bits. Every operation is charged, by the sizes
// of its operands, to the budget of the first.
//
// What cannot be decided at these bits (a division by an interval that holds 0) throws `undecided`:
// it is never an answer.

#include <stdexcept>
#include <string>

#include "exact.hpp"

namespace polhode::checker {

class undecided : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class interval {
 public:
  interval(const rational& q, precision bits);
  interval(integer low, integer high, precision bits);
  /// The interval between two rationals, lower <= upper.
  static interval between(const rational& lower, const rational& upper, precision bits);
  /// [-r, r], r of this many units 2^-bits.
  static interval around_zero(const integer& units, precision bits);

  [[nodiscard]] const integer& low() const { return low_; }
  [[nodiscard]] const integer& high() const { return high_; }
  [[nodiscard]] const precision& bits() const { return bits_; }
  [[nodiscard]] rational lower() const;
  [[nodiscard]] rational upper() const;
  [[nodiscard]] bool is_positive() const { return low_ > 0; }
  [[nodiscard]] bool is_negative() const { return high_ < 0; }
  /// The greatest |x| of a member, in units.
  [[nodiscard]] integer magnitude() const;
  /// At other bits, rounded outward.
  [[nodiscard]] interval with_bits(precision bits) const;
  /// times 2^k, exactly for k >= 0.
  [[nodiscard]] interval scaled(long k) const;
  /// Widened by so many units on both sides.
  [[nodiscard]] interval widened(const integer& units) const;

  friend interval operator-(const interval& x);
  friend interval operator+(const interval& x, const interval& y);
  friend interval operator-(const interval& x, const interval& y);
  friend interval operator*(const interval& x, const interval& y);
  /// Throws undecided where y holds 0.
  friend interval operator/(const interval& x, const interval& y);
  friend interval operator*(const interval& x, long n);
  friend interval operator/(const interval& x, long n);  // n > 0

 private:
  integer low_;
  integer high_;
  precision bits_;
};

/// Every member of x is below every member of y.
[[nodiscard]] bool is_below(const interval& x, const interval& y);
[[nodiscard]] bool is_inside(const interval& x, const rational& lower, const rational& upper);
[[nodiscard]] bool overlaps(const interval& x, const rational& lower, const rational& upper);
[[nodiscard]] interval hull(const interval& x, const interval& y);

[[nodiscard]] interval square(const interval& x);
/// Throws undecided where x holds a negative number.
[[nodiscard]] interval sqrt(const interval& x);
[[nodiscard]] interval pi(precision bits);
/// Throws undecided for |x| > 2^17.
[[nodiscard]] interval exp(const interval& x);
/// Throws undecided unless x is positive.
[[nodiscard]] interval log(const interval& x);
[[nodiscard]] interval atan(const interval& x);
struct sine_and_cosine {
  interval sine;
  interval cosine;
};
/// Throws undecided for |x| > 2^17.
[[nodiscard]] sine_and_cosine sin_cos(const interval& x);
/// log(x + sqrt(x^2 + 1)) for positive x.
[[nodiscard]] interval asinh(const interval& x);

}  // namespace polhode::checker
