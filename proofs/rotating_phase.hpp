#pragma once

// F(c,0), half the Montgomery phase of rotating motion, as a function of c. It maps (0, a) one to
// one onto (pi J, infinity), decreasing: proofs/arguments/montgomery_rotating.md.

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
