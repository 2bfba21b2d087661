#pragma once

// The truncation errors of the quadrature rules: every bound with its hypotheses and its proof or
// source. All are computed in balls; a caller takes the upper end.

#include "polhode/arithmetic/ball.hpp"

namespace polhode {

/// What is known of a 2 pi-periodic function f in a strip of the complex plane.
struct strip_bound {
  ball half_width;  // H > 0: f is analytic in |Im t| < H' for some H' > H ...
  ball supremum;    // ... and |f| <= M for |Im t| <= H
};

/// |T_N - I| for I the integral of f over one period and T_N the trapezoidal rule with N nodes
/// 2 pi (k + s) / N, at any shift s:
///
///   |T_N - I| <= 4 pi M / (e^(H N) - 1).
///
/// Source: L. N. Trefethen, J. A. C. Weideman, SIAM Review 56 (2014), Theorem 3.2. Proof: let
/// f = sum c_k e^(i k t). Moving the line of integration to Im t = -+H gives |c_k| <= M e^(-H |k|).
/// The rule integrates e^(i k t) exactly unless N divides k != 0, when it gives 2 pi e^(2 pi i k s / N)
/// instead of 0. So |T_N - I| <= 2 pi * 2 * sum over j >= 1 of M e^(-H N j), which is the bound.
///
/// Hypotheses: bound.half_width is certainly positive (else the result is undefined), N >= 1, and the
/// two statements of strip_bound, which its maker has proved.
[[nodiscard]] ball periodic_trapezoid_error(const strip_bound& bound, long nodes);

}  // namespace polhode
