#pragma once

// The frame of the principal axes about J, from the values of theta functions.

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "rigid_body/rotor_scalars.hpp"
#include "rigid_body/vectors.hpp"

namespace polhode::detail {

template <class T>
T negated_if(bool negative, const T& x) {
  return negative ? T(-x) : x;
}

/// J/|J| in the principal axes, x and y over `across` of prepared.
template <class T>
triple<T> direction(const triple<T>& amplitude, regime kind, const theta_point<T>& at, bool odd) {
  const bool oscillating = kind == regime::oscillating;
  const T cn = negated_if(odd, at.cn);
  const T sn = negated_if(odd, at.sn);
  return {T(amplitude[0] * (oscillating ? at.dn : cn)), T(amplitude[1] * sn),
          T(amplitude[2] * (oscillating ? cn : at.dn))};
}

/// {x, y} over their length, and {0, 1} where both are 0: there a long double has nothing left of
/// them.
template <class T>
std::array<T, 2> unit_vector(T x, T y) {
  if constexpr (std::floating_point<T>) {
    // Squares must not be lost.
    constexpr T tiny = std::numeric_limits<T>::min() /
                       (std::numeric_limits<T>::epsilon() * std::numeric_limits<T>::epsilon());
    if (square_of(x) + square_of(y) < tiny) {
      const T greatest = std::max(std::abs(x), std::abs(y));
      if (!(greatest > 0)) return {0, 1};
      x /= greatest;
      y /= greatest;
    }
  }
  const T length = T(1 / root_of(T(square_of(x) + square_of(y))));
  return {T(x * length), T(y * length)};
}

/// R_z(Phi) R_y(theta) R_z(psi), which takes principal axes to axes of which the third is along J;
/// Phi = angle - atan2(x, y). J/|J| is (across j_0, across j_1, j_2).
template <class T>
matrix3<T> frame(const triple<T>& j, const T& across, const std::pair<T, T>& angle, const T& x,
                 const T& y) {
  const auto [sx, cx] = unit_vector(x, y);
  const auto& [s, c] = angle;
  const T cos_phi = T(c * cx + s * sx);
  const T sin_phi = T(s * cx - c * sx);
  T cos_psi = whole<T>(1, bits_in(x));
  T sin_psi = whole<T>(0, bits_in(x));
  T sin_theta = sin_psi;
  if (!is_zero_number(j[0]) || !is_zero_number(j[1])) {
    sin_theta = T(across * root_of(T(square_of(j[0]) + square_of(j[1]))));
    const auto [sine, cosine] = unit_vector(j[1], T(-j[0]));
    sin_psi = sine;
    cos_psi = cosine;
  }
  const T first = T(j[2] * cos_psi);
  const T second = T(-j[2] * sin_psi);
  return {{{T(cos_phi * first - sin_phi * sin_psi), T(cos_phi * second - sin_phi * cos_psi),
            T(cos_phi * sin_theta)},
           {T(sin_phi * first + cos_phi * sin_psi), T(sin_phi * second + cos_phi * cos_psi),
            T(sin_phi * sin_theta)},
           {T(across * j[0]), T(across * j[1]), j[2]}}};
}

template <class T>
T dot(const triple<T>& x, const matrix3<T>& m, std::size_t column) {
  return T(x[0] * m[0][column] + x[1] * m[1][column] + x[2] * m[2][column]);
}

/// sin and cos of 2 pi times the fraction. In long double the fraction is reduced to an eighth of a
/// turn first, exactly: a difference of numbers of which one is a multiple of 1/4 and at most 1/8
/// away. The library's own functions would reduce the angle, which costs as much again.
template <class T>
std::pair<T, T> of_turns(const T& fraction) {
  if constexpr (std::floating_point<T>) {
    const T quarters = std::nearbyint(4 * fraction);
    const auto [sine, cosine] =
        sine_cosine(T(scaled(pi_of<T>(bits_in(fraction)), 1) * (fraction - quarters / 4)));
    switch (static_cast<int>(quarters) & 3) {
      case 0:
        return {sine, cosine};
      case 1:
        return {cosine, -sine};
      case 2:
        return {-sine, -cosine};
      default:
        return {-cosine, sine};
    }
  }
  return sine_cosine(T(scaled(pi_of<T>(bits_in(fraction)), 1) * fraction));
}

template <class T>
theta_point<T> steady_point(precision bits) {
  const T zero = constant<T>(0, bits);
  return {zero, zero, zero, zero, constant<T>(1, bits)};
}

}  // namespace polhode::detail
