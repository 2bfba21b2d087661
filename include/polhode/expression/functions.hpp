#pragma once

// The functions and constants that a formula may use: the one list from which the reader, the help of the
// program and the check of docs/expressions.md are made.

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "polhode/arithmetic/ball.hpp"
#include "polhode/arithmetic/exact.hpp"

namespace polhode {

struct expression_function {
  std::string name;
  std::string arguments;    // "x", "x, n"
  std::string description;  // in some words
  std::string domain;       // where it is defined
};

struct expression_constant {
  std::string name;
  std::string description;
};

/// A function of real arguments that whoever reads formulas adds to those of this room
/// (expression_names::further), known by what it is over balls. Its values over other types are made of these; it is
/// not available over regions and series, off the real line, nor in derivatives beyond the first. Functions may share a
/// name where their numbers of arguments differ.
struct further_function {
  expression_function what;
  std::size_t arity = 1;
  /// Obeys the inclusion principle.
  std::function<ball(std::span<const ball>)> value;
  /// The partial derivatives over the balls, in the order of the arguments; empty where there are none.
  std::function<std::vector<ball>(std::span<const ball>)> gradient = nullptr;
  /// False for numbers of which it is certain that the function is not defined there; may be empty.
  std::function<bool(std::span<const rational>)> may_be_defined = nullptr;
};
using further_functions = std::vector<further_function>;

[[nodiscard]] const std::vector<expression_function>& expression_functions();
[[nodiscard]] const std::vector<expression_constant>& expression_constants();

}  // namespace polhode
