// q and q' at the start, by Horner's scheme in two's complement.

#include <algorithm>
#include <utility>

#include "quadrature/rules/gauss_legendre/few_limbs/neighbourhood.hpp"

namespace polhode::detail::legendre {
namespace {

/// {result + 1, size} = floor({x, size} y / 2^64) + {c, size}, all of them in two's complement.
void multiply_and_add(limb* result, const limb* x, limb y, const limb* c, long size) {
  result[0] = 0;
  mpn_copyi(result + 1, c, size);
  result[size] += mpn_addmul_1(result, x, size, y);
  // As an unsigned number a negative x is 2^(64 size) too large.
  if ((x[size - 1] >> 63) != 0) result[size] -= y;
}

/// A two's complement with `size` limbs, as a number with w limbs behind the point; false where it
/// is too large for one.
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

}  // namespace polhode::detail::legendre
