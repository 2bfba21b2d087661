#pragma once

#include "polhode/arithmetic/text.hpp"

namespace polhode::detail {

/// Whether x, printed to so many digits, shows them all.
[[nodiscard]] inline bool has_digits(const ball& x, long digits) {
  if (!x.is_bounded()) return false;
  return to_decimal_enclosure(x, digits).has(digits);
}

}  // namespace polhode::detail
