#pragma once

// Jets: truncated Taylor series, for derivatives and for tighter ranges over wide balls.
//
// A jet<T, n> holds f_k = f^(k)(x) / k! for k = 0 ... n. Put jet<T, n>::variable(x) into a generic
// function and the result's coefficients are those of the function at x. Over balls (and over any
// scalar that obeys the inclusion principle) they enclose f^(k)(t)/k! for every t in x: a jet of a
// wide ball bounds the derivatives over all of it. What is not differentiable somewhere in x (abs
// across 0) has undefined coefficients from the first one that fails.
//
// T may be ball, complex_ball, mpfr_float, double, or anything else with their operators and
// functions. The order is a template parameter, or dynamic_order with a run-time order (then on the
// heap). Two jets that meet in an operation have the same order, else it throws
// std::invalid_argument: the coefficients that the shorter one lacks are unknown, not 0.
//
// Boost.Math's autodiff (fvar) was looked at first. It cannot serve here: it decides by `==`, by
// operator< and by numeric_limits<T>::epsilon() which terms to form (in pow, in inverse, in
// products), makes scalars from bare ints where a ball needs a precision, and gives floor, ceil and
// fabs a derivative at their breaks. Over balls, where equality is not decidable, each of these
// would be unsound or does not compile.
//
// Recurrences: A. Griewank, A. Walther, Evaluating Derivatives (2nd ed., 2008), table 13.2; each
// follows from a differential equation of the function, written beside it.

#include <array>
#include <cmath>
#include <concepts>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/special_functions.hpp"

namespace polhode {

inline constexpr int dynamic_order = -1;

template <class T, int Order>
class jet;

namespace detail {
template <class X>
struct is_jet : std::false_type {};
template <class T, int Order>
struct is_jet<jet<T, Order>> : std::true_type {};
template <class X>
concept jet_scalar = !is_jet<std::remove_cvref_t<X>>::value;

/// The integer n as something that combines with T without a conversion that may lose bits.
template <class T>
[[nodiscard]] constexpr auto exact(long n) {
  if constexpr (std::floating_point<T>) {
    return static_cast<T>(n);
  } else {
    return n;
  }
}
/// 0 and 1 of the kind and precision of x (and undefined where x is).
template <class T>
[[nodiscard]] T zero_like(const T& x) {
  return T(x * exact<T>(0));
}
template <class T>
[[nodiscard]] T one_like(const T& x) {
  return T(x * exact<T>(0) + exact<T>(1));
}

[[noreturn]] inline void refuse_orders(int m, int n) {
  throw std::invalid_argument("jets of the orders " + std::to_string(m) + " and " +
                              std::to_string(n) + ": an operation takes jets of one order");
}
[[noreturn]] inline void refuse_order(int order, int fixed) {
  throw std::invalid_argument(
      "a jet of order " + std::to_string(order) + ": " +
      (fixed == dynamic_order ? "it must be 0 or more, and be given where the type leaves it open"
                              : "the type's order is " + std::to_string(fixed)));
}
}  // namespace detail

template <class T, int Order>
class jet {
 public:
  using scalar_type = T;
  using storage = std::conditional_t<Order == dynamic_order, std::vector<T>,
                                     std::array<T, static_cast<std::size_t>(Order) + 1>>;

  /// The function with the constant value c, or the identity at x, to the given order (which must
  /// be Order where that is fixed, and be given where it is open: throws std::invalid_argument
  /// otherwise).
  [[nodiscard]] static jet constant(const T& c, int order = Order) {
    if (order < 0) detail::refuse_order(order, Order);
    jet r(order);
    r[0] = c;
    for (int k = 1; k <= order; ++k) r[k] = detail::zero_like(c);
    return r;
  }
  [[nodiscard]] static jet variable(const T& x, int order = Order) {
    jet r = constant(x, order);
    if (order >= 1) r[1] = detail::one_like(x);
    return r;
  }
  /// A jet with room for the order, to be filled. Without one, where the type leaves it open, a jet
  /// without coefficients, to be assigned.
  explicit jet(int order = Order) {
    if constexpr (Order == dynamic_order) {
      if (order < dynamic_order) detail::refuse_order(order, Order);
      coefficients_.resize(static_cast<std::size_t>(order) + 1);
    } else {
      if (order != Order) detail::refuse_order(order, Order);
    }
  }

