#pragma once

// The sign of dF(-bu,u)/du for all bodies and motions at once, by interval arithmetic: the
// numerical companion of the exact proof.

#include <array>
#include <vector>

#include "polhode/arithmetic/ball.hpp"
#include "polhode/rigid_body/phase_integrands.hpp"

namespace polhode::proofs {

/// W = -u sqrt(b (a + b)) dF(-bu,u)/du as an integral without singularities, over a compact box.
///
///   W = integral over (0, pi/2) of cos^2 t (sigma^(-1/2) + r u sigma^(-3/2)) dt,
///   sigma = u + p (1 - u) cos^2 t, p = a/(a + b), r = b (1 + a)/(a + b);
/// the change of variables is in proofs/arguments/sign_dF_du.md.
/// For a > 0, 0 < b < 1 both p and r lie in (0, 1) (r < 1 since b + ab < a + b). So every body and
/// motion is a point (p, r, u) of the box [0,1]^3, and W > 0 there shows dF/du < 0.
struct sweep_point {
  ball p, r, u;  // interval parameters, within [0, 1]
};

/// A lower bound of W over a box of parameters: the integrand is bounded over 64 equal cells of t.
/// The lower ends are used: cos^2 decreases over each cell, and sigma^(-1/2) and sigma^(-3/2)
/// decrease in sigma.
[[nodiscard]] ball slope_lower_bound(const sweep_point& box);

/// An enclosure of W for parameters with sigma certainly positive, from the same cells (its width
/// is that of the cells: a few hundredths).
[[nodiscard]] ball slope_enclosure(const sweep_point& box);

/// The point (p, r, u) of a motion.
[[nodiscard]] sweep_point point_of(const oscillating_motion& motion, precision p);

/// A box of parameters p, r, u with exact ends.
struct sweep_box {
  std::array<rational, 3> low;
  std::array<rational, 3> high;
};

struct sweep_result {
  bool holds = false;               // W > bound on every box
  rational bound;                   // as given
  long boxes = 0;                   // boxes on which it was shown
  long evaluations = 0;             // boxes looked at, those that were split included
  int deepest = 0;                  // halvings that led to the smallest box
  rational least;                   // the least lower bound found, cut off to a decimal
  std::vector<sweep_box> covering;  // those boxes; together they are [0,1]^3
};

/// Bisects [0,1]^3 until W > wanted is shown on every box, or gives up at most_evaluations. (The
/// infimum of W is pi/4 = 0.785..., at u = 1, r = 0.)
[[nodiscard]] sweep_result sweep_slope(long most_evaluations = 200'000,
                                       const rational& wanted = rational(3, 4));

}  // namespace polhode::proofs
