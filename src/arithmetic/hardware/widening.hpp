#pragma once

// Approximations at a point, with proofs, and the functions of intervals made of them.
//
// u = 2^-53: RN(t) = t (1 + d) with |d| <= u where nothing underflows, and |RN(t) - t| <= 2^(e-54)
// for |t| <= 2^e.
//
// LEMMA P (polynomials; N. Higham, Accuracy and Stability of Numerical Algorithms, 2nd ed. 2002,
// lemma 3.1). Let a sum of products be evaluated in any order such that each summand, from its
// factors to the result, passes through at most m roundings, those of its factors counted. Then the
// computed value is the sum of the summands, each times 1 + d, |d| <= g_m = m u / (1 - m u). So its
// error is at most g_m times the sum of the summands' absolute values.
//
// LEMMA W (widening). Let |f - y| <= b |y| + 2^-1075, for doubles y and b = 2^-n, 48 <= n <= 52.
// Then widened_down(y, b) <= f <= widened_up(y, b). Proof for the first, next_down(RN(v)), where v
// = y - E and E is the computed b |y|. Let s be the distance from RN(v) to the double below; v is
// at least RN(v) - s/2, so next_down(RN(v)) <= v - s/2.
//   |y| >= 2^-960: E = b |y| exactly, and s/2 > 2^-1075.
//   |y| < 2^-960: E is off by at most 2^-1075, and v is a multiple of 2^-1074. Either v is a
//   double,
// and the step takes it down by 2^-1074 at least; or |v| > 2^-1021, and v lies 2^-1074 or more
// above next_down(RN(v)), as multiples of 2^-1074 do. So the result is at most v - 2^-1074 <= y - b
// |y| - 2^-1075. []
//
// A relative error e with respect to f, e <= 2^-48, is one of e / (1 - e) < e (1 + 2^-47) with
// respect to y; the bounds have room for that, and it is not mentioned again.

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "polhode/arithmetic/double_interval.hpp"

namespace polhode::detail::hardware {

constexpr double one_third = 1.0 / 3;

/// 2^n for -1022 <= n <= 1023.
inline double power_of_two(long n) {
  return std::bit_cast<double>(static_cast<std::int64_t>(n + 1023) << 52);
}

/// The integer nearest to t, but for ties and for t's neighbourhood of them, as a double and as an
/// integer: |t| < 2^31. The sum's last place is 1.
struct nearest {
  double value;
  long integer;
  explicit nearest(double t) {
    constexpr double shift = 0x1.8p52;
    const double sum = t + shift;
    value = sum - shift;
    integer = static_cast<std::int32_t>(std::bit_cast<std::uint64_t>(sum) & 0xffffffffU);
  }
};

inline double widened_down(double y, double bound) { return next_down(y - bound * std::abs(y)); }
inline double widened_up(double y, double bound) { return next_up(y + bound * std::abs(y)); }
/// The same for approximations that are 0 only where the function is.
inline double end_down(double y, double bound) { return y == 0 ? 0 : widened_down(y, bound); }
inline double end_up(double y, double bound) { return y == 0 ? 0 : widened_up(y, bound); }

inline double_interval from_ends(double lower, double upper) { return {unchecked{}, lower, upper}; }

/// Of a function that rises with x from approximations at the ends.
template <class Approximation>
inline double_interval increasing(double_interval x, Approximation&& f, double bound) {
  const double a = x.lower();
  const double b = x.upper();
  const double low = f(a);
  const double high = a == b ? low : f(b);
  return from_ends(end_down(low, bound), end_up(high, bound));
}

/// f(|x|) with the sign of x.
template <class Approximation>
auto odd(Approximation&& f) {
  return [f](double x) { return std::copysign(f(std::abs(x)), x); };
}

/// The angles -limit and limit, rounded outward, are never passed.
inline double_interval limited(double_interval x, double limit) {
  return from_ends(std::max(x.lower(), -limit), std::min(x.upper(), limit));
}

inline constexpr double_interval unit_interval(unchecked{}, -1, 1);

}  // namespace polhode::detail::hardware
