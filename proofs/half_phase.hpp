#pragma once

// G(u) = F(-b u, u), half the Montgomery phase of oscillating motion, as a function of u: what the
// theorem on the phase, the intersections with the curve S and the count theorem rest on.
//
// For a > 0, 0 < b < 1 let g(x) = (1 - b x)/sqrt(x (a + b x)) on (0, 1]. Then
//
//   (1) G(u) = b^(-1/2) integral from 0 to pi of g(x) dt,  x = u + (1 - u) k,  k = cos^2(t/2).
//   (2) g decreases strictly, so G does: for every t in (0, pi), x increases strictly in u.
//   (3) pi I <= G(u) <= pi I g(u)/g(1), with I = g(1)/sqrt(b), since u <= x <= 1. So G(u) -> pi I
//       as u -> 1, G is continuous there when it is given this value, and G(u) > pi I for u < 1.
//   (4) G(u) >= 2 I arsinh(pi/(2 sqrt(u))), which has no bound as u -> 0.
//
// So G maps (0, 1) one to one onto (pi I, infinity), decreasing (it is continuous: the integrand is
// continuous in (t, u) on [0, pi] x [u_0, 1] for every u_0 > 0). Hence G(u) = v has exactly one
// solution in (0, 1) where v > pi I, and none where v <= pi I.
//
// Proof of (1). F(c,u) = integral from u to 1 of (1 - b x)/sqrt(x (1-x) (a + b x)(c + b x)) dx with
// c = -b u, where c + b x = b (x - u). With x = u + (1-u) k, dx = (1-u) dk and (1-x)(x-u) = (1-u)^2
// k (1-k), so that dx/sqrt((1-x)(x-u)) = dk/sqrt(k (1-k)), and this is -dt for k = cos^2(t/2).
// Proof of (2). The derivative of g^2 is -(1 - b x)(a + (a+2) b x)/(x (a + b x))^2, and 1 - b x >
// 0. Proof of (4). 1 - b x >= 1 - b, a + b x <= a + b and x <= u + k give g(x)/sqrt(b) >= I/sqrt(u
// + k). With t = pi - 2 s, k = sin^2 s <= s^2, and 2 integral from 0 to pi/2 of ds/sqrt(u + s^2) =
// 2 arsinh(pi/(2 sqrt(u))).

#include <vector>

#include "polhode/rigid_body/body.hpp"
#include "proofs/body_facts.hpp"
#include "proofs/exact_polynomial.hpp"

namespace polhode::proofs {

/// Whether (3) and (4) and the decrease hold for this body at u = 1/4, 1/2, 3/4, with G by the AGM:
/// numbers that share no formula with the proof.
[[nodiscard]] bool half_phase_obeys_its_bounds(const body& rigid);

/// A bracket of the root of G(u) = q pi, which exists exactly where q > I.
[[nodiscard]] std::optional<root_bracket> bracket_half_phase_root(const body& rigid,
                                                                  const rational& q, int bits = 40);

/// Whether G(lower) > q pi > G(upper), evaluated again.
[[nodiscard]] bool passes_half_phase(const body& rigid, const rational& q,
                                     const root_bracket& bracket);

/// q > I, decided in rationals: q^2 b (a + b) > (1 - b)^2 for q > 0.
[[nodiscard]] bool exceeds_geometric_constant(const rational& q, const body& rigid);

/// The number of whole k >= 1 with k < 1/I: ceil(1/I) - 1. In rationals: k^2 < b (a + b)/(1 - b)^2.
[[nodiscard]] integer count_crossings(const body& rigid);
/// The number of whole k >= 1 with k < 1/I + 1/2: ceil(1/I + 1/2) - 1. In rationals: (2k-1)^2 < 4 b
/// (a + b)/(1 - b)^2.
[[nodiscard]] integer count_intersections(const body& rigid);

}  // namespace polhode::proofs
