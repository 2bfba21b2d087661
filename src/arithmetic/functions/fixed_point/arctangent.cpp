// The arc tangent in fixed point, by tables with few limbs and by a correction with more.

#include <cstdint>

#include "arithmetic/functions/fixed_point/circular.hpp"
#include "arithmetic/functions/fixed_point/correction.hpp"
#include "arithmetic/functions/fixed_point_functions.hpp"

namespace polhode::detail {

using namespace fixed_point;

namespace {

/// near_atan by tables: |x| = a/b with b = 1, or a = 2^-e and b = |x| 2^-e in [1/2, 1) for |x| >=
/// 1, where atan |x| = pi/2 - atan(1/|x|).
/// |x| or b may be cut off by less than a unit, which changes the angle by less than one: |d
/// atan(a/b)| <= |da|/b for b = 1, and a/(a^2 + b^2) |db| <= |db|/(2b) <= |db|.
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
  // Both num and den are wrong by less than both errors and 3 for the products, shifts and |x| cut
  // off; b cos >= 0.35, so that the quotient is by three times that for num, and 2^-49 of it for
  // den.
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
