#pragma once

// The trapezoidal rule by midpoints, and the double exponential (tanh-sinh) rule: that rule on the
// whole line after a substitution. For functions on (a, b) that may be singular at both ends: with
//
//   x = (a+b)/2 + ((b-a)/2) tanh((pi/2) sinh t),   v = e^(pi sinh t),
//   x - a = (b-a) v/(1 + v),   b - x = (b-a)/(1 + v),   dx/dt = pi cosh(t) (x - a)(b - x)/(b - a)
//
// the integral becomes one over all t, of a function that falls like e^(-c e^|t|). x - a and b - x
// are computed as above, without cancellation. Source of the substitution: H. Takahasi, M. Mori,
// Publ. RIMS 9 (1974). These are the sums. The rule with its proof is
// quadrature_rule::double_exponential of `integrate`.

#include <concepts>
#include <stdexcept>
#include <type_traits>

#include "polhode/quadrature/rule_sum.hpp"

namespace polhode {

/// h times the sum of f(a + (j + 1/2) h), j = 0 ... n-1, h = (b - a)/n, with p bits. With T = ball
/// an enclosure of the rule's value, with T = mpfr_float the uncertified value. It calls f n times.
/// Throws std::invalid_argument for n < 1.
template <scalar T, class F>
requires function_on<F, T>
[[nodiscard]] T trapezoid_sum(const F& f, const rational& a, const rational& b, long n,
                              precision p) {
  if (n < 1) throw std::invalid_argument("trapezoid_sum: at least 1 node is needed");
  const T start = scalar_from<T>(a, p);
  const T half_step = scalar_from<T>(rational((b - a) / (2 * n)), p);
  T sum = scalar_from<T>(0, p);
  for (long j = 0; j < n; ++j) sum += f(T(start + half_step * (2 * j + 1)));
  return T(sum * (2 * half_step));
}

namespace detail {

/// f(left, right), or f at the x that has these distances from the ends, taken from the nearer one.
template <class F, class Y, class A>
[[nodiscard]] decltype(auto) at_distances(const F& f, const Y& left, const Y& right, const A& a,
                                          const A& b, bool nearer_to_a) {
  if constexpr (std::is_invocable_v<const F&, const Y&, const Y&>) {
    return f(left, right);
  } else {
    return f(nearer_to_a ? Y(a + left) : Y(b - right));
  }
}

/// e^x with the precision of x.
[[nodiscard]] inline mpfr_float exp_of(const mpfr_float& x) {
  mpfr_float r = zero_of_precision(precision_of(x));
  mpfr_exp(r.backend().data(), x.backend().data(), MPFR_RNDN);
  return r;
}
[[nodiscard]] inline ball exp_of(const ball& x) { return exp(x); }

}  // namespace detail

/// The trapezoidal rule with n nodes t over -range <= t <= range after the substitution, with p
/// bits. With T = ball an enclosure of the rule's value, with T = mpfr_float the uncertified value.
/// It calls f n times, in pairs of points symmetric about the middle. f(x) or f(x - a, b - x) must
/// be a T. Throws std::invalid_argument for n < 1.
template <scalar T, class F>
[[nodiscard]] T double_exponential_sum(const F& f, const rational& a, const rational& b,
                                       const rational& range, long n, precision p) {
  if (n < 1) throw std::invalid_argument("double_exponential_sum: at least 1 node is needed");
  const T start = scalar_from<T>(a, p);
  const T end = scalar_from<T>(b, p);
  const T length = scalar_from<T>(rational(b - a), p);
  const T half_pi(scalar_pi<T>(p) / 2);
  const T half_step = scalar_from<T>(rational(range / n), p);
  const T one = scalar_from<T>(1, p);
  const auto value = [&](const T& left, const T& right, bool nearer_to_a) -> T {
    static_assert(std::same_as<std::remove_cvref_t<decltype(detail::at_distances(
                                   f, left, right, start, end, nearer_to_a))>,
                               T>,
                  "f has to answer with a T: let a lambda over mpfr_float say -> T");
    return detail::at_distances(f, left, right, start, end, nearer_to_a);
  };
  T sum = scalar_from<T>(0, p);
  if (n % 2 != 0) {
    const T half(length / 2);
    sum = value(half, half, true) / 2;  // cosh 0 = 1, and near far / length = length / 4: see below
    sum = T(sum * half);
  }
  // t = k h/2 for k = 1, 3, ... or 2, 4, ...; cosh t and sinh t from e^t.
  for (long k = n % 2 != 0 ? 2 : 1; k < n; k += 2) {
    const T e = detail::exp_of(T(half_step * k));
    const T inverse(one / e);
    const T w = detail::exp_of(T(half_pi * T(inverse - e)));  // 1/v
    const T far(length / T(one + w));
    const T near(far * w);
    T pair = value(near, far, true);
    pair += value(far, near, false);
    // cosh(t) near far / length, near far = w far^2
    const T weight(T(T(e + inverse) * near) * T(far / T(2 * length)));
    detail::accumulate(sum, weight, pair);
  }
  // times pi and the step
  return T(sum * T(T(4 * half_pi) * half_step));
}

}  // namespace polhode
