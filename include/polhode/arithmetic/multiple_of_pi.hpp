#pragma once

// Rational multiples of pi.

#include <optional>

#include "polhode/arithmetic/ball.hpp"
#include "polhode/arithmetic/boost_bridge.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/exact.hpp"

namespace polhode::detail {

/// The r with the least denominator for which r pi lies between two numbers, as far as p bits of pi
/// show; none where they show no such r, or r = 0.
[[nodiscard]] inline std::optional<rational> simplest_multiple_of_pi(const rational& low,
                                                                     const rational& high,
                                                                     precision p) {
  const rational lower = upper_rational(ball(low, p) / pi(p));
  const rational upper = lower_rational(ball(high, p) / pi(p));
  if (lower > upper) return std::nullopt;
  rational r = simplest_between(lower, upper);
  return r == 0 ? std::nullopt : std::optional(std::move(r));
}

}  // namespace polhode::detail
