#include "legendre_zeros.hpp"

// How a zero is found and proved. The unit is u = 2^-F, F = 64 limbs_; y_0 = Y/2^64 is the start, s = 4 y_0 (1 - y_0),
// and y = y_0 + s g/n, so that q as a function of g is about as large as its derivatives there.
//   1. q(y_0) and q'(y_0) by Horner's scheme in integers.
//   2. The Taylor coefficients of q in g, from Legendre's differential equation: e_0, e_1, ... e_K. T is their
//      polynomial; what it leaves out of q and q' is bounded by legendre_taylor_remainder.
//   3. A search: Newton's method for a zero of T, g, in so many limbs as are known at each step.
//   4. The proof, in integers: T(g) is so small, and |T'| around g so large, that q changes its sign between g - r and
//      g + r. That there is only one zero need not be shown: the sets of a rule are disjoint and as many as q has zeros.
// Numbers have a sign, a limb before the point and some behind it. Every product, quotient and shift of the sizes is
// cut off, which loses less than a unit of its last place; so that errors are counted, not estimated:
//
// Horner. b_j = C_j + floor(b_(j+1) y_0) and s_j = b_(j+1) + floor(s_(j+1) y_0), where C_j, the coefficient of y^j in
// units, was rounded downward; b_0 is q(y_0), s_0 is q'(y_0), in units. A step of the first commits an error between -2 and 0
// and multiplies the one before by y_0 < 1: b_j is off by at most 2(m-j+1), m being q's degree. A step of the second
// commits one between -1 and 0, and takes over that of b_(j+1): s_0 is off by at most the sum of 2(m-i+1) + 1, i = 1 ... m,
// m(m+2). Both have room: |b_j|, |s_j| are at most 2^(64 size - 3) + m(m+2), below 2^(64 size - 1).
//
// Taylor coefficients. From (1 - x^2) P'' - 2x P' + n(n+1) P = 0,
//   4y(1-y) q'' + (2 + 4e - (6 + 4e) y) q' + (n(n+1) - 2e) q = 0,   e = 0 or 1 as n is even or odd,
// and for q = sum of c_k (y - y_0)^k, e_k = c_k (s/n)^k, that is
//   n^2 (k+1)(k+2) e_(k+2) = -n A_k e_(k+1) - s B_k e_k,
//   A_k = (k+1) (4 (1 - 2 y_0) k + 2 + 4e - (6 + 4e) y_0),   |A_k| <= (k+1)(4k+6),
//   B_k = n(n+1) - 2e - 4k(k-1) - (6 + 4e) k,                0 < B_k <= n(n+1) where k + 2 <= n/2,
// as s <= 1. (A_k is linear in y_0, between 4k + 2 + 4e and -4k - 4. B_k >= n + n^2 - (4k^2 + 6k + 2), and that is at most
// (n-4)^2 + 3(n-4) + 2 < n^2.) 2^64 A_k and 2^126 s are integers, so that the two products are off by what the
// coefficients are off by and by less than a unit each, and the quotient by less than another one. For the bounds E_k of what e_k is off
// by, in units, that is E_(k+2) <= (4k+6)/((k+2) n) E_(k+1) + (n+1)/(n (k+1)(k+2)) E_k + 3, where n >= 2k + 4: the two factors are at most
// 3/4 and 5/8 for k = 0, and together at most 3/4 for k > 0. So E_k <= max(1.4 max(E_0, E_1) + 3, 12), which is below 2^12 for n <= 1024.
//
// How generous that is. E_0 and E_1 leave out that a step's error is multiplied by y_0 in all steps after it, that no coefficient is
// rounded where n <= F, and that the first product of each is 0. Counted so, b_0 and s_0 are off by at most e and d: with c = 1 where
// n <= F and 2 elsewhere, b_m is by c - 1, b_j by y_0 times that of b_(j+1) and c, s_m by 0, s_(m-1) by that of b_m, and s_j by y_0 times
// that of s_(j+1), that of b_(j+1) and 1. And `proved` has something to spare beside them:
//   In units of y: T(g) is off by less than e + 1.02, and what T leaves out is at most 1, where without E_0 4 would be counted; s g/n is
//   cut off by less than 1 + 1/n, where 2 are counted. So E_0 is not missed where (e - 1.98) / |q'| <= 1 - 1/n.
//   In units of T': e_1 is off by d s/n + 1 + 1/n, and T'(g) by 1.02 more, where 3 would be counted; but the count for |T''| r has
//   (E_0 + 1.98 - e) |A_0|/n to spare, as r contains E_0 for e, and |2 e_2/e_1| is |A_0|/n within 2^-30.
// Both suffice at the zeros of all q, n <= 1024 (LegendreZeros.HideTheErrorsOfHornersScheme): no zero and no start comes near E_0 and E_1.
// They stay, as the sharper ones would need y_0 in every count; the tests reach the radius where the search ends early, and the three
// units of y where it ends at the last bit.

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <utility>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/quadrature/gauss_legendre.hpp"

