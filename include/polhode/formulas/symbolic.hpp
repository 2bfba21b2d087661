#pragma once

// Generic functions as formulas: what a function does is recorded by calling it once with symbols (expression/symbol.hpp).
//
//   const expression f = formula_of([](auto x) { return exp(-x * x) / (1 + x / 3); });
//   const integral i = integrate(f, 0, 1, {.digits = 50});

#include <concepts>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "polhode/arithmetic/generic_function.hpp"
#include "polhode/expression/expression.hpp"
#include "polhode/expression/symbol.hpp"

namespace polhode {

/// The formula of a symbol in the variables of these names, with the functions of docs/expressions.md and docs/elliptic.md. Throws
/// input_error where it is certainly undefined.
[[nodiscard]] expression formula_of(const symbol& s, const std::vector<std::string>& variables);

namespace detail {

/// What a function of symbols returned: where it is a constant, a number. Throws input_error for a double that is not the decimal it looks like.
template <class V>
[[nodiscard]] symbol symbol_of(const V& value) {
  if constexpr (std::floating_point<V>) {
    if (!exact_double::is_exact(static_cast<double>(value)) ||
        static_cast<V>(static_cast<double>(value)) != value) {
      throw input_error("the function is the constant " + std::to_string(value) +
                        ", a double that is not the decimal it looks like; write \"0.1\"_r or "
                        "rational(1, 10) for 0.1");
    }
    return symbol(rational(static_cast<double>(value)));
  } else {
    return symbol(value);
  }
}

}  // namespace detail

/// What a generic function of one argument does, as a formula in x. It is called once, with a symbol; or with a
/// machine_symbol<R>, beside which numbers of type R stand.
template <class Symbol = symbol, class F>
requires std::derived_from<Symbol, symbol>
[[nodiscard]] expression formula_of(const F& f) {
  if constexpr (detail::expect_generic<F, Symbol, symbol>()) {
    return formula_of(detail::symbol_of(f(Symbol(symbol::variable(0)))), {"x"});
  } else {
    throw input_error("not a generic function");  // refused above, or by the compiler in its body
  }
}

}  // namespace polhode
