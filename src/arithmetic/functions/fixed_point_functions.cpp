#include "fixed_point_functions.hpp"

// All numbers here are fractions of w limbs: the integer in {x, w} stands for itself times 2^(-64 w),
// the unit of all errors below. Some have a limb before the point and may be negative, in two's
// complement. Every product, quotient and shift is cut off, which loses less than a unit; so that "E units"
// of error are counted, not estimated, and the guard bits hide them.
//
// There are two series, that of exp and that of 1 - cos, which halving the argument makes short; and
// log and atan correct a value of one limb, whose exp or whose sine and cosine are computed, by the
// logarithm or the arc tangent of a number that is nearly 1 or nearly 0 (this is R. P. Brent's use of an
// inverse function, 1976, with a step of higher order than Newton's).

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include <gmp.h>

#include "polhode/arithmetic/mpfr_cell.hpp"
#include "tabulated_functions.hpp"

namespace polhode::detail {
namespace {

using limb = mp_limb_t;
static_assert(GMP_NUMB_BITS == 64, "polhode: limbs of 64 bits are assumed");
__extension__ using uint128 = unsigned __int128;

// Numbers of up to this many limbs are computed with.
constexpr long most_limbs = 56;
// Beyond these MPFR's logarithm, by the arithmetic-geometric mean, is the faster one.
constexpr long most_limbs_of_logarithm = 30;
// Arguments of exp, sin and cos are below 2^16, those of atan between 2^-16 and 2^16.
constexpr mpfr_exp_t range_log2 = 16;

/// Limbs, the least significant first; set as far as they are used.
template <long size>
struct limbs {
  limb values[size];
  [[nodiscard]] limb* data() { return values; }
  [[nodiscard]] const limb* data() const { return values; }
  [[nodiscard]] limb& operator[](long i) { return values[i]; }
  [[nodiscard]] limb operator[](long i) const { return values[i]; }
};
using fraction = limbs<most_limbs>;
/// With a limb before the point.
using number = limbs<most_limbs + 1>;
using double_fraction = limbs<2 * most_limbs + 2>;

/// floor(sqrt(n)), for the choice of parameters.
long integer_sqrt(long n) { return static_cast<long>(std::sqrt(static_cast<double>(n))); }

// Limbs of the fractions for p bits and such guard bits that a function's error is hardly ever too
// great for `store`; halving the arguments some sqrt(p)/4 times takes as many pairs of them, tables take few.
long limbs_for_tables(mpfr_prec_t p, long more) { return std::max((p + more + 20 + 63) / 64, 2L); }
long limbs_for_halving(mpfr_prec_t p, long more) {
  return (p + more + 40 + integer_sqrt(p) / 2 + 63) / 64;
}
long limbs_for(mpfr_prec_t p, long more) {
  const long by_tables = limbs_for_tables(p, more);
  if (by_tables <= most_tabulated_limbs) return by_tables;
  return std::max(limbs_for_halving(p, more), most_tabulated_limbs + 1);
}
bool is_tabulated(long w) { return w <= most_tabulated_limbs; }

/// The results' exponents are far inside MPFR's range, which a caller may have narrowed.
bool has_wide_range() {
  constexpr mpfr_exp_t enough = mpfr_exp_t{1} << 20;
  return mpfr_get_emax() > enough && mpfr_get_emin() < -enough;
}

/// r = x * y.
void multiply(limb* r, const limb* x, const limb* y, long w) {
  double_fraction product;
  mpn_mul_n(product.data(), x, y, w);
  mpn_copyi(r, product.data() + w, w);
}
void square(limb* r, const limb* x, long w) {
  double_fraction product;
  mpn_sqr(product.data(), x, w);
  mpn_copyi(r, product.data() + w, w);
}
/// x *= y for a number x >= 0 and a fraction y.
void multiply_number(number& x, const limb* y, long w) {
  double_fraction product;
  mpn_mul(product.data(), x.data(), w + 1, y, w);
  mpn_copyi(x.data(), product.data() + w, w + 1);
}

bool is_negative(const number& x, long w) { return (x[w] >> 63) != 0; }

/// f on |x|, with the sign given back.
template <class F>
void on_size(number& x, long w, F&& f) {
  const bool negative = is_negative(x, w);
  if (negative) mpn_neg(x.data(), x.data(), w + 1);
  f();
  if (negative) mpn_neg(x.data(), x.data(), w + 1);
}

/// Bits that are lost when a multiple of log 2, or of pi/4, is taken from |x| < 2^16.
long bits_of_turns(mpfr_srcptr x) { return std::max<long>(mpfr_get_exp(x), 0); }

/// x = |a|, a number below 2^63 that is cut off behind w limbs.
void load(number& x, mpfr_srcptr a, mpfr_exp_t exponent, long w) {
  const auto* significand = static_cast<const limb*>(mpfr_custom_get_significand(a));
  const long n = (mpfr_get_prec(a) + 63) / 64;
  mpn_zero(x.data(), w + 1);
  // |a| = {significand, n} * 2^(exponent - 64 n): shifted to the left by that many bits.
  const long shift = static_cast<long>(exponent) + 64 * (w - n);
  const long whole_limbs = shift >= 0 ? shift / 64 : -((63 - shift) / 64);
  const auto bits = static_cast<unsigned>(shift - 64 * whole_limbs);
  for (long i = 0; i < n; ++i) {
    const long to = i + whole_limbs;
    if (to >= 0 && to <= w) x[to] |= significand[i] << bits;
    if (bits != 0 && to + 1 >= 0 && to + 1 <= w) x[to + 1] |= significand[i] >> (64 - bits);
  }
}

/// r = x * 2^exponent with that sign, rounded to nearest; `error` is that of x in units, and becomes that
/// of r. False where x is not known well enough.
bool store(mpfr_ptr r, number& x, long w, int sign, mpfr_exp_t exponent, std::uint64_t units,
           magnitude& error) {
  long n = w + 1;
  while (n > 0 && x[n - 1] == 0) --n;
  if (n == 0) return false;
  const auto zeros = static_cast<unsigned>(std::countl_zero(x[n - 1]));
  if (zeros != 0) mpn_lshift(x.data(), x.data(), n, zeros);
  const mpfr_exp_t e = exponent + 64 * (n - w) - static_cast<mpfr_exp_t>(zeros);
  mpfr_t whole;
  mpfr_custom_init_set(whole, sign < 0 ? -MPFR_REGULAR_KIND : MPFR_REGULAR_KIND, e, 64 * n,
                       x.data());
  const bool inexact = mpfr_set(r, whole, MPFR_RNDN) != 0;
  const std::int64_t unit = std::int64_t{exponent} - 64 * w;
  // 2^(e - p) is the unit in the last place of `whole` at p bits; r's is not less.
  const std::int64_t half_ulp = std::int64_t{e} - mpfr_get_prec(r) - 1;
  if (static_cast<std::int64_t>(std::bit_width(units)) + unit > half_ulp - 9) return false;
  error = magnitude::from_bits_up(units, unit);
  if (inexact) error = add_up(error, magnitude::power_of_two(half_ulp));
  return true;
}

/// A constant in [1/2, 1) as a fraction, cut off: log 2, or pi/4.
class constant {
 public:
  constant(int (*f)(mpfr_ptr, mpfr_rnd_t), const limb* (*tabulated)(long w), long w) {
    if (is_tabulated(w)) {
      limbs_ = tabulated(w);
      return;
    }
    mpfr_t as_mpfr;
    mpfr_custom_init_set(as_mpfr, MPFR_ZERO_KIND, 0, 64 * w, computed_.data());
    f(as_mpfr, MPFR_RNDD);
    limbs_ = computed_.data();
  }
  constant(const constant&) = delete;  // limbs_ may point into it
  constant(constant&&) = delete;
  constant& operator=(const constant&) = delete;
  constant& operator=(constant&&) = delete;
  ~constant() = default;
  [[nodiscard]] const limb* data() const { return limbs_; }
  [[nodiscard]] limb operator[](long i) const { return limbs_[i]; }

