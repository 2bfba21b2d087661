#pragma once

// The tennis racket effect of a body: which twists it has, and where.
//
// What exists, and how often, is decided in rationals; where it is, certified to any number of
// digits. Half the Montgomery phase is G(u) where the body oscillates with c = -b u, and F(c,0)
// where it rotates; both are monotone, G from infinity at u = 0 down to pi I at u = 1, F(c,0) from
// infinity at c = 0 down to pi J at c = a (the paper's theorems on the Montgomery phase). So with
// I, J the geometric constants:
//
//   the curve C          at              exists for
//   meets S              G(u) = 2 pi/m   m odd,  m < 2/I    (m = 2k - 1 for the k-th from the edge)
//   crosses pi/2         G(u) = 2 pi/m   m even, m < 2/I    (m = 2k)
//   perfect twist        F(c,0) = 2 pi   J < 2
//   full turn            F(c,0) = pi     J < 1
//
// At I = 2/m itself the meeting is a limit, u = 1, and no motion.

#include "polhode/rigid_body/twist_curve.hpp"

namespace polhode {

// ---------------------------------------------------------------------------------------------
// What exists: exact

/// The number of m with m I < 2, which is ceil(2/I) - 1: from m^2 (1-b)^2 < 4 b (a+b).
[[nodiscard]] integer meeting_count(const body& rigid);
/// How often C meets S: ceil(1/I + 1/2) - 1, the odd ones of these m. (The paper's theorem says "at
/// least".)
[[nodiscard]] integer intersection_count(const body& rigid);
/// How often C crosses epsilon = pi/2: ceil(1/I) - 1, the even ones.
[[nodiscard]] integer crossing_count(const body& rigid);

/// Whether there is a perfect twist, psi from -pi/2 to pi/2 in one turn: J < 2, which is (a+1)^2 <
/// 9 a (a+b).
[[nodiscard]] bool has_perfect_twist(const body& rigid);
/// Whether there is a motion that goes once around in one turn, with a Montgomery phase of 2 pi
/// while it rotates: J < 1, which is (a+1)^2 < 4 a (a+b).
[[nodiscard]] bool has_full_turn(const body& rigid);

/// Whether c -> epsilon(c) is injective on (-b, a): exactly for physical and planar bodies (the
/// paper's theorem).
[[nodiscard]] bool is_injective(const body& rigid);

// ---------------------------------------------------------------------------------------------
// Where it is. Each to so many certain significant digits, with a verdict: not certified,
// precision_limit, where the numbers are beyond the exponents that MPFR has; refuted where it is
// proved above that there is none.

/// epsilon0, the defect on the separatrix: F(0, sin^2 epsilon0) = 2 pi.
[[nodiscard]] certain_number separatrix_defect_to_digits(const body& rigid, long digits);

/// The c in (0, a) of the perfect twist, and of the full turn, where epsilon = -pi/2. Solved for
/// log c: c may be e^(-1000).
[[nodiscard]] certain_number perfect_twist_to_digits(const body& rigid, long digits);
[[nodiscard]] certain_number full_turn_to_digits(const body& rigid, long digits);

/// A motion with G(u) = 2 pi/m.
struct meeting : certification {
  integer m;
  ball u;            // -c/b
  ball one_minus_u;  // to as small a relative radius, where it is below 1/2
  ball c;
  ball epsilon;  // undefined where m is even: it is pi/2 exactly
  work_count work{};
};

/// The m-th; its numbers have so many digits. At an intersection epsilon is arcsin sqrt u for k odd
/// and pi less that for k even, m = 2k - 1: there r = Q/2 on the branch k - 1, so that psi_c(pi) is
/// (-1)^(k-1) times the angle of the turning point. Throws input_error for m < 1.
[[nodiscard]] meeting meeting_to_digits(const body& rigid, const integer& m, long digits);

}  // namespace polhode
