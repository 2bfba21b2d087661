#pragma once

// The value of a formula again, as `polhode eval --verify` finds it: in complex arithmetic, with
// other bits, or without exact folding.

#include <string>
#include <vector>

#include "polhode/expression/expression.hpp"
#include "polhode/expression/parse.hpp"
#include "polhode/verify/second_opinion.hpp"

namespace polhode {

/// The certified value `first` of f, found with so many bits, again: by regions, which are sets of
/// complex numbers in balls, where f is analytic; and by real balls with an odd number of bits,
/// beyond those to which the arithmetic has tables of its own. Throws contradiction_error where an
/// enclosure has no number in common with first.
[[nodiscard]] second_opinion value_again(const expression& f, const ball& first, precision bits,
                                         long digits);

/// The value of f that exact rules showed to be the rational number `exact`, again as value_again
/// does.
[[nodiscard]] second_opinion rational_value_again(const expression& f, const rational& exact,
                                                  long digits);

/// The value of a formula that was found to be the rational number `exact`, again in ball
/// arithmetic: its numbers are given as values of variables, so that nothing is decided exactly
/// when it is read. Throws contradiction_error as value_again does.
[[nodiscard]] second_opinion exact_value_again(const std::string& formula,
                                               const std::vector<formula_definition>& definitions,
                                               const rational& exact, long digits);

/// A formula with its numbers as variables: "2*x + 1/3" as "number_1*x + number_2/number_3".
/// Exponents, the numbers of factorials and the orders of roots stay, for there it matters that
/// they are whole.
struct formula_of_variables {
  std::string text;
  std::vector<std::string> names;
  std::vector<rational> values;
};
[[nodiscard]] formula_of_variables with_numbers_as_variables(const std::string& formula);

}  // namespace polhode
