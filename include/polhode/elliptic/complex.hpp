#pragma once

// The elliptic integrals and functions of complex arguments, as the analytic continuation of the
// real functions: over complex balls, and over regions, which quadrature asks for. Conventions and
// formulas are those of carlson.hpp, legendre.hpp, jacobi.hpp and theta.hpp.
//
//   function               analytic, and given here, where
//   R_F, R_C               no argument is in (-oo, 0]
//   R_J, R_D, R_G          the real parts are positive
//                          (one of x, y, z may be exactly 0, but not of R_C and not the last one of
//                          R_D)
//   K, E, D                m is not in [1, oo)
//   Pi(n | m)              Re m < 1, Re n < 1
//   F, E, D, Pi of phi     1 - m sin^2 phi is not in (-oo, 0]; of E, D, Pi its real part and that
//                          of cos^2 phi are positive, of Pi also that of 1 - n sin^2 phi; where |Re
//                          phi| comes near pi/2, and beyond, m is not in [1, oo), and the same
//                          holds of -m/(1-m), -n/(1-n) and phi less an odd multiple of pi/2
//   sn, cn, dn, am, nome   m is not in (-oo, 0] or [1, oo); sn, cn, dn also Re m < 0 and Re m > 1
//   theta_j                |q| < 1, for j = 1, 2 and q not in (-oo, 0]
//   inverse functions      where the arguments of R_F are not in (-oo, 0]; all but arcsn, arcsc,
//                          arcsd: Re x > 0, and arccn, arccs, arccd: also Re x < 0; arccd, arcdc:
//                          Re(x sqrt(1 - m)) > 0, arcdn, arcnd: Re(x sqrt m) > 0, else the branch
//                          is one whose pq is -x
//
// Elsewhere, where an operand is too wide, and where a series would be long (a nome near 1),
// complex balls are undefined and regions not analytic (obstacle::branch_cut where an argument
// meets a cut, else obstacle::unknown). Over regions about 30 bits are right for numbers: enough
// for bounds.

#include "polhode/arithmetic/complex_ball.hpp"
#include "polhode/arithmetic/region.hpp"

namespace polhode {

#define POLHODE_COMPLEX_ELLIPTIC(Z)                                           \
  [[nodiscard]] Z carlson_rf(const Z& x, const Z& y, const Z& z);             \
  [[nodiscard]] Z carlson_rc(const Z& x, const Z& y);                         \
  [[nodiscard]] Z carlson_rj(const Z& x, const Z& y, const Z& z, const Z& p); \
  [[nodiscard]] Z carlson_rd(const Z& x, const Z& y, const Z& z);             \
  [[nodiscard]] Z carlson_rg(const Z& x, const Z& y, const Z& z);             \
  [[nodiscard]] Z elliptic_k(const Z& m);                                     \
  [[nodiscard]] Z elliptic_e(const Z& m);                                     \
  [[nodiscard]] Z elliptic_d(const Z& m);                                     \
  [[nodiscard]] Z elliptic_pi(const Z& n, const Z& m);                        \
  [[nodiscard]] Z elliptic_f(const Z& phi, const Z& m);                       \
  [[nodiscard]] Z elliptic_e(const Z& phi, const Z& m);                       \
  [[nodiscard]] Z elliptic_d(const Z& phi, const Z& m);                       \
  [[nodiscard]] Z elliptic_pi(const Z& n, const Z& phi, const Z& m);          \
  [[nodiscard]] Z elliptic_nome(const Z& m);                                  \
  /** theta_j(z, q), j from 1 to 4, and its derivative in z. */               \
  [[nodiscard]] Z theta_value(int j, const Z& z, const Z& q);                 \
  [[nodiscard]] Z theta_derivative(int j, const Z& z, const Z& q);            \
  [[nodiscard]] Z jacobi_am(const Z& u, const Z& m);                          \
  /** pq(u | m) for p and q of the letters s, c, d and n; p is not q. */      \
  [[nodiscard]] Z jacobi_quotient(char p, char q, const Z& u, const Z& m);    \
  /** The u of pq(u | m) = x, as jacobi.hpp has it. */                        \
  [[nodiscard]] Z jacobi_inverse(char p, char q, const Z& x, const Z& m);
POLHODE_COMPLEX_ELLIPTIC(complex_ball)
POLHODE_COMPLEX_ELLIPTIC(region)
#undef POLHODE_COMPLEX_ELLIPTIC

}  // namespace polhode
