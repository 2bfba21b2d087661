#pragma once

// a b + c d, a b - c d and a b + c, rounded once, as mpfr_fmma, mpfr_fmms and mpfr_fma have them:
// the products are made exactly, on the stack, and MPFR adds them.

#include <utility>

#include <gmp.h>
#include <mpfr.h>

#include "exponent_range.hpp"

namespace polhode::detail {

// Beyond this MPFR's own way costs little more.
inline constexpr long most_limbs_of_factor = 20;

inline long limbs_of_precision(mpfr_prec_t p) { return (p + GMP_NUMB_BITS - 1) / GMP_NUMB_BITS; }

/// A regular number that exact_product takes. It is to be moderate as well: the product is then a
/// number within MPFR's range, which MPFR's functions take it for.
inline bool is_short(mpfr_srcptr x) {
  return mpfr_regular_p(x) != 0 &&
         mpfr_get_prec(x) <= mpfr_prec_t{most_limbs_of_factor} * GMP_NUMB_BITS;
}

/// x y for short numbers.
class exact_product {
 public:
  exact_product(mpfr_srcptr x, mpfr_srcptr y) {
    const auto* xs = static_cast<const mp_limb_t*>(mpfr_custom_get_significand(x));
    const auto* ys = static_cast<const mp_limb_t*>(mpfr_custom_get_significand(y));
    long m = limbs_of_precision(mpfr_get_prec(x));
    long n = limbs_of_precision(mpfr_get_prec(y));
    mpfr_exp_t exponent = mpfr_get_exp(x) + mpfr_get_exp(y);
    if (m == n) {
      if (xs == ys) {
        mpn_sqr(limbs_, xs, n);
      } else {
        mpn_mul_n(limbs_, xs, ys, n);
      }
    } else {
      if (m < n) {
        std::swap(xs, ys);
        std::swap(m, n);
      }
      mpn_mul(limbs_, xs, m, ys, n);
    }
    // Two significands in [1/2, 1) have a product in [1/4, 1).
    if ((limbs_[m + n - 1] >> (GMP_NUMB_BITS - 1)) == 0) {
      mpn_lshift(limbs_, limbs_, m + n, 1);
      --exponent;
    }
    const bool negative = (mpfr_sgn(x) < 0) != (mpfr_sgn(y) < 0);
    mpfr_custom_init_set(value_, negative ? -MPFR_REGULAR_KIND : MPFR_REGULAR_KIND, exponent,
                         (m + n) * GMP_NUMB_BITS, limbs_);
  }
  exact_product(const exact_product&) = delete;
  exact_product(exact_product&&) = delete;
  exact_product& operator=(const exact_product&) = delete;
  exact_product& operator=(exact_product&&) = delete;
  ~exact_product() = default;
  [[nodiscard]] mpfr_srcptr get() const { return value_; }

 private:
  mpfr_t value_;
  mp_limb_t limbs_[2 * most_limbs_of_factor];  // set as far as they are used
};

/// r = a b + c d, and a b - c d, to nearest; the answer is MPFR's. All four are to be moderate:
/// where one product is 0 and the other underflows, mpfr_fmma and mpfr_fmms of MPFR 4.2.0 return a
/// number with an exponent far outside the range.
inline int sum_of_products(mpfr_ptr r, mpfr_srcptr a, mpfr_srcptr b, mpfr_srcptr c, mpfr_srcptr d) {
  if (!is_short(a) || !is_short(b) || !is_short(c) || !is_short(d)) {
    return mpfr_fmma(r, a, b, c, d, MPFR_RNDN);
  }
  return mpfr_add(r, exact_product(a, b).get(), exact_product(c, d).get(), MPFR_RNDN);
}
inline int difference_of_products(mpfr_ptr r, mpfr_srcptr a, mpfr_srcptr b, mpfr_srcptr c,
                                  mpfr_srcptr d) {
  if (!is_short(a) || !is_short(b) || !is_short(c) || !is_short(d)) {
    return mpfr_fmms(r, a, b, c, d, MPFR_RNDN);
  }
  return mpfr_sub(r, exact_product(a, b).get(), exact_product(c, d).get(), MPFR_RNDN);
}

/// r = a b + c to nearest; the answer is MPFR's.
inline int product_and_sum(mpfr_ptr r, mpfr_srcptr a, mpfr_srcptr b, mpfr_srcptr c) {
  const exponent_range range;
  if (!is_short(a) || !is_short(b) || !range.is_moderate(a) || !range.is_moderate(b)) {
    return mpfr_fma(r, a, b, c, MPFR_RNDN);
  }
  return mpfr_add(r, exact_product(a, b).get(), c, MPFR_RNDN);
}

}  // namespace polhode::detail
