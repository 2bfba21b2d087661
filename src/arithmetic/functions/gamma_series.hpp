#pragma once

// Gamma and log Gamma by Stirling's series, for real and for complex balls.
//
// For Re w > 0, with the Bernoulli numbers B_2k:
//
//   log Gamma(w) = (w - 1/2) log w - w + log(2 pi)/2
//                  + sum over 0 < k < N of B_2k/(2k (2k-1) w^(2k-1)) + R_N(w),
//   R_N(w) = (1/2N) integral over t > 0 of (B_2N - B_2N({t})) (w + t)^(-2N) dt
//
// (Euler and Maclaurin; E. T. Whittaker, G. N. Watson, A Course of Modern Analysis, 12.33).
// B_2N({t}) is at most |B_2N| in size, so that the numerator has the sign of B_2N or is 0, and B_2N
// alternates in sign with N. So R_N(x) and R_(N+1)(x) have opposite signs for x > 0, and each is
// smaller than their difference: |R_N(x)| is at most the first term left out; and so for the
// derivative R_N', whose integral has (w + t)^(-2N-1). For complex w = |w| e^(i a):
// |w + t|^2 - (|w| + t)^2 cos^2(a/2) = (1 - cos a)/2 (|w| - t)^2 >= 0, so that
//
//   |R_N(w)| <= sec^(2N)(a/2) |R_N(|w|)|,  |R_N'(w)| <= sec^(2N+1)(a/2) |R_N'(|w|)|,
//
// with sec^2(a/2) = 2/(1 + cos a) = 2 |w|/(|w| + Re w) < 2.
//
// Gamma(z) = Gamma(z + n)/(z (z + 1) ... (z + n - 1)) leads to such a w = z + n.

#include <cstddef>
#include <optional>

#include "polhode/arithmetic/complex_ball.hpp"

namespace polhode::detail {

/// log Gamma(w) by the terms with k < N, the bound of R_N included, for Re w > 0 and N >= 1.
[[nodiscard]] ball log_gamma_by_terms(const ball& w, std::size_t terms);
[[nodiscard]] complex_ball log_gamma_by_terms(const complex_ball& w, std::size_t terms);

/// Gamma(x) for a narrow set of positive numbers, and for exact ones that are negative and no whole
/// numbers, to about the set's precision. Nothing for a set, size or precision for which another
/// way is better.
[[nodiscard]] std::optional<ball> gamma_by_series(const ball& x);
/// log Gamma(x) for a narrow set of positive numbers; likewise.
[[nodiscard]] std::optional<ball> log_gamma_by_series(const ball& x);

/// For Re z > 0; undefined elsewhere.
[[nodiscard]] complex_ball log_gamma_by_series(const complex_ball& z);

}  // namespace polhode::detail
