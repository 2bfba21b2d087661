#pragma once

// f and f' over an interval, by Taylor's formula too.

#include "polhode/roots/real_function.hpp"

namespace polhode::detail {

using series_type = jet<ball, dynamic_order>;

/// f and f' over X by Taylor's formula about m, cut with what is known of them:
///   f(x) = sum over k < n of f_k(m) h^k + f_n(t) h^n, h = x - m, t in X, and f'(x) = sum of k
///   f_k(m) h^(k-1) + n f_n(t') h^(n-1): the derivative's coefficients are k f_k, and f_n over X
///   bounds its last one.
struct enclosed_function {
  ball value;
  ball slope;
};
[[nodiscard]] enclosed_function taylor(const series_type& at_middle, const series_type& over,
                                       const ball& h);

/// f' over x, by Taylor's formula too where plain evaluation does not tell its sign.
[[nodiscard]] ball slope_over(const function_evaluator& e, const ball& x, const real_function& f);

}  // namespace polhode::detail
