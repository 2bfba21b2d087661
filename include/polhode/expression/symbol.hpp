#pragma once

// A formula made by calling a generic function once.
//
//   // formula_of is in expression/formula_of.hpp:
//   const expression f = formula_of([](auto x) { return exp(-x * x) / (1 + x / 3); });
//
// A symbol stands for a number that is not known yet. Operators and the functions of the table
// (function_table.hpp) applied to symbols give symbols, until the function returns one; what it did
// is then an expression, with all that the library knows of those. Beside symbols stand exact
// numbers: whole numbers, rationals ("0.1"_r), double literals that are what they look like (0.5),
// and Boost's floating-point numbers, each as the exact number that it is. A double variable is
// refused when it is compiled, but beside a machine_symbol<double>, which integrate<double> and its
// like call the function with. A ball stands for a number in it; where it is used twice, for two
// numbers that may differ, unless a symbol is made of it once. A complex ball stands for a complex
// number.
//
// A function cannot branch on a symbol: comparisons do not compile, with a sentence that says what
// to write.

#include <concepts>
#include <cstddef>
#include <memory>
#include <optional>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <boost/multiprecision/number.hpp>

#include "polhode/arithmetic/ball.hpp"
#include "polhode/arithmetic/complex_ball.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "polhode/arithmetic/exact_formula.hpp"
#include "polhode/expression/exact_literal.hpp"
#include "polhode/expression/function_table.hpp"

namespace polhode {

namespace detail {

/// A number of Boost's with a floating point, whatever its backend.
template <class N>
concept boost_real = boost::multiprecision::is_number<N>::value &&
                         boost::multiprecision::number_category<N>::value ==
                         boost::multiprecision::number_kind_floating_point &&
                     !boost::multiprecision::is_interval_number<N>::value;

/// What an operator of Boost's numbers returns: an expression of references to its operands.
template <class N>
concept boost_expression = boost::multiprecision::is_number_expression<N>::value;

template <class>
inline constexpr bool never_true = false;

struct symbol_node;

}  // namespace detail

class symbol {
 public:
  /// 0.
  symbol() : symbol(0) {}
  template <machine_integer N>
  symbol(N n)  // NOLINT(google-explicit-constructor): exact
      : symbol(rational(n)) {}
  template <std::same_as<integer> N>
  symbol(const N& n)  // NOLINT(google-explicit-constructor): exact
      : symbol(rational(n)) {}
  /// Of a rational alone: a double would become one in silence.
  template <std::same_as<rational> Q>
  symbol(const Q& q)  // NOLINT(google-explicit-constructor): exact
      : symbol(of_number(q)) {}
  symbol(const rational_literal& q)  // NOLINT(google-explicit-constructor): exact
      : symbol(q.value()) {}
  symbol(exact_double x)  // NOLINT(google-explicit-constructor): exact
      : symbol(rational(x.value())) {}
  /// The number that x is. Throws input_error where it is infinite or a NaN.
  template <detail::boost_real N>
  symbol(const N& x)  // NOLINT(google-explicit-constructor): exact
      : symbol(exactly(x)) {}
  template <detail::boost_expression N>
  symbol(const N& x)  // NOLINT(google-explicit-constructor): exact
      : symbol(typename N::result_type(x)) {}

  /// A number in the ball; exactly the ball where that is one short number. Two symbols made of one
  /// ball may be different numbers in it.
  template <std::same_as<ball> B>
  symbol(const B& x)  // NOLINT(google-explicit-constructor): a number in the set
      : symbol(in_ball(x)) {}
  /// The same of a complex number: formulas of a complex argument may have it (complex_formula_of).
  template <std::same_as<complex_ball> B>
  symbol(const B& z)  // NOLINT(google-explicit-constructor): a number in the set
      : symbol(in_complex_ball(z)) {}

  /// The i-th variable, counted from 0.
  [[nodiscard]] static symbol variable(std::size_t i);
  /// The variable by the name of i in formulas of a complex argument.
  [[nodiscard]] static symbol imaginary_unit();
  /// A constant of formulas by its name: "pi", "e", "euler_gamma", "catalan".
  [[nodiscard]] static symbol constant(std::string_view name);
  /// A function of formulas by its name. The name has to live as long as the program: a literal.
  [[nodiscard]] static symbol call(std::string_view function, std::vector<symbol> operands);