namespace polhode::detail {
namespace {

static_assert(GMP_NUMB_BITS == 64, "limbs of 64 bits without nails");

using limb = mp_limb_t;
__extension__ using uint128 = unsigned __int128;

constexpr long most_limbs = few_limbed_zeros::most_bits / 64;
constexpr long greatest_order = few_limbed_zeros::greatest_order;
// |g| < 2^-least_gap, |e_k| < 2^6: what the counts of errors below rest on.
constexpr long least_gap = 32;
constexpr limb least_too_large = 64;

/// A number with w limbs behind the point and one before it, the least significant first.
struct number {
  limb limbs[most_limbs + 1];
  bool is_negative = false;
};

/// Limbs of {x, n} without zeros at the top.
long used(const limb* x, long n) {
  while (n > 0 && x[n - 1] == 0) --n;
  return n;
}

/// From the two highest limbs that are not 0.
double to_double(const number& x, long w) {
  const long n = used(x.limbs, w + 1);
  if (n == 0) return 0;
  const auto high = static_cast<double>(x.limbs[n - 1]);
  const double low = n > 1 ? static_cast<double>(x.limbs[n - 2]) : 0;
  const double size = std::ldexp(high + low * 0x1p-64, static_cast<int>(64 * (n - 1 - w)));
  return x.is_negative ? -size : size;
}

/// {x, n} += or -= {y, n} as their signs are; sums have room.
void add_to(limb* x, bool& x_is_negative, const limb* y, bool y_is_negative, long n) {
  if (x_is_negative == y_is_negative) {
    mpn_add_n(x, x, y, n);
  } else if (mpn_cmp(x, y, n) >= 0) {
    mpn_sub_n(x, x, y, n);
  } else {
    mpn_sub_n(x, y, x, n);
    x_is_negative = y_is_negative;
  }
}

/// {result + 1, size} = floor({x, size} y / 2^64) + {c, size}, all of them in two's complement.
void multiply_and_add(limb* result, const limb* x, limb y, const limb* c, long size) {
  result[0] = 0;
  mpn_copyi(result + 1, c, size);
  result[size] += mpn_addmul_1(result, x, size, y);
  // As an unsigned number a negative x is 2^(64 size) too large.
  if ((x[size - 1] >> 63) != 0) result[size] -= y;
}

/// A two's complement with `size` limbs, as a number with w limbs behind the point; false where it is too large for one.
bool take(number& result, limb* x, long size, long w) {
  result.is_negative = (x[size - 1] >> 63) != 0;
  if (result.is_negative) mpn_neg(x, x, size);
  const long have = std::min(size, w + 1);
  if (used(x, size) > have) return false;
  mpn_zero(result.limbs, w + 1);
  mpn_copyi(result.limbs, x, have);
  return true;
}

}  // namespace

/// P_n(x) = 2^-n sum of (-1)^k a_k x^(n-2k), a_k = C(n, k) C(2n - 2k, n): integers with
/// a_(k+1) / a_k = (n - 2k)(n - 2k - 1) / (2 (k + 1)(2n - 2k - 1)).
legendre_coefficients::legendre_coefficients(const legendre_shape& s, precision bits)
    : fraction_bits(bits) {
  const auto n = static_cast<unsigned long>(s.n);
  std::vector<integer> all;
  all.reserve(static_cast<std::size_t>(s.degree) + 1);
  integer a;
  const mpz_ptr z = a.backend().data();
  mpz_bin_uiui(z, 2 * n, n);
  integer sum = 0;
  for (unsigned long k = 0; 2 * k <= n; ++k) {
    const auto power = static_cast<unsigned long>(s.degree) - k;
    mpz_addmul_ui(sum.backend().data(), z, std::max(power, 1UL));
    all.push_back(a);
    if (2 * k + 1 >= n) break;
    mpz_mul_ui(z, z, (n - 2 * k) * (n - 2 * k - 1));
    mpz_divexact_ui(z, z, 2 * (k + 1) * (2 * n - 2 * k - 1));
  }
  // sum / 2^n bounds both sums of coefficients; it is at least |P_n(i)| >= 1, or 2^-1 for n = 1.
  const auto bits_of_sum = static_cast<long>(mpz_sizeinbase(sum.backend().data(), 2)) - s.n;
  size = (std::max(bits_of_sum, 1L) + 3 + fraction_bits) / GMP_NUMB_BITS + 1;
  limbs.resize(all.size() * static_cast<std::size_t>(size), 0);
  const long shift = fraction_bits - s.n;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const mpz_ptr scaled = all[k].backend().data();
    if (k % 2 != 0) mpz_neg(scaled, scaled);
    if (shift >= 0) {
      mpz_mul_2exp(scaled, scaled, static_cast<mp_bitcnt_t>(shift));
    } else {
      mpz_fdiv_q_2exp(scaled, scaled, static_cast<mp_bitcnt_t>(-shift));
    }
    mp_limb_t* const target = limbs.data() + k * static_cast<std::size_t>(size);
    mpn_copyi(target, mpz_limbs_read(scaled), static_cast<mp_size_t>(mpz_size(scaled)));
    if (mpz_sgn(scaled) < 0) mpn_neg(target, target, size);
  }
}

