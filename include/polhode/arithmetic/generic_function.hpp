#pragma once

// How a generic function, f(x) for x of any type, is called with one type and gives a value of that type. Integrals, roots and
// formulas all call functions so.

#include <concepts>
#include <type_traits>
#include <utility>

#include "polhode/arithmetic/ball.hpp"
#include "polhode/arithmetic/jet.hpp"
#include "polhode/arithmetic/region.hpp"

namespace polhode::detail {

/// f's function object for arguments of type T with p bits: what f.evaluator<T>(p) makes for the purpose, its constants made once,
/// where f has that member; else f itself.
template <class T, class F>
[[nodiscard]] auto evaluator_of(const F& f, precision p) {
  if constexpr (requires { f.template evaluator<T>(p); }) {
    return f.template evaluator<T>(p);
  } else {
    return f;
  }
}

/// A function object of one signature: its operator() is no template and not overloaded.
template <class F>
concept of_one_signature = requires {
  &F::operator();
};

/// Refuses, when it is compiled, what is no generic function of one number. Returns whether f can
/// be called with an Argument; where the body of a generic function does not compile, the compiler
/// has said so. Base is what Argument stands for, where it also converts to machine numbers.
template <class F, class Argument, class Base = Argument>
constexpr bool expect_generic() {
  if constexpr (requires(const F& f) { f.template evaluator<Argument>(precision{64}); }) {
    return true;
  } else if constexpr (of_one_signature<F> || std::is_function_v<std::remove_pointer_t<F>>) {
    static_assert(
        std::is_invocable_v<F&, const Base&>,
        "Polhode: this function takes numbers of one type only, so that what it does with "
        "them cannot be seen and nothing can be proved. Write [](auto x) { ... }; or call "
        "estimate(f, a, b), which proves nothing");
    return std::is_invocable_v<const F&, const Base&>;
  } else {
    constexpr bool is_const = std::is_invocable_v<const F&, const Argument&>;
    static_assert(is_const || !std::is_invocable_v<F&, const Argument&>,
                  "Polhode: this function changes when it is called (a mutable lambda). A function "
                  "to be proved gives the "
                  "same value for the same argument: leave out mutable");
    return is_const;
  }
}

/// The value of f as a T, also where f is constant and answers with a number: then a constant as precise as `like`, and of its order. A type
/// that needs more than precision(), or a constructor from a number, has a member constant_like.
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