  friend symbol operator-(const symbol& x) { return call("-", {x}); }
  friend const symbol& operator+(const symbol& x) { return x; }
  symbol& operator+=(const symbol& y) { return *this = call("+", {*this, y}); }
  symbol& operator-=(const symbol& y) { return *this = call("-", {*this, y}); }
  symbol& operator*=(const symbol& y) { return *this = call("*", {*this, y}); }
  symbol& operator/=(const symbol& y) { return *this = call("/", {*this, y}); }

  [[nodiscard]] const detail::symbol_node& node() const { return *node_; }

 protected:
  [[noreturn]] static void refuse_infinite();

 private:
  friend struct detail::symbol_node;
  explicit symbol(std::shared_ptr<detail::symbol_node> node) : node_(std::move(node)) {}
  template <class N>
  static rational exactly(const N& x) {
    if (!(boost::multiprecision::isfinite)(x)) refuse_infinite();
    return rational(x);
  }
  static symbol of_number(const rational& q);
  static symbol in_ball(const ball& x);
  static symbol in_complex_ball(const complex_ball& z);

  std::shared_ptr<detail::symbol_node> node_;
};

/// The formula as a symbol.
[[nodiscard]] symbol symbol_of(const exact_formula& x);

namespace detail {

/// How a symbol came about: a number, an enclosed number, a variable, or what `name` names (an
/// operator, a function, a constant) of operands.
struct symbol_node {
  std::string_view name;  // empty for a number and a variable
  rational number;
  std::size_t variable = no_variable;
  std::optional<ball> enclosure;  // of a number of which nothing else is known
  std::vector<symbol> operands;

  static constexpr std::size_t no_variable = static_cast<std::size_t>(-1);
  static constexpr std::size_t imaginary_unit = no_variable - 1;
  symbol_node() = default;
  symbol_node(const symbol_node&) = delete;
  symbol_node& operator=(const symbol_node&) = delete;
  ~symbol_node();
};

template <class X>
concept is_symbol = std::same_as<std::remove_cvref_t<X>, symbol>;

}  // namespace detail

/// A symbol beside which a variable of type R stands for the number that it is: for R = double or
/// long double, whose functions hold numbers of type R.
template <std::floating_point R>
class machine_symbol : public symbol {
 public:
  using symbol::symbol;
  machine_symbol(const symbol& x)  // NOLINT(google-explicit-constructor): the same
      : symbol(x) {}
  /// Throws input_error where it is infinite or a NaN.
  template <std::same_as<R> N>
  machine_symbol(N x)  // NOLINT(google-explicit-constructor): exact
      : symbol(exactly_of(x)) {}
  /// What a function of machine numbers asks for: refused where it is used, in one sentence.
  template <std::same_as<R> N>
  operator N() const {  // NOLINT(google-explicit-constructor): so that std::sin(x) comes here
    static_assert(detail::never_true<N>,
                  "Polhode: the argument is handed to a function of one type of numbers, as "
                  "std::sin is, so that what it does cannot be seen and nothing can be proved. "
                  "Write sin(x) for std::sin(x)");
    return N(0);
  }
  machine_symbol& operator+=(const machine_symbol& y) { return *this = call("+", {*this, y}); }
  machine_symbol& operator-=(const machine_symbol& y) { return *this = call("-", {*this, y}); }
  machine_symbol& operator*=(const machine_symbol& y) { return *this = call("*", {*this, y}); }
  machine_symbol& operator/=(const machine_symbol& y) { return *this = call("/", {*this, y}); }
  friend machine_symbol operator-(const machine_symbol& x) { return call("-", {x}); }
  friend const machine_symbol& operator+(const machine_symbol& x) { return x; }

