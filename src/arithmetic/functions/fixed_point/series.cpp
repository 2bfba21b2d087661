#include "arithmetic/functions/fixed_point/series.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace polhode::detail::fixed_point {
namespace {

/// The quotient of two coefficients: the exponential series is the sum of z^k / (1 * 2 * ... * k),
/// the circular one, for 1 - cos(sqrt(z)), of (-1)^(k+1) z^k / ((1*2) * (3*4) * ... * ((2k-1)*2k)),
/// k >= 1.
constexpr limb factor(series s, long k) {
  return static_cast<limb>(s == series::exponential ? k : (2 * k - 1) * 2 * k);
}

}  // namespace

long terms_needed(series s, long small, long w) {
  long bits = 0;
  long k = 0;
  while (bits < 64 * w) {
    ++k;
    bits += small + static_cast<long>(std::bit_width(factor(s, k))) - 1;
  }
  return k;
}

void sum_series(number& sum, series s, const limb* z, long w, long small) {
  const long terms = std::max(terms_needed(s, small, w), 2L);
  const power_table powers(z, w, std::clamp(integer_sqrt(terms) * 5 / 4, 2L, most_block));
  mpn_zero(sum.data(), w + 1);
  limb c = 1;
  for (long k = terms;; --k) {
    const long low = powers.low_limbs(k, small);
    powers.add(sum, k, c, s == series::circular && k % 2 == 0, low);
    const limb d = c * factor(s, k);
    if (k > 1 && uint128{d} * factor(s, k - 1) <= limb{1} << 62) {
      c = d;
    } else {
      on_size(sum, w, [&] { mpn_divrem_1(sum.data() + low, 0, sum.data() + low, w + 1 - low, d); });
      c = 1;
    }
    if (k == 1) return;
    powers.end_block(sum, k, low, powers.low_limbs(k - 1, small));
  }
}

}  // namespace polhode::detail::fixed_point
