#pragma once

// 1/Gamma(1 + t) by its Taylor series at 0, for real |t| <= 1/2.
//
// f(t) = 1/Gamma(1 + t) = sum over k >= 0 of d_k t^k is entire, and f'/f = -psi(1 + t) = gamma -
// sum over j >= 2 of (-1)^j zeta(j) t^(j-1) (DLMF 5.7.4), so that d_0 = 1 and
//
//   k d_k = gamma d_(k-1) - zeta(2) d_(k-2) + zeta(3) d_(k-3) - ... + (-1)^(k+1) zeta(k) d_0.
//
// For |z| <= R, a whole number, f(z) = (1 + z)(2 + z)...(R + z)/Gamma(1 + R + z), and the real part
// of 1 + R + z is at least 1. For x >= 1 and real y:
//   |Gamma(x + iy)| >= Gamma(x) sech(pi y)^(1/2) (DLMF 5.6.7), and cosh(pi y) <= e^(pi |y|);
//   Gamma(x) > 3/4. As psi increases, log Gamma is convex, and it increases from 2 on, where psi is
//   1 - gamma > 0. Between 1 and 2 it is above its tangents at both ends, where its slopes are
//   -gamma and 1 - gamma: above -gamma (1 - gamma), where they meet, and this is at least -1/4 and
//   log(3/4) < -1/4.
// So |f(z)| <= B = (4/3) e^(pi R/2) (R + 1)(R + 2)...(2R), and by Cauchy's estimate |d_k| <= B/R^k.
// For |t| <= 1/2 and R >= 1 the terms from the one with t^K on are together at most
//
//   B (|t|/R)^K/(1 - |t|/R) <= 2 B (|t|/R)^K.

#include <cstddef>
#include <optional>

#include "polhode/arithmetic/ball.hpp"

namespace polhode::detail {

/// 1/Gamma(1 + t) by the terms with k < K, the bound of the others included, for |t| <= 1/2 and K
/// >= 1.
[[nodiscard]] ball reciprocal_gamma_by_terms(const ball& t, std::size_t terms);

/// Gamma(x) at an exact x > 0 to about p bits; nothing where the series is not the better way.
[[nodiscard]] std::optional<ball> gamma_by_taylor_series(const ball& x, precision p);

}  // namespace polhode::detail
