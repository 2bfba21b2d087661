#pragma once

// Generic functions as formulas: a function is called once with symbols (symbol.hpp), which record
// what it does.
//
//   const expression f = formula_of([](auto x) { return exp(-x * x) / (1 + x / 3); });
//   const integral i = integrate(f, 0, 1, {.digits = 50});

#include <concepts>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "polhode/expression/expression.hpp"
#include "polhode/expression/symbol.hpp"

namespace polhode {

/// The formula of a symbol in the variables of these names, with the functions of
/// docs/expressions.md and docs/elliptic.md. Throws input_error where it is certainly undefined.
[[nodiscard]] expression formula_of(const symbol& s, const std::vector<std::string>& variables);

namespace detail {

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
  if constexpr (of_one_signature<F> || std::is_function_v<std::remove_pointer_t<F>>) {
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

/// What a function of symbols returned: where it is a constant, a number. Throws input_error for a
/// double that is not the decimal it looks like.
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

/// A generic function of one argument as a formula in x. It is called once, with a symbol; or with
/// a machine_symbol<R>, beside which numbers of type R stand.
template <class Symbol = symbol, class F>
requires std::derived_from<Symbol, symbol>
[[nodiscard]] expression formula_of(const F& f) {
  if constexpr (detail::expect_generic<F, Symbol, symbol>()) {
    return formula_of(detail::symbol_of(f(Symbol(symbol::variable(0)))), {"x"});
  } else {
    throw input_error("not a generic function");  // refused above, or by the compiler in its body
  }
}

/// The formula of a symbol in z; and in i, the imaginary unit, where it has complex numbers.
[[nodiscard]] expression complex_formula_of(const symbol& s);

/// A generic function of one complex argument as such a formula.
template <class Symbol = symbol, class F>
[[nodiscard]] expression complex_formula_of(const F& f) {
  if constexpr (detail::expect_generic<F, Symbol, symbol>()) {
    return complex_formula_of(detail::symbol_of(f(Symbol(symbol::variable(0)))));
  } else {
    throw input_error("not a generic function");  // refused above, or by the compiler in its body
  }
}

namespace detail {
/// x1, x2, ...
[[nodiscard]] std::vector<std::string> numbered_names(const std::string& name, std::size_t count);
}  // namespace detail

/// A generic function of x and of a std::vector of parameters as a formula in x, p1, p2, ...
template <class F>
[[nodiscard]] expression formula_with_parameters(const F& f, std::size_t parameters) {
  std::vector<symbol> p;
  for (std::size_t i = 0; i < parameters; ++i) p.push_back(symbol::variable(i + 1));
  std::vector<std::string> names = detail::numbered_names("p", parameters);
  names.insert(names.begin(), "x");
  return formula_of(detail::symbol_of(f(symbol::variable(0), std::as_const(p))), names);
}

/// A generic function of a std::vector, which returns a range, as formulas in x1, x2, ..., one for
/// each component. It is called once, with symbols of that type.
template <class Symbol = symbol, class F>
[[nodiscard]] std::vector<expression> formulas_of(const F& f, std::size_t variables) {
  using arguments = std::vector<Symbol>;
  std::vector<expression> result;
  if (variables == 0) return result;  // f may take its first variable for granted
  if constexpr (detail::expect_generic<F, arguments>()) {
    arguments x;
    for (std::size_t i = 0; i < variables; ++i) x.emplace_back(symbol::variable(i));
    const auto values = f(std::as_const(x));
    const std::vector<std::string> names = detail::numbered_names("x", variables);
    for (const auto& value : values) result.push_back(formula_of(detail::symbol_of(value), names));
  }
  return result;
}

}  // namespace polhode
