#pragma once

// Half the Montgomery phase and its slopes where the motion is known as a ball: for equations in c.

#include "polhode/rigid_body/body.hpp"

namespace polhode::detail {

/// F(c,0) for c > 0 (montgomery_phase.hpp). The integral exists and decreases for all c > 0, whatever a is.
[[nodiscard]] ball rotating_half_phase(const body& rigid, const ball& c);

/// dF(c,0)/dc = -(a+b)^(-1/2) (b+c)^(-3/2) [ (1-b) R_F(0,Y,Z) + (b (1+c)/(3 (b+c))) R_D(0,Y,Z) ], Y = a/(a+b), Z = c/(b+c);
/// the case u = 0 of the formula proved in twist_curve.cpp.
[[nodiscard]] ball rotating_half_phase_slope(const body& rigid, const ball& c);

/// u and 1 - u, of which the one near 0 is known to full relative accuracy.
struct share {
  ball u;
  ball left;
};

/// G(u) = F(-b u, u) = 2 (b (a+b))^(-1/2) [ (1-b) R_F(0,u,v) + (b (1-u)/3) R_J(0,u,v,1) ], v = (a + b u)/(a + b), for u > 0.
[[nodiscard]] ball oscillating_half_phase(const body& rigid, const share& s);

/// dG/du = -[ (a+b) R_D(0,v,u) + b (1+a) R_D(0,u,v) ] / (3 sqrt(b) (a+b)^(3/2)) (phase_integrands.hpp): it increases with u, as
/// R_D decreases in every argument.
[[nodiscard]] ball oscillating_half_phase_slope(const body& rigid, const share& s);

}  // namespace polhode::detail
