// The Taylor coefficients of q at the start, by Legendre's differential equation in integers.

#include <cmath>
#include <cstddef>

#include "quadrature/rules/gauss_legendre/few_limbs/neighbourhood.hpp"

namespace polhode::detail::legendre {

/// e_2, ... e_K, and K: so many that what is left out is below a unit, as far as one can tell.
bool neighbourhood::terms(const std::vector<double>& log2_terms) {
  const double value = to_double(e_[0], w_);
  const double slope = to_double(e_[1], w_);
  const double g = std::abs(value / slope);
  const double s = std::ldexp(static_cast<double>(s_[1]), -62);
  if (!(g < 0x1p-32) || !(s > 0)) return false;
  // `proved` takes it for up to two units of 2^-64 greater.
  const double log2_reach = std::log2((g + 0x1p-62) * s / static_cast<double>(shape_.n));
  // What is left out of the derivative needs one power less.
  const double wanted = -64.0 * static_cast<double>(w_) - 1;
  const auto most = static_cast<long>(log2_terms.size()) - 1;
  last_ = 1;
  while (last_ < most &&
         log2_terms[static_cast<std::size_t>(last_) + 1] + static_cast<double>(last_) * log2_reach >
             wanted) {
    ++last_;
  }
  const auto n = static_cast<std::uint64_t>(shape_.n);
  const auto e = static_cast<std::uint64_t>(shape_.odd);
  const long size = w_ + 1;
  for (std::uint64_t k = 0; static_cast<long>(k) + 2 <= last_; ++k) {
    const number& now = e_[k];
    const number& next = e_[k + 1];
    number& result = e_[k + 2];
    // 2^64 n A_k
    const uint128 positive = (uint128{4 * k + 2 + 4 * e} << 64);
    const uint128 negative = uint128{8 * k + 6 + 4 * e} * start_;
    const bool drift_is_negative = negative > positive;
    const uint128 drift = (drift_is_negative ? negative - positive : positive - negative) *
                          static_cast<uint128>(n * (k + 1));
    const limb factor[2] = {static_cast<limb>(drift), static_cast<limb>(drift >> 64)};
    limb product[most_limbs + 3];
    mpn_mul(product, next.limbs, size, factor, 2);
    limb* const sum = product + 1;
    bool sum_is_negative = next.is_negative != drift_is_negative;
    limb other[most_limbs + 1];
    multiply_by_s(other, now.limbs, size,
                  n * (n + 1) - 2 * e - 4 * k * k + 4 * k - (6 + 4 * e) * k);
    add_to(sum, sum_is_negative, other, now.is_negative, size);
    mpn_divrem_1(result.limbs, 0, sum, size, n * n * (k + 1) * (k + 2));
    result.is_negative = !sum_is_negative;
    if (result.limbs[w_] >= least_too_large) return false;
  }
  return true;
}

}  // namespace polhode::detail::legendre
