#pragma once

// Half the Montgomery phase, and its slopes, where the motion is known as a ball: for equations in
// c or u, and for what is differentiated in them. Each result encloses the values at all members of
// the balls, to about as many bits as they have.
//
// F(c,u) is the integral of montgomery_phase.hpp. A body rotates with half the phase F(c,0), and
// oscillates with G(u) = F(-b u, u), where u = -c/b is cos^2 psi at the turning point.

#include "polhode/rigid_body/body.hpp"

namespace polhode {

/// F(c,0) in radians, for c > 0:
///   2 ((a+b)(b+c))^(-1/2) [ (1-b) R_F(0,Y,Z) + (b/3) R_J(0,Y,Z,1) ],   Y = a/(a+b), Z = c/(b+c).
/// The integral exists and decreases for all c > 0, whatever a is: also beyond the motions, which
/// end at c = a. Undefined where c is not certainly positive.
[[nodiscard]] ball rotating_half_phase(const body& rigid, const ball& c);

/// dF(c,0)/dc = -(a+b)^(-1/2) (b+c)^(-3/2) [ (1-b) R_F(0,Y,Z) + (b (1+c)/(3 (b+c))) R_D(0,Y,Z) ],
/// under the same condition; the case u = 0 of the formula proved in
/// src/rigid_body/twist_curve.cpp.
[[nodiscard]] ball rotating_half_phase_slope(const body& rigid, const ball& c);

/// u and 1 - u, of which the one near 0 is known to full relative accuracy.
struct turning_point {
  ball u;
  ball left;
};

/// G(u) in radians, for 0 < u <= 1; for u > 1 the formula goes on, as far as b u < 1:
///   2 (b (a+b))^(-1/2) [ (1-b) R_F(0,u,v) + (b (1-u)/3) R_J(0,u,v,1) ],   v = (a + b u)/(a + b).
/// It decreases. Undefined where u is not certainly positive.
[[nodiscard]] ball oscillating_half_phase(const body& rigid, const turning_point& at);

/// dG/du = -[ (a+b) R_D(0,v,u) + b (1+a) R_D(0,u,v) ] / (3 sqrt(b) (a+b)^(3/2))
/// (phase_integrands.hpp), under the same condition. It increases with u, as R_D decreases in every
/// argument.
[[nodiscard]] ball oscillating_half_phase_slope(const body& rigid, const turning_point& at);

}  // namespace polhode
