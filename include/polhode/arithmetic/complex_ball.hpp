#pragma once

// The complex ball: a rectangle re + im*I of two real balls, known to hold a complex number.
//
// The inclusion principle (ball.hpp) holds for every operation. Branch cuts, and on which side of
// them a value on the cut lies, are those of the table in rectangle.hpp, where the functions are
// also written and proved; possibly_singular::f(z) there tells whether a cut or pole of f touches
// z. Both parts have the same precision, that of the ball; it is undefined where a part is.
//
// For an exact operand each part of a result is within one unit in the last place (its own, not
// that of |f(z)|) of the value for sqrt, log, exp, sin, cos, sinh, cosh, asin, acos, atan, asinh,
// acosh, atanh, tan, tanh, and for *, / within one of the last place.

#include <iosfwd>
#include <string>
#include <utility>

#include "polhode/arithmetic/ball.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/rectangle.hpp"

namespace polhode {

/// What rectangle.hpp needs of a ball.
template <>
struct real_set<ball> {
  /// There are narrow sets, with a midpoint and a radius, beside wide ones.
  static constexpr bool has_narrow = true;

  static bool is_undefined(const ball& x) { return x.is_undefined(); }
  static bool is_bounded(const ball& x) { return x.is_bounded(); }
  static bool is_exact(const ball& x) { return x.is_exact(); }
  static bool is_zero(const ball& x) { return sign_of(x) == certain_sign::zero; }
  /// x is exactly an integer that fits, and n is set to it.
  static bool is_machine_integer(const ball& x, long& n);
  /// No member is negative, and x is defined.
  static bool not_negative(const ball& x);

  // Numbers with the precision of `like`.
  static ball integer(long n, const ball& like) { return {n, like.precision()}; }
  static ball pi(const ball& like) { return polhode::pi(like.precision()); }
  static ball undefined(const ball& like) { return ball::undefined(like.precision()); }
  static rectangle<ball> unit(const ball& like) { return {integer(1, like), integer(0, like)}; }

  /// The same set with so many bits more, or with twice the precision and 16 bits.
  static ball raised(const ball& x, long bits) { return x.with_precision(x.precision() + bits); }
  static ball doubled(const ball& x) { return x.with_precision(2 * x.precision() + 16); }
  static ball rounded(const ball& x, const ball& like) {
    return x.with_precision(like.precision());
  }

  /// A bound of an end from outside, as a point. Where the end is infinite: all numbers beyond the
  /// greatest finite one, so that a function monotone on x has its limit there in the result.
  static ball lower_end(const ball& x);
  static ball upper_end(const ball& x);

  /// sqrt(x^2 + y^2) for narrow sets or points.
  static ball modulus(const ball& x, const ball& y);
  static std::pair<ball, ball> sin_cos(const ball& x) { return polhode::sin_cos(x); }
  static std::pair<ball, ball> sinh_cosh(const ball& x);
  /// At least log2 of the greatest |x|, at least 0, and at most so much that it can be added to a
  /// precision.
  static long bits_before_point(const ball& x);

  // For narrow sets.
  static bool is_narrow(const ball& x);
  static ball middle(const ball& x) { return x.middle(); }
  /// An enclosure of few bits, for the size of an error.
  static ball coarse(const ball& x) { return x.with_precision(40); }
  /// All members have about the same size: no radius is more than 1/32 of the greater part.
  static bool is_steady(const rectangle<ball>& z);
  /// Grows value by |s| radius(x) + |t| radius(y); false where that is infinite.
  static bool enlarge(ball& value, const ball& s, const ball& x, const ball& t, const ball& y);
  /// z / w for w that does not hold 0, to first order about the midpoints; for wide sets also
  /// undefined.
  static rectangle<ball> quotient(const rectangle<ball>& z, const rectangle<ball>& w);
};

class complex_ball : public rectangle<ball> {
 public:
  /// Operators and functions take integers and rationals beside it; inexact_operand.hpp refuses the
  /// rest.
  static constexpr bool takes_exact_numbers = true;
  /// Exactly 0, at 64 bits.
  complex_ball() = default;
  complex_ball(ball real_part, ball imaginary_part);
  explicit complex_ball(ball real_part);
  explicit complex_ball(detail::room r) : rectangle<ball>{ball(r), ball(r)} {}
  complex_ball(rectangle<ball> z)  // NOLINT(google-explicit-constructor): the same set
      : complex_ball(std::move(z.re), std::move(z.im)) {}
  template <exact_number N>
  complex_ball(const N& n, polhode::precision p) : complex_ball(ball(n, p), ball(0, p)) {}
  template <exact_number N, exact_number M>
  complex_ball(const N& real_part, const M& imaginary_part, polhode::precision p)
      : complex_ball(ball(real_part, p), ball(imaginary_part, p)) {}
  static complex_ball i(polhode::precision p) { return {0, 1, p}; }
  static complex_ball undefined(polhode::precision p) {
    return {ball::undefined(p), ball::undefined(p)};
  }