 private:
  fraction computed_;
  const limb* limbs_;
};
struct log_2 : constant {
  explicit log_2(long w) : constant(mpfr_const_log2, tabulated_log_2, w) {}
};
struct quarter_pi : constant {
  explicit quarter_pi(long w) : constant(mpfr_const_pi, tabulated_quarter_pi, w) {}
};

/// x = n c + rest with 0 <= rest < c for a number 0 <= x < 2^16 and a fraction c >= 1/2. x becomes the
/// rest. Exact but for what c is cut off, n units.
std::uint64_t reduce(number& x, const constant& c, long w) {
  const uint128 top = (uint128{x[w]} << 64) | x[w - 1];
  auto n = static_cast<std::uint64_t>(top / c[w - 1]);  // or one more or less
  x[w] -= mpn_submul_1(x.data(), c.data(), w, n);
  while (is_negative(x, w)) {
    --n;
    x[w] += mpn_add_n(x.data(), x.data(), c.data(), w);
  }
  while (x[w] != 0 || mpn_cmp(x.data(), c.data(), w) >= 0) {
    ++n;
    x[w] -= mpn_sub_n(x.data(), x.data(), c.data(), w);
  }
  return n;
}

// ---------------------------------------------------------------------------------------------
// The two series.

constexpr long most_block = 16;

enum class series { exponential, circular };

/// The quotient of two coefficients: the exponential series is the sum of z^k / (1 * 2 * ... * k), the
/// circular one, for 1 - cos(sqrt(z)), of (-1)^(k+1) z^k / ((1*2) * (3*4) * ... * ((2k-1)*2k)), k >= 1.
constexpr limb factor(series s, long k) {
  return static_cast<limb>(s == series::exponential ? k : (2 * k - 1) * 2 * k);
}

/// Terms of a series that are needed for z < 2^-small: the first one left out is below a unit, and
/// so is the rest. (Of positive terms each is less than half of the one before, so it is 2 units.)
long terms_needed(series s, long small, long w) {
  long bits = 0;
  long k = 0;
  while (bits < 64 * w) {
    ++k;
    bits += small + static_cast<long>(std::bit_width(factor(s, k))) - 1;
  }
  return k;
}

/// z, z^2, ..., z^m, and sums of them. A power is cut off at each product: for z <= 1/4 it is less than 2
/// units too small, as e' <= 1 + 2 (1/4)^(i/2) e for a square and 1 + e/4 for a product.
class power_table {
 public:
  power_table(const limb* z, long w, long m) : w_(w), m_(m) {
    mpn_copyi(powers_[1].data(), z, w);
    for (long i = 2; i <= m; ++i) {
      if (i % 2 == 0) {
        square(powers_[i].data(), powers_[i / 2].data(), w);
      } else {
        multiply(powers_[i].data(), powers_[i - 1].data(), z, w);
      }
    }
  }
  /// sum += c z^(k mod m), or less.
  void add(number& sum, long k, limb c, bool subtracted) const {
    const long i = k % m_;
    if (i == 0) {
      sum[w_] += subtracted ? -c : c;
    } else if (subtracted) {
      sum[w_] -= mpn_submul_1(sum.data(), powers_[i].data(), w_, c);
    } else {
      sum[w_] += mpn_addmul_1(sum.data(), powers_[i].data(), w_, c);
    }
  }
  /// sum *= z^m where k begins a block.
  void end_block(number& sum, long k) const {
    if (k % m_ != 0) return;
    on_size(sum, w_, [&] { multiply_number(sum, powers_[m_].data(), w_); });
  }

