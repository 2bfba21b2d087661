#pragma once

// The functions and constants that a formula may use: the one list from which the reader, the help
// of the program and the check of docs/expressions.md are made.

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "polhode/arithmetic/ball.hpp"
#include "polhode/arithmetic/complex_ball.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "polhode/arithmetic/jet.hpp"
#include "polhode/arithmetic/pi_combination.hpp"
#include "polhode/arithmetic/region.hpp"

namespace polhode {

struct expression_function {
  std::string name;
  std::string arguments;    // "x", "x, n"
  std::string description;  // in some words
  std::string domain;       // where it is defined
};

/// "x" and "n" of "x, n".
[[nodiscard]] std::vector<std::string> argument_names(const expression_function& f);

struct expression_constant {
  std::string name;
  std::string description;
};

/// Another name of a function or constant. Texts of formulas (expression::to_text) have the name it
/// stands for.
struct expression_alias {
  std::string name;
  std::string meaning;
};

/// The arguments of a call: those that are known to be q + r pi, and nothing for the others.
using known_arguments = std::span<const std::optional<pi_combination>>;

/// A function of real arguments that whoever reads formulas adds to those of this room
/// (expression_names::further), known by what it is over balls. Its values over other real types
/// are made of these; it is not available over series, nor in derivatives beyond the first.
/// Functions may share a name where their numbers of arguments differ.
struct further_function {
  expression_function what;
  std::size_t arity = 1;
  /// Obeys the inclusion principle.
  std::function<ball(std::span<const ball>)> value;
  /// The partial derivatives over the balls, in the order of the arguments; empty where there are
  /// none.
  std::function<std::vector<ball>(std::span<const ball>)> gradient = nullptr;
  /// False where it is certain that the function is not defined at the arguments; may be empty.
  std::function<bool(known_arguments)> may_be_defined = nullptr;
  /// A formula in the names of what.arguments that has the same values, for arguments that have
  /// one; may be empty.
  std::function<std::optional<std::string>(known_arguments)> simpler = nullptr;
  /// The analytic continuation over regions and over complex balls, as region.hpp and
  /// complex_ball.hpp have it of other functions; not available where empty.
  std::function<region(std::span<const region>)> over_regions = nullptr;
  std::function<complex_ball(std::span<const complex_ball>)> over_complex = nullptr;
  /// The derivative in the last argument, a formula in the names of what.arguments; empty where
  /// there is none. Series are made of it.
  std::string slope = {};
  /// The range over the real numbers in the balls at which the function is defined, or more; none
  /// where it is certainly defined at none of them. Empty where `value` says what is known.
  std::function<std::optional<ball>(std::span<const ball>)> natural_range = nullptr;

  /// A bound of |f|, by which the tails of integrals are bounded, for a last argument x with this
  /// sign (1 or -1); the other arguments are numbers in the balls. May be empty, or know none.
  struct majorant_formula {
    std::string text;         // a formula in the names of what.arguments
    bool oscillates = false;  // f does, for x -> inf: no panel holds its tail
  };
  std::function<std::optional<majorant_formula>(std::span<const ball>, int sign)> majorant =
      nullptr;
  /// Formulas in the names of what.arguments with |f - main| <= rest where the last argument x has
  /// this sign and lies near a place where f has no value, or is not analytic.
  struct leading_formula {
    std::string main;
    std::string rest;
    bool oscillates = false;  // f - main does, for x -> inf: no panel holds its tail
  };
  /// Where 0 < |x| <= 1/2. May be empty, or know none.
  std::function<std::optional<leading_formula>(std::span<const ball>, int sign)> near_zero =
      nullptr;
  /// Where |x| >= 4. May be empty, or know none.
  std::function<std::optional<leading_formula>(std::span<const ball>, int sign)> near_infinity =
      nullptr;
  /// Where f has poles at 0, -1, -2, ...: a formula in the names of what.arguments that is f, and
  /// shows its pole at -k. May be empty, or know none.
  std::function<std::optional<std::string>(std::span<const ball>, long k)> at_pole = nullptr;
  /// Of a function of one argument with poles: functions that are analytic there too, of which f is
  /// the quotient. Both empty, or none.
  std::function<jet<ball, 1>(const jet<ball, 1>&)> numerator = nullptr;
  std::function<jet<ball, 1>(const jet<ball, 1>&)> divisor = nullptr;
};
using further_functions = std::vector<further_function>;

[[nodiscard]] const std::vector<expression_function>& expression_functions();
[[nodiscard]] const std::vector<expression_constant>& expression_constants();
[[nodiscard]] const std::vector<expression_alias>& expression_aliases();

/// Whether the text is a name of infinity: inf, infinity or oo, in any case of letters, or its sign
/// in UTF-8. No formula has it; limits do.
[[nodiscard]] bool is_infinity(std::string_view text);

}  // namespace polhode
