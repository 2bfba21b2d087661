#pragma once

// Points of a box at which a function may be known exactly.

#include <optional>

#include "polhode/arithmetic/multiple_of_pi.hpp"
#include "state.hpp"

namespace polhode::detail {

[[nodiscard]] inline exact_box exact_ends(const ball& x) {
  return {lower_rational(x), upper_rational(x)};
}

/// False where x is undefined.
[[nodiscard]] inline bool is_certainly_not_zero(const ball& x) {
  return !x.is_undefined() && !contains_zero(x);
}

/// The simplest rational number in the bounded box; nothing where its parts are long.
[[nodiscard]] std::optional<rational> simple_number_in(const exact_box& b);
/// The simplest rational r for which r pi is in the bounded box; nothing where its parts are long.
[[nodiscard]] std::optional<rational> simple_multiple_of_pi_in(const exact_box& b, precision bits);

/// The first answer, which is an optional, that f gives for one of these two points.
template <class F>
[[nodiscard]] auto first_of_simple_points(const exact_box& b, precision bits, const F& f)
    -> decltype(f(pi_combination{})) {
  if (const auto q = simple_number_in(b)) {
    if (auto r = f(pi_combination{*q, 0})) return r;
  }
  const auto turns = simple_multiple_of_pi_in(b, bits);
  return turns ? f(pi_combination{0, *turns}) : std::nullopt;
}

}  // namespace polhode::detail
