#pragma once

// The truncation errors of the quadrature rules: every bound with its hypotheses and its proof or
// source. All are computed in balls; a caller takes the upper end, where that is not done already.

#include <vector>

#include "polhode/arithmetic/ball.hpp"
#include "polhode/arithmetic/magnitude.hpp"

namespace polhode {

/// What is known of a 2 pi-periodic function f in a strip of the complex plane.
struct strip_bound {
  ball half_width;  // H > 0: f is analytic in |Im t| < H' for some H' > H ...
  ball supremum;    // ... and |f| <= M for |Im t| <= H
};

/// |T_N - I| for I the integral of f over one period and T_N the trapezoidal rule with N nodes
/// 2 pi (k + s) / N, at any shift s:
///
///   |T_N - I| <= 4 pi M / (e^(H N) - 1).
///
/// Source: L. N. Trefethen, J. A. C. Weideman, SIAM Review 56 (2014), Theorem 3.2. Proof: let f =
/// sum c_k e^(i k t). Moving the line of integration to Im t = -+H gives |c_k| <= M e^(-H |k|). The
/// rule integrates e^(i k t) exactly unless N divides k != 0, when it gives 2 pi e^(2 pi i k s / N)
/// instead of 0. So |T_N - I| <= 2 pi * 2 * sum over j >= 1 of M e^(-H N j), which is the bound.
///
/// Hypotheses: bound.half_width is certainly positive (else the result is undefined), N >= 1, and
/// the two statements of strip_bound, which its maker has proved.
[[nodiscard]] ball periodic_trapezoid_error(const strip_bound& bound, long nodes);

/// |T_n - I| for I the integral of F over 0 <= t <= 1 and T_n = (1/n) sum of F((k + 1/2)/n), k = 0
/// ... n-1, where F is even about both ends or has the period 1:
///
///   |T_n - I| <= 2 M / (e^(2 H n) - 1).
///
/// Hypotheses, with bound = {H, M} in the variable s = pi t and h = H/pi: F is real on [0, 1] and
/// analytic on a neighbourhood of the rectangle 0 <= Re t <= 1, 0 <= Im t <= h; |F| <= M on its
/// side Im t = h; and for all real t near 0 either F(-t) = F(t) and F(1 + t) = F(1 - t), or F(1 +
/// t) = F(t). H is certainly positive and n >= 1, else the answer is infinite.
///
/// Proof. By Schwarz's reflection F(conj z) = conj F(z) F is analytic on a neighbourhood of 0 <= Re
/// t <= 1, |Im t| <= h. (Even ends.) F(-z) = F(z) holds for real z near 0, so by the identity
/// theorem on a neighbourhood of the segment Re z = 0, |Im z| <= h: F(-z) continues F beyond that
/// segment, and likewise F(2 - z) beyond Re z = 1. So F is continued, by reflections in turn, to an
/// even function of period 2, analytic on a strip |Im t| < h' with h' > h. In s = pi t it is even
/// with the period 2 pi, and the rule is that of the 2n nodes (k + 1/2) pi/n on the circle:
/// periodic_trapezoid_error with H and 2n nodes, halved for half of the circle and divided by pi
/// for ds = pi dt. (A period.) F(z + 1) = F(z) near Re z = 0 continues F to a strip in the same
/// way. In 2 pi t the period is 2 pi: it is that bound with 2H and n nodes, divided by 2 pi. Both
/// are the bound above. M: |F| on the closed strip is greatest on |Im t| = h by the maximum
/// principle, for F is periodic; there it is, by the symmetries, what it is on the side. F = cos(2
/// pi n t), with T_n = -1 for n nodes and I = 0, comes as near to the bound as e^(-2 H n).
[[nodiscard]] magnitude mean_trapezoid_error(const strip_bound& bound, long nodes);

/// |G_n - I| for I the integral of f over [-1, 1] and G_n the Gauss and Legendre rule with n nodes:
///
///   |G_n - I| <= (64/15) M rho^(-2n) / (1 - rho^-2).
///
/// Source: L. N. Trefethen, SIAM Review 50 (2008), Theorem 4.5. Its proof, for n nodes: let f = sum
/// of a_k T_k. In x = (z + 1/z)/2, f(x) = sum of a_k (z^k + z^-k)/2 is analytic for 1/rho < |z| <
/// rho, and moving the circle over which a_k is integrated to |z| = r < rho gives |a_k| <= 2 M
/// r^-k, k >= 1; let r go to rho. The error of the rule on T_k is 0 for k < 2n, where the rule is
/// exact, and for odd k. For even k the integral of T_k is -2/(k^2 - 1), and the rule, whose
/// weights are positive with sum 2, is at most 2 in size. For even k >= 2n, k >= 4 the error is
/// thus at most 2 + 2/15 = 32/15; the one case left, n = 1 and k = 2, has
/// |2 T_2(0) + 2/3| = 4/3, which is less. So |G_n - I| <= (32/15) sum over k = 2n, 2n + 2, ... of 2
/// M rho^-k, which is the bound. Nothing in it asks for f to be real: the a_k may be complex
/// numbers.
///
/// Hypotheses: f is analytic inside the Bernstein ellipse |x - 1| + |x + 1| < rho + 1/rho, with |f|
/// <= M there, which the caller has proved. A ball rho stands for its least member. The answer is
/// an upper bound; it is infinite where rho is not certainly greater than 1 or n < 1.
[[nodiscard]] magnitude gauss_legendre_error(long n, const ball& rho, const magnitude& bound);

// --------------------------------------------------------------------------------------------- The
// rules at Chebyshev's points. What they have in common: f is analytic inside the Bernstein ellipse
// |x - 1| + |x + 1| < rho + 1/rho, with |f| <= M there, which the caller has proved; f = sum of a_k
// T_k with
// |a_k| <= 2 M rho^-k for k >= 1 (shown above, under gauss_legendre_error). The series converges
// uniformly on [-1, 1], so the error of a rule is the sum of a_k times its error on T_k. A ball rho
// stands for its least member. The answers are upper bounds, infinite where rho is not certainly
// greater than 1 or n is too small.

/// |G_n - I| for I the integral of f(x) / sqrt(1 - x^2) over [-1, 1] and G_n Gauss and Chebyshev's
/// rule of the first kind with n >= 1 nodes cos((2j+1) pi/(2n)), all weights pi/n:
///
///   |G_n - I| <= 2 pi M / (rho^(2n) - 1).
///
/// Proof: at the nodes the sum of cos((2j+1) k pi/(2n)) over j is 0 unless 2n divides k, and n
/// (-1)^(k/(2n)) where it does. So the rule is exact for T_k (whose integral is 0 for k >= 1)
/// unless k = 2n i, i >= 1, when it is off by pi; and pi times the sum of 2 M rho^(-2ni) over i >=
/// 1 is the bound. T_2n, with M = (rho^2n + rho^-2n)/2 and the error pi, shows that no factor can
/// be missing.
[[nodiscard]] magnitude gauss_chebyshev_error(long n, const ball& rho, const magnitude& bound);

/// |G_n - I| for I the integral of f(x) sqrt(1 - x^2) over [-1, 1] and G_n Gauss and Chebyshev's
/// rule of the second kind with n >= 1 nodes cos(j pi/(n+1)) and weights pi/(n+1) sin(j
/// pi/(n+1))^2, j = 1 ... n:
///
///   |G_n - I| <= (pi/2) M (rho + 1/rho)^2 / (rho^(2n+2) - 1).
///
/// Proof: I is the integral of g(t) = f(cos t) sin(t)^2 over (0, pi). Let g = sum of b_m cos(m t).
/// For m >= 4 b_m = a_m/2 - (a_(m-2) + a_(m+2))/4, so |b_m| <= 2 M rho^-m (2 + rho^2 + rho^-2)/4 =
/// (M/2) rho^-m (rho + 1/rho)^2. With N = n + 1 the rule is pi/N times the sum of g(j pi/N), 0 <= j
/// <= N, with its ends, which are 0, halved. On cos(m t) that is 0 unless 2N divides m, and pi
/// where it does; the integral is 0 but for m = 0. The error is thus at most pi times the sum of
/// |b_m| over m = 2N, 4N, ..., all >= 4, which is the bound. U_2n, with M = sinh((2n+1) log
/// rho)/sinh(log rho) and the error pi/2, comes as near to it as (1 + rho^-2)^2/(1 - rho^-2).
[[nodiscard]] magnitude gauss_chebyshev_second_error(long n, const ball& rho,
                                                     const magnitude& bound);

/// |C_n - I| for I the integral of f over [-1, 1] and C_n Clenshaw and Curtis's rule, with the n +
/// 1 nodes cos(j pi/n), n >= 1:
///
///   |C_n - I| <= 2 M (sum over even k, n < k < 2n, of e_k rho^-k
///                     + (2/3) rho^(-2n)/(1 - rho^-2) + c / (rho^(2n) - 1)),
///   e_k = 2/((2n-k)^2 - 1) - 2/(k^2 - 1),   c = 22/15 for n >= 2, c = 2 for n = 1.
///
/// Proof: the rule integrates the polynomial of degree n that agrees with f at the nodes. So it is
/// exact for T_k, k <= n, and by symmetry for odd k. At the nodes T_k is T_m with m the distance of
/// k from the nearest multiple of 2n, m <= n, which is even for even k. For even k the integral of
/// T_k is -2/(k^2 - 1), and the rule says -2/(m^2 - 1): 2 where m = 0, else in [-2/3, 0). For n < k
/// < 2n, m = 2n - k >= 2 and the error is e_k (k > m, so it is positive). For k >= 2n it is below
/// 2/3 where m >= 2; where m = 0, 2n divides k and it is 2 + 2/(k^2 - 1), at most 2/3 + 22/15 for k
/// >= 4, and 2/3 + 2 for k = 2. Summing 2 M rho^-k times that gives the bound.
///
/// (As e_k and 2 + 2/(k^2 - 1) are at most 32/15 for k >= 4, it is below L. N. Trefethen's (64/15)
/// M rho^-k / (1 - rho^-2), SIAM Review 50 (2008), Theorem 4.5, with the least even k > n: n + 2
/// for even n, n + 1 for odd n > 1. Much of it: e_k is of the order of n^-2 for k near n.) The time
/// is proportional to n.
[[nodiscard]] magnitude clenshaw_curtis_error(long n, const ball& rho, const magnitude& bound);

/// |F_n - I| for Fejer's first rule, with the n >= 1 nodes cos((2j+1) pi/(2n)):
///
///   |F_n - I| <= 2 M (sum over even k, n <= k < 2n, of e_k rho^-k
///                     + (2/3 + 2/(4 n^2 - 1)) rho^(-2n)/(1 - rho^-2) + (4/3) / (rho^(2n) - 1)),
///   e_k = 2/((2n-k)^2 - 1) + 2/(k^2 - 1) for k > n,   e_n = 2/(n^2 - 1).
///
/// Proof: as above; exact for T_k, k < n, and odd k. T_n is 0 at the nodes. With k = 2n i + m, |m|
/// < n, T_k is there (-1)^i T_|m|, and 0 where |m| = n. So the rule says 0 for k = n, and for n < k
/// < 2n, i = 1, minus the integral of T_(2n-k), that is 2/((2n-k)^2 - 1): e_k are the errors. For k
/// >= 2n the rule says at most 2/3, or 2 where m = 0, and the integral is at most 2/(4n^2 - 1).
[[nodiscard]] magnitude fejer_error(long n, const ball& rho, const magnitude& bound);

// ---------------------------------------------------------------------------------------------
// The trapezoidal rule of a function that is small at both ends.

/// |f(x + iy)| <= supremum for from <= |y| <= to, at an x that is said elsewhere.
struct side_piece {
  double from = 0;
  double to = 0;
  magnitude supremum;
};

/// What is known of f in the rectangle A <= Re z <= B, |Im z| <= d.
struct rectangle_bound {
  double half_height = 0;        // d > 0: f is analytic on a neighbourhood of the closed rectangle;
  magnitude horizontal;          // >= the integrals of |f| along both horizontal sides, added up;
  std::vector<side_piece> left;  // at x = A, from 0 to d without a gap,
  std::vector<side_piece> right;  // and at x = B
};

/// |S_h - I| for I the integral of f over [A, B] and S_h = h times the sum of f(A + (j + 1/2) h), j
/// = 0 ... n-1, h = (B - A)/n:
///
///   |S_h - I| <= H / (e^(2 pi d/h) - 1) + V_A + V_B,
///   V = integral of |f(x + iy)| / (1 + e^(2 pi |y|/h)) dy over |y| <= d at x = A, x = B.
///
/// H is bound.horizontal. A piece y_0 <= |y| <= y_1 adds to V its supremum times
/// (h/pi) (log(1 + e^(-2 pi y_0/h)) - log(1 + e^(-2 pi y_1/h))); so V <= (h/pi) log(2) max |f|.
///
/// Proof: let q = e^(2 pi i (z - x_0)/h), x_0 = A + h/2, and c(z) = (1/2) (q + 1)/(q - 1), which is
/// cot(pi (z - x_0)/h)/(2i): its poles in the rectangle are the nodes, all inside, with the
/// residues h/(2 pi i). So the integral of f c around the rectangle, counterclockwise, is S_h. The
/// boundary's upper part U leads from B to A, its lower part L from A to B; by Cauchy's theorem the
/// integral of f over U is -I, over L it is I. Hence
///   S_h - I = integral over U of f (c + 1/2) + integral over L of f (c - 1/2),
/// c + 1/2 = q/(q - 1), c - 1/2 = 1/(q - 1). With Q = e^(-2 pi |y|/h) for y = Im z: |q| = Q above
/// and 1/Q below, so either factor is at most Q/(1 - Q) in size; on the horizontal sides that is
/// 1/(e^(2 pi d/h) - 1). On the vertical sides z - x_0 is -h/2 + iy or (n - 1/2) h + iy, where q =
/// -|q|: either factor is Q/(1 + Q) = 1/(1 + 1/Q) in size. Its integral over y_0 <= y <= y_1 is
/// (h/(2 pi)) (log(1 + Q(y_0)) - log(1 + Q(y_1))), for the derivative of log(1 + Q) is -(2 pi/h)
/// Q/(1 + Q); and there are a piece above and one below.
///
/// exp(-x^2) attains it but for the ends: at d = pi/h, S_h - I = +-2 sqrt(pi) e^(-pi^2/h^2) (1 +
/// ...) is the first term. The answer is an upper bound; it is infinite where h or d is not
/// certainly positive, or where the pieces do not lead from 0 to d.
[[nodiscard]] magnitude trapezoid_error(const ball& h, const rectangle_bound& bound);

}  // namespace polhode
