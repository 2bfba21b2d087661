#pragma once

// Formulas as the command line reads them: with the elliptic functions, and with definitions in any
// order.
//
//   const expression f = parse("exp(-x^2)");                         // in x
//   const expression g = parse("k*y", {"y"}, {{"k", "2*m"}, {"m", "ellipticK(1/2)"}});

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "polhode/expression/expression.hpp"

namespace polhode {

/// A name and its value, a formula in numbers, constants and other names.
using formula_definition = std::pair<std::string, std::string>;

/// The same definitions, each behind those whose names are in its value, else in the order given.
/// Throws input_error where a value needs its own name, or several values need each other.
[[nodiscard]] std::vector<formula_definition> in_order_of_need(
    std::vector<formula_definition> definitions);

/// Reads a formula in the variables, with the functions of docs/expressions.md and
/// docs/elliptic.md. The definitions may use each other in any order. Throws expression_error where
/// the text cannot be read or is certainly undefined, and input_error for names that may not be
/// used and definitions that need each other.
[[nodiscard]] expression parse(std::string_view text,
                               const std::vector<std::string>& variables = {"x"},
                               const std::vector<formula_definition>& definitions = {});

/// The same; of an equation "f = g" the formula f - g.
[[nodiscard]] expression parse_equation(std::string_view text,
                                        const std::vector<std::string>& variables = {"x"},
                                        const std::vector<formula_definition>& definitions = {});

/// The name of the variable of a formula, or of an equation: x; or the only name in it that is none
/// of a function, a constant, i or a definition, where x is not in it.
[[nodiscard]] std::string variable_of(std::string_view text,
                                      const std::vector<formula_definition>& definitions = {});

}  // namespace polhode
