#pragma once

// The kinds of free rotation. The angular momentum J and the energy H enter as c = 2 I_y H/J^2 - 1, which is
// -J_x^2/J^2 b + J_z^2/J^2 a and so lies in [-b, a].

#include <string>

#include "polhode/rigid_body/body.hpp"

namespace polhode {

enum class regime {
  equilibrium_x,  // c = -b: the body turns about the axis of its greatest moment
  oscillating,    // -b < c < 0
  separatrix,     // c = 0, with the unstable equilibrium about the intermediate axis
  rotating,       // 0 < c < a
  equilibrium_z   // c = a: it turns about the axis of its least moment
};

/// Decided in rationals. Throws input_error for c outside [-b, a].
[[nodiscard]] regime regime_of(const body& rigid, const rational& c);

/// "oscillating", "equilibrium about x", ...
[[nodiscard]] std::string to_text(regime r);

}  // namespace polhode
