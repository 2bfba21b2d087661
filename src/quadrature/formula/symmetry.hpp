#pragma once

// What a function does under a symmetry of its argument: found by calling it with a `symmetry`.
//
// Let sigma be a motion of the real line: a reflection x -> 2a - x, or a translation x -> x + L. A
// symmetry is what is known of a function v under it:
//
//   v(sigma x) = e v(x) + c   for all real x, e = 1 or -1, c = q + r pi with known rational q, r,
//
// or nothing. (Where one side is not defined, the other is not.) e = 1, c = 0 is invariance: even
// about a, or periodic. A constant is known to be one, and by its value where that is q' + r' pi;
// it has e = 1, c = 0, and also e = -1, c = twice its value. The argument itself has e = -1, c =
// 2a, or e = 1, c = L.
//
//   const auto f = [](const auto& x) { return exp(cos(x)) * square(sin(x)); };
//   f(symmetry::reflection({0, rational(1, 2)})).is_invariant();   // false: cos is odd about pi/2
//   f(symmetry::reflection({0, 1})).is_invariant();                // true: even about pi
//   f(symmetry::translation({0, 2})).is_invariant();               // true: 2 pi is a period
//
// The rules below are identities of the real functions. That an expression is found to have no
// symmetry says nothing: x + exp(x) - exp(x) is not seen to be odd.

#include <optional>

#include "polhode/arithmetic/ball.hpp"
#include "polhode/arithmetic/inexact_operand.hpp"
#include "polhode/arithmetic/pi_combination.hpp"

namespace polhode {

class symmetry {
 public:
  /// Operators and functions take integers and rationals beside it; inexact_operand.hpp refuses the
  /// rest.
  static constexpr bool takes_exact_numbers = true;
  /// Nothing is known.
  symmetry() = default;
  /// The argument x under x -> 2a - x.
  [[nodiscard]] static symmetry reflection(const pi_combination& a);
  /// The argument x under x -> x + by.
  [[nodiscard]] static symmetry translation(const pi_combination& by);

  /// A constant: one that is known, or some real number.
  template <exact_number N>
  explicit symmetry(const N& n) : symmetry(pi_combination{rational(n), 0}) {}
  explicit symmetry(const pi_combination& value);
  explicit symmetry(const ball&) : symmetry(some_constant()) {}
  [[nodiscard]] static symmetry some_constant();

  /// v(sigma x) = v(x).
  [[nodiscard]] bool is_invariant() const { return sign_ == 1 && shift_.is_zero(); }
  /// v(sigma x) = -v(x).
  [[nodiscard]] bool is_odd() const { return sign_ == -1 && shift_.is_zero(); }
  /// c where v(sigma x) = c - v(x).
  [[nodiscard]] std::optional<pi_combination> sum_with_image() const {
    const symmetry v = with_sign(-1);
    if (v.sign_ != -1) return std::nullopt;
    return v.shift_;
  }
  [[nodiscard]] bool is_constant() const { return constant_; }
  /// The value of a constant, where it is known.
  [[nodiscard]] const std::optional<pi_combination>& value() const { return value_; }

  friend symmetry operator+(const symmetry& u) { return u; }
  friend symmetry operator-(const symmetry& u);
  friend symmetry operator+(const symmetry& u, const symmetry& v);
  friend symmetry operator-(const symmetry& u, const symmetry& v) { return u + (-v); }
  friend symmetry operator*(const symmetry& u, const symmetry& v);
  friend symmetry operator/(const symmetry& u, const symmetry& v);

