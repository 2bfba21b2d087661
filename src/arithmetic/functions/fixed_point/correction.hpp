#pragma once

// How log and atan are computed with many limbs: a value of one limb, or of an eighth of the limbs,
// whose exp or whose sine and cosine are computed, is corrected by the logarithm or the arc tangent
// of a number that is nearly 1 or nearly 0 (this is R. P. Brent's use of an inverse function, 1976,
// with a step of higher order than Newton's). The first values are integers, so that they are the
// same on every machine.

#include <algorithm>
#include <cstdint>

#include "arithmetic/functions/fixed_point/fraction.hpp"

namespace polhode::detail::fixed_point {

/// num / den for |num| < 2^-50 and 1/4 < den < 4, then atan (or atanh) of it: q becomes a number
/// within 3 units of that of the quotient of these numbers as they are. False where the quotient is
/// not below 2^-49, or so great that the sum would have too many terms.
///
/// atan q = q (1 - q^2/3 + q^4/5 - ...): if q < 2^-n, n >= 49, and 2 n K + n >= 64 w then the first
/// term left out is below a third of a unit, and so is the rest. The quotient is cut off, 1 unit,
/// which atan (atanh) magnifies by less than 1 + 2^-90. The sum is made as sum_series makes its,
/// but for runs of coefficients c_k = P / (2k + 1) with P < 2^60 the product of the run's 2k + 1,
/// and it is below 1.1 P throughout a run: a multiplication by z^m, 2 units wrong, loses 2.2 P + 1
/// and forgets the error from before, the terms lose 2 P, the division loses 1: 6 units at most of
/// the quotient by P, and going on with another P' multiplies both sum and error by it. Limbs are
/// left out as sum_series leaves them out. The factor q < 2^-49 makes nothing of these; the product
/// is cut off.
[[nodiscard]] bool arctangent_of_quotient(number& q, const limb* num, const number& den, long w,
                                          bool hyperbolic);

/// The limbs of a first value.
[[nodiscard]] inline long limbs_of_first_value(long w) {
  constexpr long part = 8;
  return is_by_primes(w) ? std::max(w / part, 1L) : 1;
}

// First values, of one limb. Nothing is claimed of them: a bad one would be found out by the size
// of its correction.

/// log(1 + f), about, for a fraction f of one limb: below log 2.
[[nodiscard]] limb first_logarithm(limb f);

/// atan(f), about.
[[nodiscard]] limb first_arctangent(limb f);

}  // namespace polhode::detail::fixed_point
