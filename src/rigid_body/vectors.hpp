#pragma once

// Products of vectors in space.

#include "polhode/rigid_body/exact_rotation.hpp"

namespace polhode::detail {

/// S: T, or what is multiplied with one.
template <class S, class T>
[[nodiscard]] T dot(const triple<S>& x, const triple<T>& y) {
  return T(x[0] * y[0] + x[1] * y[1] + x[2] * y[2]);
}

template <class T>
[[nodiscard]] triple<T> cross(const triple<T>& x, const triple<T>& y) {
  return {x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
}

}  // namespace polhode::detail
