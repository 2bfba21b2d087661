#pragma once

// Where the curve C of the tennis racket effect meets the curve S (c = -b sin^2 epsilon) and the
// line epsilon = pi/2: the paper's lemmas 2 and 3 and its theorem 4, sharpened.
//
// For -b < c < 0 let psi_c(phi) be the solution with psi = 0 and cos theta > 0 at phi = 0, and
// epsilon(c) = pi/2 - psi_c(pi). The system keeps its form under (psi, phi) -> (-psi, -phi), and
// under (theta, phi) -> (pi - theta, -phi); its solutions are determined by their values at one phi
// (Picard and Lindeloef). By the first, psi_c is odd; psi increases up to the turning point, where
// cos theta = 0, in the angle F(c,u)/2 = G(u)/2, u = -c/b; by the second it returns as it came. So
// psi_c(phi + G) = -psi_c(phi), and
//   psi_c(pi) = 0           exactly where pi = k G(u), k = 1, 2, ...:
//     epsilon = pi/2, G(u) = pi/k;
//   psi_c(pi) is extreme    exactly where pi = (k - 1/2) G(u), k = 1, 2, ...:  C meets S,
//     G(u) = 2 pi/(2k - 1).
// G maps (0, 1) one to one onto (pi I, infinity), decreasing (half_phase.hpp). So
//   - C meets S first at G = 2 pi, at exactly one u in (0, 1) where I < 2, and nowhere there
//     otherwise (the paper's "u in (0, 1], I <= 2" counts the limit u = 1 at I = 2, where c = -b is
//     an equilibrium);
//   - epsilon = pi/2 is crossed once for every k < 1/I: ceil(1/I) - 1 times, so at all exactly
//     where I < 1;
//   - C meets S once for every k < 1/I + 1/2: N = ceil(1/I + 1/2) - 1 times, u_1 < u_2 < ..., and
//     between u_k and u_(k+1), or u_N and 1, at most one crossing, G = pi/k, since 2 pi/(2k-1) >
//     pi/k > 2 pi/(2k+1).
// The paper's theorem: I < 2/(2n+1) is n + 1 < 1/I + 1/2, so N >= n + 1 (its "at least n" and
// "another one"), and c* with G = pi/n lies beyond the n-th. Both numbers are exact questions about
// b (a+b)/(1-b)^2 = 1/I^2.

#include <functional>
#include <string>

#include "proofs/half_phase.hpp"

namespace polhode::proofs {

/// "2 pi/3", "pi".
[[nodiscard]] std::string multiple_of_pi(const rational& q);

/// "k = 1 and no other k >= 1", "k = 1 ... 3 and no other k >= 1", "no k >= 1".
[[nodiscard]] std::string counted(const integer& count);

/// Adds brackets of the roots of G(u) = q(k) pi for k = 1 ... count, the first six of them, each a
/// fact, and all to witness[key].
void add_brackets(certificate& c, const body& rigid, const integer& count,
                  const std::function<rational(int k)>& q, const std::string& key);

/// Adds the fact that I >= q, in rationals, with G(1/2) > q pi as a check by another route.
void add_absence(certificate& c, const body& rigid, const rational& q);

}  // namespace polhode::proofs
