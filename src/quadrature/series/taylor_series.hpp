#pragma once

// Integrals of hyperexponential functions by their Taylor series.
//
// On a panel, with y = c + r z, h(y) = h(c) g(z), g(0) = 1, and P a polynomial: the integral of P h
// is wanted. As g'/g = S/Q with polynomials Q = q_0 + q_1 z + ..., S = s_0 + s_1 z + ... with
// integer coefficients, q_0 > 0 (and Gaussian integers in S, where h has a factor e^(i t(y)) and is
// complex),
//
//   q_0 (n + 1) a_(n+1) = sum over k >= 0 of (s_k - (n - k) q_(k+1)) a_(n-k),    a_0 = 1,    (1)
//
// for the coefficients of g. They are computed in units of 2^-F, the quotient's parts rounded
// towards 0, until so many in a row are 0 that all later ones are: A(z) is the polynomial of these
// numbers. That is all that has to be known of them.
//
// Theorem. Let Q be positive on an interval I with 0 in it and |z| <= 1 for each z in it, and let 0
// < m <= Q/q_0, 0 < l <= |g| <= u there. If N of the a_n were computed by (1) as quotients of
// numbers that are not 0, then for z in I
//
//   |A(z) - g(z)| <= u / (m l) * N * 2^-F, and sqrt(2) times as much where S is complex.
//
// Proof. Let D = Q A' - S A. Its n-th coefficient is q_0 (n + 1) a_(n+1) less the right-hand side
// of (1), formed from the rounded numbers; it is what the division left over, less than q_0 (n + 1)
// units in each part for N of the n, and 0 for all others. As (A/g)' = (Q A' - S A)/(Q g) = D/(Q g)
// and A(0)/g(0) = 1, |A/g - 1| is at most |D|/(Q |g|) integrated from 0 to z, and so at most 1/(m l
// q_0) times the integral of |D|. Of q_0 (n + 1) t^n that is q_0 |z|^(n+1) <= q_0: in all, at most
// N q_0 units, or sqrt(2) times that. QED. As |e^(i t)| = 1, |g| is what it is without that factor.
//
// Neither the radius of convergence nor the size of the rest of the series is needed: the number of
// terms is found, and the theorem's hypotheses are inequalities between real numbers, which
// interval arithmetic proves.
//
// At an end where h(y) = r^e z^e g(z), e > -1, the same is done with g, and z^e A(z) is integrated.
//
// A range of y is cut into panels, of which the first and the last may be cut off at an end that is
// not rational. That the panels make up the range is proved where they are added up (tiling.hpp),
// not by the panels.

#include <optional>

#include "hyperexponential.hpp"
#include "quadrature/formula/integrand.hpp"

namespace polhode::detail {

/// The integral by Taylor series, where f is found to be a sum of hyperexponential functions
/// (hyperexponential.hpp) and the goal is reached: then it is certified. Otherwise returns nullopt.
/// a < b as far as is known.
[[nodiscard]] std::optional<integral> integrate_by_taylor_series(const integrand& f,
                                                                 const end_point& a,
                                                                 const end_point& b,
                                                                 const integrate_options& options);

}  // namespace polhode::detail