  [[nodiscard]] int order() const { return static_cast<int>(coefficients_.size()) - 1; }
  /// The order of both. Throws std::invalid_argument where they differ.
  [[nodiscard]] friend int common_order(const jet& x, const jet& y) {
    if (x.order() != y.order()) detail::refuse_orders(x.order(), y.order());
    return x.order();
  }
  /// f^(k) / k!.
  [[nodiscard]] const T& operator[](int k) const {
    return coefficients_[static_cast<std::size_t>(k)];
  }
  [[nodiscard]] T& operator[](int k) { return coefficients_[static_cast<std::size_t>(k)]; }
  [[nodiscard]] const T& value() const { return coefficients_[0]; }
  /// f^(k), for k up to 20 (k! is a machine integer then).
  [[nodiscard]] T derivative(int k) const {
    long factorial = 1;
    for (int j = 2; j <= k; ++j) factorial *= j;
    return T((*this)[k] * detail::exact<T>(factorial));
  }

  jet& operator+=(const jet& y) { return *this = *this + y; }
  jet& operator-=(const jet& y) { return *this = *this - y; }
  jet& operator*=(const jet& y) { return *this = *this * y; }
  jet& operator/=(const jet& y) { return *this = *this / y; }

  friend jet operator+(const jet& x, const jet& y) {
    return build(common_order(x, y), [&](int k, const jet&) { return T(x[k] + y[k]); });
  }
  friend jet operator-(const jet& x, const jet& y) {
    return build(common_order(x, y), [&](int k, const jet&) { return T(x[k] - y[k]); });
  }
  friend jet operator-(const jet& x) {
    return build(x.order(), [&](int k, const jet&) { return T(-x[k]); });
  }
  friend jet operator+(const jet& x) { return x; }
  friend jet operator*(const jet& x, const jet& y) {
    return build(common_order(x, y), [&](int k, const jet&) { return convolution(x, y, 0, k, k); });
  }
  /// q y = x.
  friend jet operator/(const jet& x, const jet& y) {
    return build(common_order(x, y), [&](int k, const jet& q) {
      return k == 0 ? T(x[0] / y[0]) : T((x[k] - convolution(q, y, 0, k - 1, k)) / y[0]);
    });
  }

  // With a scalar: T itself, or anything that combines with T (machine integers, rationals).
  template <detail::jet_scalar S>
  friend jet operator+(const jet& x, const S& s) {
    jet r = x;
    r[0] = T(x[0] + s);
    return r;
  }
  template <detail::jet_scalar S>
  friend jet operator+(const S& s, const jet& x) {
    return x + s;
  }
  template <detail::jet_scalar S>
  friend jet operator-(const jet& x, const S& s) {
    jet r = x;
    r[0] = T(x[0] - s);
    return r;
  }
  template <detail::jet_scalar S>
  friend jet operator-(const S& s, const jet& x) {
    return -(x - s);
  }
  template <detail::jet_scalar S>
  friend jet operator*(const jet& x, const S& s) {
    return build(x.order(), [&](int k, const jet&) { return T(x[k] * s); });
  }
  template <detail::jet_scalar S>
  friend jet operator*(const S& s, const jet& x) {
    return x * s;
  }
  template <detail::jet_scalar S>
  friend jet operator/(const jet& x, const S& s) {
    return build(x.order(), [&](int k, const jet&) { return T(x[k] / s); });
  }
  template <detail::jet_scalar S>
  friend jet operator/(const S& s, const jet& x) {
    return constant(T(detail::zero_like(x[0]) + s), x.order()) / x;
  }