 private:
  long w_;
  long m_;
  fraction powers_[most_block + 1];
};

/// sum = the series at z < 1/4, to `terms` terms, within 34 units.
///
/// The coefficients are integers c over common denominators D, each the product of a run a..b of factors:
///     sum over k >= a of z^k / (f(a) ... f(k)) = (sum over k = a..b of c_k z^k + rest) / D,
/// c_k = f(k+1) ... f(b), where `rest` is the same sum from b + 1 on. In blocks of m terms the powers
/// below z^m are at hand, and a block is multiplied by z^m to join the next lower one
/// (M. S. Paterson and L. J. Stockmeyer 1973; D. M. Smith 1989).
///
/// Error, in units. A power is less than 2 too small. In a run, S = sum of c_k / D <= 1/f(a) + 1/(f(a) f(a+1)) + ... < 1.72. So the terms of a run are
/// wrong by less than 2 S D < 3.5 D; the sum before a division stays below 1.75 D + 2 < 2^63, each
/// product of it with z^m, itself 2 units wrong, loses less than 3.5 D + 5 and divides the error from before
/// by 16 at least (m >= 2); a run's products together then lose less than 16/15 (3.5 D + 5) < 4 D + 6.
/// With the division, and the error e of the run above,
///     e' < 3.5 + 4 + 6 / D + 1 + e / D < 15 + e / 2 for D >= 2,
/// below 30 for every run with D >= 2; a run with D = 1 would be the factor 1 alone, which never
/// is by itself: it is joined to the run above. With the terms left out, 2 more, less than 34.
void sum_series(number& sum, series s, const limb* z, long w, long terms) {
  terms = std::max(terms, 2L);
  const power_table powers(z, w, std::clamp(integer_sqrt(terms) * 5 / 4, 2L, most_block));
  mpn_zero(sum.data(), w + 1);
  limb c = 1;
  for (long k = terms;; --k) {
    powers.add(sum, k, c, s == series::circular && k % 2 == 0);
    const limb d = c * factor(s, k);
    if (k > 1 && uint128{d} * factor(s, k - 1) <= limb{1} << 62) {
      c = d;
    } else {
      on_size(sum, w, [&] { mpn_divrem_1(sum.data(), 0, sum.data(), w + 1, d); });
      c = 1;
    }
    if (k == 1) return;
    powers.end_block(sum, k);
  }
}

/// m = e^t - 1 for a fraction t < log 2. Returns the error, in units.
///
/// m is computed at y = t / 2^r, and e^(2y) - 1 = 2 m + m^2. Cutting y off changes m by less than 2
/// units, the series by 34. If m is wrong by e then 2 m + m^2 is by 2 e (1 + m) and one more; over
/// all steps the factors 1 + m = e^y, e^(2y), ... have a product below e^t < 2. So the error is below
///     2 * 2^r (36 + 1/2 + 1/4 + ...) < 2^(r + 7).
/// An error above e^t - 1 <= 1 - 2^-64 w would be one of a sum that overflows: but the steps are
/// cut off downwards, as is the series, whose terms are positive, so that m stays below its true value.
std::uint64_t expm1_of_fraction(fraction& m, const limb* t, long w) {
  if (is_tabulated(w)) return tabulated_expm1(m.data(), t, w);
  const long r = std::min(integer_sqrt(64 * w) / 2 + 2, 31L);
  mpn_rshift(m.data(), t, w, static_cast<unsigned>(r));
  number sum;
  sum_series(sum, series::exponential, m.data(), w, terms_needed(series::exponential, r, w));
  mpn_copyi(m.data(), sum.data(), w);
  for (long i = 0; i < r; ++i) {
    fraction m2;
    square(m2.data(), m.data(), w);
    mpn_lshift(m.data(), m.data(), w, 1);
    mpn_add_n(m.data(), m.data(), m2.data(), w);
  }
  return std::uint64_t{1} << (r + 7);
}

/// Zero bits at the top of a fraction.
long leading_zeros(const limb* x, long w) {
  for (long i = w - 1; i >= 0; --i) {
    if (x[i] != 0) return 64 * (w - 1 - i) + std::countl_zero(x[i]);
  }
  return 64 * w;
}

/// v = 1 - cos t for a fraction t < 0.79. Returns the error, in units.
///
/// v is computed at y = t / 2^r with z = y^2, and 1 - cos(2y) = 4 v - 2 v^2. Cutting y off moves t by 2^r
/// units and v by less; cutting z off moves v(y) by less than 1, the series by 34. If v is wrong by e
/// then 4 v - 2 v^2 is by 4 e and 2 more. So the error is below 4^r (35 + 2/3) + 2^r <= 4^r (36 + 1/6).
/// v^2 is cut off downwards, so that v >= 0 does not become negative.
std::uint64_t versine_of_fraction(fraction& v, const limb* t, long w) {
  const long zeros = leading_zeros(t, w);
  const long r = std::max(std::min(integer_sqrt(64 * w) / 3 + 1, 18L) - zeros, 1L);
  fraction y;
  fraction z;
  mpn_rshift(y.data(), t, w, static_cast<unsigned>(r));
  square(z.data(), y.data(), w);
  number sum;
  const long small = std::min(2 * (r + zeros), 32 * w);
  sum_series(sum, series::circular, z.data(), w, terms_needed(series::circular, small, w));
  if (is_negative(sum, w)) mpn_zero(sum.data(), w + 1);  // nearer to v >= 0
  mpn_copyi(v.data(), sum.data(), w);
  for (long i = 0; i < r; ++i) {
    fraction v2;
    square(v2.data(), v.data(), w);
    mpn_lshift(v.data(), v.data(), w, 2);
    mpn_submul_1(v.data(), v2.data(), w, 2);
  }
  return std::uint64_t{37} << (2 * r);
}

/// s = sin t from v = 1 - cos t, known within `units` < 2^42, for 2^-18 <= t < 0.79: the root of
/// 2 v - v^2. Returns the error: that of the square is below 2 units + 2, that of the root is this divided by
/// the sum of the true and the computed root, which is above 1.5 s, and one more for cutting off. If t
/// has `zeros` zeros in front then s > 0.9 t > 2^(-zeros - 1.16), and the error is less than
/// (2 units + 2) 2^(zeros + 1.16) / 1.5 + 1 < (units + 1) 2^(zeros + 2).
std::uint64_t sine_from_versine(limb* s, const fraction& v, std::uint64_t units, long zeros,
                                long w) {
  double_fraction square_of_s;
  fraction v2;
  square(v2.data(), v.data(), w);
  mpn_zero(square_of_s.data(), w);
  limb* const top = square_of_s.data() + w;
  mpn_lshift(top, v.data(), w, 1);
  mpn_sub_n(top, top, v2.data(), w);
  mpn_sqrtrem(s, nullptr, square_of_s.data(), 2 * w);
  return (units + 1) << (zeros + 2);
}

// ---------------------------------------------------------------------------------------------
// Corrections: the arc tangent and its hyperbolic fellow of a small number.

/// num / den for |num| < 2^-50 and 1/4 < den < 4, then atan (or atanh) of it: q becomes a number within 3
/// units of that of the quotient of these numbers as they are. False where the quotient is not
/// below 2^-49.
///
/// atan q = q (1 - q^2/3 + q^4/5 - ...): with 98 K + 49 >= 64 w the first term left out is below a third of
/// a unit, and so is the rest. The quotient is cut off, 1 unit, which atan (atanh) magnifies by less than
/// 1 + 2^-90. The sum is made as sum_series makes its, but for runs of coefficients c_k = P / (2k + 1)
/// with P < 2^60 the product of the run's 2k + 1, and it is below 1.1 P throughout a run: a multiplication by
/// z^m, 2 units wrong, loses 2.2 P + 1 and forgets the error from before, the terms lose
/// 2 P, the division loses 1: 6 units at most of the quotient by P, and going on with another P' multiplies
/// both sum and error by it. The factor q < 2^-49 makes nothing of these; the product is cut off.
bool arctangent_of_quotient(number& q, const limb* num, const number& den, long w,
                            bool hyperbolic) {
  double_fraction dividend;
  fraction z;
  limbs<most_limbs + 2> quotient{};
  number remainder;
  mpn_zero(dividend.data(), w);
  mpn_copyi(dividend.data() + w, num, w);
  const long n = den[w] != 0 ? w + 1 : w;
  mpn_tdiv_qr(quotient.data(), remainder.data(), 0, dividend.data(), 2 * w, den.data(), n);
  if (n == w && quotient[w] != 0) return false;
  if ((quotient[w - 1] >> 15) != 0) return false;
  square(z.data(), quotient.data(), w);
  const long terms = (64 * w - 49 + 97) / 98;
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
    on_size(q, w, [&] { mpn_mul_1(q.data(), q.data(), w + 1, product); });
    for (long k = last; k >= first; --k) {
      powers.add(q, k, product / static_cast<limb>(2 * k + 1), !hyperbolic && k % 2 != 0);
      if (k > 0) powers.end_block(q, k);
    }
    on_size(q, w, [&] { mpn_divrem_1(q.data(), 0, q.data(), w + 1, product); });
    last = first - 1;
  }
  multiply_number(q, quotient.data(), w);
  return true;
}

// First values, of one limb. Nothing is claimed of them: a bad one would be found out by the size of its
// correction. They are integers, so that they are the same on every machine.

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

/// log(1 + f), about, for a fraction f of one limb.
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
  return first_logarithms[j] + 2 * (v + high_product(v, tail));
}

