#pragma once

#include "statements/shared.hpp"

namespace polhode::statements {

[[nodiscard]] inline claim_text reduced_system() {
  return {
      .name = "reduced_system",
      .reference = "section 3, eqs. (6)-(9), (18)-(20)",
      .statement =
          "In the paper's Euler angles, where sin(theta) > 0, every free rotation of a body with "
          "I_z < I_y < I_x and "
          "|J| = 1 along Z obeys eqs. (6), has the constant c of eq. (7), and relative to phi "
          "obeys the reduced system, eqs. (18) and (19), and so eqs. (8), (9) and (20).",
      .technique = "identities of polynomials in the sines and cosines of the angles",
      .formula =
          "With R' = R [omega]x, J = R^T e_Z, |J| = 1: theta' = (1/I_y - 1/I_x) sin(theta) "
          "sin(psi) cos(psi), phi' = sin^2(psi)/I_y + cos^2(psi)/I_x, psi' = (1/I_z - phi') "
          "cos(theta); c = a - sin^2(theta) (a + b cos^2(psi)) is constant; dpsi/dphi = (a + b "
          "cos^2(psi)) cos(theta)/(1 - b cos^2(psi)), dtheta/dphi = b sin(theta) sin(psi) "
          "cos(psi)/(1 - b cos^2(psi))",
      .method =
          "With x, y, z = 1/I_x, 1/I_y, 1/I_z, s, k = sin(psi), cos(psi), p, q = sin(theta), "
          "cos(theta), J = (-pk, ps, q), h = theta', w = psi', f = phi': each equation is an "
          "identity of polynomials but for multiples of s^2 + k^2 - 1 and p^2 + q^2 - 1, which "
          "are 0. Decided by expansion.",
      .steps =
          {identity("0-p*(y-x)*p*s*k", "(0-p*k)*(y*p*s) - (p*s)*(0-x*p*k)",
                    "J_z' = -ph is J_x omega_y - J_y omega_x, with h = (y-x)psk and omega = (-xpk, "
                    "yps, zq)"),
           identity("(0-q*(y-x)*p*s*k*k+p*s*(z-y*s^2-x*k^2)*q) - ((p*s)*(z*q)-q*(y*p*s))",
                    "p*s*q*y*(1-s^2-k^2)",
                    "J_x' = -qhk + psw is J_y omega_z - J_z omega_y, with w = (z-ys^2-xk^2)q"),
           identity("(q*(y-x)*p*s*k*s+p*k*(z-y*s^2-x*k^2)*q) - (q*(0-x*p*k)-(0-p*k)*(z*q))",
                    "p*q*k*x*(1-s^2-k^2)",
                    "J_y' = qhs + pkw is J_z omega_x - J_x omega_z: eqs. (6) for theta and psi are "
                    "Euler's "
                    "equations"),
           identity("s*(p*s*w-q*h*k) + k*(q*h*s+p*k*w)", "p*w*(s^2+k^2)",
                    "and where p is not 0 Euler's equations give them: h = -J_z'/p, w = (s J_x' + "
                    "k J_y')/p"),
           identity(
               "((y-x)*p*s*k*s-(y*s^2+x*k^2)*p*k) - (0-x*p*k)", "p*k*x*(1-s^2-k^2)",
               "omega_x = hs - fpk, with f = ys^2 + xk^2: the axis of R' = R [omega]x, R = Rz(phi) "
               "Ry(theta) Rz(psi)"),
           identity("((y-x)*p*s*k*k+(y*s^2+x*k^2)*p*s) - y*p*s", "p*s*y*(s^2+k^2-1)",
                    "omega_y = hk + fps"),
           identity("((z-y*s^2-x*k^2)*q+(y*s^2+x*k^2)*q)", "z*q",
                    "omega_z = w + fq: eq. (6) for phi"),
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
           identity("((a+b*k^2)*q)^2-(a+b*k^2)*((a-p^2*(a+b*k^2))+b*k^2)",
                    "(a+b*k^2)^2*(p^2+q^2-1)",
                    "the square of eq. (18) is that of eq. (9), with the sign of q"),
           identity("(b*p*s*k)^2*(a+b*k^2)", "b^2*(a-(a-p^2*(a+b*k^2)))*s^2*k^2",
                    "the square of eq. (19) is that of eq. (8), with the sign of sk, as p > 0"),
           identity("b*p*(0-s)*k", "0-b*p*s*k",
                    "with psi and phi also -psi and -phi are a solution: eq. (18) has s^2 only, "
                    "eq. (19) is odd in s"),
           identity("(a+b*k^2)*(0-q)", "0-(a+b*k^2)*q",
                    "with psi and theta also -psi and pi - theta are a solution, at the same phi: "
                    "eq. (18) is odd in q, eq. (19) has no q, and its left side changes its sign "
                    "as its s does")},
      .tier = by_kernel,
      .argument = {in_coq("FreeBody.euler_equations"), in_coq("FreeBody.equation_6_theta"),
                   in_coq("FreeBody.equation_6_psi"), in_coq("FreeBody.equation_6_phi"),
                   in_coq("FreeBody.equation_7"), in_coq("FreeBody.c_constant"),
                   in_coq("FreeBody.equation_18"), in_coq("FreeBody.equation_19"),
                   in_coq("FreeBody.equation_8"), in_coq("FreeBody.equation_9_plus"),
                   in_coq("FreeBody.equation_9_minus"), in_coq("FreeBody.equation_20"),
                   in_coq("ReducedSystem.reduced_system")}};
}

}  // namespace polhode::statements
