#pragma once

// 1 - cos t and sin t in fixed point, which the circular functions and the arc tangent rest on.

#include <cstdint>

#include "arithmetic/functions/fixed_point/fraction.hpp"

namespace polhode::detail::fixed_point {

/// v = 1 - cos t for a fraction t < 0.79. Returns the error, in units.
///
/// v is computed at y = t / 2^r with z = y^2, and 1 - cos(2y) = 4 v - 2 v^2. Cutting y off moves t
/// by 2^r units and v by less; cutting z off moves v(y) by less than 1, the series by 34. If v is
/// wrong by e then 4 v - 2 v^2 is by 4 e and 2 more. So the error is below 4^r (35 + 2/3) + 2^r <=
/// 4^r (36 + 1/6). v^2 is cut off downwards, so that v >= 0 does not become negative.
std::uint64_t versine_of_fraction(limb* v, const limb* t, long w);

/// s = sin t from v = 1 - cos t, known within `units` < 2^42, for 2^-18 <= t < 0.79: the root of 2
/// v - v^2. Returns the error: that of the square is below 2 units + 2, that of the root is this
/// divided by the sum of the true and the computed root, which is above 1.5 s, and one more for
/// cutting off. If t has `zeros` zeros in front then s > 0.9 t > 2^(-zeros - 1.16), and the error
/// is less than (2 units + 2) 2^(zeros + 1.16) / 1.5 + 1 < (units + 1) 2^(zeros + 2).
std::uint64_t sine_from_versine(limb* s, const limb* v, std::uint64_t units, long zeros, long w);

/// s = sin t and c = cos t, numbers, for a fraction t <= pi/4 with that many zero bits at its top,
/// with more limbs than tables have. Either pointer may be null.
struct circular_errors {
  std::uint64_t sine;
  std::uint64_t cosine;
};
circular_errors sine_and_cosine(number* s, number* c, const limb* t, long zeros, long w);

}  // namespace polhode::detail::fixed_point
