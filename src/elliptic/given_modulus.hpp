#pragma once

// The modulus and the working precision of an elliptic function over balls.

#include <algorithm>

#include "elliptic/legendre_points.hpp"
#include "polhode/arithmetic/ball.hpp"
#include "polhode/elliptic/parameter.hpp"

namespace polhode::detail {

using ball_parameter = elliptic_parameter<ball>;

[[nodiscard]] inline precision precision_for(const ball& x, const ball_parameter& m) {
  return std::max(x.precision(), m.given().precision());
}
/// x with q bits, or with its own where they are more.
[[nodiscard]] inline ball raised_ball(const ball& x, precision q) {
  return x.with_precision(std::max(q, x.precision()));
}
[[nodiscard]] inline modulus<ball> modulus_at(const ball& given, const ball_parameter& m,
                                              precision q) {
  return modulus_of(given, m.is_complement(), std::max(q, given.precision()));
}

}  // namespace polhode::detail
