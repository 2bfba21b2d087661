#pragma once

// How a generic function, f(x) for x of any type, is called with one type and gives a value of that
// type.

#include <concepts>
#include <type_traits>
#include <utility>

#include "polhode/arithmetic/ball.hpp"
#include "polhode/arithmetic/jet.hpp"
#include "polhode/arithmetic/region.hpp"

namespace polhode::detail {

/// f's function object for arguments of type T with p bits: what f.evaluator<T>(p) makes for the
/// purpose, its constants made once, where f has that member; else f itself.
template <class T, class F>
[[nodiscard]] auto evaluator_of(const F& f, precision p) {
  if constexpr (requires { f.template evaluator<T>(p); }) {
    return f.template evaluator<T>(p);
  } else {
    return f;
  }
}

/// The value of f as a T, also where f is constant and answers with a number: then a constant as
/// precise as `like`, and of its order. A type that needs more than precision(), or a constructor
/// from a number, has a member constant_like.
template <class T, class V>
[[nodiscard]] T value_as(V&& value, const T& like) {
  if constexpr (std::same_as<std::remove_cvref_t<V>, T>) {
    return std::forward<V>(value);
  } else if constexpr (is_jet<T>::value) {
    using coefficient = std::remove_cvref_t<decltype(like[0])>;
    return T::constant(value_as<coefficient>(value, like[0]), like.order());
  } else if constexpr (std::same_as<T, region>) {
    return constant_region(value, like);
  } else if constexpr (requires { like.constant_like(value); }) {
    return like.constant_like(value);
  } else if constexpr (requires { T(value, like.precision()); }) {
    return T(value, like.precision());
  } else {
    return T(value);
  }
}

}  // namespace polhode::detail
