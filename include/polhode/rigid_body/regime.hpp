#pragma once

// The kinds of free rotation. The angular momentum J and the energy H enter as c = 2 I_y H/J^2 - 1,
// which is -J_x^2/J^2 b + J_z^2/J^2 a and so lies in [-b, a].

#include <string>

#include "polhode/rigid_body/body.hpp"

namespace polhode {

/// Of a body with two or three equal moments an equilibrium may be about any axis of their plane or
/// about any axis at all: it is equilibrium_x for c = -b, and else equilibrium_z.
enum class regime {
  equilibrium_x,  // c = -b: the body turns about the axis of its greatest moment
  oscillating,    // -b < c < 0: J goes around the axis of the greatest moment
  separatrix,     // c = 0: J goes from one unstable equilibrium to the other, and takes for ever
  rotating,       // 0 < c < a: J goes around the axis of the least moment
  equilibrium_z,  // c = a: it turns about the axis of its least moment
  equilibrium_y   // c = 0 and J exactly along the intermediate axis: only the state tells
};

/// Decided exactly: in rationals, where these are. For c = 0 the separatrix, never equilibrium_y.
/// Throws input_error for c outside [-b, a].
[[nodiscard]] regime regime_of(const body& rigid, const exact_real& c);

/// Whether J goes around in the body, in a finite time: oscillating or rotating.
[[nodiscard]] constexpr bool is_periodic(regime r) {
  return r == regime::oscillating || r == regime::rotating;
}
/// Whether J stays where it is in the body.
[[nodiscard]] constexpr bool is_equilibrium(regime r) {
  return r == regime::equilibrium_x || r == regime::equilibrium_y || r == regime::equilibrium_z;
}
/// Whether J goes around the axis x, or stays on it: c < 0.
[[nodiscard]] constexpr bool is_about_x(regime r) {
  return r == regime::oscillating || r == regime::equilibrium_x;
}

/// "oscillating", "equilibrium about x", ...
[[nodiscard]] std::string to_text(regime r);

}  // namespace polhode
