#pragma once

// The curve C of the tennis racket effect: by how much a body misses the perfect twist in one turn.
//
// Let psi_c(phi) be the motion c with psi_c(0) = 0 and cos theta > 0 there. In the turn from phi =
// -pi to pi, psi goes from -psi_c(pi) to psi_c(pi); the defect is
//
//   epsilon(c) = pi/2 - psi_c(pi),
//
// so that it is 0 for a perfect twist. This is the paper's curve, for which its definition by "the
// time from -pi/2 + epsilon to pi/2 - epsilon is 2 pi" leaves open which of several passages
// through pi/2 - epsilon is meant.
//
// With Q = half the Montgomery phase, psi stands at its extremes (oscillating) or has advanced by
// an odd multiple of pi/2 (rotating) at phi = Q/2, 3Q/2, ... On the branch n = floor(pi/Q + 1/2)
// the rest is r = pi - n Q in [-Q/2, Q/2), and with the psi_1 in [-pi/2, pi/2] that has
// phi(psi_1) = r on the first quarters,
//
//   psi_c(pi) = (-1)^n psi_1 where the body oscillates,  psi_c(pi) = n pi + psi_1 where it rotates.
//
// These are the paper's implicit equations 2 n G -+ F(c,u) = 2 pi, u = sin^2 epsilon. Where C meets
// S (epsilon is that of the turning point) n changes, and epsilon does not jump.

#include "polhode/rigid_body/montgomery_phase.hpp"
#include "polhode/rigid_body/motion.hpp"

namespace polhode {

/// A point of the curve.
struct twist : certification {
  regime motion = regime::separatrix;
  integer branch;  // n; 0 on the separatrix
  ball epsilon;    // in radians; undefined where not certified
  ball slope;      // d epsilon/dc; undefined where it was not asked for
  work_count work{};
};

enum class with_slope : bool { no, yes };

/// The point of C at c, with epsilon to about p bits (of itself, or of pi/2 where it is far from
/// 0), for any c between -b and a, ends excluded. Throws input_error as regime_of does, and in
/// equilibria, where the angular momentum does not move.
///
/// Certified: n by an enclosure of pi/Q + 1/2 without an integer in it, at growing precision; psi_1
/// by an interval Newton step that maps a box into itself, which proves that the box holds a root.
/// There is no other, since phi increases with psi. Not certified, precision_limit: c is so near a
/// meeting of C and S (or such a perfect twist) that n is not decided with some multiple of the
/// bits that c has; or e^(pi sqrt(ab)) is beyond the exponents of MPFR, some 2^(2^30).
[[nodiscard]] twist twist_at(const body& rigid, const rational& c, precision p,
                             with_slope slope = with_slope::yes);

/// The same to so many certain significant digits, of the slope too where it is asked for. The
/// second form takes a motion of this body.
[[nodiscard]] twist twist_to_digits(const body& rigid, const rational& c, long digits,
                                    with_slope slope = with_slope::yes);
[[nodiscard]] twist twist_to_digits(const body& rigid, const motion& of, long digits,
                                    with_slope slope = with_slope::yes);
/// Its epsilon alone.
[[nodiscard]] certain_number defect_to_digits(const body& rigid, const rational& c, long digits);

/// The defect in the limit a -> infinity, b -> 0, with chi = a b and beta = c/b, to about p bits:
///   pi/2 - am(pi sqrt(chi (1 + beta)) | 1/(1 + beta)),
/// the paper's formula, where for -1 < beta < 0, with m = 1/(1 + beta) > 1, the motion is bounded
/// and am stands for the psi with sin psi = sn(pi sqrt chi | 1 + beta) sqrt(1 + beta), cos psi = dn
/// > 0 (DLMF 22.17.2-4). Throws input_error for chi <= 0 or beta <= -1.
[[nodiscard]] ball limit_defect(const rational& chi, const rational& beta, precision p);
[[nodiscard]] certain_number limit_defect_to_digits(const rational& chi, const rational& beta,
                                                    long digits);

}  // namespace polhode