  /// s s = x: 2 s_0 s_k = x_k - sum of s_j s_(k-j), 0 < j < k.
  friend jet sqrt(const jet& x) {
    using std::sqrt;
    return build(x.order(), [&](int k, const jet& s) {
      return k == 0 ? T(sqrt(x[0]))
                    : T((x[k] - convolution(s, s, 1, k - 1, k)) / (s[0] * detail::exact<T>(2)));
    });
  }
  friend jet square(const jet& x) { return x * x; }
  /// e' = x' e.
  friend jet exp(const jet& x) {
    using std::exp;
    return build(x.order(), [&](int k, const jet& e) {
      return k == 0 ? T(exp(x[0])) : T(weighted(x, e, k) / detail::exact<T>(k));
    });
  }
  /// x l' = x'.
  friend jet log(const jet& x) {
    using std::log;
    return from_slope(x, T(log(x[0])), [](const shorter& y) { return unit(y) / y; });
  }
  /// s' = x' c, c' = -x' s.
  friend std::pair<jet, jet> sin_cos(const jet& x) {
    using std::cos;
    using std::sin;
    jet s(x.order());
    jet c(x.order());
    if constexpr (std::same_as<T, ball>) {
      sin_cos(s[0], c[0], x[0]);  // both for little more than the price of one
    } else {
      s[0] = T(sin(x[0]));
      c[0] = T(cos(x[0]));
    }
    for (int k = 1; k <= x.order(); ++k) {
      s[k] = T(weighted(x, c, k) / detail::exact<T>(k));
      c[k] = T(-weighted(x, s, k) / detail::exact<T>(k));
    }
    return {s, c};
  }
  friend jet sin(const jet& x) { return sin_cos(x).first; }
  friend jet cos(const jet& x) { return sin_cos(x).second; }
  /// s' = x' c, c' = x' s.
  friend jet sinh(const jet& x) { return hyperbolic(x).first; }
  friend jet cosh(const jet& x) { return hyperbolic(x).second; }
  /// t' = (1 + t^2) x', coefficient by coefficient.
  friend jet tan(const jet& x) {
    using std::tan;
    return riccati(x, T(tan(x[0])), 1);
  }
  /// t' = (1 - t^2) x'.
  friend jet tanh(const jet& x) {
    using std::tanh;
    return riccati(x, T(tanh(x[0])), -1);
  }
  // f' = g(x) x', integrated.
  friend jet atan(const jet& x) {
    using std::atan;
    return from_slope(x, T(atan(x[0])),
                      [](const shorter& y) { return unit(y) / (unit(y) + square(y)); });
  }
  friend jet asin(const jet& x) {
    using std::asin;
    return from_slope(x, T(asin(x[0])),
                      [](const shorter& y) { return unit(y) / sqrt(unit(y) - square(y)); });
  }
  friend jet acos(const jet& x) {
    using std::acos;
    return from_slope(x, T(acos(x[0])),
                      [](const shorter& y) { return -unit(y) / sqrt(unit(y) - square(y)); });
  }
  friend jet asinh(const jet& x) {
    using std::asinh;
    return from_slope(x, T(asinh(x[0])),
                      [](const shorter& y) { return unit(y) / sqrt(unit(y) + square(y)); });
  }
  friend jet acosh(const jet& x) {
    using std::acosh;
    return from_slope(x, T(acosh(x[0])), [](const shorter& y) {
      return unit(y) / (sqrt(y - unit(y)) * sqrt(y + unit(y)));
    });
  }
  friend jet atanh(const jet& x) {
    using std::atanh;
    return from_slope(x, T(atanh(x[0])),
                      [](const shorter& y) { return unit(y) / (unit(y) - square(y)); });
  }
  /// f' = (2 / sqrt(pi)) e^(-x^2) x', and minus that.
  friend jet erf(const jet& x) requires std::same_as<T, ball> {
    return from_slope(x, erf(x[0]), [](const shorter& y) { return bell(y); });
  }
  friend jet erfc(const jet& x) requires std::same_as<T, ball> {
    return from_slope(x, erfc(x[0]), [](const shorter& y) { return -bell(y); });
  }
  /// x r' = a r x' for r = x^a: k x_0 r_k = sum of (a j - (k - j)) x_j r_(k-j), 1 <= j <= k. Where
  /// x may be 0 the quotient by x_0, and with it the derivatives, are undefined.
  friend jet pow(const jet& x, const ball& a) requires std::same_as<T, ball> {
    return build(x.order(), [&](int k, const jet& r) {
      if (k == 0) return pow(x[0], a);
      ball sum = detail::zero_like(x[0]);
      for (int j = 1; j <= k; ++j) {
        sum += (a * static_cast<long>(j) - static_cast<long>(k - j)) * x[j] * r[k - j];
      }
      return sum / (x[0] * static_cast<long>(k));
    });
  }
  /// exp(y log x).
  friend jet pow(const jet& x, const jet& y) requires std::same_as<T, ball> {
    return exp(y * log(x));
  }
  /// By repeated squaring; negative powers through the reciprocal.
  friend jet pow(const jet& x, long n) {
    if (n < 0) return detail::one_like(x[0]) / power(x, 0UL - static_cast<unsigned long>(n));
    return power(x, static_cast<unsigned long>(n));
  }

