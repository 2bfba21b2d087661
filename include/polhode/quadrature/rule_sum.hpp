#pragma once

// What the sums of the quadrature rules have in common.

#include <concepts>
#include <type_traits>

#include "polhode/arithmetic/scalar.hpp"

namespace polhode {

/// A function of a scalar that answers with a scalar of the same type. (A lambda that returns what an operator
/// of mpfr_float returns, an expression of references to its argument, is none: let it say `-> T`.)
template <class F, class T>
concept function_on = scalar<T> && requires(const F& f, const T& x) {
  { f(x) } -> std::same_as<T>;
};

namespace detail {

/// sum += weight * value, rounded once.
inline void accumulate(ball& sum, const ball& weight, const ball& value) {
  fma(sum, weight, value, sum);
}
inline void accumulate(mpfr_float& sum, const mpfr_float& weight, const mpfr_float& value) {
  mpfr_fma(sum.backend().data(), weight.backend().data(), value.backend().data(),
           sum.backend().data(), MPFR_RNDN);
}

/// The set as a scalar: itself, or the number in its middle.
template <scalar T>
[[nodiscard]] decltype(auto) scalar_of(const ball& x) {
  if constexpr (std::same_as<T, ball>) {
    return (x);
  } else {
    return midpoint(x);
  }
}

}  // namespace detail
}  // namespace polhode
