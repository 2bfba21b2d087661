#pragma once

// What is known of a zero once it is proved.

#include "polhode/arithmetic/ball.hpp"

namespace polhode::detail {

/// A zero y of q in `square`, and q'(y) in slope / scale.
struct legendre_zero {
  ball square;
  ball slope;
  ball scale;
};

}  // namespace polhode::detail
