#pragma once

// The arithmetic of the functions in fixed point. All numbers here are fractions of w limbs: the
// integer in {x, w} stands for itself times 2^(-64 w), the unit of all errors below. Some have a
// limb before the point and may be negative, in two's complement. Every product, quotient and shift
// is cut off, which loses less than a unit; so that "E units" of error are counted, not estimated,
// and the guard bits hide them.

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>

#include <gmp.h>
#include <mpfr.h>

#include "arithmetic/functions/tabulated_functions.hpp"
#include "polhode/arithmetic/magnitude.hpp"
#include "polhode/arithmetic/mpfr_functions.hpp"

namespace polhode::detail::fixed_point {

using limb = mp_limb_t;
static_assert(GMP_NUMB_BITS == 64, "polhode: limbs of 64 bits are assumed");
__extension__ using uint128 = unsigned __int128;

// Numbers of up to this many limbs have room on the stack.
constexpr long few_limbs = 160;
// Numbers of up to this many limbs are computed with.
constexpr long most_limbs = 1L << 18;
// Arguments of exp, sin and cos are below 2^16, those of atan between 2^-16 and 2^16.
constexpr mpfr_exp_t range_log2 = 16;

/// Limbs, the least significant first, not set. Up to `few` of them are on the stack.
template <long few>
class limbs {
 public:
  explicit limbs(long count)
      : heap_(count > few ? new limb[static_cast<std::size_t>(count)] : nullptr),
        values_(heap_ ? heap_.get() : few_values_) {}
  limbs(const limbs&) = delete;  // values_ may point into it
  limbs(limbs&&) = delete;
  limbs& operator=(const limbs&) = delete;
  limbs& operator=(limbs&&) = delete;
  ~limbs() = default;
  [[nodiscard]] limb* data() { return values_; }
  [[nodiscard]] const limb* data() const { return values_; }
  [[nodiscard]] limb& operator[](long i) { return values_[i]; }
  [[nodiscard]] limb operator[](long i) const { return values_[i]; }

