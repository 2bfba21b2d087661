// The arc tangent in fixed point, by tables with few limbs and by a correction with more.

#include <cstdint>

#include "arithmetic/functions/fixed_point/circular.hpp"
#include "arithmetic/functions/fixed_point/correction.hpp"
#include "arithmetic/functions/fixed_point_functions.hpp"
#include "polhode/arithmetic/mpfr_cell.hpp"

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
  number size(w);
  load(size, x, steep ? 0 : e, w);
  number other(w);
  mpn_zero(other.data(), w + 1);
  if (steep) {
    other[w - 1] = limb{1} << (64 - e);
  } else {
    other[w] = 1;
  }
  number value(w);
  const auto found = tabulated_atan(value.data(), steep ? other.data() : size.data(),
                                    steep ? size.data() : other.data(), w);
  if (!found) return false;
  std::uint64_t units = *found + 1;
  value[w] = 0;
  if (steep) {
    const quarter_pi eighth(w);
    number half(w);
    half[w] = mpn_lshift(half.data(), eighth.data(), w, 1);
    mpn_sub_n(value.data(), half.data(), value.data(), w + 1);
    units += 2;
  }
  return store(r, value, w, mpfr_sgn(x), 0, units, error);
}

/// first = atan |x|, or atan(1/|x|) for |x| >= 1, about, in its upper limbs: a choice.
bool set_first_arctangent(fraction& first, mpfr_srcptr x, long few, long w) {
  constexpr mpfr_prec_t guard = 32;
  const mpfr_prec_t bits = 64 * few;
  mpfr_cell tangent(bits + guard);
  mpfr_cell angle(bits);
  if (mpfr_get_exp(x) > 0) {
    mpfr_ui_div(tangent.get(), 1, x, MPFR_RNDZ);
  } else {
    mpfr_set(tangent.get(), x, MPFR_RNDZ);
  }
  magnitude error;
  if (!near_atan(angle.get(), tangent.get(), error)) return false;
  number value(few);
  load(value, angle.get(), mpfr_get_exp(angle.get()), few);
  if (value[few] != 0) return false;
  mpn_copyi(first.data() + (w - few), value.data(), few);
  return true;
}

}  // namespace

bool near_atan(mpfr_ptr r, mpfr_srcptr x, magnitude& error) {
  if (mpfr_regular_p(x) == 0 || mpfr_get_exp(x) > range_log2 || mpfr_get_exp(x) < -range_log2 ||
      !may_be_own()) {
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
  number size(w);
  load(size, x, steep ? 0 : e, w);
  const limb top = size[w - 1];
  limb tangent = top;
  if (steep) {
    const uint128 quotient = (uint128{1} << (128 - e)) / top;
    tangent = (quotient >> 64) != 0 ? ~limb{0} : static_cast<limb>(quotient);
  }
  // angle = first + atan((a cos - b sin) / (b cos + a sin)) with the sine and cosine of `first`.
  fraction first(w);
  mpn_zero(first.data(), w);
  if (const long few = limbs_of_first_value(w); few == 1) {
    first[w - 1] = first_arctangent(tangent);
  } else if (!set_first_arctangent(first, x, few, w)) {
    return false;
  }
  const long zeros = leading_zeros(first.data(), w);
  if (zeros > range_log2 + 1) return false;
  number s(w);
  number c(w);
  const circular_errors circular = sine_and_cosine(&s, &c, first.data(), zeros, w);
  if (c[w] != 0) return false;  // only where `first` is 0
  fraction num(w);
  fraction product(w);
  number den(w);
  bool below = false;
  if (steep) {
    fraction shifted(w);
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
  number correction(w);
  if (!arctangent_of_quotient(correction, num.data(), den, w, false)) return false;
  number value(w);
  mpn_copyi(value.data(), first.data(), w);
  value[w] = 0;
  if (below) {
    mpn_sub_n(value.data(), value.data(), correction.data(), w + 1);
  } else {
    mpn_add_n(value.data(), value.data(), correction.data(), w + 1);
  }
  // Both num and den are wrong by less than both errors and 3 for the products, shifts and |x| cut
  // off; b cos >= 0.35, so that the quotient is by three times that for num, and 2^-49 of it for
  // den.
  std::uint64_t units = 3 * (circular.cosine + circular.sine + 3) + 3 + 1;
  if (steep) {
    const quarter_pi eighth(w);
    number half(w);
    half[w] = mpn_lshift(half.data(), eighth.data(), w, 1);
    mpn_sub_n(value.data(), half.data(), value.data(), w + 1);
    units += 2;
  }
  return store(r, value, w, mpfr_sgn(x), 0, units, error);
}

}  // namespace polhode::detail
