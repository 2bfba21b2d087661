#pragma once

#include "body.hpp"

namespace polhode::checker {

/// The sign of epsilon(c) - level for -b < c <= a, the twist defect of the tennis racket effect.
/// Throws undecided where these bits do not tell.
///
/// epsilon(c) = pi/2 - psi, psi = psi_c(pi). With H the angle of a half turn (G(-c/b) where the
/// motion oscillates, F(c,0) where it rotates), n the whole number and r with pi = n H + r, |r| <=
/// H/2, and s with F(c, cos^2 s) = 2 |r|:  psi = (-1)^n sign(r) s where it oscillates, n pi +
/// sign(r) s where it rotates; on the separatrix F(0, cos^2 psi) = 2 pi. (By the symmetries of the
/// reduced system; the paper's implicit equations.)
[[nodiscard]] int side_of_defect(const body& rigid, const real& c, const rational& level,
                                 precision bits);

}  // namespace polhode::checker