/// atan(f), about.
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

/// num = |x - y|; true where x < y.
bool difference(fraction& num, const limb* x, const limb* y, long w) {
  if (mpn_cmp(x, y, w) >= 0) {
    mpn_sub_n(num.data(), x, y, w);
    return false;
  }
  mpn_sub_n(num.data(), y, x, w);
  return true;
}

}  // namespace

// ---------------------------------------------------------------------------------------------

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
/// e^|x| = 2^n V with V = e^t, 1 <= V < 2, is computed as near_exp does, with E units of error and V >= 1. Its inverse,
/// cut off, is then wrong by E + 2 at most, and 2^-2n/V by E + 3. The value is 2^(n-1) times
/// V + 2^-2n/V <= 5/2, or V - 2^-2n/V >= 0: for n = 0 and small t the bits that V and 1/V have in common are lost.
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

bool near_log(mpfr_ptr r, mpfr_srcptr x, magnitude& error) {
  constexpr mpfr_exp_t most_exponent = mpfr_exp_t{1} << 20;
  if (mpfr_regular_p(x) == 0 || mpfr_sgn(x) < 0 || mpfr_get_exp(x) > most_exponent ||
      mpfr_get_exp(x) < -most_exponent || !has_wide_range()) {
    return false;
  }
  // x = (1 + f) 2^e, exactly. Near 1 the logarithm begins as many bits behind the point as x and 1 have
  // in common.
  const mpfr_exp_t e = mpfr_get_exp(x) - 1;
  const auto* significand = static_cast<const limb*>(mpfr_custom_get_significand(x));
  const limb top = significand[(mpfr_get_prec(x) - 1) / 64];
  const long in_common = e == 0 ? std::countl_zero(top << 1) : (e == -1 ? std::countl_one(top) : 0);
  const long w = limbs_for(std::max(mpfr_get_prec(r), mpfr_get_prec(x)), in_common);
  if (w > most_limbs_of_logarithm || in_common > 32) return false;
  number f;
  load(f, x, 1, w);
  f[w] = 0;
  const auto turns = static_cast<limb>(e < 0 ? -e : e);
  // value = log(1 + f), and e log 2 is added.
  const auto finish = [&](number& value, std::uint64_t units) {
    const log_2 log2(w);
    if (e < 0) {
      value[w] -= mpn_submul_1(value.data(), log2.data(), w, turns);
    } else {
      value[w] += mpn_addmul_1(value.data(), log2.data(), w, turns);
    }
    const bool negative = is_negative(value, w);
    if (negative) mpn_neg(value.data(), value.data(), w + 1);
    return store(r, value, w, negative ? -1 : 1, 0, units + turns, error);
  };
  if (is_tabulated(w)) {
    number value;
    const auto units = tabulated_log1p(value.data(), f.data(), w);
    return units && finish(value, *units);
  }
  // log(1 + f) = l + 2 atanh((1 + f - e^l) / (1 + f + e^l)).
  fraction l{};
  l[w - 1] = std::min(first_logarithm(f[w - 1]), first_logarithms[64] - 1);
  fraction m;
  const std::uint64_t units = expm1_of_fraction(m, l.data(), w);
  fraction num;
  const bool below = difference(num, f.data(), m.data(), w);
  number den;
  den[w] = 2 + mpn_add_n(den.data(), f.data(), m.data(), w);
  number correction;
  if (!arctangent_of_quotient(correction, num.data(), den, w, true)) return false;
  // The error of m, through d/dE of (F - E) / (F + E), which is below 2 F / (F + E)^2 <= 1 for E, F >= 1,
  // twice; and that of log 2, |e| units.
  number value{};
  mpn_copyi(value.data(), l.data(), w);
  for (int i = 0; i < 2; ++i) {
    if (below) {
      mpn_sub_n(value.data(), value.data(), correction.data(), w + 1);
    } else {
      mpn_add_n(value.data(), value.data(), correction.data(), w + 1);
    }
  }
  return finish(value, 2 * units + 6);
}

