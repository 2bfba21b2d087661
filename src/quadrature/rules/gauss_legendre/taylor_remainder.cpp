// The error bound behind the nodes: what a Taylor polynomial of q leaves out of it, by Cauchy's
// estimate. The error of the rule itself is bounded in rules/error_bounds.cpp.

#include <cstdint>

#include "polhode/quadrature/gauss_legendre.hpp"

namespace polhode::detail {

/// For r > 0 let s = sqrt(r). If |x^2 - y_0| <= r, then x lies in the Bernstein ellipse |x - 1| +
/// |x + 1| <= 2 cosh(a), sinh(a) = s. Proof: (|x-1| + |x+1|)^2 = |x-1|^2 + |x+1|^2 + 2|x^2-1| = 2
/// (|y| + 1 + |y-1|), which for y = x^2 is at most 2 (y_0 + r + 1 + 1 - y_0 + r) = 4 (1 + r) = 4
/// cosh(a)^2. In that ellipse |P_n| <= e^(na): P_n(cos t) is a combination of cos((n - 2k) t) with
/// positive coefficients that add up to P_n(1) = 1 (expand the generating function ((1 - z e^(it))
/// (1 - z e^(-it)))^(-1/2)), and
/// |cos((n - 2k) t)| <= e^(n |Im t|), with |Im t| <= a there. As a <= sinh(a) = s, |q| <= e^(ns) on
/// the disc for even n. For odd n q = P_n / x, and on the boundary of the ellipse |x| is at least
/// the minor half axis, sinh(a) = s: by the maximum principle |q| <= e^(ns) / s. Call that bound M.
/// Cauchy: the k-th coefficient is at most M r^-k, so with t = h/r < 1 the remainders are at most
///   sum over k >= j of M t^k = M t^j / (1 - t), sum over k >= j of k M t^(k-1) / r = (M/r) t^(j-1)
///   (j - (j-1) t) / (1-t)^2 <= (M t^j / h) j / (1-t)^2.
/// With s = 2j/n, the best choice for even n: M t^j = (e n / (2j))^(2j) h^j, times n / (2j) for odd
/// n.
///
/// How generous that is: half of it would do for all n, j, h and y_0. q(y) is a Jacobi polynomial
/// in 2y - 1, P_m^(0, -1/2) or P_m^(0, 1/2), and so are its derivatives but for a factor; they are
/// the largest at y = 1 for even n, at y = 0 for odd n (Szegő, Orthogonal Polynomials, theorem
/// 7.32.1). With N = n/2 that gives, for all y_0 in [0, 1],
///   |c_k| <= product over i < k of (m - i)(m + 1/2 + i) / k!^2 <= e^(1/2) N^(2k) / k!^2 for even
///   n,
///   |c_k| <= Gamma(N + k + 1) / (Gamma(N - k + 1/2) Gamma(k + 3/2) k!) <= 2 e n^(2k) sqrt(N/pi) /
///   (2k+1)! for odd n,
/// as k <= m: the first product's factors are at most m^2 but for (1 + 1/(2m)), and Gamma(N + k +
/// 1) / Gamma(N - k + 1/2) is at most (N^2 + N)^k sqrt(N). By Stirling's formula the k-th term
/// e^(2k) (n/(2k))^(2k), times N/k for odd n, is at least 2 pi k e^(-1/2) > 3 and 2 pi sqrt(k N) /
/// e > 2.8 times that; and M t^k is not less than it for any k >= j.
taylor_remainder legendre_taylor_remainder(long n, long j, const magnitude& h) {
  const auto order = static_cast<std::uint64_t>(j);
  const magnitude inverse_s = divide_up(magnitude::from_integer_up(static_cast<std::uint64_t>(n)),
                                        magnitude::from_integer_down(2 * order));
  const magnitude t = multiply_up(multiply_up(inverse_s, inverse_s), h);
  const magnitude complement = subtract_down(magnitude::from_integer_down(1), t);
  // e < 2.71828183
  const magnitude e =
      divide_up(magnitude::from_integer_up(271'828'183), magnitude::from_integer_down(100'000'000));
  magnitude power = multiply_up(multiply_up(e, e), t);
  magnitude bound = n % 2 != 0 ? inverse_s : magnitude::from_integer_up(1);
  for (std::uint64_t left = order; left != 0; left /= 2) {
    if (left % 2 != 0) bound = multiply_up(bound, power);
    power = multiply_up(power, power);
  }
  // Both are infinite where t >= 1.
  return {divide_up(bound, complement),
          divide_up(divide_up(multiply_up(bound, magnitude::from_integer_up(order)), h),
                    multiply_down(complement, complement))};
}

}  // namespace polhode::detail