  // Odd functions.
  friend symmetry asin(const symmetry& v) { return v.under_odd_function(); }
  friend symmetry atan(const symmetry& v) { return v.under_odd_function(); }
  friend symmetry sinh(const symmetry& v) { return v.under_odd_function(); }
  friend symmetry tanh(const symmetry& v) { return v.under_odd_function(); }
  friend symmetry asinh(const symmetry& v) { return v.under_odd_function(); }
  friend symmetry atanh(const symmetry& v) { return v.under_odd_function(); }
  friend symmetry erf(const symmetry& v) { return v.under_odd_function(); }
  // Even functions.
  friend symmetry square(const symmetry& v) { return pow(v, 2); }
  friend symmetry cosh(const symmetry& v) { return v.under_even_function(); }
  friend symmetry abs(const symmetry& v) { return v.under_even_function(); }
  /// v^n has the parity of n.
  friend symmetry pow(const symmetry& v, long n);
  /// The real root: odd where n is; where n is even, of non-negative numbers.
  friend symmetry root(const symmetry& v, long n) {
    return n % 2 != 0 ? v.under_odd_function() : v.under_any_function();
  }
  // sin(e v + k pi) = (-1)^k e sin v, cos(e v + k pi) = (-1)^k cos v, tan(e v + k pi) = e tan v for
  // whole k; with pi as the unit for sinpi and cospi.
  friend symmetry sin(const symmetry& v) { return v.under_circular_function(true, v.half_turns()); }
  friend symmetry cos(const symmetry& v) {
    return v.under_circular_function(false, v.half_turns());
  }
  friend symmetry sinpi(const symmetry& v) { return v.under_circular_function(true, v.halves()); }
  friend symmetry cospi(const symmetry& v) { return v.under_circular_function(false, v.halves()); }
  friend symmetry tan(const symmetry& v);
  /// acos(-v) = pi - acos(v).
  friend symmetry acos(const symmetry& v);
  /// erfc(-v) = 2 - erfc(v).
  friend symmetry erfc(const symmetry& v);
  // Without such an identity: of invariant arguments they are invariant.
  friend symmetry sqrt(const symmetry& v) { return v.under_any_function(); }
  friend symmetry exp(const symmetry& v) { return v.under_any_function(); }
  friend symmetry expm1(const symmetry& v) { return v.under_any_function(); }
  friend symmetry log(const symmetry& v) { return v.under_any_function(); }
  friend symmetry log1p(const symmetry& v) { return v.under_any_function(); }
  friend symmetry acosh(const symmetry& v) { return v.under_any_function(); }
  friend symmetry floor(const symmetry& v) { return v.under_any_function(); }
  friend symmetry ceil(const symmetry& v) { return v.under_any_function(); }
  friend symmetry gamma(const symmetry& v) { return v.under_any_function(); }
  friend symmetry log_gamma(const symmetry& v) { return v.under_any_function(); }
  friend symmetry pow(const symmetry& v, const rational&) { return v.under_any_function(); }
  friend symmetry pow(const symmetry& u, const symmetry& v) { return of_two(u, v); }
  friend symmetry min(const symmetry& u, const symmetry& v) { return of_two(u, v); }
  friend symmetry max(const symmetry& u, const symmetry& v) { return of_two(u, v); }
  friend symmetry agm(const symmetry& u, const symmetry& v) { return of_two(u, v); }
  friend symmetry atan2(const symmetry& v, const symmetry& u) { return of_two(v, u); }
  /// sqrt(u^2 + v^2).
  friend symmetry hypot(const symmetry& u, const symmetry& v) {
    return of_two(u.under_even_function(), v.under_even_function());
  }

 private:
  [[nodiscard]] static symmetry known(int sign, const pi_combination& shift);
  /// The same with this sign: of a constant by its value.
  [[nodiscard]] symmetry with_sign(int sign) const;
  [[nodiscard]] symmetry times(const pi_combination& constant) const;
  [[nodiscard]] symmetry under_any_function() const;
  [[nodiscard]] symmetry under_odd_function() const;
  [[nodiscard]] symmetry under_even_function() const;
  [[nodiscard]] symmetry under_circular_function(bool is_sine,
                                                 const std::optional<integer>& k) const;
  [[nodiscard]] static symmetry of_two(const symmetry& u, const symmetry& v);
  /// k where c = k pi, or c = k, with a whole k.
  [[nodiscard]] std::optional<integer> half_turns() const;
  [[nodiscard]] std::optional<integer> halves() const;

  int sign_ = 0;  // e; 0 where nothing is known
  pi_combination shift_;
  bool constant_ = false;
  std::optional<pi_combination> value_;
};

namespace detail {
template <class N>
concept constant_of_symmetry = exact_number<N> || std::same_as<N, ball>;
}  // namespace detail

template <detail::constant_of_symmetry N>
[[nodiscard]] symmetry operator+(const symmetry& v, const N& n) {
  return v + symmetry(n);
}
template <detail::constant_of_symmetry N>
[[nodiscard]] symmetry operator+(const N& n, const symmetry& v) {
  return symmetry(n) + v;
}
template <detail::constant_of_symmetry N>
[[nodiscard]] symmetry operator-(const symmetry& v, const N& n) {
  return v - symmetry(n);
}
template <detail::constant_of_symmetry N>
[[nodiscard]] symmetry operator-(const N& n, const symmetry& v) {
  return symmetry(n) - v;
}
template <detail::constant_of_symmetry N>
[[nodiscard]] symmetry operator*(const symmetry& v, const N& n) {
  return v * symmetry(n);
}
template <detail::constant_of_symmetry N>
[[nodiscard]] symmetry operator*(const N& n, const symmetry& v) {
  return symmetry(n) * v;
}
template <detail::constant_of_symmetry N>
[[nodiscard]] symmetry operator/(const symmetry& v, const N& n) {
  return v / symmetry(n);
}
template <detail::constant_of_symmetry N>
[[nodiscard]] symmetry operator/(const N& n, const symmetry& v) {
  return symmetry(n) / v;
}

}  // namespace polhode
