#pragma once

// A real number that is known exactly, as q + r pi with rational q and r, or by an enclosure and,
// where there is one, a formula: the scalar of jets and series in which "is this coefficient 0" can
// be decided.

#include <concepts>
#include <optional>
#include <string_view>
#include <utility>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "polhode/arithmetic/exact_formula.hpp"
#include "polhode/arithmetic/pi_combination.hpp"

namespace polhode {

/// Exact are the results of + - * / of exact numbers, as far as they have this form, and the values
/// of functions at the few points where they are evidently rational (exp 0, cos 0, sin pi, sqrt of
/// a square, ...). Other results of them have a formula while that is short. A number whose
/// numerators or denominators pass 2^longest is kept by its enclosure alone.
class known_number {
 public:
  /// Operators and functions take integers and rationals beside it; inexact_operand.hpp refuses the
  /// rest.
  static constexpr bool takes_exact_numbers = true;
  static constexpr std::size_t longest = 4096;  // bits
  static constexpr precision usual_precision = 128;

  known_number() : exact_(0), enclosure_(0, usual_precision) {}
  /// Of a rational alone: whether a ball converts to one is not asked then.
  template <std::same_as<rational> Q>
  explicit known_number(const Q& q, precision p = usual_precision)
      : known_number(pi_combination{q, 0}, p) {}
  explicit known_number(const pi_combination& x, precision p = usual_precision);
  /// A ball without width is the exact number that it is.
  explicit known_number(ball x);
  /// The number that the formula is, which lies in x; the formula may be null.
  known_number(ball x, exact_formula::pointer formula) : known_number(std::move(x)) {
    if (!exact_) formula_ = std::move(formula);
  }

  /// The rational number that it is known to be.
  [[nodiscard]] const std::optional<rational>& exact() const { return exact_; }
  /// The number q + r pi that it is known to be.
  [[nodiscard]] std::optional<pi_combination> form() const {
    return exact_ ? pi_combination{*exact_, 0} : with_pi_;
  }
  /// A formula of it; null where none is known.
  [[nodiscard]] exact_formula::pointer formula() const {
    if (formula_) return formula_;
    const auto s = form();
    return s ? exact_formula::of(*s) : nullptr;
  }
  [[nodiscard]] bool has_formula() const { return exact_ || with_pi_ || formula_; }
  [[nodiscard]] const ball& enclosure() const { return enclosure_; }
  [[nodiscard]] bool is_exactly(long n) const { return exact_ && *exact_ == n; }
  [[nodiscard]] bool is_zero() const { return is_exactly(0); }

  /// x, with an enclosure of this one's precision.
  [[nodiscard]] known_number like(const pi_combination& x) const {
    return known_number(x, enclosure_.precision());
  }
  [[nodiscard]] known_number like(const rational& q) const {
    return known_number(q, enclosure_.precision());
  }
  [[nodiscard]] known_number like(long n) const { return like(rational(n)); }

  friend known_number operator-(const known_number& x);
  friend known_number operator+(const known_number& x, const known_number& y);
  friend known_number operator-(const known_number& x, const known_number& y) { return x + (-y); }
  /// 0 times a number is 0, however little is known of the number if it is defined.
  friend known_number operator*(const known_number& x, const known_number& y);
  /// Undefined where y may be 0.
  friend known_number operator/(const known_number& x, const known_number& y);
  known_number& operator+=(const known_number& y) { return *this = *this + y; }
  friend known_number operator+(const known_number& x, long n) { return x + x.like(n); }
  friend known_number operator-(const known_number& x, long n) { return x - x.like(n); }
  friend known_number operator*(const known_number& x, long n) { return x * x.like(n); }
  friend known_number operator/(const known_number& x, long n) { return x / x.like(n); }

  /// The value of the function of these numbers, which lies in `value`.
  template <class... Numbers>
  [[nodiscard]] static known_number made(std::string_view function, ball value,
                                         const Numbers&... x) {
    if (!(x.has_formula() && ...)) return known_number(std::move(value));
    return {std::move(value), exact_formula::of(function, {x.formula()...})};
  }

 private:
  std::optional<rational> exact_;
  std::optional<pi_combination> with_pi_;  // q + r pi with r != 0: it is no rational number then
  exact_formula::pointer formula_;         // where it has neither
  ball enclosure_;
};

[[nodiscard]] known_number sqrt(const known_number& x);
// exp(0) = 1, log(1) = 0, sin(0) = 0, ..., and sin, cos and tan at multiples of pi/2.
[[nodiscard]] known_number exp(const known_number& x);
[[nodiscard]] known_number log(const known_number& x);
[[nodiscard]] known_number sin(const known_number& x);
[[nodiscard]] known_number cos(const known_number& x);
[[nodiscard]] known_number tan(const known_number& x);
[[nodiscard]] known_number asin(const known_number& x);
[[nodiscard]] known_number acos(const known_number& x);
[[nodiscard]] known_number atan(const known_number& x);
[[nodiscard]] known_number sinh(const known_number& x);
[[nodiscard]] known_number cosh(const known_number& x);
[[nodiscard]] known_number tanh(const known_number& x);
[[nodiscard]] known_number asinh(const known_number& x);
[[nodiscard]] known_number acosh(const known_number& x);
[[nodiscard]] known_number atanh(const known_number& x);

}  // namespace polhode
