#pragma once

// erf, gamma, digamma and zeta of real balls, and gamma of complex ones. Values at points are those
// of series whose remainders are bounded, or MPFR's, correctly rounded; ranges follow from
// monotonicity and convexity, stated beside each function, and narrow ones from the derivative.

#include "polhode/arithmetic/ball.hpp"
#include "polhode/arithmetic/complex_ball.hpp"

namespace polhode {

class region;

/// (2/sqrt(pi)) integral from 0 to x of e^(-t^2) dt, and 1 minus it. Monotone on R.
[[nodiscard]] ball erf(const ball& x);
[[nodiscard]] ball erfc(const ball& x);

/// The same of complex sets, for |z| up to 32 (DLMF 7.6.2); undefined beyond. erfc is 1 - erf, to
/// an absolute error.
[[nodiscard]] complex_ball erf(const complex_ball& z);
[[nodiscard]] complex_ball erfc(const complex_ball& z);

/// Gamma(x), for sets without a pole (0, -1, -2, ...), else undefined; log|Gamma(x)| likewise.
/// Between two poles log|Gamma| is convex (its second derivative is the sum of (x+k)^-2 > 0), so
/// |Gamma| and log|Gamma| decrease where the digamma function is negative and increase where it is
/// positive; where it changes sign inside the set, the minimum is bounded below by a tangent of the
/// convex function.
[[nodiscard]] ball gamma(const ball& x);
[[nodiscard]] ball log_gamma(const ball& x);

/// The digamma function, (log|Gamma(x)|)', for sets without a pole, else undefined. Between two
/// poles it increases: its derivative is the sum of (x+k)^-2 > 0 over k >= 0 (DLMF 5.15.1).
[[nodiscard]] ball digamma(const ball& x);

/// Gamma of a complex set without a pole, by Stirling's series where Re z > 0 and by reflection
/// where Re z < 1 (DLMF 5.5.3, 5.11.1); else undefined. log Gamma(z), the branch that is real on
/// the positive axis, for Re z > 0; undefined elsewhere, but log|Gamma(x)| where the imaginary part
/// is exactly 0. To 8,192 bits at most, whatever the precision.
[[nodiscard]] complex_ball gamma(const complex_ball& z);
[[nodiscard]] complex_ball log_gamma(const complex_ball& z);

/// Their continuations over a region, by Stirling's series: Gamma where it has no pole, down to Re
/// z = -1000; log Gamma for Re z > 0; elsewhere it is not available (obstacle::unknown).
[[nodiscard]] region gamma(const region& z);
[[nodiscard]] region log_gamma(const region& z);
/// Where it has no pole, down to Re z = -1000.
[[nodiscard]] region digamma(const region& z);

/// The Riemann zeta function at an integer n >= 2, with p bits; undefined at 0 and 1.
[[nodiscard]] ball zeta(unsigned long n, precision p);

}  // namespace polhode
