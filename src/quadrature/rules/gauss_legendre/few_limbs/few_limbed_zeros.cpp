// How a zero is found and proved. The unit is u = 2^-F, F = 64 limbs_; y_0 = Y/2^64 is the start, s
// = 4 y_0 (1 - y_0), and y = y_0 + s g/n, so that q as a function of g is about as large as its
// derivatives there.
//   1. q(y_0) and q'(y_0) by Horner's scheme in integers.
//   2. The Taylor coefficients of q in g, from Legendre's differential equation: e_0, e_1, ... e_K.
//      T is their polynomial; what it leaves out of q and q' is bounded by
//      legendre_taylor_remainder.
//   3. A search: Newton's method for a zero of T, g, in so many limbs as are known at each step.
//   4. The proof, in integers: T(g) is so small, and |T'| around g so large, that q changes its
//      sign between g - r and g + r. That there is only one zero need not be shown: the sets of a
//      rule are disjoint and as many as q has zeros.
// Numbers have a sign, a limb before the point and some behind it. Every product, quotient and
// shift of the sizes is cut off, which loses less than a unit of its last place; so that errors are
// counted, not estimated:
//
// Horner. b_j = C_j + floor(b_(j+1) y_0) and s_j = b_(j+1) + floor(s_(j+1) y_0), where C_j, the
// coefficient of y^j in units, was rounded downward; b_0 is q(y_0), s_0 is q'(y_0), in units. A
// step of the first commits an error between -2 and 0 and multiplies the one before by y_0 < 1: b_j
// is off by at most 2(m-j+1), m being q's degree. A step of the second commits one between -1 and
// 0, and takes over that of b_(j+1): s_0 is off by at most the sum of 2(m-i+1) + 1, i = 1 ... m,
// m(m+2). Both have room: |b_j|, |s_j| are at most 2^(64 size - 3) + m(m+2), below 2^(64 size - 1).
//
// Taylor coefficients. From (1 - x^2) P'' - 2x P' + n(n+1) P = 0,
//   4y(1-y) q'' + (2 + 4e - (6 + 4e) y) q' + (n(n+1) - 2e) q = 0,   e = 0 or 1 as n is even or odd,
// and for q = sum of c_k (y - y_0)^k, e_k = c_k (s/n)^k, that is
//   n^2 (k+1)(k+2) e_(k+2) = -n A_k e_(k+1) - s B_k e_k,
//   A_k = (k+1) (4 (1 - 2 y_0) k + 2 + 4e - (6 + 4e) y_0),   |A_k| <= (k+1)(4k+6),
//   B_k = n(n+1) - 2e - 4k(k-1) - (6 + 4e) k,                0 < B_k <= n(n+1) where k + 2 <= n/2,
// as s <= 1. (A_k is linear in y_0, between 4k + 2 + 4e and -4k - 4. B_k >= n + n^2 - (4k^2 + 6k +
// 2), and that is at most (n-4)^2 + 3(n-4) + 2 < n^2.) 2^64 A_k and 2^126 s are integers, so that
// the two products are off by what the coefficients are off by and by less than a unit each, and
// the quotient by less than another one. For the bounds E_k of what e_k is off by, in units, that
// is E_(k+2) <= (4k+6)/((k+2) n) E_(k+1) + (n+1)/(n (k+1)(k+2)) E_k + 3, where n >= 2k + 4: the two
// factors are at most 3/4 and 5/8 for k = 0, and together at most 3/4 for k > 0. So E_k <= max(1.4
// max(E_0, E_1) + 3, 12), which is below 2^12 for n <= 1024.
//
// How generous that is. E_0 and E_1 leave out that a step's error is multiplied by y_0 in all steps
// after it, that no coefficient is rounded where n <= F, and that the first product of each is 0.
// Counted so, b_0 and s_0 are off by at most e and d: with c = 1 where n <= F and 2 elsewhere, b_m
// is by c - 1, b_j by y_0 times that of b_(j+1) and c, s_m by 0, s_(m-1) by that of b_m, and s_j by
// y_0 times that of s_(j+1), that of b_(j+1) and 1. And `proved` has something to spare beside
// them:
//   In units of y: T(g) is off by less than e + 1.02, and what T leaves out is at most 1, where
//   without E_0 4 would be counted; s g/n is cut off by less than 1 + 1/n, where 2 are counted. So
//   E_0 is not missed where (e - 1.98) / |q'| <= 1 - 1/n. In units of T': e_1 is off by d s/n + 1 +
//   1/n, and T'(g) by 1.02 more, where 3 would be counted; but the count for |T''| r has (E_0 +
//   1.98 - e) |A_0|/n to spare, as r contains E_0 for e, and |2 e_2/e_1| is |A_0|/n within 2^-30.
// Both suffice at the zeros of all q, n <= 1024 (LegendreZeros.HideTheErrorsOfHornersScheme): no
// zero and no start comes near E_0 and E_1. They stay, as the sharper ones would need y_0 in every
// count; the tests reach the radius where the search ends early, and the three units of y where it
// ends at the last bit.

#include "quadrature/rules/gauss_legendre/few_limbs/few_limbed_zeros.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "quadrature/rules/gauss_legendre/few_limbs/neighbourhood.hpp"

namespace polhode::detail {

few_limbed_zeros::few_limbed_zeros(const legendre_shape& s, precision bits, long most)
    : shape_(s),
      bits_(bits),
      polynomial_(s, std::max((bits + 63) / 64 * 64, precision{128})),
      limbs_(polynomial_.fraction_bits / 64) {
  const auto n = static_cast<std::uint64_t>(s.n);
  const auto m = static_cast<std::uint64_t>(s.degree);
  const long last = std::min(most, s.degree);
  log2_terms_ = {0, 0};
  errors_ = {2 * (m + 1), (m * (m + 2) + 1) / n + 2};
  for (long order = 2; order <= last; ++order) {
    // The bound of legendre_taylor_remainder, for the slope: of order times that for the value.
    const auto j = static_cast<double>(order);
    const double base = std::numbers::e * static_cast<double>(s.n) / (2 * j);
    log2_terms_.push_back(2 * j * std::log2(base) + std::log2(j) +
                          (s.odd != 0 ? std::log2(static_cast<double>(s.n)) : 0.0));
    const auto k = static_cast<std::uint64_t>(order - 2);
    const std::uint64_t divisor = n * n * (k + 1) * (k + 2);
    const std::uint64_t sum =
        n * (k + 1) * (4 * k + 6) * errors_[k + 1] + n * (n + 1) * errors_[k] + 2;
    errors_.push_back(sum / divisor + 2);
  }
}

std::optional<legendre_zero> few_limbed_zeros::near(std::uint64_t start) const {
  if (start == 0) return std::nullopt;
  legendre::neighbourhood around(shape_, errors_, limbs_, start);
  if (!around.values(polynomial_) || !around.terms(log2_terms_) ||
      !around.search(std::max(bits_, 64 * limbs_ - 40))) {
    return std::nullopt;
  }
  return around.proved();
}

}  // namespace polhode::detail