 private:
  static symbol exactly_of(R x);
};

extern template class machine_symbol<double>;
extern template class machine_symbol<long double>;

namespace detail {

template <class X>
inline constexpr bool is_machine_symbol_v = false;
template <class R>
inline constexpr bool is_machine_symbol_v<machine_symbol<R>> = true;
template <class X>
concept is_machine_symbol = is_machine_symbol_v<std::remove_cvref_t<X>>;

/// What may stand beside a symbol, and is none.
template <class N>
concept beside_symbol = machine_integer<N> || std::same_as<N, integer> ||
    std::same_as<N, rational> || std::same_as<N, rational_literal> || std::same_as<N, ball> ||
    std::same_as<N, complex_ball> || boost_real<N> || boost_expression<N>;

/// What stands beside a machine_symbol<R>, and is none.
template <class N, class R>
concept beside_machine_symbol = beside_symbol<N> || std::same_as<N, R> || std::same_as<N, symbol>;

/// What a function of these arguments returns: a machine_symbol where one is among them.
template <class... X>
struct symbol_of_call {
  using type = symbol;
};
template <class R, class... X>
struct symbol_of_call<machine_symbol<R>, X...> {
  using type = machine_symbol<R>;
};
template <class Y, class... X>
struct symbol_of_call<Y, X...> : symbol_of_call<X...> {};
template <class... X>
using symbol_for = typename symbol_of_call<std::remove_cvref_t<X>...>::type;

/// A variable of a machine type: a literal is none.
template <class D>
concept floating_variable = std::floating_point<std::remove_const_t<D>>;

/// Made into a type once for each D: one error.
template <class D>
struct exact_variable_needed {
  static_assert(never_true<D>,
                "Polhode: a double or float variable in a formula is not an exact number. Write "
                "polhode::rational(k) for the number that k is, or integrate<double> and its like, "
                "beside whose arguments doubles stand");
  static constexpr bool reported = true;
};

/// At least one of the arguments of a call is a symbol, and the others can stand beside it.
template <class... X>
concept call_of_symbols = ((is_symbol<X> || is_machine_symbol<X>) || ...) &&
                          (std::convertible_to<X, symbol_for<X...>> && ...);

}  // namespace detail

// The operators. A double literal comes as an exact_double: a parameter that the compiler converts
// to.
#define POLHODE_SYMBOL_OPERATOR(op)                                           \
  [[nodiscard]] inline symbol operator op(const symbol& x, const symbol& y) { \
    return symbol::call(#op, {x, y});                                         \
  }                                                                           \
  template <detail::beside_symbol N>                                          \
  [[nodiscard]] symbol operator op(const symbol& x, const N& y) {             \
    return symbol::call(#op, {x, symbol(y)});                                 \
  }                                                                           \
  template <detail::beside_symbol N>                                          \
  [[nodiscard]] symbol operator op(const N& x, const symbol& y) {             \
    return symbol::call(#op, {symbol(x), y});                                 \
  }                                                                           \
  template <detail::is_symbol X>                                              \
  [[nodiscard]] symbol operator op(const X& x, exact_double y) {              \
    return symbol::call(#op, {x, symbol(y)});                                 \
  }                                                                           \
  template <detail::is_symbol Y>                                              \
  [[nodiscard]] symbol operator op(exact_double x, const Y& y) {              \
    return symbol::call(#op, {symbol(x), y});                                 \
  }                                                                           \
  template <detail::is_symbol X, detail::floating_variable D>                 \
  [[nodiscard]] symbol operator op(const X& x, D& /*y*/) {                    \
    static_assert(detail::exact_variable_needed<D>::reported);                \
    return x;                                                                 \
  }                                                                           \
  template <detail::is_symbol Y, detail::floating_variable D>                 \
  [[nodiscard]] symbol operator op(D& /*x*/, const Y& y) {                    \
    static_assert(detail::exact_variable_needed<D>::reported);                \
    return y;                                                                 \
  }
POLHODE_SYMBOL_OPERATOR(+)
POLHODE_SYMBOL_OPERATOR(-)
POLHODE_SYMBOL_OPERATOR(*)
POLHODE_SYMBOL_OPERATOR(/)
#undef POLHODE_SYMBOL_OPERATOR

#define POLHODE_SYMBOL_COMPARISON(op)                                                           \
  template <class X, class Y>                                                                   \
  requires(detail::is_symbol<X> || detail::is_symbol<Y> || detail::is_machine_symbol<X> ||      \
           detail::is_machine_symbol<Y>) bool                                                   \
  operator op(const X&, const Y&) {                                                             \
    static_assert(detail::never_true<X>,                                                        \
                  "Polhode: a function that is to be proved cannot branch on its argument. "    \
                  "Write it with abs, min, max, floor, ceil or sign, or split the range where " \
                  "the formula changes");                                                       \
    return false;                                                                               \
  }
POLHODE_SYMBOL_COMPARISON(<)
POLHODE_SYMBOL_COMPARISON(>)
POLHODE_SYMBOL_COMPARISON(<=)
POLHODE_SYMBOL_COMPARISON(>=)
POLHODE_SYMBOL_COMPARISON(==)
POLHODE_SYMBOL_COMPARISON(!=)
#undef POLHODE_SYMBOL_COMPARISON

// The functions of the table, by their names.
#define POLHODE_SYMBOL_FUNCTION(name, arguments, ...)                      \
  template <class... X>                                                    \
  requires detail::call_of_symbols<X...>                                   \
  [[nodiscard]] detail::symbol_for<X...> name(const X&... x) {             \
    constexpr std::string_view names(arguments);                           \
    static_assert(sizeof...(X) == (names.find(',') == names.npos ? 1 : 2), \
                  "Polhode: " #name " is a function of " arguments);       \
    return symbol::call(#name, {detail::symbol_for<X...>(x)...});          \
  }
POLHODE_FUNCTION_TABLE(POLHODE_SYMBOL_FUNCTION, POLHODE_SYMBOL_FUNCTION, POLHODE_SYMBOL_FUNCTION,
                       POLHODE_SYMBOL_FUNCTION)
#undef POLHODE_SYMBOL_FUNCTION

/// x^y for a double literal y, and its mirror image.
[[nodiscard]] inline symbol pow(const symbol& x, exact_double y) {
  return symbol::call("pow", {x, symbol(y)});
}
[[nodiscard]] inline symbol pow(exact_double x, const symbol& y) {
  return symbol::call("pow", {symbol(x), y});
}

// As the standard library and Boost call them.
[[nodiscard]] inline symbol square(const symbol& x) { return symbol::call("pow", {x, symbol(2)}); }
/// i x, in formulas of a complex argument.
[[nodiscard]] inline symbol times_i(const symbol& x) { return symbol::imaginary_unit() * x; }
[[nodiscard]] inline symbol fabs(const symbol& x) { return symbol::call("abs", {x}); }
[[nodiscard]] inline symbol tgamma(const symbol& x) { return symbol::call("gamma", {x}); }

#define POLHODE_MACHINE_SYMBOL_OPERATOR(op)                                                        \
  template <class R>                                                                               \
  [[nodiscard]] machine_symbol<R> operator op(const machine_symbol<R>& x,                          \
                                              const machine_symbol<R>& y) {                        \
    return symbol::call(#op, {x, y});                                                              \
  }                                                                                                \
  template <class R, detail::beside_machine_symbol<R> N>                                           \
  [[nodiscard]] machine_symbol<R> operator op(const machine_symbol<R>& x, const N& y) {            \
    return symbol::call(#op, {x, machine_symbol<R>(y)});                                           \
  }                                                                                                \
  template <class R, detail::beside_machine_symbol<R> N>                                           \
  [[nodiscard]] machine_symbol<R> operator op(const N& x, const machine_symbol<R>& y) {            \
    return symbol::call(#op, {machine_symbol<R>(x), y});                                           \
  }                                                                                                \
  template <detail::is_machine_symbol X>                                                           \
  requires(!std::same_as<X, machine_symbol<double>>) [[nodiscard]] X operator op(const X& x,       \
                                                                                 exact_double y) { \
    return symbol::call(#op, {x, symbol(y)});                                                      \
  }                                                                                                \
  template <detail::is_machine_symbol Y>                                                           \
  requires(!std::same_as<Y, machine_symbol<double>>) [[nodiscard]] Y operator op(exact_double x,   \
                                                                                 const Y& y) {     \
    return symbol::call(#op, {symbol(x), y});                                                      \
  }
POLHODE_MACHINE_SYMBOL_OPERATOR(+)
POLHODE_MACHINE_SYMBOL_OPERATOR(-)
POLHODE_MACHINE_SYMBOL_OPERATOR(*)
POLHODE_MACHINE_SYMBOL_OPERATOR(/)
#undef POLHODE_MACHINE_SYMBOL_OPERATOR

template <class R>
[[nodiscard]] machine_symbol<R> square(const machine_symbol<R>& x) {
  return symbol::call("pow", {x, symbol(2)});
}
template <class R>
[[nodiscard]] machine_symbol<R> fabs(const machine_symbol<R>& x) {
  return symbol::call("abs", {x});
}
template <class R>
[[nodiscard]] machine_symbol<R> tgamma(const machine_symbol<R>& x) {
  return symbol::call("gamma", {x});
}

}  // namespace polhode