 private:
  /// r[k] = f(k, r), in the order of k: f may read the coefficients already made.
  template <class F>
  [[nodiscard]] static jet build(int order, F&& f) {
    jet r(order);
    for (int k = 0; k <= order; ++k) r[k] = f(k, r);
    return r;
  }
  /// Sum of x_j y_(n-j) for first <= j <= last; 0 where there is no such j.
  [[nodiscard]] static T convolution(const jet& x, const jet& y, int first, int last, int n) {
    T sum = detail::zero_like(x[0]);
    for (int j = first; j <= last; ++j) sum += x[j] * y[n - j];
    return sum;
  }
  /// Sum of j x_j y_(k-j) for 1 <= j <= k: the k-th coefficient of t x' y.
  [[nodiscard]] static T weighted(const jet& x, const jet& y, int k) {
    T sum = detail::zero_like(x[0]);
    for (int j = 1; j <= k; ++j) sum += T(x[j] * detail::exact<T>(j)) * y[k - j];
    return sum;
  }
  [[nodiscard]] static std::pair<jet, jet> hyperbolic(const jet& x) {
    using std::cosh;
    using std::sinh;
    jet s(x.order());
    jet c(x.order());
    s[0] = T(sinh(x[0]));
    c[0] = T(cosh(x[0]));
    for (int k = 1; k <= x.order(); ++k) {
      s[k] = T(weighted(x, c, k) / detail::exact<T>(k));
      c[k] = T(weighted(x, s, k) / detail::exact<T>(k));
    }
    return {s, c};
  }
  /// t' = (1 + sign t^2) x' from t_0.
  [[nodiscard]] static jet riccati(const jet& x, const T& t0, long sign) {
    jet t(x.order());
    jet w(x.order());  // 1 + sign t^2
    const auto factor = detail::exact<T>(sign);
    t[0] = t0;
    w[0] = T(t0 * t0 * factor + detail::exact<T>(1));
    for (int k = 1; k <= x.order(); ++k) {
      t[k] = T(weighted(x, w, k) / detail::exact<T>(k));
      w[k] = T(convolution(t, t, 0, k, k) * factor);
    }
    return t;
  }
  using shorter = jet<T, dynamic_order>;  // of one order less, in what follows
  [[nodiscard]] static shorter unit(const shorter& y) {
    return shorter::constant(detail::one_like(y[0]), y.order());
  }
  /// The jet with f(x_0) = value and f' = slope(x) x'.
  template <class Slope>
  [[nodiscard]] static jet from_slope(const jet& x, T value, Slope&& slope) {
    jet r(x.order());
    r[0] = std::move(value);
    if (x.order() == 0) return r;
    shorter x_prime(x.order() - 1);
    shorter x_lower(x.order() - 1);
    for (int k = 0; k < x.order(); ++k) {
      x_prime[k] = T(x[k + 1] * detail::exact<T>(k + 1));
      x_lower[k] = x[k];
    }
    const shorter r_prime = slope(x_lower) * x_prime;
    for (int k = 1; k <= x.order(); ++k) r[k] = T(r_prime[k - 1] / detail::exact<T>(k));
    return r;
  }
  [[nodiscard]] static shorter bell(const shorter& y) requires std::same_as<T, ball> {
    return exp(-square(y)) * (2 * rsqrt(pi(y[0].precision())));
  }
  [[nodiscard]] static jet power(const jet& x, unsigned long n) {
    jet result = constant(detail::one_like(x[0]), x.order());
    jet base = x;
    while (n != 0) {
      if ((n & 1) != 0) result = result * base;
      n >>= 1;
      if (n != 0) base = square(base);
    }
    return result;
  }