near_pair near_sin_cos(mpfr_ptr sine, mpfr_ptr cosine, mpfr_srcptr x, magnitude& sine_error,
                       magnitude& cosine_error) {
  near_pair found{false, false};
  const mpfr_ptr either = sine != nullptr ? sine : cosine;
  if (mpfr_regular_p(x) == 0 || mpfr_get_exp(x) > range_log2 || mpfr_get_exp(x) < -range_log2 ||
      !has_wide_range()) {
    return found;
  }
  const long small = std::max<long>(-mpfr_get_exp(x), 0);
  // With more limbs the two series by tables take longer than one by halving and a square root.
  constexpr long most_limbs_by_tables = 3;
  long w = limbs_for_tables(mpfr_get_prec(either), small + bits_of_turns(x));
  const bool tabulated = w <= most_limbs_by_tables;
  if (!tabulated) w = limbs_for_halving(mpfr_get_prec(either), 2 * small);
  if (w > most_limbs) return found;
  // |x| = n pi/4 + t, cut off by one unit, with an error of n units.
  number t;
  load(t, x, mpfr_get_exp(x), w);
  const quarter_pi eighth(w);
  const std::uint64_t n = reduce(t, eighth, w);
  // |x| = quarters * pi/2 + t, or - t.
  const std::uint64_t quarters = (n + 1) / 2;
  const bool minus = n % 2 != 0;
  if (minus) mpn_sub_n(t.data(), eighth.data(), t.data(), w);
  number sine_of_t;
  number cosine_of_t;
  fraction v;
  const std::uint64_t first_units =
      tabulated ? tabulated_sin_cos(sine_of_t.data(), cosine_of_t.data(), t.data(), w)
                : versine_of_fraction(v, t.data(), w);
  // By the quadrant: sin, cos, -sin, -cos (of t, or of -t) for the sine of |x|, and one on for the cosine.
  const auto set = [&](mpfr_ptr r, std::uint64_t quadrant, bool negated, magnitude& error) {
    std::uint64_t units = first_units;
    bool negative = negated != (quadrant % 4 >= 2);
    const bool by_sine = quadrant % 2 == 0;
    number& value = by_sine ? sine_of_t : cosine_of_t;
    if (by_sine) {
      if (!tabulated) {
        const long zeros = leading_zeros(t.data(), w);
        if (zeros > range_log2) return false;
        units = sine_from_versine(value.data(), v, first_units, zeros, w);
      }
      value[w] = 0;
      negative = negative != minus;
    } else if (!tabulated) {
      mpn_zero(value.data(), w);
      value[w] = 1 - mpn_sub_n(value.data(), value.data(), v.data(), w);
    }
    return store(r, value, w, negative ? -1 : 1, 0, units + n + 2, error);
  };
  if (sine != nullptr) found.sine = set(sine, quarters, mpfr_sgn(x) < 0, sine_error);
  if (cosine != nullptr) found.cosine = set(cosine, quarters + 1, false, cosine_error);
  return found;
}

