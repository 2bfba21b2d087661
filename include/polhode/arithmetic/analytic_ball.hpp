#pragma once

// A complex ball as the argument of an analytic function.
//
// An analytic_ball has what a complex_ball and a region have in common and mean the same by: the
// operators, and the functions of the list below, with principal values. What is not analytic, or
// means one thing for a complex number and another as the continuation of a real function, does not
// compile: abs, arg, conj, the parts, comparisons. So a generic function that takes regions and
// analytic balls is the same function for both.

#include <concepts>
#include <utility>

#include "polhode/arithmetic/complex_ball.hpp"
#include "polhode/arithmetic/exact.hpp"

namespace polhode {

class analytic_ball {
 public:
  /// Operators and functions take integers and rationals beside it; inexact_operand.hpp refuses the
  /// rest.
  static constexpr bool takes_exact_numbers = true;
  analytic_ball() = default;
  explicit analytic_ball(complex_ball z) : z_(std::move(z)) {}

  /// The set, for who has called the function.
  [[nodiscard]] const complex_ball& value() const& { return z_; }
  [[nodiscard]] complex_ball&& value() && { return std::move(z_); }
  [[nodiscard]] polhode::precision precision() const { return z_.precision(); }
  /// A real number, as precise as this one.
  [[nodiscard]] analytic_ball constant_like(const rational& q) const {
    return analytic_ball(complex_ball(ball(q, precision())));
  }
  [[nodiscard]] analytic_ball constant_like(const ball& x) const {
    return analytic_ball(complex_ball(x));
  }

  friend analytic_ball operator+(const analytic_ball& z) { return z; }
  friend analytic_ball operator-(const analytic_ball& z) { return analytic_ball(-z.z_); }

// With each other, and with complex balls, balls and exact numbers, which are constants.
#define POLHODE_OPERATOR(sign)                                                         \
  friend analytic_ball operator sign(const analytic_ball& z, const analytic_ball& w) { \
    return analytic_ball(z.z_ sign w.z_);                                              \
  }                                                                                    \
  template <complex_operand X>                                                         \
  friend analytic_ball operator sign(const analytic_ball& z, const X& x) {             \
    return analytic_ball(z.z_ sign x);                                                 \
  }                                                                                    \
  template <complex_operand X>                                                         \
  friend analytic_ball operator sign(const X& x, const analytic_ball& z) {             \
    return analytic_ball(x sign z.z_);                                                 \
  }                                                                                    \
  template <class X>                                                                   \
  analytic_ball& operator sign##=(const X& x) {                                        \
    return *this = *this sign x;                                                       \
  }
  POLHODE_OPERATOR(+)
  POLHODE_OPERATOR(-)
  POLHODE_OPERATOR(*)
  POLHODE_OPERATOR(/)
#undef POLHODE_OPERATOR

#define POLHODE_FUNCTION(f) \
  friend analytic_ball f(const analytic_ball& z) { return analytic_ball(f(z.z_)); }
  POLHODE_FUNCTION(times_i)
  POLHODE_FUNCTION(square)
  POLHODE_FUNCTION(sqrt)
  POLHODE_FUNCTION(exp)
  POLHODE_FUNCTION(log)
  POLHODE_FUNCTION(sin)
  POLHODE_FUNCTION(cos)
  POLHODE_FUNCTION(tan)
  POLHODE_FUNCTION(asin)
  POLHODE_FUNCTION(acos)
  POLHODE_FUNCTION(atan)
  POLHODE_FUNCTION(sinh)
  POLHODE_FUNCTION(cosh)
  POLHODE_FUNCTION(tanh)
  POLHODE_FUNCTION(asinh)
  POLHODE_FUNCTION(acosh)
  POLHODE_FUNCTION(atanh)
#undef POLHODE_FUNCTION
  friend analytic_ball pow(const analytic_ball& z, long n) { return analytic_ball(pow(z.z_, n)); }
  friend analytic_ball pow(const analytic_ball& z, const analytic_ball& w) {
    return analytic_ball(pow(z.z_, w.z_));
  }
  template <class X>
  requires std::same_as<X, complex_ball> || std::same_as<X, ball> || rational_like<X>
  friend analytic_ball pow(const analytic_ball& z, const X& w) {
    if constexpr (std::same_as<X, complex_ball>) {
      return analytic_ball(pow(z.z_, w));
    } else if constexpr (std::same_as<X, ball>) {
      return analytic_ball(pow(z.z_, complex_ball(w)));
    } else {
      return analytic_ball(pow(z.z_, complex_ball(w, z.precision())));
    }
  }

  /// |z| is not analytic; sqrt(z * z) is z or -z.
  friend void abs(const analytic_ball& z) = delete;

 private:
  complex_ball z_;
};

}  // namespace polhode
