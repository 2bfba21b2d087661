#pragma once

// The functions that formulas are made of, over three kinds of sets: real intervals; intervals with
// one of the derivative (jet); and rectangles of complex numbers. Each holds the values for all
// members of its operands, and throws `undecided` where the function is not known to be defined on
// them; over a jet, not known to have a derivative there; over a rectangle, not known to be
// analytic in a neighbourhood of it. Off the real line sqrt and log are the principal values, cut
// along the negative real axis with 0; all others are made of these, of exp and of + - * /, so that
// they take conjugate values at conjugate points.

#include "interval.hpp"

namespace polhode::checker {

// ---------------------------------------------------------------------------------------------
// Real intervals, also wide ones: beside those of interval.hpp, which lose width where an interval
// is wide.

/// With x = m + d, |d| <= r: sin x = sin m cos d + cos m sin d, 1 - r^2/2 <= cos d <= 1, |sin d| <=
/// r; and so for cos.
[[nodiscard]] sine_and_cosine sin_cos_over(const interval& x);
[[nodiscard]] interval sin(const interval& x);
[[nodiscard]] interval cos(const interval& x);
[[nodiscard]] interval sinh(const interval& x);
[[nodiscard]] interval cosh(const interval& x);
/// They increase: from the values at the ends.
[[nodiscard]] interval exp_over(const interval& x);
[[nodiscard]] interval atan_over(const interval& x);

// ---------------------------------------------------------------------------------------------
// A value and a derivative

struct jet {
  interval value;
  interval slope;
};
[[nodiscard]] jet operator-(const jet& x);
[[nodiscard]] jet operator+(const jet& x, const jet& y);
[[nodiscard]] jet operator-(const jet& x, const jet& y);
[[nodiscard]] jet operator*(const jet& x, const jet& y);
[[nodiscard]] jet operator/(const jet& x, const jet& y);
[[nodiscard]] jet square(const jet& x);
[[nodiscard]] jet sqrt(const jet& x);
[[nodiscard]] jet exp_over(const jet& x);
[[nodiscard]] jet log(const jet& x);
[[nodiscard]] jet sin(const jet& x);
[[nodiscard]] jet cos(const jet& x);
[[nodiscard]] jet sinh(const jet& x);
[[nodiscard]] jet cosh(const jet& x);
[[nodiscard]] jet atan_over(const jet& x);

// ---------------------------------------------------------------------------------------------
// Rectangles re + i im

struct rectangle {
  interval re;
  interval im;
};
[[nodiscard]] rectangle operator-(const rectangle& z);
[[nodiscard]] rectangle operator+(const rectangle& z, const rectangle& w);
[[nodiscard]] rectangle operator-(const rectangle& z, const rectangle& w);
[[nodiscard]] rectangle operator*(const rectangle& z, const rectangle& w);
[[nodiscard]] rectangle operator/(const rectangle& z, const rectangle& w);
[[nodiscard]] rectangle square(const rectangle& z);
[[nodiscard]] rectangle sqrt(const rectangle& z);
[[nodiscard]] rectangle exp_over(const rectangle& z);
[[nodiscard]] rectangle log(const rectangle& z);
[[nodiscard]] rectangle sin(const rectangle& z);
[[nodiscard]] rectangle cos(const rectangle& z);
[[nodiscard]] rectangle sinh(const rectangle& z);
[[nodiscard]] rectangle cosh(const rectangle& z);
[[nodiscard]] rectangle atan_over(const rectangle& z);

// ---------------------------------------------------------------------------------------------
// What the evaluation of a formula needs of a set

/// The number q as such a set, at the bits of `like`.
[[nodiscard]] interval constant(const rational& q, const interval& like);
[[nodiscard]] jet constant(const rational& q, const jet& like);
[[nodiscard]] rectangle constant(const rational& q, const rectangle& like);
[[nodiscard]] interval pi_like(const interval& like);
[[nodiscard]] jet pi_like(const jet& like);
[[nodiscard]] rectangle pi_like(const rectangle& like);
[[nodiscard]] inline const precision& precision_of(const interval& x) { return x.bits(); }
[[nodiscard]] inline const precision& precision_of(const jet& x) { return x.value.bits(); }
[[nodiscard]] inline const precision& precision_of(const rectangle& x) { return x.re.bits(); }
/// The bits before the point of the greatest member.
[[nodiscard]] long bits_before_point(const interval& x);
[[nodiscard]] long bits_before_point(const jet& x);
[[nodiscard]] long bits_before_point(const rectangle& z);

}  // namespace polhode::checker
