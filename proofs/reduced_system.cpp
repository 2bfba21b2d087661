// The equations of motion in the paper's Euler angles, from Euler's equations: its eqs. (6) to (9)
// and (18) to (20).
//
// The attitude is R = Rz(phi) Ry(theta) Rz(psi), from body to space, with J = e_Z in space, so that
// in the body J = R^T e_Z = (-sin theta cos psi, sin theta sin psi, cos theta), and omega = I^-1 J.
// From R' = R [omega]x
//   omega = psi' e_z + theta' Rz(-psi) e_y + phi' Rz(-psi) Ry(-theta) e_z
//         = (theta' sin psi, theta' cos psi, psi') + phi' J,
// and J' = J x omega. The steps below say that the theta', psi', phi' of eqs. (6) are the ones that
// make both equations hold; they are the only ones where sin theta > 0. Each is an identity of
// polynomials in sines and cosines but for a multiple of sin^2 + cos^2 - 1. For motions as
// functions of time the claim is a theorem of Coq (proofs/coq/paper/FreeBody.v).

#include "statements/reduced_system.hpp"
#include "proofs/claims.hpp"
#include "proofs/exact_polynomial.hpp"

namespace polhode::proofs {
namespace {

certificate prove_system(const request&) {
  certificate c;
  add_steps(c, statements::reduced_system().steps);
  c.conclude();
  return c;
}

}  // namespace

claim reduced_system_claim() { return {statements::reduced_system(), prove_system}; }

}  // namespace polhode::proofs
