#pragma once

// The trapezoidal rule (by midpoints) for functions that are small at both ends of a range: there
// it converges geometrically, as it does for periodic ones, at the rate of the strip in which the
// function is analytic.
//
//   line_integral i = integrate_line([](auto x) { return exp(-x * x); }, -20, 20, 500);
//
// What is certified is the integral over the finite range; what lies beyond, the caller has to
// bound.

#include <functional>
#include <optional>
#include <stdexcept>
#include <string>

#include "polhode/arithmetic/generic_function.hpp"
#include "polhode/arithmetic/region.hpp"
#include "polhode/arithmetic/verdict.hpp"
#include "polhode/quadrature/error_bounds.hpp"
#include "polhode/quadrature/integrate.hpp"
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

struct line_options {
  long most_nodes = 20'000'000;
  precision most_precision = precision{1} << 26;
};

/// A number of nodes and the proof that it suffices.
struct line_plan {
  long nodes = 0;              // 0 where no plan was found
  rectangle_bound rectangle;   // what the proof rests on
  magnitude truncation_error;  // >= |rule - integral|
  reason why = reason::none;   // where nodes == 0
  long region_evaluations = 0;
};

/// An integral with its proof, or how far it got.
struct line_integral {
  ball enclosure = ball::undefined(64);  // undefined where nothing is proved
  status verdict = status::not_certified;
  reason why = reason::none;
  line_plan plan;
  polhode::precision precision = 0;  // working bits
  long evaluations = 0;              // of f at real nodes, over all precisions tried
};

/// What can be proved about a function in the rectangle of half the height d; nothing where that is
/// not enough.
using bound_on_rectangle = std::function<std::optional<rectangle_bound>(double d)>;

/// Looks for the least n for which the proved truncation error over a range of so great a length is
/// at most 2^-bits, and for the height <= highest that proves it. The search is heuristic; the
/// error in the result is proved. Fails with not_analytic where no rectangle was proved, with
/// evaluation_limit where n would exceed most_nodes: so it is where f is not small at the ends.
[[nodiscard]] line_plan plan_trapezoid(const bound_on_rectangle& bound, const rational& length,
                                       double highest, long bits, long most_nodes);

namespace detail {

using region_function = std::function<region(const region& z)>;

/// f is proved analytic on a neighbourhood of the closed rectangle left <= Re z <= right, 0 <= Im z
/// <= d, by tiles that are halved where they do not prove it: each is, they cover the rectangle,
/// and f is one formula.
[[nodiscard]] bool is_analytic_on(const region_function& f, double left, double right, double d,
                                  long& evaluations);

/// An upper bound of the integral of |f(x + i d)| dx over [left, right], from tiles; infinite where
/// f is not proved analytic there.
[[nodiscard]] magnitude integral_along(const region_function& f, double left, double right,
                                       double d, long& evaluations);

/// What integrate_line rests on, for an f that is real on [a, b]: with its analyticity on the upper
/// half of the rectangle Schwarz's reflection f(conj z) = conj f(z) continues it to the lower half,
/// with the same |f|.
[[nodiscard]] std::optional<rectangle_bound> bound_of_real_function(const region_function& f,
                                                                    const rational& a,
                                                                    const rational& b, double d,
                                                                    long& evaluations);

/// The sum and its proof, for a plan that was made for 2^-(bits + 1): sum(p) is the rule's value
/// with p bits, beyond bounds what its range leaves out.
[[nodiscard]] line_integral carry_out(line_plan plan,
                                      const std::function<ball(long n, precision p)>& sum,
                                      long bits, const magnitude& beyond,
                                      const line_options& options);

}  // namespace detail

/// Encloses the integral of f over [a, b] in a ball of radius at most 2^-bits, by the trapezoidal
/// rule. f is as for integrate: one generic function, called with a region (to prove it analytic in
/// a rectangle around [a, b]) and with a ball. It takes fewest nodes where f is, at the ends, not
/// much greater than 2^-bits. Verdicts: certified; not_certified with not_analytic,
/// evaluation_limit (as where f is not small at the ends), precision_limit, not_defined (f is
/// undefined at a node). Throws std::invalid_argument unless a < b.
template <class F>
[[nodiscard]] line_integral integrate_line(const F& f, const rational& a, const rational& b,
                                           long bits, const line_options& options = {}) {
  if (!(a < b)) throw std::invalid_argument("integrate_line: the range needs a < b");
  const detail::region_function over = [&](const region& z) {
    return detail::value_as<region>(f(z), z);
  };
  long evaluations = 0;
  constexpr double highest = 1024;
  line_plan plan = plan_trapezoid(
      [&](double d) { return detail::bound_of_real_function(over, a, b, d, evaluations); },
      rational(b - a), highest, bits + 1, options.most_nodes);
  plan.region_evaluations = evaluations;
  return detail::carry_out(
      std::move(plan),
      [&](long n, precision p) {
        const auto real = detail::evaluator_of<ball>(f, p);
        const auto g = [&](const ball& x) -> ball { return detail::value_as<ball>(real(x), x); };
        return trapezoid_sum<ball>(g, a, b, n, p);
      },
      bits, magnitude(), options);
}

}  // namespace polhode