  [[nodiscard]] polhode::precision precision() const { return re.precision(); }
  [[nodiscard]] bool is_undefined() const { return re.is_undefined(); }
  [[nodiscard]] bool is_bounded() const { return re.is_bounded() && im.is_bounded(); }
  /// A single complex number.
  [[nodiscard]] bool is_exact() const { return re.is_exact() && im.is_exact(); }
  /// Bounds of |z| over the set, as of a ball.
  [[nodiscard]] magnitude magnitude_upper() const;
  [[nodiscard]] magnitude magnitude_lower() const;

  [[nodiscard]] complex_ball with_precision(polhode::precision p) const {
    return {re.with_precision(p), im.with_precision(p)};
  }
  [[nodiscard]] complex_ball middle() const { return {re.middle(), im.middle()}; }
  /// Both parts grown by error: the result holds every number within that distance of the set.
  [[nodiscard]] complex_ball enlarged(const magnitude& error) const {
    return {re.enlarged(error), im.enlarged(error)};
  }
};

// ---------------------------------------------------------------------------------------------
// Operators, mixed with balls and with exact numbers.

[[nodiscard]] complex_ball operator+(const complex_ball& z, const complex_ball& w);
[[nodiscard]] complex_ball operator-(const complex_ball& z, const complex_ball& w);
[[nodiscard]] complex_ball operator*(const complex_ball& z, const complex_ball& w);
/// Undefined where w holds 0.
[[nodiscard]] complex_ball operator/(const complex_ball& z, const complex_ball& w);
[[nodiscard]] inline complex_ball operator-(const complex_ball& z) { return {-z.re, -z.im}; }
[[nodiscard]] inline complex_ball operator+(const complex_ball& z) { return z; }

template <class X>
concept real_operand = std::same_as<X, ball> || exact_number<X>;

template <real_operand X>
[[nodiscard]] complex_ball operator+(const complex_ball& z, const X& x) {
  return {z.re + x, z.im};
}
template <real_operand X>
[[nodiscard]] complex_ball operator+(const X& x, const complex_ball& z) {
  return {x + z.re, z.im};
}
template <real_operand X>
[[nodiscard]] complex_ball operator-(const complex_ball& z, const X& x) {
  return {z.re - x, z.im};
}
template <real_operand X>
[[nodiscard]] complex_ball operator-(const X& x, const complex_ball& z) {
  return {x - z.re, -z.im};
}
template <real_operand X>
[[nodiscard]] complex_ball operator*(const complex_ball& z, const X& x) {
  return {z.re * x, z.im * x};
}
template <real_operand X>
[[nodiscard]] complex_ball operator*(const X& x, const complex_ball& z) {
  return {x * z.re, x * z.im};
}
template <real_operand X>
[[nodiscard]] complex_ball operator/(const complex_ball& z, const X& x) {
  return {z.re / x, z.im / x};
}
[[nodiscard]] inline complex_ball operator/(const ball& x, const complex_ball& z) {
  return complex_ball(x) / z;
}
template <exact_number N>
[[nodiscard]] complex_ball operator/(const N& n, const complex_ball& z) {
  return complex_ball(n, z.precision()) / z;
}

template <class X>
concept complex_operand = std::same_as<X, complex_ball> || real_operand<X>;
template <complex_operand X>
complex_ball& operator+=(complex_ball& z, const X& x) {
  return z = z + x;
}
template <complex_operand X>
complex_ball& operator-=(complex_ball& z, const X& x) {
  return z = z - x;
}
template <complex_operand X>
complex_ball& operator*=(complex_ball& z, const X& x) {
  return z = z * x;
}
template <complex_operand X>
complex_ball& operator/=(complex_ball& z, const X& x) {
  return z = z / x;
}

// ---------------------------------------------------------------------------------------------
// Functions: principal values, as rectangle.hpp says.

[[nodiscard]] inline complex_ball conj(const complex_ball& z) { return {z.re, -z.im}; }
/// i z.
[[nodiscard]] inline complex_ball times_i(const complex_ball& z) { return {-z.im, z.re}; }
/// z * 2^n, exactly.
[[nodiscard]] inline complex_ball scale(const complex_ball& z, long n) {
  return {scale(z.re, n), scale(z.im, n)};
}
[[nodiscard]] ball abs(const complex_ball& z);
/// In (-pi, pi]; undefined where z holds 0.
[[nodiscard]] ball arg(const complex_ball& z);
[[nodiscard]] complex_ball square(const complex_ball& z);
[[nodiscard]] complex_ball reciprocal(const complex_ball& z);
[[nodiscard]] complex_ball sqrt(const complex_ball& z);
[[nodiscard]] complex_ball exp(const complex_ball& z);
[[nodiscard]] complex_ball log(const complex_ball& z);
[[nodiscard]] complex_ball sin(const complex_ball& z);
[[nodiscard]] complex_ball cos(const complex_ball& z);
[[nodiscard]] complex_ball tan(const complex_ball& z);
[[nodiscard]] complex_ball sinh(const complex_ball& z);
[[nodiscard]] complex_ball cosh(const complex_ball& z);
[[nodiscard]] complex_ball tanh(const complex_ball& z);
[[nodiscard]] complex_ball asin(const complex_ball& z);
[[nodiscard]] complex_ball acos(const complex_ball& z);
[[nodiscard]] complex_ball atan(const complex_ball& z);
[[nodiscard]] complex_ball asinh(const complex_ball& z);
[[nodiscard]] complex_ball acosh(const complex_ball& z);
[[nodiscard]] complex_ball atanh(const complex_ball& z);
[[nodiscard]] complex_ball pow(const complex_ball& z, long n);
[[nodiscard]] complex_ball pow(const complex_ball& z, const complex_ball& w);

/// The arithmetic-geometric mean of 1 and z with the right choice of every square root, that is
/// with |a - b| <= |a + b| (D. A. Cox, The arithmetic-geometric mean of Gauss, L'Enseignement
/// Math. 30 (1984), section 2): Cox's simplest value, analytic off (-inf, 0]. On that cut it is
/// the limit from above; the mean of 1 with 0 or with -1 is 0.
[[nodiscard]] complex_ball agm(const complex_ball& z);
/// z agm(w / z), the limit for im(w / z) from above where w / z is negative; 0 where z or w is 0.
/// A set z and a set w that both hold 0 and more give the square of half side max(|z|, |w|).
[[nodiscard]] complex_ball agm(const complex_ball& z, const complex_ball& w);

// ---------------------------------------------------------------------------------------------
// Sets.

/// As for balls: a yes is exact, and a no too but for ends that are not representable.
[[nodiscard]] bool contains(const complex_ball& z, const complex_ball& w);
template <rational_like N, rational_like M>
[[nodiscard]] bool contains(const complex_ball& z, const N& real_part, const M& imaginary_part) {
  return contains(z.re, real_part) && contains(z.im, imaginary_part);
}
[[nodiscard]] bool overlaps(const complex_ball& z, const complex_ball& w);
/// The least rectangle that holds both sets.
[[nodiscard]] complex_ball hull(const complex_ball& z, const complex_ball& w);
/// The common part; undefined where there is none.
[[nodiscard]] complex_ball intersection(const complex_ball& z, const complex_ball& w);

/// For reading: both parts as to_decimal (text.hpp) has them, "1.41421... - 0.5*I".
[[nodiscard]] std::string to_decimal(const complex_ball& z, long most_digits);
std::ostream& operator<<(std::ostream& out, const complex_ball& z);

}  // namespace polhode
