#pragma once

// F(c,0), half the Montgomery phase of rotating motion, as a function of c: what theorem 2 and the
// perfect twist rest on.
//
// For 0 < c <= a, with X = cos^2 psi,
//   F(c,0) = 2 integral from 0 to pi/2 of (1 - b X)/sqrt((a + b X)(c + b X)) dpsi.
//   (1) The integrand is positive and decreases strictly in c, so F(c,0) does; it is continuous in
//       (psi, c) for c > 0, so F(c,0) is.
//   (2) 1 <= (a + b X)/(c + b X) <= a/c. So, with P = 2 integral of (1 - b X)/(a + b X),  P <
//       F(c,0) <= P sqrt(a/c) for c < a, and P is the limit for c -> a and the greatest lower
//       bound.
//   (3) P = pi J: (1 - b X)/(a + b X) = (1 + a)/(a + b X) - 1, and with T = tan psi and k^2 = a/(a
//       + b) the derivative of arctan(k T)/sqrt(a (a+b)) is 1/(a + b X), so that the integral of
//       the latter is pi/(2 sqrt(a (a+b))).
//   (4) F(c,0) >= 2 I arsinh((pi/2) sqrt(b/c)), which has no bound as c -> 0: 1 - b X >= 1 - b, a +
//       b X <= a + b, and cos psi <= pi/2 - psi = s, where the integral of ds/sqrt(c + b s^2) is
//       arsinh(s sqrt(b/c))/sqrt(b).
// So F(c,0) maps (0, a) one to one onto (pi J, infinity), decreasing.

#include <vector>

#include "proofs/body_facts.hpp"
#include "proofs/exact_polynomial.hpp"

namespace polhode::proofs {

/// Whether the phase decreases and keeps within the proof's bounds at c = a/4, a/2, 3a/4, computed
/// by the AGM.
[[nodiscard]] bool rotating_phase_obeys_its_bounds(const body& rigid);

/// q > J, decided in rationals: (q+1)^2 a (a + b) > (a + 1)^2 for q > -1.
[[nodiscard]] bool exceeds_second_geometric_constant(const rational& q, const body& rigid);

/// A bracket of c/a for the root of F(c,0) = q pi, which exists exactly where q > J.
[[nodiscard]] std::optional<root_bracket> bracket_rotating_phase_root(const body& rigid,
                                                                      const rational& q,
                                                                      int bits = 40);

/// Whether F(c,0) passes q pi between c = a lower and c = a upper, evaluated again.
[[nodiscard]] bool passes_rotating_phase(const body& rigid, const rational& q,
                                         const root_bracket& bracket);

}  // namespace polhode::proofs
