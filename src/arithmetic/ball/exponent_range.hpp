#pragma once

// Where a number lies in MPFR's range of exponents, for the code that rounds intermediate numbers
// itself.
//
// An overflow leaves an infinity behind, whose inverse is an exact 0; an underflow leaves 0 or the
// least number. After either, "a relative error below 2^-p" is no longer true of what is computed
// on. The operations of balls look after that themselves. A function that combines bare MPFR
// numbers, and bounds the errors relative to the result, does it in two steps:
//   1. its operands are moderate, so that no product, sum or quotient of two products leaves MPFR's
//      default range;
//   2. each number that it rounds is faithful. This is asked of the result, for a caller may have
//      narrowed the range, and at a very high precision a difference may be smaller than all
//      products.
// Where one of them fails, the function combines balls instead.

#include <mpfr.h>

namespace polhode::detail {

class exponent_range {
 public:
  exponent_range() : least_(mpfr_get_emin()), most_(mpfr_get_emax()) {}

  /// x is 0, or its exponent is within an eighth of the range.
  [[nodiscard]] bool is_moderate(mpfr_srcptr x) const {
    return mpfr_regular_p(x) == 0 || (mpfr_get_exp(x) > least_ / 8 && mpfr_get_exp(x) < most_ / 8);
  }
  /// x, rounded to nearest with that ternary value, is the exact number or differs from it by half
  /// a unit in x's last place at most.
  [[nodiscard]] bool is_faithful(mpfr_srcptr x, int ternary) const {
    if (ternary == 0) return mpfr_number_p(x) != 0;
    // A number that underflowed has the least exponent.
    return mpfr_regular_p(x) != 0 && mpfr_get_exp(x) > least_;
  }

 private:
  mpfr_exp_t least_;
  mpfr_exp_t most_;
};

}  // namespace polhode::detail
