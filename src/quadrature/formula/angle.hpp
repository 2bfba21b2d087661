#pragma once

// Real numbers at equal distances, as arguments of a periodic function: balls that also have their
// sines and cosines, from a table, at the price of four multiplications. A function written for any
// type of argument is called with an `angle` where the trapezoidal rule is summed; sin(x), cos(x)
// and tan(x) then cost next to nothing, and so do those of small whole multiples of x. Everything
// else is what it is for a ball.

#include <memory>
#include <utility>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/generic_function.hpp"
#include "polhode/quadrature/periodic_trapezoid.hpp"

namespace polhode {

/// The numbers start + (2k + 1) half_step, k = 0 ... count-1, with e^(i x) of each.
class equidistant_angles {
 public:
  equidistant_angles(const ball& start, const ball& half_step, long count, precision p);

  [[nodiscard]] ball value(long k) const { return start_ + half_step_ * (2 * k + 1); }
  /// {cosine, sine} of m times the k-th number, m != 0.
  [[nodiscard]] std::pair<ball, ball> cosine_and_sine(long k, long m) const;

 private:
  ball start_;
  ball half_step_;
  long block_;
  detail::circle_powers<ball> fine_;    // e^(i j half_step), j = 0 ... 2 block
  detail::circle_powers<ball> coarse_;  // e^(i (start + 2 block j half_step))
};

/// A ball, or m times one of the numbers above.
class angle {
 public:
  /// Operators and functions take integers and rationals beside it; inexact_operand.hpp refuses the
  /// rest.
  static constexpr bool takes_exact_numbers = true;
  angle() = default;
  explicit angle(ball x) : value_(std::move(x)) {}
  template <exact_number N>
  angle(const N& n, precision p) : value_(n, p) {}
  angle(const equidistant_angles& among, long k) : value_(among.value(k)), among_(&among), k_(k) {}

  [[nodiscard]] const ball& value() const { return value_; }
  [[nodiscard]] polhode::precision precision() const { return value_.precision(); }

  friend angle operator+(const angle& x) { return x; }
  friend angle operator-(const angle& x) { return x.multiple(-x.value_, -x.m_); }
  friend angle operator+(const angle& x, const angle& y) { return angle(x.value_ + y.value_); }
  friend angle operator-(const angle& x, const angle& y) { return angle(x.value_ - y.value_); }
  friend angle operator*(const angle& x, const angle& y);
  friend angle operator/(const angle& x, const angle& y) { return angle(x.value_ / y.value_); }

  friend angle sin(const angle& x);
  friend angle cos(const angle& x);
  friend angle tan(const angle& x);

 private:
  /// x, m times a number of the table; without the table where |m| is large.
  [[nodiscard]] angle multiple(ball x, long m) const;

  ball value_;
  const equidistant_angles* among_ = nullptr;
  long k_ = 0;
  long m_ = 1;
};

#define POLHODE_OF_ANGLE(f) \
  [[nodiscard]] inline angle f(const angle& x) { return angle(f(x.value())); }
POLHODE_OF_ANGLE(square)
POLHODE_OF_ANGLE(sqrt)
POLHODE_OF_ANGLE(abs)
POLHODE_OF_ANGLE(floor)
POLHODE_OF_ANGLE(ceil)
POLHODE_OF_ANGLE(exp)
POLHODE_OF_ANGLE(expm1)
POLHODE_OF_ANGLE(log)
POLHODE_OF_ANGLE(log1p)
POLHODE_OF_ANGLE(asin)
POLHODE_OF_ANGLE(acos)
POLHODE_OF_ANGLE(atan)
POLHODE_OF_ANGLE(sinh)
POLHODE_OF_ANGLE(cosh)
POLHODE_OF_ANGLE(tanh)
POLHODE_OF_ANGLE(asinh)
POLHODE_OF_ANGLE(acosh)
POLHODE_OF_ANGLE(atanh)
#undef POLHODE_OF_ANGLE
#define POLHODE_OF_ANGLES(f)                                     \
  [[nodiscard]] inline angle f(const angle& x, const angle& y) { \
    return angle(f(x.value(), y.value()));                       \
  }
POLHODE_OF_ANGLES(min)
POLHODE_OF_ANGLES(max)
POLHODE_OF_ANGLES(hypot)
POLHODE_OF_ANGLES(agm)
POLHODE_OF_ANGLES(pow)
#undef POLHODE_OF_ANGLES
[[nodiscard]] inline angle pow(const angle& x, long n) { return angle(pow(x.value(), n)); }
[[nodiscard]] inline angle pow(const angle& x, const rational& e) {
  return angle(pow(x.value(), ball(e, x.precision())));
}

namespace detail {
template <class N>
concept number_beside_angle = exact_number<N> || std::same_as<N, ball>;
}  // namespace detail

#define POLHODE_WITH_NUMBER(sign)                                 \
  template <detail::number_beside_angle N>                        \
  [[nodiscard]] angle operator sign(const angle& x, const N& n) { \
    return x sign detail::value_as<angle>(n, x);                  \
  }                                                               \
  template <detail::number_beside_angle N>                        \
  [[nodiscard]] angle operator sign(const N& n, const angle& x) { \
    return detail::value_as<angle>(n, x) sign x;                  \
  }
POLHODE_WITH_NUMBER(+)
POLHODE_WITH_NUMBER(-)
POLHODE_WITH_NUMBER(*)
POLHODE_WITH_NUMBER(/)
#undef POLHODE_WITH_NUMBER

}  // namespace polhode
