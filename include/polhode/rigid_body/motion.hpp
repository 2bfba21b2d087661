#pragma once

// A free rotation but for its time and its place in space: a body and c = 2 I_y H/J^2 - 1, exact.
//
// In units of |J| and I_y/|J|, with a = I_y/I_z - 1 and b = 1 - I_y/I_x, Euler's equations have the
// solution
//
//                 J in the principal axes x, y, z   lambda^2   m_1 = 1 - m            kappa
//   oscillating   (-A dn u, B sn u, C cn u)         b (a-c)    -c (a+b)/(b (a-c))     (b+c)/(a-c)
//   rotating      (-A cn u, B sn u, C dn u)         a (b+c)    c (a+b)/(a (b+c))      b/a
//   separatrix    (-A sech u, tanh u, C sech u)     a b        0                      b/a
//
// in Jacobi's functions of u = lambda t + u_0 and the parameter m, with A^2 = (a-c)/(a+b), C^2 =
// (b+c)/(a+b), and B^2 = (b+c)/b
// (oscillating) or (a-c)/a (else) (L. D. Landau, E. M. Lifshitz, Mechanics, 37). Also J_x^2 + J_y^2
//               = A^2 (1 + kappa sn^2).
//
// Proof. dJ/dt = J x omega with omega = ((1-b) J_x, J_y, (1+a) J_z) in these units is
//   J_x' = a J_y J_z,   J_y' = -(a+b) J_x J_z,   J_z' = b J_x J_y.
// With sn' = cn dn, cn' = -sn dn, dn' = -m sn cn each line asks for an equation such as A m lambda
// = a B C (the first, oscillating) or B lambda = (a+b) A C (the second); all factors are positive,
// and their squares are equal as rational functions of a, b, c, by m = a (b+c)/(b (a-c))
// (oscillating), b (a-c)/(a (b+c)) (rotating).
//
// Everything here is an exact_real, so that m_1 and lambda keep all their digits however near c is
// to 0 or to an end. The formulas hold for equal moments, too, a = 0 or b = 0, but in their
// equilibria.

#include <array>

#include "polhode/rigid_body/regime.hpp"
#include "polhode/rigid_body/work.hpp"

namespace polhode {

class motion {
 public:
  /// Throws input_error for c outside [-b, a].
  motion(const body& rigid, const exact_real& c);
  /// Moments may be equal: a = 0 where I_y = I_z, b = 0 where I_x = I_y. Throws input_error for a <
  /// 0, for b outside [0, 1), and for c outside [-b, a].
  motion(exact_real a, exact_real b, exact_real c);
  /// The same where the regime has been decided exactly, as that of a state: where a, b and c are
  /// irrational, c = a and c = -b are not seen by comparing enclosures. equilibrium_y is taken as
  /// the separatrix.
  motion(exact_real a, exact_real b, exact_real c, polhode::regime known);

  [[nodiscard]] const exact_real& a() const { return a_; }
  [[nodiscard]] const exact_real& b() const { return b_; }
  [[nodiscard]] const exact_real& c() const { return c_; }
  /// By c; so never equilibrium_y.
  [[nodiscard]] polhode::regime regime() const { return regime_; }

  // The numbers of the table. In an equilibrium they are those of the formula for c < 0 at c = -b,
  // of that for c > 0 at c = a: the limits of small oscillations about the axis. Each throws
  // input_error where lambda^2 = 0, which is in equilibria of bodies with equal moments only.

  /// lambda^2 > 0, in units of J^2/I_y^2.
  [[nodiscard]] exact_real lambda2() const;
  /// m_1 = 1 - m, in [0, 1]; 0 on the separatrix alone.
  [[nodiscard]] exact_real m1() const;
  /// m, 0 exactly where two moments are equal.
  [[nodiscard]] exact_real m() const;
  /// kappa >= 0.
  [[nodiscard]] exact_real kappa() const;
  /// A^2, B^2, C^2: the greatest values of J_x^2/J^2, J_y^2/J^2, J_z^2/J^2.
  [[nodiscard]] std::array<exact_real, 3> greatest_squares() const;
  /// The least cos^2 psi, where tan psi = -J_y/J_x: u = -c/b at the turning points where the motion
  /// oscillates (1 in its equilibrium c = -b), and 0 else, where psi goes around.
  [[nodiscard]] exact_real turning_point() const;

  /// The period T in which J goes once around in the body, in units of I_y/|J|, to about p bits:
  ///   T = 4 K(m)/lambda = 2 pi/(lambda agm(1, sqrt m_1))   (C. F. Gauss; DLMF 19.8.5).
  /// Counts one integral and its steps in `work`, where that is given. Throws input_error as
  /// refuse_unless_periodic does.
  [[nodiscard]] ball period(precision p, work_count* work = nullptr) const;
  /// The Montgomery phase in radians, unwrapped, to about p bits: 2 F(c, turning_point()) of
  /// montgomery_phase.hpp. Throws input_error as refuse_unless_periodic does.
  [[nodiscard]] ball phase(precision p) const;

  /// Throws input_error in equilibria, where J does not move in the body.
  void refuse_equilibrium() const;
  /// Throws input_error in equilibria, and on the separatrix, where period and phase are infinite.
  void refuse_unless_periodic() const;

 private:
  /// lambda^2 = first second.
  struct factors {
    exact_real first;
    exact_real second;
  };
  [[nodiscard]] factors factors_of_lambda2() const;

  exact_real a_;
  exact_real b_;
  exact_real c_;
  polhode::regime regime_;
};

}  // namespace polhode