bool near_sin(mpfr_ptr r, mpfr_srcptr x, magnitude& error) {
  return near_sin_cos(r, nullptr, x, error, error).sine;
}
bool near_cos(mpfr_ptr r, mpfr_srcptr x, magnitude& error) {
  return near_sin_cos(nullptr, r, x, error, error).cosine;
}

namespace {
/// near_atan by tables: |x| = a/b with b = 1, or a = 2^-e and b = |x| 2^-e in [1/2, 1) for |x| >= 1, where atan |x| = pi/2 - atan(1/|x|).
/// |x| or b may be cut off by less than a unit, which changes the angle by less than one: |d atan(a/b)| <= |da|/b for b = 1, and
/// a/(a^2 + b^2) |db| <= |db|/(2b) <= |db|.
bool tabulated_arctangent(mpfr_ptr r, mpfr_srcptr x, long w, magnitude& error) {
  const mpfr_exp_t e = mpfr_get_exp(x);
  const bool steep = e > 0;
  number size;
  load(size, x, steep ? 0 : e, w);
  number other;
  mpn_zero(other.data(), w + 1);
  if (steep) {
    other[w - 1] = limb{1} << (64 - e);
  } else {
    other[w] = 1;
  }
  number value;
  const auto found = tabulated_atan(value.data(), steep ? other.data() : size.data(),
                                    steep ? size.data() : other.data(), w);
  if (!found) return false;
  std::uint64_t units = *found + 1;
  value[w] = 0;
  if (steep) {
    const quarter_pi eighth(w);
    number half;
    half[w] = mpn_lshift(half.data(), eighth.data(), w, 1);
    mpn_sub_n(value.data(), half.data(), value.data(), w + 1);
    units += 2;
  }
  return store(r, value, w, mpfr_sgn(x), 0, units, error);
}
}  // namespace

