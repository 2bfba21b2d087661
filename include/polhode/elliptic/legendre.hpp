#pragma once

// Legendre's integrals. Conventions: the parameter is m = k^2, the characteristic n has the sign of
// DLMF 19.2(ii), the amplitude phi comes before the parameter. With Delta(t) = sqrt(1 - m sin^2 t):
//
//   F(phi | m)     = int_0^phi dt / Delta                          K(m) = F(pi/2 | m)
//   E(phi | m)     = int_0^phi Delta dt                            E(m) = E(pi/2 | m)
//   D(phi | m)     = int_0^phi sin^2 t / Delta dt = (F - E)/m      D(m) = D(pi/2 | m)
//   Pi(n; phi | m) = int_0^phi dt / ((1 - n sin^2 t) Delta)        Pi(n | m) = Pi(n; pi/2 | m)
//   cel(kc, p, a, b) = int_0^(pi/2) (a cos^2 t + b sin^2 t) / (cos^2 t + p sin^2 t)
//                                   dt / sqrt(cos^2 t + kc^2 sin^2 t)
//
//   function     domain, else undefined
//   K, D         m < 1
//   E            m <= 1
//   Pi(n|m)      m < 1, n != 1; the Cauchy principal value for n > 1
//   F, E, D      m sin^2 t <= 1 for t from 0 to phi, and for F and D not = 1 at an odd multiple of
//                pi/2 from 0 to phi; so every phi where m < 1, and |phi| < pi/2 where m = 1
//   Pi(n;phi|m)  the same, n sin^2 phi != 1; the principal value where n sin^2 t = 1 between 0 and
//                phi
//   cel          kc != 0, p != 0; the principal value for p < 0
//
// How (DLMF 19.25(i); c = cos phi, s = sin phi, X = c^2, Y = c^2 + m1 s^2, so that nothing is lost
// near m = 1):
//   F = s R_F(X,Y,1),  D = s^3 R_D(X,Y,1)/3,  E = F - m D,  K = R_F(0,m1,1),  E(m) = 2 R_G(0,m1,1),
//   Pi = F + (n/3) s^3 R_J(X,Y,1, c^2 + (1-n) s^2) for n >= 0, and a form without cancellation for
//   n < 0 (DLMF 19.21.12); for |phi| > pi/2 by whole periods, F(phi) = 2 k K + F(phi - k pi). So
//   they converge as R_F and R_J do: quadratically. E = F - m D loses log2 K bits near m = 1, which
//   are put in.
// Over balls: enclosures, close to the last place for numbers, and over wide balls the range by
// monotonicity: for phi > 0 the integrands increase with m and n (E's decreases with m), for phi <
// 0 the other way round; all increase with phi where n sin^2 t < 1. Where a principal value is
// taken, by ball arithmetic. mpfr_float and double: uncertified, from the same templates
// (src/elliptic/legendre_points.hpp).

#include <array>

#include "polhode/elliptic/parameter.hpp"

namespace polhode {

#define POLHODE_LEGENDRE(T)                                                              \
  [[nodiscard]] T elliptic_k(const elliptic_parameter<T>& m);                            \
  [[nodiscard]] T elliptic_e(const elliptic_parameter<T>& m);                            \
  [[nodiscard]] T elliptic_d(const elliptic_parameter<T>& m);                            \
  [[nodiscard]] T elliptic_pi(const T& n, const elliptic_parameter<T>& m);               \
  [[nodiscard]] T elliptic_f(const T& phi, const elliptic_parameter<T>& m);              \
  [[nodiscard]] T elliptic_e(const T& phi, const elliptic_parameter<T>& m);              \
  [[nodiscard]] T elliptic_d(const T& phi, const elliptic_parameter<T>& m);              \
  [[nodiscard]] T elliptic_pi(const T& n, const T& phi, const elliptic_parameter<T>& m); \
  [[nodiscard]] T bulirsch_cel(const T& kc, const T& p, const T& a, const T& b);
POLHODE_LEGENDRE(ball)
POLHODE_LEGENDRE(mpfr_float)
POLHODE_LEGENDRE(double)
#undef POLHODE_LEGENDRE

// Partial derivatives (DLMF 19.4(i)), in the order of the arguments; with respect to m also where
// m1 was given. Those of Pi in n and m are undefined where n = m or n = 0 cannot be excluded (n = 0
// for that in n).
[[nodiscard]] ball elliptic_k_derivative(const elliptic_parameter<ball>& m);
[[nodiscard]] ball elliptic_e_derivative(const elliptic_parameter<ball>& m);
[[nodiscard]] std::array<ball, 2> elliptic_f_gradient(const ball& phi,
                                                      const elliptic_parameter<ball>& m);
[[nodiscard]] std::array<ball, 2> elliptic_e_gradient(const ball& phi,
                                                      const elliptic_parameter<ball>& m);
[[nodiscard]] std::array<ball, 2> elliptic_pi_gradient(const ball& n,
                                                       const elliptic_parameter<ball>& m);
[[nodiscard]] std::array<ball, 3> elliptic_pi_gradient(const ball& n, const ball& phi,
                                                       const elliptic_parameter<ball>& m);

}  // namespace polhode
