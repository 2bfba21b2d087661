#pragma once

// The double exponential (tanh-sinh) rule, for functions on (a, b) that may be singular at both
// ends. With
//
//   x = (a+b)/2 + ((b-a)/2) tanh((pi/2) sinh t),   v = e^(pi sinh t),
//   x - a = (b-a) v/(1 + v),   b - x = (b-a)/(1 + v),   dx/dt = pi cosh(t) (x - a)(b - x)/(b - a)
//
// the integral becomes one over all t, of a function that falls like e^(-c e^|t|): the trapezoidal
// rule's case (trapezoid.hpp). x - a and b - x are computed as above, without cancellation. Source
// of the substitution: H. Takahasi, M. Mori, Publ. RIMS 9 (1974).
//
// f is a function of x, or one of two arguments f(x - a, b - x), which loses nothing near the ends:
//
//   integrate_double_exponential([](auto x) { return sqrt(x) * log(x); }, 0, 1, 300);
//   integrate_double_exponential([](auto u, auto v) { return 1 / sqrt(u * v); }, -1, 1, 300);

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>

#include "polhode/arithmetic/generic_function.hpp"
#include "polhode/quadrature/end_series.hpp"
#include "polhode/quadrature/trapezoid.hpp"

namespace polhode {

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

/// What is known of f near an end. At a complex x at the distance s from it, 0 < |s| <= reach,
/// however often the path to x went around the end,
///
///   |f(x)| <= factor |s|^exponent (1 + |log s|)^log_degree,
///
/// with log s continued along the path; and f is analytic there, continued from the real range.
struct end_growth {
  rational exponent = 0;  // > -1
  int log_degree = 0;
  magnitude factor;
  double reach = 0;
};

/// From the series of f as a function of the distance: |sum of L^k G_k| <= (1 + |L|)^K times the
/// sum of |G_k|. Nothing where there is none. reach is the half-side of the square over which the
/// series was made.
[[nodiscard]] std::optional<end_growth> growth_from_series(const end_series& series, double reach);

namespace detail {

/// f near one end after another, and over inner regions of t: what the proof needs.
struct double_exponential_problem {
  rational a;
  rational b;
  /// f at a region of the distances.
  std::function<region(const region& left, const region& right)> over;
  end_growth left;
  end_growth right;

  /// An upper bound of what the range |t| <= T leaves out, T > 0.
  [[nodiscard]] magnitude beyond(double range) const;
  /// The bounds for the rectangle |Re t| <= T, |Im t| <= d.
  [[nodiscard]] std::optional<rectangle_bound> rectangle(double range, double d,
                                                         long& evaluations) const;
};

/// A range for which beyond() is less than 2^-bits, and so much less that the sides do not matter;
/// 0 for none.
[[nodiscard]] double range_for(const double_exponential_problem& problem, long bits);

}  // namespace detail

/// Encloses the integral of f over (a, b) in a ball of radius at most 2^-bits. f is one generic
/// function, of x or of (x - a, b - x), called with regions (to prove it analytic around the open
/// range), with an end_series (to bound it near the ends; not where growth is given for an end) and
/// with balls. Verdicts: as for integrate_line; not_analytic also where there is no series at an
/// end, not_integrable where that says that f grows too fast. Throws std::invalid_argument unless a
/// < b, and where a growth that is given has an exponent <= -1 or no reach.
template <class F>
[[nodiscard]] line_integral integrate_double_exponential(
    const F& f, const rational& a, const rational& b, long bits,
    const std::optional<end_growth>& left = std::nullopt,
    const std::optional<end_growth>& right = std::nullopt, const line_options& options = {}) {
  if (!(a < b)) {
    throw std::invalid_argument("integrate_double_exponential: the range needs a < b");
  }
  for (const auto& given : {left, right}) {
    if (given && !(given->exponent > -1 && given->reach > 0 && given->log_degree >= 0)) {
      throw std::invalid_argument(
          "integrate_double_exponential: a growth needs an exponent > -1 and a reach > 0");
    }
  }
  const rational length = b - a;
  detail::double_exponential_problem problem{a, b, {}, {}, {}};
  problem.over = [&](const region& u, const region& v) {
    // Which of the two ends x is computed from makes no difference to the set that it is in.
    if constexpr (std::is_invocable_v<const F&, const region&, const region&>) {
      return detail::value_as<region>(f(u, v), u);
    } else {
      const bool nearer_to_a = u.magnitude_upper() < v.magnitude_upper();
      const region x = nearer_to_a ? a + u : b - v;
      return detail::value_as<region>(f(x), x);
    }
  };
  line_integral result;
  const auto find = [&](const std::optional<end_growth>& given, bool at_a) {
    if (given) return given;
    // The farther the series reaches, the higher the rectangle that can be proved.
    for (const rational& part : {rational(15, 16), rational(3, 4), rational(1, 2), rational(1, 4),
                                 rational(1, 16), rational(1, 256)}) {
      const double reach = double_interval(rational(length * part)).midpoint();
      const known_number zero;
      const known_number one(rational(1));
      const known_number minus(rational(-1));
      end_series series;
      if constexpr (std::is_invocable_v<const F&, const end_series&, const end_series&>) {
        const end_series near = end_series::argument(zero, one, 1, reach);
        const end_series far = end_series::argument(known_number(length), minus, 1, reach);
        series = detail::value_as<end_series>(at_a ? f(near, far) : f(far, near), near);
      } else {
        const end_series x =
            end_series::argument(known_number(at_a ? a : b), at_a ? one : minus, 1, reach);
        series = detail::value_as<end_series>(f(x), x);
      }
      std::optional<end_growth> found = growth_from_series(series, reach);
      if (found) return found;
    }
    return given;
  };
  const std::optional<end_growth> at_a = find(left, true);
  const std::optional<end_growth> at_b = find(right, false);
  if (!at_a || !at_b) {
    result.why = reason::not_analytic;
    return result;
  }
  if (at_a->exponent <= -1 || at_b->exponent <= -1) {
    result.why = reason::not_integrable;
    return result;
  }
  problem.left = *at_a;
  problem.right = *at_b;
  const double range = detail::range_for(problem, bits + 3);
  if (range == 0) {
    result.why = reason::precision_limit;
    return result;
  }
  long evaluations = 0;
  constexpr double highest = 1.5;  // < pi/2
  line_plan plan =
      plan_trapezoid([&](double d) { return problem.rectangle(range, d, evaluations); },
                     rational(2 * rational(range)), highest, bits + 2, options.most_nodes);
  plan.region_evaluations = evaluations;
  return detail::carry_out(
      std::move(plan),
      [&](long n, precision p) {
        const auto real = detail::evaluator_of<ball>(f, p);
        if constexpr (std::is_invocable_v<decltype(real), const ball&, const ball&>) {
          const auto g = [&](const ball& u, const ball& v) -> ball {
            return detail::value_as<ball>(real(u, v), u);
          };
          return double_exponential_sum<ball>(g, a, b, rational(range), n, p);
        } else {
          const auto g = [&](const ball& x) -> ball { return detail::value_as<ball>(real(x), x); };
          return double_exponential_sum<ball>(g, a, b, rational(range), n, p);
        }
      },
      bits, problem.beyond(range), options);
}

}  // namespace polhode