  storage coefficients_;
};

namespace detail {
/// What a function with breaks has at one: its value, and no derivatives.
template <int Order>
[[nodiscard]] jet<ball, Order> value_alone(const ball& value, int order) {
  auto r = jet<ball, Order>::constant(value, order);
  for (int k = 1; k <= order; ++k) r[k] = ball::undefined(value.precision());
  return r;
}
/// A step function with the given value, whose jumps are at the integers.
template <int Order>
[[nodiscard]] jet<ball, Order> step(const jet<ball, Order>& x, const ball& value) {
  const ball below = floor(x[0]);
  if (below.is_exact() && certainly_less(below, x[0]) && certainly_less(x[0], below + 1)) {
    return jet<ball, Order>::constant(value, x.order());
  }
  return value_alone<Order>(value, x.order());
}
}  // namespace detail

/// |x|: +x or -x where the sign is known, else with undefined coefficients beyond the value.
template <int Order>
[[nodiscard]] jet<ball, Order> abs(const jet<ball, Order>& x) {
  switch (sign_of(x[0])) {
    case certain_sign::positive:
      return x;
    case certain_sign::negative:
      return -x;
    default:
      break;
  }
  return detail::value_alone<Order>(abs(x[0]), x.order());
}

/// The lesser (greater) of the two where that is certain, else with undefined coefficients beyond
/// the value.
template <int Order>
[[nodiscard]] jet<ball, Order> min(const jet<ball, Order>& x, const jet<ball, Order>& y) {
  const int order = common_order(x, y);
  if (certainly_less(x[0], y[0])) return x;
  if (certainly_less(y[0], x[0])) return y;
  return detail::value_alone<Order>(min(x[0], y[0]), order);
}
template <int Order>
[[nodiscard]] jet<ball, Order> max(const jet<ball, Order>& x, const jet<ball, Order>& y) {
  const int order = common_order(x, y);
  if (certainly_less(x[0], y[0])) return y;
  if (certainly_less(y[0], x[0])) return x;
  return detail::value_alone<Order>(max(x[0], y[0]), order);
}
/// Constant away from the integers, else with undefined coefficients beyond the value.
template <int Order>
[[nodiscard]] jet<ball, Order> floor(const jet<ball, Order>& x) {
  return detail::step(x, floor(x[0]));
}
template <int Order>
[[nodiscard]] jet<ball, Order> ceil(const jet<ball, Order>& x) {
  return detail::step(x, ceil(x[0]));
}

/// The derivative of f over x.
template <class F, class T>
[[nodiscard]] T derivative(const F& f, const T& x) {
  return f(jet<T, 1>::variable(x))[1];
}

/// An enclosure of the range of f over x by Taylor's formula with Lagrange's remainder of order n
/// >= 1,
///   f(t) = sum over k < n of f_k(m) (t - m)^k + f_n(s) (t - m)^n,   s between m and t,
/// m the middle of x, cut with the range by plain evaluation; n = 1 is the mean value form. Its
/// excess is of order width^2 where that of plain evaluation is of order width (A. Neumaier,
/// Interval Methods for Systems of Equations, 1990, Thm 2.3.3). Where f is not proved n times
/// differentiable over x, plain evaluation alone. f is a generic function: it is called with a ball
/// and with jets.
template <class F>
[[nodiscard]] ball taylor_range(const F& f, const ball& x, int n = 1) {
  ball plain = f(x);
  const ball middle = x.middle();
  if (n < 1 || middle.is_undefined() || plain.is_undefined()) return plain;
  using series = jet<ball, dynamic_order>;
  const series at_middle = f(series::variable(middle, n - 1));
  const series over_x = f(series::variable(x, n));
  const ball h = x - middle;
  ball sum = over_x[n] * pow(h, n);
  for (int k = n - 1; k >= 0; --k) sum += at_middle[k] * pow(h, k);
  if (sum.is_undefined()) return plain;
  const ball both = intersection(plain, sum);
  return both.is_undefined() ? plain : both;
}

}  // namespace polhode