 private:
  limb few_values_[few];
  std::unique_ptr<limb[]> heap_;
  limb* values_;
};
/// Of w limbs.
struct fraction : limbs<few_limbs> {
  explicit fraction(long w) : limbs(w) {}
};
/// With a limb before the point.
struct number : limbs<few_limbs + 1> {
  explicit number(long w) : limbs(w + 1) {}
};
struct double_fraction : limbs<2 * few_limbs + 2> {
  explicit double_fraction(long w) : limbs(2 * w + 2) {}
};

/// floor(sqrt(n)), for the choice of parameters.
inline long integer_sqrt(long n) { return static_cast<long>(std::sqrt(static_cast<double>(n))); }

// With more limbs arguments are reduced by primes; with fewer they are halved, or by tables.
constexpr long most_limbs_for_halving = 20;
inline bool is_tabulated(long w) { return w <= most_tabulated_limbs; }
inline bool is_by_primes(long w) { return w > most_limbs_for_halving; }

// Limbs of the fractions for p bits and such guard bits that a function's error is hardly ever too
// great for `store`; halving the arguments some sqrt(p)/4 times takes as many pairs of them, tables
// and primes take few.
inline long limbs_for_tables(mpfr_prec_t p, long more) {
  return std::max((p + more + 20 + 63) / 64, 2L);
}
inline long limbs_for_halving(mpfr_prec_t p, long more) {
  return (p + more + 40 + integer_sqrt(p) / 2 + 63) / 64;
}
inline long limbs_for_primes(mpfr_prec_t p, long more) { return (p + more + 40 + 63) / 64; }
inline long limbs_for(mpfr_prec_t p, long more) {
  const long by_tables = limbs_for_tables(p, more);
  if (by_tables <= most_tabulated_limbs) return by_tables;
  const long by_halving = limbs_for_halving(p, more);
  if (is_by_primes(by_halving))
    return std::max(limbs_for_primes(p, more), most_limbs_for_halving + 1);
  return std::max(by_halving, most_tabulated_limbs + 1);
}

/// The results' exponents are far inside MPFR's range, which a caller may have narrowed; and nobody
/// wants MPFR's functions.
inline bool may_be_own() {
  constexpr mpfr_exp_t enough = mpfr_exp_t{1} << 20;
  return mpfr_get_emax() > enough && mpfr_get_emin() < -enough &&
         !only_mpfr_functions::are_wanted();
}

/// r = x * y.
inline void multiply(limb* r, const limb* x, const limb* y, long w) {
  double_fraction product(w);
  mpn_mul_n(product.data(), x, y, w);
  mpn_copyi(r, product.data() + w, w);
}
inline void square(limb* r, const limb* x, long w) {
  double_fraction product(w);
  mpn_sqr(product.data(), x, w);
  mpn_copyi(r, product.data() + w, w);
}
/// x *= y for a number x >= 0 and a fraction y.
inline void multiply_number(number& x, const limb* y, long w) {
  double_fraction product(w);
  mpn_mul(product.data(), x.data(), w + 1, y, w);
  mpn_copyi(x.data(), product.data() + w, w + 1);
}

inline bool is_negative(const number& x, long w) { return (x[w] >> 63) != 0; }

/// f on |x|, with the sign given back.
template <class F>
void on_size(number& x, long w, F&& f) {
  const bool negative = is_negative(x, w);
  if (negative) mpn_neg(x.data(), x.data(), w + 1);
  f();
  if (negative) mpn_neg(x.data(), x.data(), w + 1);
}

/// Bits that are lost when a multiple of log 2, or of pi/4, is taken from |x| < 2^16.
inline long bits_of_turns(mpfr_srcptr x) { return std::max<long>(mpfr_get_exp(x), 0); }

/// Zero bits at the top of a fraction.
inline long leading_zeros(const limb* x, long w) {
  for (long i = w - 1; i >= 0; --i) {
    if (x[i] != 0) return 64 * (w - 1 - i) + std::countl_zero(x[i]);
  }
  return 64 * w;
}

/// num = |x - y|; true where x < y.
inline bool difference(fraction& num, const limb* x, const limb* y, long w) {
  if (mpn_cmp(x, y, w) >= 0) {
    mpn_sub_n(num.data(), x, y, w);
    return false;
  }
  mpn_sub_n(num.data(), y, x, w);
  return true;
}

/// x = |a|, a number below 2^63 that is cut off behind w limbs.
void load(number& x, mpfr_srcptr a, mpfr_exp_t exponent, long w);

/// r = x * 2^exponent with that sign, rounded to nearest; `error` is that of x in units, and
/// becomes that of r. False where x is not known well enough.
[[nodiscard]] bool store(mpfr_ptr r, number& x, long w, int sign, mpfr_exp_t exponent,
                         std::uint64_t units, magnitude& error);

/// A constant in [1/2, 1) as a fraction, cut off: log 2, or pi/4.
class constant {
 public:
  [[nodiscard]] const limb* data() const { return limbs_; }
  [[nodiscard]] limb operator[](long i) const { return limbs_[i]; }

 protected:
  /// Where `tabulated` is null, room for w limbs, which are still to be set.
  constant(const limb* tabulated, long w)
      : own_(tabulated != nullptr ? 0 : w),
        limbs_(tabulated != nullptr ? tabulated : own_.data()) {}
  [[nodiscard]] limb* own() { return own_.data(); }

 private:
  fraction own_;
  const limb* limbs_;
};
struct log_2 : constant {
  explicit log_2(long w);
};
struct quarter_pi : constant {
  explicit quarter_pi(long w);
};

/// x = n c + rest with 0 <= rest < c for a number 0 <= x < 2^16 and a fraction c >= 1/2. x becomes
/// the rest. Exact but for what c is cut off, n units.
std::uint64_t reduce(number& x, const constant& c, long w);

}  // namespace polhode::detail::fixed_point
