#pragma once

// G(u) = F(-b u, u), half the Montgomery phase of oscillating motion, as a function of u. It maps
// (0, 1) one to one onto (pi I, infinity), decreasing: proofs/arguments/half_phase_limits.md.

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
