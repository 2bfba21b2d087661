#pragma once

// For tests of the checker's parts: a budget that nothing passes.

#include <limits>

#include "checker/budget.hpp"

namespace polhode::checker {

inline budget& generous() {
  static budget all({std::numeric_limits<long>::max(), std::numeric_limits<long>::max()});
  return all;
}
inline precision at_bits(long bits) { return {bits, generous()}; }

}  // namespace polhode::checker
