#pragma once

// Messages about three numbers that should be moments of inertia.

#include <array>
#include <string>

#include "polhode/arithmetic/text.hpp"

namespace polhode::detail {

/// "3, 2, 1".
[[nodiscard]] inline std::string listed(const std::array<rational, 3>& x) {
  return to_text(x[0]) + ", " + to_text(x[1]) + ", " + to_text(x[2]);
}

/// Throws input_error.
inline void refuse_unless_positive(const std::array<rational, 3>& moments) {
  for (const rational& moment : moments) {
    if (moment > 0) continue;
    throw input_error("moments of inertia " + listed(moments) + ": " + to_text(moment) +
                      " is not positive; all three must be");
  }
}

}  // namespace polhode::detail
