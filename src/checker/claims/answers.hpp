#pragma once

// Answers to questions about intervals: yes, no, or not known at this precision.

#include <initializer_list>
#include <optional>

#include "checker/real.hpp"

namespace polhode::checker {

using tri = std::optional<bool>;

inline interval exactly(const real& x, precision bits) { return x.at(bits); }

/// x < y: true, false, or not known.
[[nodiscard]] inline tri below(const interval& x, const interval& y) {
  if (is_below(x, y)) return true;
  if (is_below(y, x)) return false;
  return std::nullopt;
}

/// True where all are true, false where one is false.
[[nodiscard]] inline tri all_of(std::initializer_list<tri> answers) {
  bool known = true;
  for (const tri& answer : answers) {
    if (answer && !*answer) return false;
    known = known && answer.has_value();
  }
  return known ? tri(true) : std::nullopt;
}

}  // namespace polhode::checker