bool near_atan(mpfr_ptr r, mpfr_srcptr x, magnitude& error) {
  if (mpfr_regular_p(x) == 0 || mpfr_get_exp(x) > range_log2 || mpfr_get_exp(x) < -range_log2 ||
      !has_wide_range()) {
    return false;
  }
  const mpfr_exp_t e = mpfr_get_exp(x);
  const bool steep = e > 0;  // |x| >= 1: atan |x| = pi/2 - atan(1 / |x|)
  if (const long w = limbs_for(mpfr_get_prec(r), steep ? 0 : -static_cast<long>(e));
      is_tabulated(w)) {
    return tabulated_arctangent(r, x, w, error);
  }
  const long w = limbs_for(mpfr_get_prec(r), steep ? 0 : -2 * static_cast<long>(e));
  if (w > most_limbs) return false;
  // tan(angle) = a / b: a = |x|, b = 1, or a = 2^-e, b = |x| 2^-e in [1/2, 1).
  number size;
  load(size, x, steep ? 0 : e, w);
  const limb top = size[w - 1];
  limb tangent = top;
  if (steep) {
    const uint128 quotient = (uint128{1} << (128 - e)) / top;
    tangent = (quotient >> 64) != 0 ? ~limb{0} : static_cast<limb>(quotient);
  }
  // angle = first + atan((a cos - b sin) / (b cos + a sin)) with the sine and cosine of `first`.
  fraction first{};
  first[w - 1] = first_arctangent(tangent);
  const long zeros = leading_zeros(first.data(), w);
  if (zeros > range_log2 + 1) return false;
  fraction v;
  fraction s;
  const std::uint64_t cosine_units = versine_of_fraction(v, first.data(), w);
  const std::uint64_t sine_units = sine_from_versine(s.data(), v, cosine_units, zeros, w);
  fraction c;
  mpn_neg(c.data(), v.data(), w);  // v > 0
  fraction num;
  fraction product;
  number den;
  bool below = false;
  if (steep) {
    fraction shifted;
    mpn_rshift(shifted.data(), c.data(), w, static_cast<unsigned>(e));
    multiply(product.data(), size.data(), s.data(), w);
    below = difference(num, shifted.data(), product.data(), w);
    mpn_rshift(shifted.data(), s.data(), w, static_cast<unsigned>(e));
    multiply(product.data(), size.data(), c.data(), w);
    den[w] = mpn_add_n(den.data(), shifted.data(), product.data(), w);
  } else {
    multiply(product.data(), size.data(), c.data(), w);
    below = difference(num, product.data(), s.data(), w);
    multiply(product.data(), size.data(), s.data(), w);
    den[w] = mpn_add_n(den.data(), c.data(), product.data(), w);
  }
  number correction;
  if (!arctangent_of_quotient(correction, num.data(), den, w, false)) return false;
  number value{};
  mpn_copyi(value.data(), first.data(), w);
  if (below) {
    mpn_sub_n(value.data(), value.data(), correction.data(), w + 1);
  } else {
    mpn_add_n(value.data(), value.data(), correction.data(), w + 1);
  }
  // Both num and den are wrong by less than both errors and 3 for the products, shifts and |x| cut off;
  // b cos >= 0.35, so that the quotient is by three times that for num, and 2^-49 of it for den.
  std::uint64_t units = 3 * (cosine_units + sine_units + 3) + 3 + 1;
  if (steep) {
    const quarter_pi eighth(w);
    number half{};
    half[w] = mpn_lshift(half.data(), eighth.data(), w, 1);
    mpn_sub_n(value.data(), half.data(), value.data(), w + 1);
    units += 2;
  }
  return store(r, value, w, mpfr_sgn(x), 0, units, error);
}

}  // namespace polhode::detail
