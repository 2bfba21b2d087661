#pragma once

// The Montgomery phase: the angle dphi by which a free rigid body has turned about its angular
// momentum when that has gone once around in the body frame. It is not taken modulo 2 pi.
//
// With x = cos^2 psi (dpsi/dphi of the reduced system) it is 2 F(c, -c/b) where the body oscillates
// and 2 F(c, 0) where it rotates:
//
//   F(c,u) = integral from u to 1 of (1 - b x) / sqrt(x (1-x) (a + b x) (c + b x)) dx,
//     0 <= u < 1,  b u + c >= 0.
//
// In Carlson's integrals, with X = u, Y = (a + b u)/(a + b), Z = (c + b u)/(c + b),
//
//   F(c,u) = 2 sqrt((1-u)/((a+b)(b+c))) [ (1-b) R_F(X,Y,Z) + (b (1-u)/3) R_J(X,Y,Z,1) ].
//
// Proof. Put t + 1 = (1-u)/(1-x), which runs from 1 to infinity. Then x = (t + X)/(t + 1), a + b x
// = (a + b)(t + Y)/(t + 1), c + b x = (c + b)(t + Z)/(t + 1), 1 - x = (1-u)/(t + 1) and dx =
// (1-u)/(t + 1)^2 dt, so that F is sqrt((1-u)/((a+b)(b+c))) times the integral over t > 0 of (1 - b
// x)/sqrt((t+X)(t+Y)(t+Z)), where 1 - b x = 1 - b + b (1-u)/(t + 1).
//
// X, Y, Z and the factors are formed exactly, and every term is positive: nothing cancels, however
// near c is to an end of its range or to 0. For X = 0 or Z = 0 the integrals are complete: by the
// arithmetic-geometric mean and Bartky's sum (docs/elliptic.md).

#include "polhode/rigid_body/certain_number.hpp"
#include "polhode/rigid_body/regime.hpp"

namespace polhode {

class motion;

/// F(c,u), to about p bits. Throws input_error unless -b < c <= a, 0 <= u < 1 and b u + c >= 0, and
/// for c = u = 0, where it is infinite.
[[nodiscard]] ball phase_integral(const body& rigid, const exact_real& c, const exact_real& u,
                                  precision p);

/// dF/du = -(1 - b u)/sqrt(u (1-u) (a + b u) (c + b u)): minus the integrand at the lower limit.
/// Throws input_error as phase_integral does, and where the integrand is infinite there: for u = 0
/// and for b u + c = 0.
[[nodiscard]] ball phase_integral_slope(const body& rigid, const rational& c, const rational& u,
                                        precision p);

/// The Montgomery phase, to about p bits, where the body oscillates or rotates. In the other
/// regimes input_error: on the separatrix it is infinite, and in an equilibrium the angular
/// momentum does not move.
[[nodiscard]] ball montgomery_phase(const body& rigid, const exact_real& c, precision p);

/// Its greatest lower bound over the regime, the limit for c -> -b, 2 pi (geometric constant), or
/// for c -> a, 2 pi (second geometric constant): the paper's theorems on the Montgomery phase. In
/// an equilibrium: the limit there. input_error on the separatrix.
[[nodiscard]] ball montgomery_phase_limit(const body& rigid, const rational& c, precision p);

/// The period T of the angular momentum in the body, in units of I_y/J, to about p bits:
/// motion::period. Throws input_error as montgomery_phase does.
[[nodiscard]] ball rotation_period(const body& rigid, const rational& c, precision p);

/// The two parts of the Montgomery phase (R. Montgomery, Am. J. Phys. 59, 1991): dynamic, 2 H T/J =
/// (1 + c) T in units of I_y/J, and geometric, the phase less that, -(the integral of cos theta
/// dpsi around) = -(the integral of c + b x over a period) < 0.
[[nodiscard]] ball dynamic_phase(const body& rigid, const rational& c, precision p);
[[nodiscard]] ball geometric_phase(const body& rigid, const rational& c, precision p);

/// The Montgomery phase to `digits` certain significant digits: the precision is raised until they
/// are certain.
[[nodiscard]] certain_number montgomery_phase_to_digits(const body& rigid, const rational& c,
                                                        long digits);
[[nodiscard]] certain_number montgomery_phase_to_digits(const motion& of, long digits);

/// The same of montgomery_phase_limit.
[[nodiscard]] certain_number montgomery_phase_limit_to_digits(const body& rigid, const rational& c,
                                                              long digits);

/// The same of these. The geometric part cancels near c = -b, where it is of the order of 1 + c/b.
[[nodiscard]] certain_number rotation_period_to_digits(const body& rigid, const rational& c,
                                                       long digits);
[[nodiscard]] certain_number dynamic_phase_to_digits(const body& rigid, const rational& c,
                                                     long digits);
[[nodiscard]] certain_number geometric_phase_to_digits(const body& rigid, const rational& c,
                                                       long digits);
[[nodiscard]] certain_number geometric_phase_to_digits(const motion& of, long digits);

/// By how much the phase is above its greatest lower bound, to so many certain digits of this
/// difference, which cancels near the end: of the order of 1 - u = 1 + c/b or of a - c.
[[nodiscard]] certain_number montgomery_phase_excess_to_digits(const body& rigid, const rational& c,
                                                               long digits);

}  // namespace polhode
