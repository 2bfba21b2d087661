#include "tabulated_functions.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <tuple>
#include <type_traits>

namespace polhode::detail {
namespace {

using limb = mp_limb_t;
static_assert(GMP_NUMB_BITS == 64, "polhode: limbs of 64 bits are assumed");
__extension__ using uint128 = unsigned __int128;
__extension__ using int128 = __int128;

// --------------------------------------------------------------------------------------------- The
// tables, made at build time (make_function_tables.cpp). Entries are cut off: what is read of one
// is less than a unit too small.

struct entry {
  std::array<limb, most_tabulated_limbs> limbs;
  /// The first w limbs behind the point.
  [[nodiscard]] constexpr const limb* at(long w) const {
    return limbs.data() + (most_tabulated_limbs - w);
  }
};
template <std::size_t size>
using table = std::array<entry, size>;

#include "function_tables.hpp"

// ---------------------------------------------------------------------------------------------
// Arithmetic at a number of limbs that the compiler knows. A product is cut off: it is less than a
// unit too small.

template <std::size_t w>
void multiply(limb* r, const limb* x, const limb* y) {
  std::array<limb, 2 * w> product;
  if constexpr (w == 1) {
    product[1] = static_cast<limb>((uint128{x[0]} * y[0]) >> 64);
  } else if constexpr (w <= 4) {
    limb carry = 0;
#pragma GCC unroll 8
    for (std::size_t k = 0; k < w; ++k) {
      const uint128 sum = uint128{x[0]} * y[k] + carry;
      product[k] = static_cast<limb>(sum);
      carry = static_cast<limb>(sum >> 64);
    }
    product[w] = carry;
#pragma GCC unroll 8
    for (std::size_t i = 1; i < w; ++i) {
      carry = 0;
#pragma GCC unroll 8
      for (std::size_t k = 0; k < w; ++k) {
        const uint128 sum = uint128{x[i]} * y[k] + product[i + k] + carry;
        product[i + k] = static_cast<limb>(sum);
        carry = static_cast<limb>(sum >> 64);
      }
      product[i + w] = carry;
    }
  } else if (x == y) {
    mpn_sqr(product.data(), x, w);
  } else {
    mpn_mul_n(product.data(), x, y, w);
  }
  std::copy_n(product.data() + w, w, r);
}
/// The same where a few units do not matter: for 2 <= w <= 4 without the products x[i] y[k] with i
/// + k < w - 1, which reach the result by carries alone. The w - 1 of them with i + k = w - 2 are
/// at most (1 - 2^-64)^2 units each, the others together less than (w - 1) 2^-64, so that all are
/// below w - 1: the result is less than w units too small.
template <std::size_t w>
void multiply_roughly(limb* r, const limb* x, const limb* y) {
  if constexpr (w < 2 || w > 4) {
    multiply<w>(r, x, y);
  } else {
    std::array<limb, w + 1> product;  // from its limb w - 1 on
    const uint128 first = uint128{x[0]} * y[w - 1];
    product[0] = static_cast<limb>(first);
    product[1] = static_cast<limb>(first >> 64);
#pragma GCC unroll 8
    for (std::size_t i = 1; i < w; ++i) {
      limb carry = 0;
#pragma GCC unroll 8
      for (std::size_t k = 0; k <= i; ++k) {
        const uint128 sum = uint128{x[i]} * y[w - 1 - i + k] + product[k] + carry;
        product[k] = static_cast<limb>(sum);
        carry = static_cast<limb>(sum >> 64);
      }
      product[i + 1] = carry;
    }
    std::copy_n(product.data() + 1, w, r);
  }
}
/// r = x + y; returns the carry.
template <std::size_t w>
limb add(limb* r, const limb* x, const limb* y) {
  limb carry = 0;
#pragma GCC unroll 8
  for (std::size_t i = 0; i < w; ++i) {
    const uint128 sum = uint128{x[i]} + y[i] + carry;
    r[i] = static_cast<limb>(sum);
    carry = static_cast<limb>(sum >> 64);
  }
  return carry;
}
/// r = x - y; returns the borrow.
template <std::size_t w>
limb subtract(limb* r, const limb* x, const limb* y) {
  limb borrow = 0;
#pragma GCC unroll 8
  for (std::size_t i = 0; i < w; ++i) {
    const uint128 rest = uint128{x[i]} - y[i] - borrow;
    r[i] = static_cast<limb>(rest);
    borrow = static_cast<limb>(rest >> 64) & 1;
  }
  return borrow;
}

// --------------------------------------------------------------------------------------------- The
// series P(z) = c_0 + c_1 z + c_2 z^2 + ..., or with alternating signs, for 0 <= z < 2^-bits and
// positive decreasing coefficients c_0 <= 1/2.

using coefficients = decltype(inverse_numbers);

/// (e^r - 1 - r)/r^2.
struct exponential {
  static constexpr const coefficients& c = inverse_factorials;
  static constexpr std::size_t bits = 14;
  static constexpr bool alternating = false;
};
/// (1 - cos r)/r^2 and (r - sin r)/r^3 for z = r^2.
struct versine {
  static constexpr const coefficients& c = inverse_even_factorials;
  static constexpr std::size_t bits = 14;
  static constexpr bool alternating = true;
};
struct sine_defect {
  static constexpr const coefficients& c = inverse_odd_factorials;
  static constexpr std::size_t bits = 14;
  static constexpr bool alternating = true;
};
/// (h - log(1 + h))/h^2 and (-log(1 - h) - h)/h^2.
struct logarithm_above {
  static constexpr const coefficients& c = inverse_numbers;
  static constexpr std::size_t bits = 13;
  static constexpr bool alternating = true;
};
struct logarithm_below {
  static constexpr const coefficients& c = inverse_numbers;
  static constexpr std::size_t bits = 13;
  static constexpr bool alternating = false;
};
/// (y - atan y)/y^3 for z = y^2.
struct arctangent_defect {
  static constexpr const coefficients& c = inverse_odd_numbers;
  static constexpr std::size_t bits = 26;
  static constexpr bool alternating = true;
};

/// The least count n of terms with c_n z^n <= 2^(-64 w - 1): what is left out is at most 2 c_n z^n,
/// a unit.
template <class series, std::size_t w>
constexpr std::size_t terms = [] {
  for (std::size_t n = 0;; ++n) {
    std::size_t zeros = 0;  // c_n < 2^-zeros
    for (std::size_t i = most_tabulated_limbs; i-- > 0;) {
      const limb part = series::c.at(n).limbs[i];  // no constant beyond the last coefficient
      zeros += static_cast<std::size_t>(std::countl_zero(part));
      if (part != 0) break;
    }
    if (series::bits * n + zeros > 64 * w) return n;
  }
}();

/// The limbs with which the sum from term k on is computed: as it is multiplied by z^k, the last
/// ones do not matter.
template <class series, std::size_t w>
constexpr std::size_t limbs_from(std::size_t k) {
  constexpr std::size_t guard = 10;
  const std::size_t below = series::bits * (k - std::min<std::size_t>(k, 1));
  return w - (below - std::min(below, guard)) / 64;
}

/// P(z) by Horner's rule, in sum: c_k + c_(k+1) z + ... in the first limbs_from(k) limbs.
///
/// The error of P, in units. A step commits up to five errors of 2^(-64 v), v = limbs_from(k + 1):
/// z is cut off (the sum is below 1), and the product is less than four units too small; and its
/// coefficient is wrong by less than 2^(-64 limbs_from(k)). They are multiplied by z^k < 2^(-bits
/// k). Where limbs are dropped, 64 (w - v) <= bits k - 10 makes each of them at most 2^-10 units;
/// elsewhere they are at most 2^(-bits k). So all steps together commit less than 6 (1 + 2^-12 + 44
/// * 2^-10) < 6.3, and with what is left out P is wrong by less than 8 units.
template <class series, std::size_t w, std::size_t k = 0>
void evaluate(limb* sum, const limb* z) {
  constexpr std::size_t here = limbs_from<series, w>(k);
  static_assert(here >= 1);
  const limb* c = series::c[k].at(here);
  if constexpr (k + 1 == terms<series, w>) {
    std::copy_n(c, here, sum + w - here);
  } else {
    constexpr std::size_t next = limbs_from<series, w>(k + 1);
    evaluate<series, w, k + 1>(sum, z);
    multiply_roughly<next>(sum + w - next, sum + w - next, z + w - next);
    if constexpr (here > next) sum[w - here] = 0;
    if constexpr (series::alternating) {
      subtract<here>(sum + w - here, c, sum + w - here);
    } else {
      add<here>(sum + w - here, sum + w - here, c);
    }
  }
}

// ---------------------------------------------------------------------------------------------
// The functions. P's error of 8 units, multiplied by r^2 < 2^-14 or less, is below 2^-10 units.

/// t = j/128 + i/16384 + r: e^t - 1 = x + m + x m for m = e^r - 1 and x = a + b + a b of two
/// entries a, b. Errors: r^2 P is cut off twice, m is wrong by less than 3; x by less than (1 + b)
/// + (1 + a) + 1 < 5; the sum by less than 5 (1 + m) + 3 (1 + x) + 1 < 13. All of x, m and the
/// products are below their true values, so that the sum is below e^t - 1 < 1.
template <std::size_t w>
std::uint64_t expm1_at(limb* m, const limb* t) {
  const limb top = t[w - 1];
  const limb* a = coarse_expm1[top >> 57].at(w);
  const limb* b = fine_expm1[(top >> 50) & 127].at(w);
  std::array<limb, w> r;
  std::copy_n(t, w, r.data());
  r[w - 1] = top << 14 >> 14;
  std::array<limb, w> p;
  std::array<limb, w> square;
  evaluate<exponential, w>(p.data(), r.data());
  multiply<w>(square.data(), r.data(), r.data());
  multiply<w>(p.data(), p.data(), square.data());
  add<w>(r.data(), r.data(), p.data());
  std::array<limb, w> x;
  multiply<w>(x.data(), a, b);
  add<w>(x.data(), x.data(), a);
  add<w>(x.data(), x.data(), b);
  multiply<w>(m, x.data(), r.data());
  add<w>(m, m, x.data());
  add<w>(m, m, r.data());
  return 13;
}

/// t = j/128 + r. With v = 1 - cos r and q = r - sin r:
///     sin t = S + C (r - q) - S v,  cos t = C - S (r - q) - C v.
/// Errors: z = r^2 is cut off, v is wrong by less than 1 + 1 + 2^-10, q = r z P by 1 + 1 + 2^-10.
/// With 1 for S and C each of the two is wrong by less than 1 + (r + 2.1 + 1) + (v + 2.1 + 1) < 8.
template <std::size_t w>
std::uint64_t sin_cos_at(limb* s, limb* c, const limb* t) {
  const limb top = t[w - 1];
  const std::size_t j = top >> 57;
  std::array<limb, w> r;
  std::copy_n(t, w, r.data());
  r[w - 1] = top << 7 >> 7;
  std::array<limb, w> z;
  std::array<limb, w> v;
  std::array<limb, w> q;
  multiply<w>(z.data(), r.data(), r.data());
  evaluate<versine, w>(v.data(), z.data());
  multiply<w>(v.data(), v.data(), z.data());
  evaluate<sine_defect, w>(q.data(), z.data());
  multiply<w>(q.data(), q.data(), z.data());
  multiply<w>(q.data(), q.data(), r.data());
  subtract<w>(r.data(), r.data(), q.data());
  if (j == 0) {
    std::copy_n(r.data(), w, s);
    std::fill_n(c, w, 0);
    c[w] = 1 - subtract<w>(c, c, v.data());
    return 8;
  }
  const limb* sine = sines[j].at(w);
  const limb* cosine = cosines[j].at(w);
  std::array<limb, w> product;
  multiply<w>(product.data(), cosine, r.data());
  add<w>(s, sine, product.data());
  multiply<w>(product.data(), sine, v.data());
  subtract<w>(s, s, product.data());
  multiply<w>(product.data(), sine, r.data());
  subtract<w>(c, cosine, product.data());
  multiply<w>(product.data(), cosine, v.data());
  subtract<w>(c, c, product.data());
  c[w] = 0;
  return 8;
}

/// The whole number k for which (1 + f) k/256 is near 1, for f from j/128 to (j + 1)/128.
constexpr std::array<limb, 128> inverses = [] {
  std::array<limb, 128> result{};
  for (limb j = 0; j < 128; ++j) result[j] = ((limb{1} << 17) / (257 + 2 * j) + 1) / 2;
  return result;
}();

/// (1 + f) (k/256) (1 - i/16384) = 1 + g: log(1 + f) = log(256/k) - log(1 - i/16384) + log(1 + g),
/// where 2^22 g is computed exactly.
/// |g| < 2^-13 is looked at, whatever k and i are. Errors: 1 for either entry, 1 for g cut off,
/// which the logarithm magnifies by less than 1 + 2^-12; g^2 P is cut off twice: less than 6.
template <std::size_t w>
std::optional<std::uint64_t> log1p_at(limb* l, const limb* f) {
  const limb k = inverses[f[w - 1] >> 57];
  // 2^72 ((1 + f) k/256 - 1), nearly; i = 16384 of this.
  const int128 first = (int128{1} << 64 | f[w - 1]) * static_cast<int128>(k) - (int128{256} << 64);
  const auto i = static_cast<std::int64_t>((first + (int128{1} << 57)) >> 58);
  if (i < -128 || i > 128) return std::nullopt;
  const limb factor = k * static_cast<limb>(16384 - i);
  std::array<limb, w + 1> g;
  g[w] = factor + mpn_mul_1(g.data(), f, w, factor) - (limb{1} << 22);
  const bool below = (g[w] >> 63) != 0;
  if (below) mpn_neg(g.data(), g.data(), w + 1);
  if ((g[w] >> 9) != 0) return std::nullopt;
  for (std::size_t n = 0; n < w; ++n) g[n] = (g[n] >> 22) | (g[n + 1] << 42);
  std::array<limb, w> p;
  std::array<limb, w> square;
  multiply<w>(square.data(), g.data(), g.data());
  const limb* coarse = coarse_logarithms[256 - k].at(w);
  const limb* fine = (i < 0 ? logarithms_above[static_cast<std::size_t>(-i)]
                            : logarithms_below[static_cast<std::size_t>(i)])
                         .at(w);
  std::copy_n(coarse, w, l);
  l[w] = 0;
  if (i < 0) {
    l[w] -= subtract<w>(l, l, fine);
  } else {
    l[w] += add<w>(l, l, fine);
  }
  if (below) {
    evaluate<logarithm_below, w>(p.data(), g.data());
    multiply<w>(p.data(), p.data(), square.data());
    l[w] -= subtract<w>(l, l, g.data());
  } else {
    evaluate<logarithm_above, w>(p.data(), g.data());
    multiply<w>(p.data(), p.data(), square.data());
    l[w] += add<w>(l, l, g.data());
  }
  l[w] -= subtract<w>(l, l, p.data());
  return 6;
}

/// a/b = tan(first + second + rest) with tan first = j/128 and tan second = i/16384. With
///     p = 2^21 (1 - i j/2^21),  q = 2^21 (j/128 + i/16384),  tan rest = (a p - b q)/(b p + a q),
/// numerator and denominator being computed exactly. |tan rest| < 2^-13 is looked at, whatever j
/// and i are. Errors: 1 for the quotient cut off, y z P is cut off twice, z once, which does not
/// matter; 1 for either entry: less than 6.
template <std::size_t w>
std::optional<std::uint64_t> atan_at(limb* t, const limb* a, const limb* b) {
  // a/b and i, nearly.
  const limb tangent = b[w] != 0 || a[w - 1] >= b[w - 1]
                           ? (b[w] != 0 && a[w] == 0 ? a[w - 1] : ~limb{0})
                           : static_cast<limb>((uint128{a[w - 1]} << 64) / b[w - 1]);
  const limb j = (tangent >> 57) + ((tangent >> 56) & 1);
  const std::int64_t rest =
      static_cast<std::int64_t>(tangent >> 32) - static_cast<std::int64_t>(j << 25);
  const auto norm = static_cast<std::int64_t>((limb{1} << 32) + ((tangent >> 32) * j >> 7));
  const std::int64_t i =
      std::clamp<std::int64_t>(((rest << 15) + (rest < 0 ? -norm : norm)) / (2 * norm), -64, 64);
  const limb p = (limb{1} << 21) - static_cast<limb>(i) * j;
  const limb q = (j << 14) + (static_cast<limb>(i) << 7);
  if ((q >> 63) != 0) return std::nullopt;
  std::array<limb, 2 * w + 1> dividend{};
  limb* const numerator = dividend.data() + w;
  std::array<limb, w + 1> denominator;
  mpn_mul_1(numerator, a, w + 1, p);
  mpn_submul_1(numerator, b, w + 1, q);
  const bool below = (numerator[w] >> 63) != 0;
  if (below) mpn_neg(numerator, numerator, w + 1);
  mpn_mul_1(denominator.data(), b, w + 1, p);
  mpn_addmul_1(denominator.data(), a, w + 1, q);
  std::array<limb, w + 1> y;
  std::array<limb, w + 1> remainder;
  mpn_tdiv_qr(y.data(), remainder.data(), 0, dividend.data(), 2 * w + 1, denominator.data(), w + 1);
  if (y[w] != 0 || (y[w - 1] >> 51) != 0) return std::nullopt;
  std::array<limb, w> z;
  std::array<limb, w> sum;
  multiply<w>(z.data(), y.data(), y.data());
  evaluate<arctangent_defect, w>(sum.data(), z.data());
  multiply<w>(sum.data(), sum.data(), z.data());
  multiply<w>(sum.data(), sum.data(), y.data());
  subtract<w>(y.data(), y.data(), sum.data());
  const limb* fine = fine_arctangents[static_cast<std::size_t>(i < 0 ? -i : i)].at(w);
  std::copy_n(coarse_arctangents[j].at(w), w, t);
  if (i < 0) {
    subtract<w>(t, t, fine);
  } else {
    add<w>(t, t, fine);
  }
  if (below) {
    subtract<w>(t, t, y.data());
  } else {
    add<w>(t, t, y.data());
  }
  return 6;
}

/// f with the number of limbs as a constant.
template <class F>
auto at_limbs(long w, F&& f) {
  switch (w) {
    case 2:
      return f(std::integral_constant<std::size_t, 2>());
    case 3:
      return f(std::integral_constant<std::size_t, 3>());
    case 4:
      return f(std::integral_constant<std::size_t, 4>());
    case 5:
      return f(std::integral_constant<std::size_t, 5>());
    case 6:
      return f(std::integral_constant<std::size_t, 6>());
    case 7:
      return f(std::integral_constant<std::size_t, 7>());
    default:
      return f(std::integral_constant<std::size_t, 8>());
  }
}

constexpr entry quarter_pi = coarse_arctangents[128];
constexpr entry log_2 = coarse_logarithms[128];

}  // namespace

const limb* tabulated_log_2(long w) { return log_2.at(w); }
const limb* tabulated_quarter_pi(long w) { return quarter_pi.at(w); }

std::uint64_t tabulated_expm1(limb* m, const limb* t, long w) {
  return at_limbs(w, [&](auto limbs) { return expm1_at<limbs>(m, t); });
}
std::uint64_t tabulated_sin_cos(limb* s, limb* c, const limb* t, long w) {
  return at_limbs(w, [&](auto limbs) { return sin_cos_at<limbs>(s, c, t); });
}
std::optional<std::uint64_t> tabulated_log1p(limb* l, const limb* f, long w) {
  return at_limbs(w, [&](auto limbs) { return log1p_at<limbs>(l, f); });
}
std::optional<std::uint64_t> tabulated_atan(limb* t, const limb* a, const limb* b, long w) {
  return at_limbs(w, [&](auto limbs) { return atan_at<limbs>(t, a, b); });
}

}  // namespace polhode::detail
