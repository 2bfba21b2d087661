#pragma once

#include "polhode/rigid_body/body.hpp"

namespace polhode::proofs {

/// epsilon(c) = pi/2 - psi_c(pi) of the tennis racket effect, for -b < c <= a, as an enclosure from
/// certified bisection; it has some 40 bits where p is 128 or more. psi_c is the solution of the
/// reduced system with psi = 0 and cos theta > 0 at phi = 0.
///
/// Let H be the angle phi of a half turn, F(c,-c/b) where the motion oscillates and F(c,0) where it
/// rotates, n the whole number with pi = n H + r and -H/2 <= r < H/2 (n = 0 and r = pi on the
/// separatrix, where H is infinite), and s in [0, pi/2] with F(c, cos^2 s) = 2 |r|. By the
/// symmetries of the motion (proofs/arguments/count.md; for rotating motion psi_c(phi + H) =
/// psi_c(phi) + pi),
///   psi_c(pi) = (-1)^n sign(r) s (oscillating),  n pi + sign(r) s (rotating, separatrix).
/// This is the paper's set of implicit equations, 2 n H +- F(c,u) = 2 pi.
/// Undefined where p bits don't decide n (near a point where C meets S).
[[nodiscard]] ball twist_defect(const body& rigid, const exact_real& c, precision p);

}  // namespace polhode::proofs
