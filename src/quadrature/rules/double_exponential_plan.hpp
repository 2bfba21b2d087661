#pragma once

// The proof of the double exponential rule (polhode/quadrature/double_exponential.hpp): bounds of
// the integrand in t, in a rectangle and beyond it.

#include <functional>
#include <optional>

#include "polhode/quadrature/double_exponential.hpp"
#include "quadrature/ends/end_series.hpp"
#include "quadrature/rules/trapezoid_plan.hpp"

namespace polhode::detail {

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

}  // namespace polhode::detail
