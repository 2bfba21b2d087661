#pragma once

// From values at numbers to enclosures over balls: enough working bits, and monotonicity.

#include <array>

#include "polhode/arithmetic/boost_bridge.hpp"
#include "polhode/arithmetic/elementary.hpp"

namespace polhode::detail {

/// Not more bits than these, beside a few times those asked for, are looked for behind
/// cancellation. A value that is 0 has no good bits ever.
inline constexpr std::int64_t most_bits_lost = std::int64_t{1} << 16;

/// f(q), an enclosure computed with q bits, for growing q until it has p good bits, or until more
/// bits are of no use. The result has p bits.
template <class F>
[[nodiscard]] ball to_accuracy(precision p, const F& f) {
  constexpr int most_attempts = 5;
  precision q = p + 24;
  ball best = ball::undefined(p);
  for (int attempt = 0; attempt < most_attempts; ++attempt) {
    const ball value = f(q);
    if (value.is_undefined()) {  // maybe only for want of bits
      if (attempt >= 2 || 2 * q > p + most_bits_lost) break;
      q += q;
      continue;
    }
    best = best.is_undefined() ? value : intersection(best, value);
    const magnitude size = value.magnitude_lower();
    if (value.is_bounded() && scale(value.radius(), p + 4) <= size) break;
    if (value.is_exact()) break;
    // As many bits more as were lost; twice as many where not even the sign was found.
    const std::int64_t kept = !value.is_bounded() || size.is_zero()
                                  ? -q
                                  : size.log2_floor() - value.radius().log2_floor();
    const std::int64_t more = p + 16 - kept;
    if (q + more > 4 * p + most_bits_lost) break;
    q += static_cast<precision>(std::max<std::int64_t>(more, 24));
  }
  return best.with_precision(p);
}

[[nodiscard]] inline bool not_negative(const ball& x) {
  if (x.is_undefined()) return false;
  mpfr_float low = lower(x);
  return mpfr_sgn(low.backend().data()) >= 0;
}

/// An end of a bounded set as an exact ball of its precision, rounded outward.
[[nodiscard]] inline ball lower_end(const ball& x) { return x.is_exact() ? x : ball(lower(x)); }
[[nodiscard]] inline ball upper_end(const ball& x) { return x.is_exact() ? x : ball(upper(x)); }

/// The range of f over balls where f is monotone in every argument in the given direction: 1 or -1.
/// f is called with numbers. Where that is undefined at a corner, so is the result.
template <std::size_t Count, class F>
[[nodiscard]] ball monotone_range(const std::array<ball, Count>& x,
                                  const std::array<int, Count>& direction, precision p,
                                  const F& f) {
  bool exact = true;
  for (const ball& argument : x) exact = exact && argument.is_exact();
  if (exact) return f(x);
  std::array<ball, Count> at_least;
  std::array<ball, Count> at_most;
  for (std::size_t i = 0; i < Count; ++i) {
    at_least[i] = direction[i] > 0 ? lower_end(x[i]) : upper_end(x[i]);
    at_most[i] = direction[i] > 0 ? upper_end(x[i]) : lower_end(x[i]);
  }
  const ball low = f(at_least);
  const ball high = f(at_most);
  if (low.is_undefined() || high.is_undefined()) return ball::undefined(p);
  return hull(low, high);
}

/// The greatest of the relative radii, or infinity where a set may hold 0 and is no number.
template <std::size_t Count>
[[nodiscard]] magnitude greatest_relative_radius(const std::array<ball, Count>& x) {
  magnitude greatest;
  for (const ball& argument : x) {
    if (argument.is_exact()) continue;
    if (!argument.is_bounded()) return magnitude::infinity();
    const ball middle = argument.middle();
    greatest = max(greatest, divide_up(argument.radius(), middle.magnitude_lower()));
  }
  return greatest;
}

/// monotone_range for a homogeneous f > 0 of degree -1/2, 1/2 (then steepness is 1) or -3/2 (then
/// it is 3). Where all relative radii are at most r, f lies between its values at (1+r) and (1-r)
/// times the middles m, which are (1+-r)^degree f(m), and so within steepness r f(m) of f(m) for r
/// <= 1/4: the functions (1-r)^degree are convex (for degree < 0) or below 1+r, and 2^... at r =
/// 1/4: (3/4)^(-1/2) < 1 + 1/4, (3/4)^(-3/2) < 1 + 3/4. One value then serves narrow balls.
template <std::size_t Count, class F>
[[nodiscard]] ball homogeneous_range(const std::array<ball, Count>& x,
                                     const std::array<int, Count>& direction,
                                     std::uint64_t steepness, precision p, const F& f) {
  const magnitude r = greatest_relative_radius(x);
  if (!r.is_zero() && r <= magnitude::power_of_two(std::min<long>(10 - p, -2))) {
    std::array<ball, Count> middles;
    for (std::size_t i = 0; i < Count; ++i) middles[i] = x[i].middle();
    const ball value = f(middles);
    return value.enlarged(multiply_up(multiply_up(r, magnitude::from_integer_up(steepness)),
                                      value.magnitude_upper()));
  }
  return monotone_range(x, direction, p, f);
}

}  // namespace polhode::detail
