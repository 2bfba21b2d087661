#pragma once

// From balls to the scalars of a rotor: the ball itself with so many bits, or its middle.

#include <vector>

#include "polhode/rigid_body/rotor.hpp"
#include "rigid_body/rotor_series.hpp"

namespace polhode::detail {

template <rotor_scalar T>
[[nodiscard]] T as_scalar(const ball& x, precision bits) {
  if constexpr (std::same_as<T, ball>) {
    return x.with_precision(bits);
  } else if constexpr (std::same_as<T, mpfr_float>) {
    return midpoint(x.with_precision(bits));
  } else if constexpr (std::same_as<T, long double>) {
    return mpfr_get_ld(midpoint(x).backend().data(), MPFR_RNDN);
  } else {
    return mpfr_get_d(midpoint(x).backend().data(), MPFR_RNDN);
  }
}

template <class T>
triple<T> as_scalars(const triple<ball>& x, precision bits) {
  return {as_scalar<T>(x[0], bits), as_scalar<T>(x[1], bits), as_scalar<T>(x[2], bits)};
}
template <class T>
matrix3<T> as_scalars(const matrix3<ball>& x, precision bits) {
  return {as_scalars<T>(x[0], bits), as_scalars<T>(x[1], bits), as_scalars<T>(x[2], bits)};
}
template <class T>
std::vector<T> as_scalars(const std::vector<ball>& x, precision bits) {
  std::vector<T> result;
  result.reserve(x.size());
  for (const ball& one : x) result.push_back(as_scalar<T>(one, bits));
  return result;
}
template <class T>
theta_series<T> as_scalars(const theta_series<ball>& x, precision bits) {
  theta_series<T> r;
  r.hyperbolic = x.hyperbolic;
  r.scale = as_scalar<T>(x.scale, bits);
  r.nome = as_scalar<T>(x.nome, bits);
  r.odd = as_scalars<T>(x.odd, bits);
  r.even = as_scalars<T>(x.even, bits);
  r.lag_sine = as_scalars<T>(x.lag_sine, bits);
  r.lag_cosine = as_scalars<T>(x.lag_cosine, bits);
  r.odd_tail = x.odd_tail;
  r.even_tail = x.even_tail;
  r.lag_sine_tail = x.lag_sine_tail;
  r.lag_cosine_tail = x.lag_cosine_tail;
  return r;
}

[[nodiscard]] inline bool is_zero_number(const ball& x) { return x.is_exact() && contains_zero(x); }
[[nodiscard]] inline bool is_zero_number(const mpfr_float& x) { return sign_in(x) == 0; }
[[nodiscard]] inline bool is_zero_number(long double x) { return sign_in(x) == 0; }

}  // namespace polhode::detail
