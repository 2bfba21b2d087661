#pragma once

// The trapezoidal rule (by midpoints) over a range at whose ends the function is small: there it
// converges geometrically, as it does for periodic functions, at the rate of the height of the
// rectangle in which the function is analytic. What lies beyond the range, the caller has to bound.

#include <functional>
#include <optional>

#include "polhode/arithmetic/exact.hpp"
#include "polhode/arithmetic/region.hpp"
#include "polhode/arithmetic/verdict.hpp"
#include "polhode/quadrature/error_bounds.hpp"
#include "polhode/quadrature/periodic_trapezoid.hpp"

namespace polhode::detail {

/// A number of nodes and the proof that it suffices.
struct line_plan {
  long nodes = 0;              // 0 where no plan was found
  rectangle_bound rectangle;   // what the proof rests on
  magnitude truncation_error;  // >= |rule - integral|
  reason why = reason::none;   // where nodes == 0
  long region_evaluations = 0;
};

struct line_integral : trapezoid_integral {
  line_plan plan;
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

/// The sum and its proof, for a plan that was made for 2^-(bits + 1): sum(n, p) is the rule's value
/// with n nodes and p bits, beyond bounds what its range leaves out.
[[nodiscard]] line_integral carry_out(line_plan plan,
                                      const std::function<ball(long n, precision p)>& sum,
                                      long bits, const magnitude& beyond,
                                      const trapezoid_options& options);

}  // namespace polhode::detail
