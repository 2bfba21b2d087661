#pragma once

// Products of matrices and of a matrix with a vector, for any scalar.

#include "polhode/rigid_body/rotor.hpp"

namespace polhode::detail {

template <class T>
[[nodiscard]] matrix3<T> product(const matrix3<T>& x, const matrix3<T>& y) {
  matrix3<T> result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k)
      result[i][k] = x[i][0] * y[0][k] + x[i][1] * y[1][k] + x[i][2] * y[2][k];
  }
  return result;
}
template <class T>
[[nodiscard]] matrix3<T> transposed(const matrix3<T>& x) {
  matrix3<T> result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) result[i][k] = x[k][i];
  }
  return result;
}
template <class T>
[[nodiscard]] triple<T> product(const matrix3<T>& x, const triple<T>& v) {
  triple<T> result;
  for (std::size_t i = 0; i < 3; ++i) result[i] = x[i][0] * v[0] + x[i][1] * v[1] + x[i][2] * v[2];
  return result;
}

}  // namespace polhode::detail
