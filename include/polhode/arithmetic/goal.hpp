#pragma once

#include <cmath>
#include <optional>

#include "polhode/arithmetic/ball.hpp"
#include "polhode/arithmetic/complex_ball.hpp"

namespace polhode {

/// How narrow an enclosure is to be: a radius of at most 10^-digits of the value, or, if that is
/// given too, one of at most 2^absolute_exponent.
struct goal {
  long digits = 15;
  std::optional<long> absolute_exponent = std::nullopt;

  /// An enclosure with this radius of a number that is at least `size` in absolute value meets the
  /// goal.
  [[nodiscard]] bool is_met(const magnitude& radius, const magnitude& size) const {
    if (radius.is_infinite()) return false;
    if (absolute_exponent && radius <= magnitude::power_of_two(*absolute_exponent)) return true;
    return multiply_up(radius, pow(ball(10, 64), digits).magnitude_upper()) <= size;
  }
  [[nodiscard]] bool is_met_by(const ball& x) const {
    return is_met(x.radius(), x.magnitude_lower());
  }
  /// In both parts, relative to the absolute value.
  [[nodiscard]] bool is_met_by(const complex_ball& z) const {
    return is_met(max(z.re.radius(), z.im.radius()), z.magnitude_lower());
  }
  /// log2 of 10^digits, to search with.
  [[nodiscard]] double log2_relative() const {
    return static_cast<double>(digits) * std::log2(10.0);
  }
};

}  // namespace polhode
