#pragma once

// e^t - 1, sin and cos, log and atan in fixed point at few limbs, by tables: the argument is
// brought near 0 by an entry of a table, or two, and a short series does the rest.
//
// A fraction of w limbs is the integer in {x, w} times 2^(-64 w); a number has one limb more,
// before the point. 2^(-64 w) is called a unit here. What the functions return is a bound, in
// units, of how far the results are from the true values at the argument as it is given. 2 <= w <=
// most_tabulated_limbs, and results do not overlap arguments.

#include <cstdint>
#include <optional>

#include <gmp.h>

namespace polhode::detail {

constexpr long most_tabulated_limbs = 8;

/// The fractions log 2 and pi/4, cut off: less than one unit too small.
[[nodiscard]] const mp_limb_t* tabulated_log_2(long w);
[[nodiscard]] const mp_limb_t* tabulated_quarter_pi(long w);

/// m = e^t - 1 for a fraction t < log 2. m is a fraction too, and not above the true value.
std::uint64_t tabulated_expm1(mp_limb_t* m, const mp_limb_t* t, long w);

/// s = sin t, a fraction, and c = cos t, a number, for a fraction t < pi/4.
std::uint64_t tabulated_sin_cos(mp_limb_t* s, mp_limb_t* c, const mp_limb_t* t, long w);

/// l = log(1 + f), a number in two's complement, for a fraction f. Returns nothing where the tables
/// do not reach.
std::optional<std::uint64_t> tabulated_log1p(mp_limb_t* l, const mp_limb_t* f, long w);

/// t = atan(a/b), a fraction, for numbers 0 <= a <= b and 1/2 <= b <= 1. Returns nothing where the
/// tables do not reach.
std::optional<std::uint64_t> tabulated_atan(mp_limb_t* t, const mp_limb_t* a, const mp_limb_t* b,
                                            long w);

}  // namespace polhode::detail
