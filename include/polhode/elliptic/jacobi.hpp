#pragma once

// Jacobi's elliptic functions of a real argument u and the parameter m (elliptic_parameter: m =
// k^2, or m1 = 1 - m given), their quotients and inverses (DLMF 22). phi = am(u | m) is the inverse
// of u = F(phi | m), and
//
//   sn = sin phi,  cn = cos phi,  dn = sqrt(1 - m sn^2),  pq = pn/qn for p, q in s, c, d, n with nn
//   = 1.
//
//   function          domain, else undefined
//   sn, cn, dn        all u and m; m = 1 and 1 < m by DLMF 22.5(ii) and 22.17(i)
//   their quotients   where the divisor is not 0
//   am                m <= 1
//
// How: with (a_n, b_n) the AGM of 1 and sqrt m1, F(w) of carlson_core.hpp is unchanged where a, b
// pass to a', b' and
//   z = z' g'/h',  g = h' - e/h',  h = h' + e/h',  e = (a^2 - b^2)/4,
// z = cs u and g = sqrt(z^2+b^2), h = sqrt(z^2+a^2) are ds u and ns u at the top (C. F. Gauss's
// transformation, DLMF 22.7(i), in the letters of the AGM). At the bottom, where a_N and b_N agree,
// z = M cot(M u) with an M in [b_N, a_N] and g, h as 1/sin(M u) times numbers of [b_N, a_N]; from
// there the triple is carried up, multiplied by its denominator, with no division and no square
// root: log p steps for p bits. M is computed to as many bits more as u has before the point, so
// that arguments are reduced exactly, however large (to 2^(2^24)). Over balls: enclosures, close to
// the last place for numbers; over wide balls by the range of am, which increases with u and, for u
// > 0, decreases with m. mpfr_float and double: uncertified, from the same templates.

#include <array>

#include "polhode/elliptic/parameter.hpp"

namespace polhode {

template <class T>
struct jacobi_values {
  T sn, cn, dn;
};

#define POLHODE_JACOBI(T)                                                                     \
  [[nodiscard]] jacobi_values<T> jacobi_elliptic(const T& u, const elliptic_parameter<T>& m); \
  [[nodiscard]] T jacobi_am(const T& u, const elliptic_parameter<T>& m);                      \
  [[nodiscard]] T jacobi_sn(const T& u, const elliptic_parameter<T>& m);                      \
  [[nodiscard]] T jacobi_cn(const T& u, const elliptic_parameter<T>& m);                      \
  [[nodiscard]] T jacobi_dn(const T& u, const elliptic_parameter<T>& m);                      \
  [[nodiscard]] T jacobi_ns(const T& u, const elliptic_parameter<T>& m);                      \
  [[nodiscard]] T jacobi_nc(const T& u, const elliptic_parameter<T>& m);                      \
  [[nodiscard]] T jacobi_nd(const T& u, const elliptic_parameter<T>& m);                      \
  [[nodiscard]] T jacobi_sc(const T& u, const elliptic_parameter<T>& m);                      \
  [[nodiscard]] T jacobi_sd(const T& u, const elliptic_parameter<T>& m);                      \
  [[nodiscard]] T jacobi_cs(const T& u, const elliptic_parameter<T>& m);                      \
  [[nodiscard]] T jacobi_cd(const T& u, const elliptic_parameter<T>& m);                      \
  [[nodiscard]] T jacobi_ds(const T& u, const elliptic_parameter<T>& m);                      \
  [[nodiscard]] T jacobi_dc(const T& u, const elliptic_parameter<T>& m);
POLHODE_JACOBI(ball)
POLHODE_JACOBI(mpfr_float)
POLHODE_JACOBI(double)
#undef POLHODE_JACOBI

// Inverse functions: the u of DLMF 22.15(ii) with pq(u) = x, for 0 <= m <= 1.
//
//   function                x                 u
//   arcsn                   [-1, 1]           [-K, K]
//   arccn, arccd            [-1, 1]           [0, 2K]
//   arcdn                   [sqrt m1, 1]      [0, K]
//   arcns, arcdc            [1, oo)           (0, K], [0, K)
//   arcnc                   [1, oo)           [0, K)
//   arcnd                   [1, 1/sqrt m1]    [0, K]
//   arcsc                   R                 (-K, K)
//   arcsd                   |x| <= 1/sqrt m1  [-K, K]
//   arccs                   R                 (0, 2K)
//   arcds                   [sqrt m1, oo)     (0, K]
// Each is R_F of three polynomials in x^2 times a square root of another.
[[nodiscard]] ball jacobi_arcsn(const ball& x, const elliptic_parameter<ball>& m);
[[nodiscard]] ball jacobi_arccn(const ball& x, const elliptic_parameter<ball>& m);
[[nodiscard]] ball jacobi_arcdn(const ball& x, const elliptic_parameter<ball>& m);
[[nodiscard]] ball jacobi_arcns(const ball& x, const elliptic_parameter<ball>& m);
[[nodiscard]] ball jacobi_arcnc(const ball& x, const elliptic_parameter<ball>& m);
[[nodiscard]] ball jacobi_arcnd(const ball& x, const elliptic_parameter<ball>& m);
[[nodiscard]] ball jacobi_arcsc(const ball& x, const elliptic_parameter<ball>& m);
[[nodiscard]] ball jacobi_arcsd(const ball& x, const elliptic_parameter<ball>& m);
[[nodiscard]] ball jacobi_arccs(const ball& x, const elliptic_parameter<ball>& m);
[[nodiscard]] ball jacobi_arccd(const ball& x, const elliptic_parameter<ball>& m);
[[nodiscard]] ball jacobi_arcds(const ball& x, const elliptic_parameter<ball>& m);
[[nodiscard]] ball jacobi_arcdc(const ball& x, const elliptic_parameter<ball>& m);

/// The nome q = exp(-pi K(1-m)/K(m)), in [0, 1], for 0 <= m <= 1 (DLMF 22.2.1). It increases with
/// m.
[[nodiscard]] ball elliptic_nome(const elliptic_parameter<ball>& m);

/// Partial derivatives in u (DLMF 22.13.1) and m, for m < 1; by d am/dm = -dn dF/dm.
struct jacobi_gradient_values {
  std::array<ball, 2> am, sn, cn, dn;
};
[[nodiscard]] jacobi_gradient_values jacobi_gradient(const ball& u,
                                                     const elliptic_parameter<ball>& m);

}  // namespace polhode