namespace {

/// What is about one start.
class neighbourhood {
 public:
  neighbourhood(const legendre_shape& s, const std::vector<std::uint64_t>& errors, long limbs,
                std::uint64_t start)
      : shape_(s), errors_(errors), w_(limbs), start_(start) {
    const uint128 product = uint128{start} * (limb{0} - start);  // 2^126 s
    s_[0] = static_cast<limb>(product);
    s_[1] = static_cast<limb>(product >> 64);
  }

  bool values(const legendre_coefficients& polynomial);
  bool terms(const std::vector<double>& log2_terms);
  bool search(long wanted);
  std::optional<legendre_zero> proved();

 private:
  void multiply_by_s(limb* r, const limb* x, long size, limb factor) const;
  template <bool derivative>
  number evaluate(long w, long last) const;
  void correct(long w, long w_of_slope);
  [[nodiscard]] long last_for(long bits) const;

  const legendre_shape& shape_;
  const std::vector<std::uint64_t>& errors_;
  const long w_;
  const std::uint64_t start_;
  limb s_[2] = {};
  number e_[greatest_order + 1];
  long last_ = 0;  // K
  number g_;       // its limb before the point is 0
  long gap_ = 0;   // |g| < 2^-gap
};

/// {r, size} = floor({x, size} s factor), where that has as many limbs and factor < 2^32.
void neighbourhood::multiply_by_s(limb* r, const limb* x, long size, limb factor) const {
  limb product[most_limbs + 4];
  mpn_mul(product, x, size, s_, 2);
  // s is s_ / 2^126: by four times as much, and two limbs down.
  mpn_mul_1(product, product, size + 2, 4 * factor);
  mpn_copyi(r, product + 2, size);
}

/// e_0 and e_1.
bool neighbourhood::values(const legendre_coefficients& polynomial) {
  constexpr long most = most_limbs + few_limbed_zeros::greatest_n * 2 / 64 + 2;
  const long size = polynomial.size;
  if (size > most) return false;
  // Each with a limb below it, which a product's lowest one goes to.
  limb rooms[4][most + 1];
  limb* value = rooms[0];
  limb* slope = rooms[1];
  limb* next_value = rooms[2];
  limb* next_slope = rooms[3];
  const limb* coefficient = polynomial.limbs.data();
  mpn_copyi(value + 1, coefficient, size);
  mpn_zero(slope + 1, size);
  for (long j = 0; j < shape_.degree; ++j) {
    coefficient += size;
    multiply_and_add(next_slope, slope + 1, start_, value + 1, size);
    multiply_and_add(next_value, value + 1, start_, coefficient, size);
    std::swap(slope, next_slope);
    std::swap(value, next_value);
  }
  if (!take(e_[0], value + 1, size, w_)) return false;
  number derivative;
  // It may be of the size of n^2, which a limb before the point holds.
  if (!take(derivative, slope + 1, size, w_)) return false;
  multiply_by_s(e_[1].limbs, derivative.limbs, w_ + 1, 1);
  mpn_divrem_1(e_[1].limbs, 0, e_[1].limbs, w_ + 1, static_cast<limb>(shape_.n));
  e_[1].is_negative = derivative.is_negative;
  return e_[0].limbs[w_] < least_too_large && e_[1].limbs[w_] < least_too_large;
}

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

/// Of the terms beyond it what they add at g, and at T', is below 2^-bits.
long neighbourhood::last_for(long bits) const {
  return std::clamp((bits + 10) / gap_ + 1, 1L, last_);
}

/// T(g) or T'(g) from the terms up to `last`, and w limbs behind the point, the first ones of g and of the terms.
///
/// Let v = 2^(-64 w). In Horner's scheme h_k = e_k + g h_(k+1), or h_k = k e_k + g h_(k+1), down to h_0 or h_1. As
/// |e_k| < 64, k <= 40 and |g| < 2^-32, |h_k| < 2^12. h_k has so many limbs behind the point, at least w_k, that
/// 2^(-64 w_k) |g|^j <= 2^-24 v, j being the powers of g that it will be multiplied by, and w for j = 0; g is cut off after as
/// many. The step commits at most k units 2^(-64 w_k) for e_k, one for the product, and |h_(k+1)| for g; but none for
/// e_k and g, j = 0, if w is w_. All that, with j > 0, is at most 2^13 2^-24 v in the result, so 40 such steps count less than v,
/// and the last step's product less than v. What the e_k, j > 0, themselves are off by, k E_k u with E_k <= 2^12,
/// multiplied by |g|^j, is in all less than u. So T(g) is off by less than E_0 + 3 units, and T'(g) by less than E_1 + 3,
/// where w is w_ and `last` is K.
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
  // The error of g is below 2^-known. That after a step of Newton's method is 2^bend times its square.
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

/// Let v be a bound of |T(g)| and of what T leaves out of q, in units, and r u a radius. |T''| <= M = 2 |e_2| + 2^-22 on [g - r u,
/// g + r u], as the other terms add at most 64 (6 * 2^-31 + 12 * 2^-62 + ...); so |T'| >= t = |T'(g)| - r u M there, and where r t >= v,
/// q is of other signs, or 0, at g - r u and g + r u.
///
/// t: with r < 2^48 and F >= 128, r u M < 2^-72, as is what T'(g) is off by; they are less than one unit of 2^-64.
/// y is off by s r/n units, and by less than two for a product and a quotient that are cut off. T' is off by M r units, and by what
/// T'(g) is. That is true for each zero between g - r u and g + r u; the zero's slope is s q'(y) = n T' and what T leaves out of q', times s <= 1.
/// |y - y_0| <= s (|g| + r u)/n, as |g| + r u is less than its first limb and two units of 2^-64.
std::optional<legendre_zero> neighbourhood::proved() {
  const number value = evaluate<false>(w_, last_);
  const number slope = evaluate<true>(w_, last_);
  // The greatest |y - y_0|.
  const auto n = static_cast<std::uint64_t>(shape_.n);
  const magnitude unit = magnitude::power_of_two(-64 * w_);
  const magnitude s = magnitude::from_bits_up(s_[1] + 1, -62);
  const magnitude size_of_g = magnitude::from_bits_up(g_.limbs[w_ - 1] + 2, -64);
  magnitude left_out_of_slope;
  if (last_ < shape_.degree) {
    const magnitude reach = divide_up(multiply_up(s, size_of_g), magnitude::from_integer_down(n));
    const taylor_remainder remainder = legendre_taylor_remainder(shape_.n, last_ + 1, reach);
    if (remainder.of_value > unit) return std::nullopt;
    left_out_of_slope = remainder.of_slope;
  }
  if (used(value.limbs, w_ + 1) > 1 || (value.limbs[0] >> 60) != 0) return std::nullopt;
  const std::uint64_t bound = value.limbs[0] + errors_[0] + 3 + 1;
  const limb least_slope =
      slope.limbs[w_] != 0 ? ~limb{0} : std::max(slope.limbs[w_ - 1], limb{1}) - 1;
  if (least_slope == 0) return std::nullopt;
  const uint128 radius = (uint128{bound} << 64) / least_slope + 1;
  if (radius >> 48 != 0) return std::nullopt;

  // s g / n
  const long size = w_ + 1;
  number y;
  multiply_by_s(y.limbs, g_.limbs, size, 1);
  mpn_divrem_1(y.limbs, 0, y.limbs, size, n);
  y.is_negative = g_.is_negative;
  limb centre[most_limbs + 1];
  mpn_zero(centre, size);
  centre[w_ - 1] = start_;
  add_to(y.limbs, y.is_negative, centre, false, size);
  const auto to_ball = [&](const number& x, const magnitude& error) {
    mpz_t z;
    const long length = used(x.limbs, size);
    const ball units(mpz_roinit_n(z, x.limbs, x.is_negative ? -length : length), 64 * w_);
    return scale(units, -64 * w_).enlarged(error);
  };
  const auto in_units = [&](std::uint64_t count) {
    return scale(magnitude::from_integer_up(count), -64 * w_);
  };
  const auto error_of_square = static_cast<std::uint64_t>((radius * (s_[1] + 1)) >> 62) / n + 3;
  uint128 bend = uint128{1} << 42;  // M in units of 2^-64
  if (last_ >= 2) bend += (uint128{e_[2].limbs[w_]} << 65) + 2 * (uint128{e_[2].limbs[w_ - 1]} + 1);
  const auto error_by_bend = static_cast<std::uint64_t>((radius * bend) >> 64) + 1;
  mpz_t z;
  return legendre_zero{to_ball(y, in_units(error_of_square)),
                       shape_.n * to_ball(slope, add_up(in_units(errors_[1] + 3 + error_by_bend),
                                                        left_out_of_slope)),
                       scale(ball(mpz_roinit_n(z, s_, 2), 128), -126)};
}

}  // namespace

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
  neighbourhood around(shape_, errors_, limbs_, start);
  if (!around.values(polynomial_) || !around.terms(log2_terms_) ||
      !around.search(std::max(bits_, 64 * limbs_ - 40))) {
    return std::nullopt;
  }
  return around.proved();
}

}  // namespace polhode::detail
