#include "arithmetic/functions/fixed_point/exponential.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "arithmetic/functions/fixed_point/prime_reduction.hpp"
#include "arithmetic/functions/fixed_point/series.hpp"
#include "arithmetic/functions/fixed_point_functions.hpp"

namespace polhode::detail::fixed_point {

namespace exponential_impl {
namespace {

constexpr long digit_bits = 5;
constexpr long digits = 5;
constexpr long digit_count = 1L << digit_bits;
constexpr limb digit_mask = limb{digit_count - 1};
constexpr long reduced_bits = digits * digit_bits;

/// m becomes (1 + m)(1 + f) - 1, cut off.
void join(limb* m, const limb* f, long w) {
  fraction product(w);
  multiply(product.data(), m, f, w);
  mpn_add_n(m, m, f, w);
  mpn_add_n(m, m, product.data(), w);
}

/// The entries e^(i/2^5) - 1, e^(j/2^10) - 1, ... with w limbs, and a bound of their errors: they
/// are too small. i <= 22, for t < log 2.
class exponential_table {
 public:
  explicit exponential_table(long w)
      : w_(w), entries_(static_cast<std::size_t>(digits * digit_count * w)) {
    fraction first(w);
    set_least_base(first);
    for (long level = digits - 1; level >= 0; --level) {
      const limb last = level == 0 ? 22 : digit_mask;
      fraction product(w);
      mpn_copyi(product.data(), first.data(), w);
      std::uint64_t units = first_units;
      for (limb i = 1;; ++i) {
        mpn_copyi(place_of(level, i), product.data(), w_);
        if (i == last) break;
        join(product.data(), first.data(), w_);
        // E (1 + f) + D (1 + m) + 1, f < 1/16, m < 1.
        units += units / 16 + 2 * first_units + 2;
      }
      units_ = std::max(units_, units);
      for (long i = 0; level > 0 && i < digit_bits; ++i) join(first.data(), first.data(), w_);
    }
  }

  /// With w limbs, at most as many as it has.
  [[nodiscard]] const limb* entry(long level, limb digit, long w) const {
    return entries_.data() + first_limb(level, digit) + (w_ - w);
  }
  /// The units by which an entry with w limbs is too small at most. With fewer limbs than the table
  /// has it is cut off.
  [[nodiscard]] std::uint64_t units(long w) const { return w == w_ ? units_ : 2; }

 private:
  // Of the series 34, and (1 + m)^2 - 1 makes 2 E (1 + m) + 1 of an error E: over the squares from
  // the least base to the first the factors 1 + m have a product below 2, and the error becomes
  // less than 2 2^20 (34 + 1).
  static constexpr std::uint64_t first_units = std::uint64_t{35} << (digit_bits * (digits - 1) + 1);

  [[nodiscard]] long first_limb(long level, limb digit) const {
    return (level * digit_count + static_cast<long>(digit)) * w_;
  }
  limb* place_of(long level, limb digit) { return entries_.data() + first_limb(level, digit); }

  /// m becomes e^y - 1 for the last digit's y = 2^-25.
  void set_least_base(fraction& m) const {
    fraction y(w_);
    mpn_zero(y.data(), w_);
    const long place = 64 * w_ - reduced_bits;
    y[place / 64] = limb{1} << (place % 64);
    number sum(w_);
    sum_series(sum, series::exponential, y.data(), w_, reduced_bits - 1);
    mpn_copyi(m.data(), sum.data(), w_);
  }

  long w_;
  std::vector<limb> entries_;
  std::uint64_t units_ = 0;
};

// Beyond these the reduction by primes is faster.
constexpr long most_limbs_by_digits = 20;

}  // namespace
}  // namespace exponential_impl

std::uint64_t expm1_of_fraction(limb* m, const limb* t, long w) {
  using namespace exponential_impl;
  if (is_tabulated(w)) return tabulated_expm1(m, t, w);
  if (w > most_limbs_by_digits) {
    number value(w);
    const std::uint64_t units = exponential_by_primes(value, t, w);
    if (value[w] == 1) {
      mpn_copyi(m, value.data(), w);
    } else {
      // Nearer to 1 <= e^t < 2.
      std::fill_n(m, w, value[w] == 0 ? limb{0} : ~limb{0});
    }
    return units;
  }
  static const exponential_table table(most_limbs_by_digits);
  fraction y(w);
  mpn_copyi(y.data(), t, w);
  y[w - 1] &= ~limb{0} >> reduced_bits;
  number sum(w);
  sum_series(sum, series::exponential, y.data(), w, reduced_bits);
  mpn_copyi(m, sum.data(), w);
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
      !may_be_own()) {
    return false;
  }
  const long w = limbs_for(mpfr_get_prec(r), bits_of_turns(x));
  if (w > most_limbs) return false;
  // |x| = n log 2 + t, cut off by one unit, with an error of n units; for x < 0 the next multiple.
  number t(w);
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
  fraction m(w);
  const std::uint64_t units = expm1_of_fraction(m.data(), t.data(), w) + 2 * (n + 2) + 1;
  number value(w);
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
  if (w > most_limbs || exponent > range_log2 || exponent < least_exponent || !may_be_own()) {
    return false;
  }
  number t(w);
  load(t, x, exponent, w);
  const log_2 log2(w);
  const std::uint64_t n = reduce(t, log2, w);
  fraction m(w);
  const std::uint64_t units = expm1_of_fraction(m.data(), t.data(), w) + 2 * (n + 2) + 1;
  number value(w);
  mpn_copyi(value.data(), m.data(), w);
  value[w] = 1;
  const std::uint64_t shift = 2 * n;
  std::uint64_t both = units;
  if (shift < static_cast<std::uint64_t>(64 * w)) {
    // floor((2^(128 w) - 1) / V), in units, is below 2^(64 w) unless V = 1; and then too.
    double_fraction dividend(w);
    for (long i = 0; i < 2 * w; ++i) dividend[i] = ~limb{0};
    double_fraction quotient(w);
    number remainder(w);
    mpn_tdiv_qr(quotient.data(), remainder.data(), 0, dividend.data(), 2 * w, value.data(), w + 1);
    number inverse(w);
    mpn_zero(inverse.data(), w + 1);
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
