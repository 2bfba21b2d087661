#include "arithmetic/functions/fixed_point/exponential.hpp"

#include <algorithm>
#include <cstdint>

#include "arithmetic/functions/fixed_point/series.hpp"
#include "arithmetic/functions/fixed_point_functions.hpp"

namespace polhode::detail::fixed_point {

namespace exponential_impl {
namespace {

constexpr long digit_bits = 6;
constexpr long digits = 4;
constexpr limb digit_mask = (limb{1} << digit_bits) - 1;
constexpr long reduced_bits = digits * digit_bits;

/// m becomes (1 + m)(1 + f) - 1, cut off.
void join(fraction& m, const limb* f, long w) {
  fraction product;
  multiply(product.data(), m.data(), f, w);
  mpn_add_n(m.data(), m.data(), f, w);
  mpn_add_n(m.data(), m.data(), product.data(), w);
}

/// e^(i/2^6) - 1, e^(j/2^12) - 1, ... with the most limbs, and how many units they are too small at
/// most. i <= 44, for t < log 2.
class exponential_table {
 public:
  exponential_table() {
    for (long level = 0; level < digits; ++level) {
      const long bits = digit_bits * (level + 1);
      fraction& first = entries_[level][1];
      first = base(bits);
      const limb last = level == 0 ? 44 : digit_mask;
      // Of the first entry, by the series at y < 1/4 and halvings: 2 (34 + 2) 2^halvings and less
      // than as many for the steps.
      std::uint64_t units = first_units;
      for (limb i = 2; i <= last; ++i) {
        entries_[level][i] = entries_[level][i - 1];
        join(entries_[level][i], first.data(), most_limbs);
        // E (1 + f) + D (1 + m) + 1, f < 1/32, m < 1.
        units += units / 32 + 2 * first_units + 2;
      }
      units_ = std::max(units_, units);
    }
  }

  /// With w limbs.
  [[nodiscard]] const limb* entry(long level, limb digit, long w) const {
    return entries_[level][digit].data() + (most_limbs - w);
  }
  /// Those of an entry with w limbs: of fewer than the most it is cut off.
  [[nodiscard]] std::uint64_t units(long w) const { return w == most_limbs ? units_ : 2; }

 private:
  static constexpr long halvings = 25;
  static constexpr std::uint64_t first_units = std::uint64_t{1} << (halvings + 7);

  /// e^(2^-bits) - 1, by y = 2^-(bits + halvings) and e^(2y) - 1 = 2 m + m^2: an error e of m
  /// becomes 2 e (1 + m) and one more, and the factors 1 + m have a product below 2.
  static fraction base(long bits) {
    fraction y;
    mpn_zero(y.data(), most_limbs);
    const long place = 64 * most_limbs - bits - halvings;
    y[place / 64] = limb{1} << (place % 64);
    number sum;
    sum_series(sum, series::exponential, y.data(), most_limbs, bits + halvings - 1);
    fraction m;
    mpn_copyi(m.data(), sum.data(), most_limbs);
    for (long i = 0; i < halvings; ++i) {
      fraction m2;
      square(m2.data(), m.data(), most_limbs);
      mpn_lshift(m.data(), m.data(), most_limbs, 1);
      mpn_add_n(m.data(), m.data(), m2.data(), most_limbs);
    }
    return m;
  }

  fraction entries_[digits][digit_mask + 1];
  std::uint64_t units_ = 0;
};

const exponential_table& the_exponential_table() {
  static const exponential_table table;
  return table;
}

}  // namespace
}  // namespace exponential_impl

std::uint64_t expm1_of_fraction(fraction& m, const limb* t, long w) {
  using namespace exponential_impl;
  if (is_tabulated(w)) return tabulated_expm1(m.data(), t, w);
  const exponential_table& table = the_exponential_table();
  fraction y;
  mpn_copyi(y.data(), t, w);
  y[w - 1] &= ~limb{0} >> reduced_bits;
  number sum;
  sum_series(sum, series::exponential, y.data(), w, reduced_bits);
  mpn_copyi(m.data(), sum.data(), w);
  for (long level = digits - 1; level >= 0; --level) {
    const limb digit = (t[w - 1] >> (64 - digit_bits * (level + 1))) & digit_mask;
    if (digit != 0) join(m, table.entry(level, digit, w), w);
  }
  return 68 + digits * 2 * (2 * table.units(w) + 1);
}

}  // namespace polhode::detail::fixed_point

