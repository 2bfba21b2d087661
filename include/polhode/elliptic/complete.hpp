#pragma once

// Complete elliptic integrals by the arithmetic-geometric mean: quadratic convergence, every term
// positive. Conventions: parameter m (not the modulus k, m = k^2), complementary parameter m1 = 1 -
// m.

#include "polhode/arithmetic/ball.hpp"

namespace polhode {

/// The arithmetic-geometric mean of a and b and, from the same steps
///   a_{n+1} = (a_n + b_n)/2,  b_{n+1} = sqrt(a_n b_n),  c_{n+1} = (a_n - b_n)/2,
/// the sum of 2^(n-1) c_n^2 over n >= 1.
struct agm_sums {
  ball mean;
  ball sum;
  int steps = 0;
};

/// Hypothesis: a and b are certainly positive; otherwise mean and sum are undefined. They also are
/// where the balls are so wide (by a factor of 4 or more) that nothing contracts.
///
/// What is left out after c_N (N >= 1) is at most 2^(N-1) c_N^2 q / (1 - q) with q = 2 (c_N / (4
/// M))^2, where q <= 1/2 is checked. Proof: a_n - b_n = 2 c_{n+1} and c_{n+1} = c_n^2 / (4 a_{n+1})
/// (from 4 a_{n+1} c_{n+1} = (a_n^2 - b_n^2) = c_n^2), and a_n >= M for n >= 1; so the ratio of
/// successive terms is 2 (c_{n+1}/c_n)^2 = 2 (c_n / (4 a_{n+1}))^2 <= q. The mean lies in [b_n,
/// a_n] for every n >= 1, an interval of length 2 c_{n+1} <= c_n^2 / (2 M).
[[nodiscard]] agm_sums agm_with_sum(const ball& a, const ball& b);

/// Complete integrals over 0 <= t <= pi/2 with D^2 = 1 - m sin^2 t:
///   k = integral of 1/D,         e = integral of D,
///   d = integral of sin^2 t / D = (K - E)/m,    b = integral of cos^2 t / D = (E - m1 K)/m.
/// Formulas, with the AGM of 1 and sqrt(m1): K = pi / (2 M);  (K - E)/K = m/2 + sum over n >= 1 of
/// 2^(n-1) c_n^2 (Abramowitz and Stegun 17.6.3-4; DLMF 19.8.6);  D = K (1/2 + (that sum)/m), where
/// the sum over m is formed without dividing by m;  B = K - D;  E = B + m1 D.
struct complete_integrals {
  ball k, e, d, b;
};

/// Hypotheses: m1 is certainly positive, and m = 1 - m1 is given beside it so that neither end of
/// [0, 1] loses digits; m >= 0. Where they certainly fail (m + m1 holds no 1), all are undefined;
/// for members m < 0 of a ball that reaches below 0 the formulas hold too.
[[nodiscard]] complete_integrals complete_legendre(const ball& m, const ball& m1);

/// Carlson's complete R_D(0, y, z) = (3/2) integral over t >= 0 of dt / (sqrt(t (t + y)) (t +
/// z)^(3/2)), for y, z certainly positive, else undefined:
///   y <= z:  R_D(0, y, z) = 3 z^(-3/2) D(1 - y/z)       (DLMF 19.25.1),
///   y >= z:  R_D(0, y, z) = 3 y^(-1/2) B(1 - z/y) / z
///     (from y R_D(0,z,y) + z R_D(0,y,z) = 3 R_F(0,y,z)).
/// Where the balls leave the order open the result is the hull of both: each holds for its own
/// members. one_minus_ratio is 1 - min(y,z)/max(y,z), given by the caller who has it without
/// cancellation.
[[nodiscard]] ball complete_rd(const ball& y, const ball& z, const ball& one_minus_ratio);

/// The derivative of M = agm(x, y) with respect to y, for x, y certainly positive, else undefined:
///   2 M^2 y R_D(0, x^2, y^2)/(3 pi),
/// from pi/(2 M) = R_F(0, x^2, y^2) (DLMF 19.22.1) and dR_F(0, u, v)/dv = -R_D(0, u, v)/6, the
/// derivative of R_F = (1/2) integral of dt/sqrt(t (t + u)(t + v)) under its integral. M is
/// symmetric, so that agm_slope(y, x) is the derivative with respect to x.
///
/// Over sets by their ends: the slope increases in x and decreases in y. Proof. (a + b)/2 and
/// sqrt(a b) are concave and increase in a and in b; so are, then, the iterates of both, and their
/// limit M. As M is concave, its slope in y decreases in y; as the slope is homogeneous of degree 0
/// (M is of degree 1), it is a function of y/x, and increases in x.
[[nodiscard]] ball agm_slope(const ball& x, const ball& y);

}  // namespace polhode
