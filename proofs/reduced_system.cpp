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

#include "proofs/claims.hpp"
#include "proofs/exact_polynomial.hpp"

namespace polhode::proofs {
namespace {

certificate prove_system(const request&) {
  certificate c;
  c.formula =
      "With R' = R [omega]x, J = R^T e_Z, |J| = 1: theta' = (1/I_y - 1/I_x) sin(theta) sin(psi) "
      "cos(psi), phi' = sin^2(psi)/I_y + cos^2(psi)/I_x, psi' = (1/I_z - phi') cos(theta); c = a "
      "- sin^2(theta) (a + b cos^2(psi)) is constant; dpsi/dphi = (a + b cos^2(psi)) "
      "cos(theta)/(1 - b cos^2(psi)), dtheta/dphi = b sin(theta) sin(psi) cos(psi)/(1 - b "
      "cos^2(psi))";
  c.method =
      "With x, y, z = 1/I_x, 1/I_y, 1/I_z, s, k = sin(psi), cos(psi), p, q = sin(theta), "
      "cos(theta), J = (-pk, ps, q), h = theta', w = psi', f = phi': each equation is an "
      "identity of polynomials but for multiples of s^2 + k^2 - 1 and p^2 + q^2 - 1, which are "
      "0. Decided by expansion.";
  add_steps(
      c,
      {identity("0-p*(y-x)*p*s*k", "(0-p*k)*(y*p*s) - (p*s)*(0-x*p*k)",
                "J_z' = -ph is J_x omega_y - J_y omega_x, with h = (y-x)psk and omega = (-xpk, "
                "yps, zq)"),
       identity("(0-q*(y-x)*p*s*k*k+p*s*(z-y*s^2-x*k^2)*q) - ((p*s)*(z*q)-q*(y*p*s))",
                "p*s*q*y*(1-s^2-k^2)",
                "J_x' = -qhk + psw is J_y omega_z - J_z omega_y, with w = (z-ys^2-xk^2)q"),
       identity(
           "(q*(y-x)*p*s*k*s+p*k*(z-y*s^2-x*k^2)*q) - (q*(0-x*p*k)-(0-p*k)*(z*q))",
           "p*q*k*x*(1-s^2-k^2)",
           "J_y' = qhs + pkw is J_z omega_x - J_x omega_z: eqs. (6) for theta and psi are Euler's "
           "equations"),
       identity("s*(p*s*w-q*h*k) + k*(q*h*s+p*k*w)", "p*w*(s^2+k^2)",
                "and where p is not 0 Euler's equations give them: h = -J_z'/p, w = (s J_x' + k "
                "J_y')/p"),
       identity(
           "((y-x)*p*s*k*s-(y*s^2+x*k^2)*p*k) - (0-x*p*k)", "p*k*x*(1-s^2-k^2)",
           "omega_x = hs - fpk, with f = ys^2 + xk^2: the axis of R' = R [omega]x, R = Rz(phi) "
           "Ry(theta) Rz(psi)"),
       identity("((y-x)*p*s*k*k+(y*s^2+x*k^2)*p*s) - y*p*s", "p*s*y*(s^2+k^2-1)",
                "omega_y = hk + fps"),
       identity("((z-y*s^2-x*k^2)*q+(y*s^2+x*k^2)*q)", "z*q", "omega_z = w + fq: eq. (6) for phi"),
       identity("x*p^2*k^2+y*p^2*s^2+z*q^2-y",
                "(z-y)-p^2*((z-y)+(y-x)*k^2)+z*(p^2+q^2-1)+y*p^2*(s^2+k^2-1)",
                "c = 2H/y - 1 with a = (z-y)/y, b = (y-x)/y: eq. (7)"),
       identity("0-2*p*q*(b*p*s*k)*(a+b*k^2)+2*p^2*b*k*s*((a+b*k^2)*q)", "0*a",
                "the derivative of a - p^2(a+bk^2) along the motion is 0: c is constant"),
       identity("y*s^2+x*k^2-(y-(y-x)*k^2)", "0-y*(1-s^2-k^2)", "f = y(1 - bk^2)"),
       identity("(z-y*s^2-x*k^2)-((z-y)+(y-x)*k^2)", "y*(1-s^2-k^2)",
                "w = y(a + bk^2)q: w/f is eq. (18), and h/f, h = ybpsk, eq. (19)"),
       identity("(a-p^2*(a+b*k^2))+b*k^2-q^2*(a+b*k^2)", "(a+b*k^2)*(1-p^2-q^2)",
                "c + bk^2 = q^2(a + bk^2): eq. (20)"),
       identity("((a+b*k^2)*q)^2-(a+b*k^2)*((a-p^2*(a+b*k^2))+b*k^2)", "(a+b*k^2)^2*(p^2+q^2-1)",
                "the square of eq. (18) is that of eq. (9), with the sign of q"),
       identity("(b*p*s*k)^2*(a+b*k^2)", "b^2*(a-(a-p^2*(a+b*k^2)))*s^2*k^2",
                "the square of eq. (19) is that of eq. (8), with the sign of sk, as p > 0"),
       identity(
           "b*p*(0-s)*k", "0-b*p*s*k",
           "with psi and phi also -psi and -phi are a solution: eq. (18) has s^2 only, eq. (19) is "
           "odd in s")});
  c.conclude();
  return c;
}

}  // namespace

claim reduced_system_claim() {
  return {"section 3, eqs. (6)-(9), (18)-(20)",
          "In the paper's Euler angles, where sin(theta) > 0, every free rotation of a body with "
          "I_z < I_y < I_x and |J| = "
          "1 along Z obeys eqs. (6), has the constant c of eq. (7), and relative to phi obeys the "
          "reduced system, eqs. (18) and (19), and so eqs. (8), (9) and (20).",
          "identities of polynomials in the sines and cosines of the angles",
          prove_system,
          proof_tier::by_kernel,
          {{step_kind::kernel, "FreeBody.euler_equations"},
           {step_kind::kernel, "FreeBody.equation_6_theta"},
           {step_kind::kernel, "FreeBody.equation_6_psi"},
           {step_kind::kernel, "FreeBody.equation_6_phi"},
           {step_kind::kernel, "FreeBody.equation_7"},
           {step_kind::kernel, "FreeBody.c_constant"},
           {step_kind::kernel, "FreeBody.equation_18"},
           {step_kind::kernel, "FreeBody.equation_19"},
           {step_kind::kernel, "FreeBody.equation_8"},
           {step_kind::kernel, "FreeBody.equation_9_plus"},
           {step_kind::kernel, "FreeBody.equation_9_minus"},
           {step_kind::kernel, "FreeBody.equation_20"},
           {step_kind::kernel, "ReducedSystem.reduced_system"}}};
}

}  // namespace polhode::proofs
