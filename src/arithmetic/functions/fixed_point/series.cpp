#include "arithmetic/functions/fixed_point/series.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <stdexcept>

namespace polhode::detail::fixed_point {
namespace {

/// The coefficient of z^(k-1) over that of z^k, but for its sign.
constexpr limb factor(series s, long k) {
  switch (s) {
    case series::exponential:
      return static_cast<limb>(k);
    case series::circular:
      return static_cast<limb>((2 * k - 1) * 2 * k);
    case series::hyperbolic_sine:
    case series::sine:
      break;
  }
  return static_cast<limb>(2 * k * (2 * k + 1));
}

constexpr bool alternates(series s) { return s == series::circular || s == series::sine; }

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
  if (terms > most_terms) throw std::logic_error("a series in fixed point has too many terms");
  // With many limbs the products that join blocks are short ones.
  const long root = integer_sqrt(terms);
  const power_table powers(
      z, w, std::clamp(is_by_primes(w) ? root * 4 / 5 : root * 5 / 4, 2L, most_block));
  mpn_zero(sum.data(), w + 1);
  limb c = 1;
  for (long k = terms;; --k) {
    const long low = powers.low_limbs(k, small);
    powers.add(sum, k, c, alternates(s) && k % 2 == 0, low);
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
