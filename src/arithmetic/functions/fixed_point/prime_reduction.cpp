#include "arithmetic/functions/fixed_point/prime_reduction.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <span>
#include <stdexcept>
#include <utility>

#include "arithmetic/functions/fixed_point/bit_burst.hpp"
#include "arithmetic/functions/fixed_point/prime_numbers.hpp"
#include "arithmetic/functions/fixed_point/prime_relations.hpp"
#include "arithmetic/functions/fixed_point/series.hpp"
#include "polhode/arithmetic/exact.hpp"

namespace polhode::detail::fixed_point {

namespace prime_reduction_impl {
namespace {

/// Where parts of the argument are summed by halves, a choice.
struct parts_from {
  long least_limbs;
  long most_terms_of_rest;
};
constexpr parts_from parts_of_exponential{1100, 100};
constexpr parts_from parts_of_circle{1600, 400};

/// How many relations are used for w limbs, another choice: with too many the products of powers
/// become long.
std::size_t logarithms_used(long w) {
  return static_cast<std::size_t>(12 + std::min(w, 64L) / 4 + w / 40);
}
std::size_t angles_used(long w) {
  return static_cast<std::size_t>(std::min(10 + std::min(w, 64L) / 6 + w / 60, 30L));
}

/// t = sum of e_j n_j + rest.
struct reduction {
  std::array<long, prime_count> exponents{};
  bool negative = false;    // of the rest
  std::uint64_t units = 0;  // sum of |e_j|: the error, as each n_j is too small by less than 1
};

__extension__ using int128 = __int128;

/// The bits of a number with w limbs down to 2^-120, modulo 2^8.
uint128 upper_bits(const limb* x, long w) {
  return (uint128{x[w]} << 120) + (((uint128{x[w - 1]} << 64) | x[w - 2]) >> 8);
}

/// A relation's sum, about, in units of 2^-120.
int128 sum_of(const relation& r, const prime_numbers& numbers, long w) {
  uint128 sum = 0;
  for (std::size_t j = 0; j < prime_count; ++j) {
    sum += upper_bits(numbers.number(j, w), w) * static_cast<uint128>(int128{r[j]});
  }
  return static_cast<int128>(sum);
}

/// t, a fraction, is reduced to |rest|.
reduction reduce_by(number& rest, const limb* t, const prime_numbers& numbers,
                    std::span<const relation> relations, std::size_t used, long w) {
  mpn_copyi(rest.data(), t, w);
  rest[w] = 0;
  reduction result;
  auto about = static_cast<int128>(upper_bits(rest.data(), w));
  for (const relation& r : relations.first(std::min(used, relations.size()))) {
    const int128 step = sum_of(r, numbers, w);
    const int128 doubled = 2 * about + (about < 0 ? -step : step);
    const auto times = static_cast<long>(doubled / (2 * step));
    about -= times * step;
    for (std::size_t j = 0; j < prime_count; ++j) result.exponents[j] += times * r[j];
  }
  for (std::size_t j = 0; j < prime_count; ++j) {
    const long e = result.exponents[j];
    const limb* n = numbers.number(j, w);
    const auto size = static_cast<limb>(std::abs(e));
    if (e > 0) mpn_submul_1(rest.data(), n, w + 1, size);
    if (e < 0) mpn_addmul_1(rest.data(), n, w + 1, size);
    result.units += size;
  }
  result.negative = is_negative(rest, w);
  if (result.negative) mpn_neg(rest.data(), rest.data(), w + 1);
  if (rest[w] != 0 || rest[w - 1] >> 63 != 0) {
    throw std::logic_error("an argument was not reduced by primes");
  }
  return result;
}

/// rest = sinh t, or sin t, for a fraction t < 1/2 with w limbs, within 19 units.
///
/// z = t^2 is cut off, which moves g, the series without its first term over t, by less than 1 as
/// g' < 1/5; the series is within 34 units. So g is within 35, t g within 17.5 + 1.
void sum_odd_series(fraction& result, const limb* t, series s, long w) {
  fraction z(w);
  square(z.data(), t, w);
  number g(w);
  const long small = std::clamp(2 * leading_zeros(t, w), 2L, 32 * w);
  sum_series(g, s, z.data(), w, small);
  if (is_negative(g, w)) mpn_zero(g.data(), w + 1);  // nearer to g >= 0
  fraction product(w);
  multiply(product.data(), g.data(), t, w);
  if (s == series::sine) {
    mpn_sub_n(result.data(), t, product.data(), w);
  } else {
    mpn_add_n(result.data(), t, product.data(), w);
  }
}

/// The number of bits of the greatest exponent.
int bits_of(const std::array<long, prime_count>& exponents) {
  int bits = 0;
  for (const long e : exponents) {
    bits = std::max(bits, static_cast<int>(std::bit_width(static_cast<limb>(std::abs(e)))));
  }
  return bits;
}

// A product of powers, from the exponents' upper bits on (E. G. Straus 1964): squared from bit to
// bit, and multiplied by the primes that have the bit. Each of the odd primes once, their product
// is below 2^48; each of the Gaussian ones once, their norm is below 2^64.

/// The product of the odd p_j^(e_j) with positive e_j, or of the p_j^(-e_j) with negative ones.
integer product_of_powers(const std::array<long, prime_count>& exponents, bool positive) {
  integer result = 1;
  for (int bit = bits_of(exponents); bit-- > 0;) {
    limb factor = 1;
    for (std::size_t j = 1; j < prime_count; ++j) {
      const long e = positive ? exponents[j] : -exponents[j];
      if (e > 0 && (e >> bit & 1) != 0) factor *= static_cast<limb>(primes[j]);
    }
    result *= result;
    result *= factor;
  }
  return result;
}

struct gaussian_number {
  integer re;
  integer im;
};

gaussian_number square_of(const gaussian_number& x) {
  return {(x.re + x.im) * (x.re - x.im), (x.re * x.im) << 1U};
}

/// The product of the odd pi_j^(e_j), by their conjugates for negative e_j.
gaussian_number product_of_gaussian_powers(const std::array<long, prime_count>& exponents) {
  gaussian_number result{1, 0};
  for (int bit = bits_of(exponents); bit-- > 0;) {
    gaussian_integer factor{1, 0};
    for (std::size_t j = 1; j < prime_count; ++j) {
      const long e = exponents[j];
      if ((std::abs(e) >> bit & 1) == 0) continue;
      const std::int64_t re = gaussian_primes[j].re;
      const std::int64_t im = e > 0 ? gaussian_primes[j].im : -gaussian_primes[j].im;
      factor = {factor.re * re - factor.im * im, factor.re * im + factor.im * re};
    }
    result = square_of(result);
    result = {result.re * factor.re - result.im * factor.im,
              result.re * factor.im + result.im * factor.re};
  }
  return result;
}

/// The whole number in {x, n}.
integer whole(const limb* x, long n) {
  integer result;
  mpz_import(result.backend().data(), static_cast<std::size_t>(n), -1, sizeof(limb), 0, 0, x);
  return result;
}

/// x, or the nearest number of n limbs.
void put(limb* to, const integer& x, long n) {
  mpn_zero(to, n);
  if (x <= 0) return;
  const auto size = static_cast<long>(mpz_size(x.backend().data()));
  if (size > n) {
    std::fill_n(to, n, ~limb{0});
  } else {
    mpn_copyi(to, mpz_limbs_read(x.backend().data()), size);
  }
}

/// A part of an argument: a/2^scale <= 2^-small.
struct short_part {
  integer a;
  long scale;
  long small;
};

/// Takes the upper half of the bits of t that are needed below its zeros, where the sum of an odd
/// series at t would have many terms.
std::optional<short_part> take_upper_bits(number& t, long w, parts_from from) {
  const long zeros = leading_zeros(t.data(), w);
  if (w < from.least_limbs || 64 * w < 2 * zeros * from.most_terms_of_rest) return std::nullopt;
  const long scale = 2 * zeros;
  const long place = 64 * w - scale;  // of a's last bit
  integer a = whole(t.data() + place / 64, w - place / 64);
  a >>= static_cast<unsigned long>(place % 64);
  mpn_zero(t.data() + place / 64 + 1, w - place / 64 - 1);
  t[place / 64] &= (limb{1} << (place % 64)) - 1;
  return short_part{std::move(a), scale, zeros};
}

/// 2^(64 w) e^t, or e^-t, for the parts that are taken from t < 1/2, e^t < 1.65, if there are any.
/// Adds to the error.
///
/// A factor is within 2 units. So the product's error becomes f e + 2 p + 1 for a factor f and a
/// product p before it: all factors together, and so all products, are below 1.65 and a part adds
/// less than 1.65 (2 1.65 + 1) < 8.
std::optional<integer> exponential_of_parts(number& t, bool negative, long w,
                                            std::uint64_t& units) {
  std::optional<integer> product;
  while (const auto part = take_upper_bits(t, w, parts_of_exponential)) {
    const integer a = negative ? integer(-part->a) : part->a;
    integer factor = integer(1) << static_cast<unsigned long>(64 * w);
    factor += expm1_of_short(a, part->scale, part->small, 64 * w);
    if (product) {
      *product *= factor;
      *product >>= static_cast<unsigned long>(64 * w);
    } else {
      product = std::move(factor);
    }
    units += 8;
  }
  return product;
}

/// x y/2^(64 w), cut off.
gaussian_number scaled_product(const gaussian_number& x, const gaussian_number& y, long w) {
  gaussian_number result{x.re * y.re - x.im * y.im, x.re * y.im + x.im * y.re};
  result.re >>= static_cast<unsigned long>(64 * w);
  result.im >>= static_cast<unsigned long>(64 * w);
  return result;
}

/// sqrt(1 - s^2) for |s| < 0.6 with w limbs: within 1 and 0.75 times the error of s.
integer cosine_from_sine(const integer& s, long w) {
  integer square = (integer(1) << static_cast<unsigned long>(128 * w)) - s * s;
  integer root;
  mpz_sqrt(root.backend().data(), square.backend().data());
  return root;
}

/// 2^(64 w) (cos t + i sin t) for t < 1/2, within 31 units and 9 for each part.
///
/// sin of the rest is within 19 units, its cosine within 0.58 times that and 1: together within 23.
/// A part's are within 2 and 3, together within 4. Of a product of numbers of size 1 the errors
/// add, and cutting off both its parts adds 1.5: less than 9 for a part and 31 for the rest, with
/// the products of errors.
gaussian_number circle_of(number& t, long w, std::uint64_t& units) {
  std::optional<gaussian_number> product;
  while (const auto part = take_upper_bits(t, w, parts_of_circle)) {
    integer s = sine_of_short(part->a, part->scale, part->small, 64 * w);
    integer c = cosine_from_sine(s, w);
    gaussian_number factor{std::move(c), std::move(s)};
    product = product ? scaled_product(*product, factor, w) : std::move(factor);
    units += 9;
  }
  fraction s(w);
  sum_odd_series(s, t.data(), series::sine, w);
  integer sine = whole(s.data(), w);
  integer cosine = cosine_from_sine(sine, w);
  gaussian_number rest{std::move(cosine), std::move(sine)};
  units += 31;
  return product ? scaled_product(*product, rest, w) : std::move(rest);
}

}  // namespace
}  // namespace prime_reduction_impl

// e^rest is the product of the parts' exponentials and of sqrt(1 + s^2) + s, or - s, for the sinh s
// of what is left of |rest| < 1/2. s is within 19 units, the root within 9 + 1 as s/sqrt(1 + s^2) <
// 0.47, so that their sum is within 29. Both factors are below 1.65: with the parts' error of P
// units the product is within 1.65 (29 + P) + 1 and the product of the errors, less than 1.7 (29 +
// P). The product of the primes' powers is e^t over e^rest, below 2 e^(1/2) < 3.3, so that it makes
// less than 6 (29 + P) of that; cutting off adds 1. The error of the rest, E = sum of |e_j| units,
// makes less than 2 E of e^t < 2, and the powers of the rounded rest are those of the true one.
std::uint64_t exponential_by_primes(number& value, const limb* t, long w) {
  using namespace prime_reduction_impl;
  const auto logarithms = logarithms_of_primes(w);
  number rest(w);
  const reduction r = reduce_by(rest, t, *logarithms, logarithm_relations, logarithms_used(w), w);
  std::uint64_t units = r.units + 29;
  const std::optional<integer> parts = exponential_of_parts(rest, r.negative, w, units);
  fraction s(w);
  sum_odd_series(s, rest.data(), series::hyperbolic_sine, w);
  double_fraction square_of_root(w);
  mpn_sqr(square_of_root.data(), s.data(), w);
  square_of_root[2 * w] = 1;
  number root(w);
  mpn_sqrtrem(root.data(), nullptr, square_of_root.data(), 2 * w + 1);
  if (r.negative) {
    root[w] -= mpn_sub_n(root.data(), root.data(), s.data(), w);
  } else {
    root[w] += mpn_add_n(root.data(), root.data(), s.data(), w);
  }
  integer numerator = product_of_powers(r.exponents, true);
  integer denominator = product_of_powers(r.exponents, false);
  (r.exponents[0] > 0 ? numerator : denominator) <<=
      static_cast<unsigned long>(std::abs(r.exponents[0]));
  integer product = whole(root.data(), w + 1);
  if (parts) {
    product *= *parts;
    product >>= static_cast<unsigned long>(64 * w);
  }
  product *= numerator;
  product /= denominator;
  put(value.data(), product, w + 1);
  return 6 * units + 1;
}

// With Z the product of the powers of the pi_j^2 or their conjugates, and of i, the number
// cos(rest) + i sin(rest) is turned by Z/|Z|, which leaves the size of its error. The error of the
// rest adds `units`, cutting off 1.
std::uint64_t sine_and_cosine_by_primes(limb* sine, limb* cosine, const limb* t, long w) {
  using namespace prime_reduction_impl;
  const auto angles = angles_of_primes(w);
  number rest(w);
  const reduction r = reduce_by(rest, t, *angles, angle_relations, angles_used(w), w);
  std::uint64_t units = r.units;
  gaussian_number circle = circle_of(rest, w, units);
  if (r.negative) circle.im = -circle.im;
  const gaussian_number root = product_of_gaussian_powers(r.exponents);
  const integer size = root.re * root.re + root.im * root.im;
  gaussian_number turn = square_of(root);
  for (long quarter = r.exponents[0] & 3; quarter > 0; --quarter) {
    turn = {integer(-turn.im), turn.re};
  }
  integer real = circle.re * turn.re - circle.im * turn.im;
  integer imaginary = circle.re * turn.im + circle.im * turn.re;
  real /= size;
  imaginary /= size;
  put(cosine, real, w);
  put(sine, imaginary, w);
  return units + 1;
}

}  // namespace polhode::detail::fixed_point
