#pragma once

// Where a point lies, beside a box whose ends are rational or infinite.

#include <cstdint>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/roots/systems.hpp"

namespace polhode::detail {

enum class place : std::uint8_t { inside, outside, undecided };

/// Of one coordinate.
[[nodiscard]] inline place place_of(const rational& x, const system_side& side) {
  const auto& [low, high] = side;
  return (low && x < *low) || (high && x > *high) ? place::outside : place::inside;
}
[[nodiscard]] inline place place_of(const ball& x, const system_side& side) {
  const auto& [low, high] = side;
  const precision p = x.precision() + 64;
  if ((low && certainly_less(x, ball(*low, p))) || (high && certainly_less(ball(*high, p), x))) {
    return place::outside;
  }
  const bool is_inside = (!low || certainly_less_equal(ball(*low, p), x)) &&
                         (!high || certainly_less_equal(x, ball(*high, p)));
  return is_inside ? place::inside : place::undecided;
}

/// T: ball or rational.
template <class T>
[[nodiscard]] place place_of(const std::vector<T>& x, const system_box& box) {
  place result = place::inside;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const place here = place_of(x[i], box[i]);
    if (here == place::outside) return here;
    if (here == place::undecided) result = here;
  }
  return result;
}

}  // namespace polhode::detail
