// The Taylor polynomial's zero, by Newton's method in so many limbs as are known at each step. The
// proof evaluates the polynomial in the same way.

#include <algorithm>
#include <cmath>

#include "quadrature/rules/gauss_legendre/few_limbs/neighbourhood.hpp"

namespace polhode::detail::legendre {

/// Of the terms beyond it what they add at g, and at T', is below 2^-bits.
long neighbourhood::last_for(long bits) const {
  return std::clamp((bits + 10) / gap_ + 1, 1L, last_);
}

/// T(g) or T'(g) from the terms up to `last`, and w limbs behind the point, the first ones of g and
/// of the terms.
///
/// Let v = 2^(-64 w). In Horner's scheme h_k = e_k + g h_(k+1), or h_k = k e_k + g h_(k+1), down to
/// h_0 or h_1. As
/// |e_k| < 64, k <= 40 and |g| < 2^-32, |h_k| < 2^12. h_k has so many limbs behind the point, at
/// least w_k, that 2^(-64 w_k) |g|^j <= 2^-24 v, j being the powers of g that it will be multiplied
/// by, and w for j = 0; g is cut off after as many. The step commits at most k units 2^(-64 w_k)
/// for e_k, one for the product, and |h_(k+1)| for g; but none for e_k and g, j = 0, if w is w_.
/// All that, with j > 0, is at most 2^13 2^-24 v in the result, so 40 such steps count less than v,
/// and the last step's product less than v. What the e_k, j > 0, themselves are off by, k E_k u
/// with E_k <= 2^12, multiplied by |g|^j, is in all less than u. So T(g) is off by less than E_0 +
/// 3 units, and T'(g) by less than E_1 + 3, where w is w_ and `last` is K.
template <bool derivative>
number neighbourhood::evaluate(long w, long last) const {
  const auto limbs_at = [&](long j) {
    if (j == 0) return w;
    return std::clamp((64 * w + 24 - gap_ * j + 63) / 64, 1L, w);
  };
  constexpr long lowest = derivative ? 1 : 0;
  number sum;
  long have = limbs_at(last - lowest);
  const auto term = [&](number& to, long k, long limbs) {
    const number& e = e_[k];
    if constexpr (derivative) {
      mpn_mul_1(to.limbs, e.limbs + (w_ - limbs), limbs + 1, static_cast<limb>(k));
    } else {
      mpn_copyi(to.limbs, e.limbs + (w_ - limbs), limbs + 1);
    }
    to.is_negative = e.is_negative;
  };
  term(sum, last, have);
  limb product[2 * most_limbs + 1];
  for (long k = last - 1; k >= lowest; --k) {
    const long limbs = limbs_at(k - lowest);
    // {g, limbs} {sum, have + 1}, of which `limbs` remain behind the point
    const limb* const g = g_.limbs + (w_ - limbs);
    if (limbs >= have + 1) {
      mpn_mul(product, g, limbs, sum.limbs, have + 1);
    } else {
      mpn_mul(product, sum.limbs, have + 1, g, limbs);
    }
    const bool product_is_negative = sum.is_negative != g_.is_negative;
    term(sum, k, limbs);
    add_to(sum.limbs, sum.is_negative, product + have, product_is_negative, limbs + 1);
    have = limbs;
  }
  return sum;
}

/// A step of Newton's method with w limbs.
void neighbourhood::correct(long w, long w_of_slope) {
  const number value = evaluate<false>(w, last_for(64 * w));
  const number slope = evaluate<true>(w_of_slope, last_for(64 * w_of_slope));
  const long size = used(value.limbs, w + 1);
  const long size_of_slope = used(slope.limbs, w_of_slope + 1);
  if (size == 0 || size_of_slope == 0) return;
  limb numerator[2 * most_limbs + 2];
  mpn_zero(numerator, w_of_slope);
  mpn_copyi(numerator + w_of_slope, value.limbs, size);
  const long whole = w_of_slope + size;
  if (whole < size_of_slope) return;
  limb quotient[2 * most_limbs + 2];
  limb rest[most_limbs + 1];
  mpn_tdiv_qr(quotient, rest, 0, numerator, whole, slope.limbs, size_of_slope);
  const long length = whole - size_of_slope + 1;
  number step;
  mpn_zero(step.limbs, w_ + 1);
  mpn_copyi(step.limbs + (w_ - w), quotient, std::min(length, w));
  add_to(g_.limbs, g_.is_negative, step.limbs, value.is_negative == slope.is_negative, w_ + 1);
}

/// g, to about 2^-wanted.
bool neighbourhood::search(long wanted) {
  const double value = to_double(e_[0], w_);
  const double slope = to_double(e_[1], w_);
  const double second = last_ >= 2 ? to_double(e_[2], w_) : 0;
  const double third = last_ >= 3 ? to_double(e_[3], w_) : 0;
  double g = 0;
  for (int i = 0; i < 3; ++i) g = -(value + g * g * (second + g * third)) / slope;
  if (!(std::abs(g) < 0x1p-32)) return false;
  int exponent = 0;
  const double fraction = std::frexp(std::abs(g), &exponent);
  if (!(fraction > 0)) exponent = -64 * static_cast<int>(w_);
  gap_ = std::min(-exponent - 1L, 63L);
  if (gap_ < least_gap) return false;
  // |g| = bits 2^(exponent - 53): into the first limbs.
  mpn_zero(g_.limbs, w_ + 1);
  const auto bits = static_cast<std::uint64_t>(std::ldexp(fraction, 53));
  const long below = 64 * w_ + exponent - 53;  // bits below it
  if (below >= 0) {
    const long at = below / 64;
    const long shift = below % 64;
    g_.limbs[at] |= bits << shift;
    if (shift != 0 && at + 1 < w_) g_.limbs[at + 1] |= bits >> (64 - shift);
  }
  g_.is_negative = g < 0;
  // The error of g is below 2^-known. That after a step of Newton's method is 2^bend times its
  // square.
  const auto loss = static_cast<long>(std::max(-std::log2(std::abs(slope)), 0.0)) + 2;
  const auto bend =
      static_cast<long>(std::max(std::log2(std::abs(second / slope) + 1e-9), 0.0)) + 1;
  const long known = gap_ + 46;
  long goals[16];
  long steps = 0;
  for (long goal = wanted; steps < 16 && goal > known; goal = (goal + bend) / 2 + 3) {
    goals[steps++] = goal;
  }
  long have = known;
  while (steps > 0) {
    const long goal = goals[--steps];
    const long w = std::min((goal + loss + 63) / 64, w_);
    correct(w, std::min((goal - have + loss + 8 + 63) / 64, w));
    have = goal;
  }
  // g may have grown by rounding only.
  return g_.limbs[w_] == 0 && g_.limbs[w_ - 1] >> (64 - gap_) == 0;
}

template number neighbourhood::evaluate<false>(long w, long last) const;
template number neighbourhood::evaluate<true>(long w, long last) const;

}  // namespace polhode::detail::legendre
