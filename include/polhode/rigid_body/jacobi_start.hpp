#pragma once

// Where a motion is at time 0, in Jacobi's functions: for what happens at a certain u = lambda t +
// u_0 (motion.hpp).

#include "polhode/rigid_body/rotor.hpp"

namespace polhode {

/// sn, cn, dn of u_0, by their squares and the signs -1, 0, 1 of sn and cn; dn >= 0. On the
/// separatrix these are tanh u_0 and, twice, sech u_0.
struct jacobi_start {
  int sine = 0;
  int cosine = 0;
  exact_real sine2 = 0, cosine2 = 0, delta2 = 0;

  /// The distance of u_0 from the nearest zero of sn, in [0, K], to about p bits:
  ///   sqrt(sn^2) R_F(cn^2, dn^2, 1)   (DLMF 19.25.5).
  /// So u_0 is sine times this where cosine >= 0, and sine times (2K less this) beyond, as sn(2K -
  /// u) = sn u and cn(2K - u) = -cn u; u_0 is in (-2K, 2K], and where sine = 0 and cosine < 0 it is
  /// 2K.
  [[nodiscard]] ball distance(precision p) const;
};

/// With the principal axes turned as rotor.hpp says: half turns about them, symmetries of the
/// motion, make J_x < 0 or J_z > 0, or both. From (J_x, J_y, J_z)/|J| and the table of motion.hpp:
/// sn = J_y/B, and -J_x/A, J_z/C are dn, cn (oscillating) or cn, dn (else). Throws input_error in
/// equilibria, where there is no u.
[[nodiscard]] jacobi_start jacobi_start_of(const initial_state& state);

}  // namespace polhode
