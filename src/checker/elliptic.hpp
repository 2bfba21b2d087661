#pragma once

// The integrals of the claims, each with its enclosure; a > 0, 0 < b < 1, u = -c/b for oscillating
// motion.
//
//   F(c,u) = integral from u to 1 of (1 - b x)/sqrt(x (1-x)(a + b x)(c + b x)) dx,
//     G(u) = F(-b u, u).

#include <functional>

#include "real.hpp"

namespace polhode::checker {

/// The mean of A, g > 0 and the sum over n >= 1 of 2^(n-1) c_n^2, c_(n+1) = (A_n - g_n)/2.
struct mean_and_sum {
  interval mean;
  interval sum;
};
[[nodiscard]] mean_and_sum agm_with_sum(const interval& A, const interval& g);

/// The mean of A, g > 0 and the sum of the Q of Bartky's transformation (DLMF 19.8.6 to 19.8.8,
/// 19.22.9): with p_0 = Q_0 = 1,
///   p' = (p^2 + A g)/(2p),  e = (p^2 - A g)/(p^2 + A g),  Q' = Q e/2,  (A, g) <- the mean and the
///   root of the product.
[[nodiscard]] mean_and_sum bartky_sums(interval A, interval g);

/// dG/du at 0 < u <= 1.
[[nodiscard]] interval half_phase_slope(const real& a, const real& b, const real& u,
                                        precision bits);

/// G(u), 0 < u <= 1.
[[nodiscard]] interval half_phase(const real& a, const real& b, const real& u, precision bits);
/// F(c,0), 0 < c <= a.
[[nodiscard]] interval rotating_phase(const real& a, const real& b, const real& c, precision bits);
/// F(0,u), 0 < u < 1, with u given by sin^2 and cos^2 of one angle: u = sine_squared.
[[nodiscard]] interval separatrix_phase(const real& a, const real& b, const interval& sine_squared,
                                        const interval& cosine_squared);
/// F(c, cos^2 psi) for -b < c <= a, c != 0 and 0 < psi < pi/2, to about 50 bits. For c < 0 sin^2
/// psi must be below 1 + c/b, the turning point; throws undecided where that is not clear.
[[nodiscard]] interval partial_phase(const real& a, const real& b, const real& c,
                                     const interval& psi);

/// The integral from 0 to pi of g(cos t) dt by the trapezoidal rule with n nodes on the half
/// circle, where g(cos t) is analytic for |Im t| <= half_width and |g(cos t)| <= supremum there.
struct periodic_integral {
  interval value;
  interval truncation_bound;
};
[[nodiscard]] periodic_integral periodic_trapezoid(
    const std::function<interval(const interval& cosine)>& g, long n, const rational& half_width,
    const rational& supremum, precision bits);

/// x(t) = ((1 + u) + (1 - u) cos t)/2 for |Im t| <= H: Re x >= below, |x| <= above. u -+ (1 - u)
/// sinh^2(H/2), as |cos t| <= cosh H, Re cos t >= -cosh H and cosh H = 1 + 2 sinh^2(H/2).
struct strip_range {
  interval below;
  interval above;
};
[[nodiscard]] strip_range range_on_strip(const rational& u, const rational& half_width,
                                         precision bits);

}  // namespace polhode::checker
