#include "arithmetic/functions/fixed_point/correction.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

#include "arithmetic/functions/fixed_point/series.hpp"

namespace polhode::detail::fixed_point {

bool arctangent_of_quotient(number& q, const limb* num, const number& den, long w,
                            bool hyperbolic) {
  double_fraction dividend(w);
  fraction z(w);
  double_fraction quotient(w);
  mpn_zero(quotient.data(), w + 2);
  number remainder(w);
  mpn_zero(dividend.data(), w);
  mpn_copyi(dividend.data() + w, num, w);
  const long n = den[w] != 0 ? w + 1 : w;
  mpn_tdiv_qr(quotient.data(), remainder.data(), 0, dividend.data(), 2 * w, den.data(), n);
  if (n == w && quotient[w] != 0) return false;
  if ((quotient[w - 1] >> 15) != 0) return false;
  square(z.data(), quotient.data(), w);
  const long zeros = std::min(leading_zeros(quotient.data(), w), 32 * w);
  const long small = 2 * zeros;
  const long terms = std::max((64 * w - zeros + small - 1) / small, 1L);
  if (terms > most_terms) return false;  // a bad first value
  const power_table powers(z.data(), w, std::max(integer_sqrt(terms), 2L));
  mpn_zero(q.data(), w + 1);
  long last = terms - 1;
  while (last >= 0) {
    limb product = 1;
    long first = last + 1;
    while (first > 0 && uint128{product} * static_cast<limb>(2 * first - 1) < limb{1} << 60) {
      --first;
      product *= static_cast<limb>(2 * first + 1);
    }
    long low = powers.low_limbs(last, small);
    on_size(q, w, [&] { mpn_mul_1(q.data() + low, q.data() + low, w + 1 - low, product); });
    for (long k = last; k >= first; --k) {
      powers.add(q, k, product / static_cast<limb>(2 * k + 1), !hyperbolic && k % 2 != 0, low);
      if (k > 0) {
        const long next_low = powers.low_limbs(k - 1, small);
        powers.end_block(q, k, low, next_low);
        low = next_low;
      }
    }
    on_size(q, w, [&] { mpn_divrem_1(q.data() + low, 0, q.data() + low, w + 1 - low, product); });
    last = first - 1;
  }
  multiply_number(q, quotient.data(), w);
  return true;
}

namespace {

constexpr limb high_product(limb x, limb y) { return static_cast<limb>((uint128{x} * y) >> 64); }

// log(1 + j/64) = 2 atanh(j / (128 + j)), and Euler's series of atan x: the sum of
// x / (1 + x^2) times the products of 2n/(2n+1) x^2 / (1 + x^2).
constexpr std::array<limb, 65> first_logarithms = [] {
  std::array<limb, 65> result{};
  for (limb j = 0; j <= 64; ++j) {
    uint128 power = (uint128{j} << 81) / (128 + j);
    uint128 sum = 0;
    for (limb k = 1; power != 0; k += 2) {
      sum += power / k;
      power = power * j / (128 + j) * j / (128 + j);
    }
    result[j] = static_cast<limb>(sum >> 16);
  }
  return result;
}();
constexpr std::array<limb, 65> first_arctangents = [] {
  std::array<limb, 65> result{};
  for (limb j = 0; j <= 64; ++j) {
    const limb norm = 4096 + j * j;
    uint128 term = (uint128{j} << 86) / norm;
    uint128 sum = 0;
    for (limb n = 1; term != 0; ++n) {
      sum += term;
      term = term * 2 * n / (2 * n + 1) * j * j / norm;
    }
    result[j] = static_cast<limb>(sum >> 16);
  }
  return result;
}();

}  // namespace

limb first_logarithm(limb f) {
  const limb j = f >> 58;
  const limb rest = f << 6 >> 6;
  // (m - c) / (m + c) for m = 1 + f, c = 1 + j/64.
  const uint128 sum = (uint128{2} << 64) + f + (j << 58);
  const auto v = static_cast<limb>((uint128{rest} << 62) / (sum >> 2));
  const limb v2 = high_product(v, v);
  constexpr limb third = ~limb{0} / 3;
  const limb tail =
      high_product(v2, third + high_product(v2, ~limb{0} / 5 + high_product(v2, ~limb{0} / 7)));
  return std::min(first_logarithms[j] + 2 * (v + high_product(v, tail)), first_logarithms[64] - 1);
}

limb first_arctangent(limb f) {
  const limb j = f >> 58;
  const limb rest = f << 6 >> 6;
  // (f - c) / (1 + f c), c = j/64.
  const uint128 divisor = (uint128{1} << 64) + high_product(f, j << 58);
  const auto v = static_cast<limb>((uint128{rest} << 63) / (divisor >> 1));
  const limb v2 = high_product(v, v);
  const limb tail = high_product(
      v2,
      ~limb{0} / 3 -
          high_product(
              v2, ~limb{0} / 5 - high_product(v2, ~limb{0} / 7 - high_product(v2, ~limb{0} / 9))));
  return first_arctangents[j] + v - high_product(v, tail);
}

}  // namespace polhode::detail::fixed_point