namespace polhode::detail {

using namespace fixed_point;

bool near_exp(mpfr_ptr r, mpfr_srcptr x, magnitude& error) {
  if (mpfr_regular_p(x) == 0 || mpfr_get_exp(x) > range_log2 || mpfr_get_exp(x) < -64 ||
      !has_wide_range()) {
    return false;
  }
  const long w = limbs_for(mpfr_get_prec(r), bits_of_turns(x));
  if (w > most_limbs) return false;
  // |x| = n log 2 + t, cut off by one unit, with an error of n units; for x < 0 the next multiple.
  number t;
  load(t, x, mpfr_get_exp(x), w);
  const log_2 log2(w);
  const std::uint64_t n = reduce(t, log2, w);
  auto exponent = static_cast<mpfr_exp_t>(n);
  if (mpfr_sgn(x) < 0) {
    exponent = -exponent;
    if (mpn_zero_p(t.data(), w) == 0) {
      mpn_sub_n(t.data(), log2.data(), t.data(), w);
      --exponent;
    }
  }
  // e^t <= 2 magnifies t's error of n + 2.
  fraction m;
  const std::uint64_t units = expm1_of_fraction(m, t.data(), w) + 2 * (n + 2) + 1;
  number value;
  mpn_copyi(value.data(), m.data(), w);
  value[w] = 1;
  return store(r, value, w, 1, exponent, units, error);
}

namespace {

/// (e^|x| + e^-|x|)/2, or (e^|x| - e^-|x|)/2 with x's sign.
///
/// e^|x| = 2^n V with V = e^t, 1 <= V < 2, is computed as near_exp does, with E units of error and
/// V >= 1. Its inverse, cut off, is then wrong by E + 2 at most, and 2^-2n/V by E + 3. The value is
/// 2^(n-1) times V + 2^-2n/V <= 5/2, or V - 2^-2n/V >= 0: for n = 0 and small t the bits that V and
/// 1/V have in common are lost.
bool near_hyperbolic(mpfr_ptr r, mpfr_srcptr x, magnitude& error, bool sine) {
  constexpr mpfr_exp_t least_exponent = -32;
  if (mpfr_regular_p(x) == 0) return false;
  const mpfr_exp_t exponent = mpfr_get_exp(x);
  const long in_common = sine ? std::max<long>(0, -static_cast<long>(exponent)) : 0;
  const long w = limbs_for(mpfr_get_prec(r), in_common + bits_of_turns(x));
  if (w > most_limbs || exponent > range_log2 || exponent < least_exponent || !has_wide_range()) {
    return false;
  }
  number t;
  load(t, x, exponent, w);
  const log_2 log2(w);
  const std::uint64_t n = reduce(t, log2, w);
  fraction m;
  const std::uint64_t units = expm1_of_fraction(m, t.data(), w) + 2 * (n + 2) + 1;
  number value;
  mpn_copyi(value.data(), m.data(), w);
  value[w] = 1;
  const std::uint64_t shift = 2 * n;
  std::uint64_t both = units;
  if (shift < static_cast<std::uint64_t>(64 * w)) {
    // floor((2^(128 w) - 1) / V), in units, is below 2^(64 w) unless V = 1; and then too.
    double_fraction dividend;
    for (long i = 0; i < 2 * w; ++i) dividend[i] = ~limb{0};
    double_fraction quotient;
    number remainder;
    mpn_tdiv_qr(quotient.data(), remainder.data(), 0, dividend.data(), 2 * w, value.data(), w + 1);
    number inverse{};
    const auto limbs_away = static_cast<long>(shift / 64);
    const auto bits_away = static_cast<unsigned>(shift % 64);
    mpn_copyi(inverse.data(), quotient.data() + limbs_away, w - limbs_away);
    if (bits_away != 0) mpn_rshift(inverse.data(), inverse.data(), w, bits_away);
    if (sine) {
      mpn_sub_n(value.data(), value.data(), inverse.data(), w + 1);
    } else {
      mpn_add_n(value.data(), value.data(), inverse.data(), w + 1);
    }
  }
  both += units + 3;  // what is below a unit, if nothing was added
  const int sign = sine && mpfr_sgn(x) < 0 ? -1 : 1;
  return store(r, value, w, sign, static_cast<mpfr_exp_t>(n) - 1, both, error);
}

}  // namespace

bool near_cosh(mpfr_ptr r, mpfr_srcptr x, magnitude& error) {
  return near_hyperbolic(r, x, error, false);
}
bool near_sinh(mpfr_ptr r, mpfr_srcptr x, magnitude& error) {
  return near_hyperbolic(r, x, error, true);
}

}  // namespace polhode::detail
