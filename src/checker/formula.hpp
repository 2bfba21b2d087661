#pragma once

// Formulas as text: the checker's own reader, and their evaluation over the sets of functions.hpp.
//
//   sum     = product { (+|-) product }            from the left
//   product = signed { (*|/) signed }              from the left
//   signed  = - signed | power                     -x^2 is -(x^2)
//   power   = operand [ ^ { - } power ]            from the right: 2^3^2 is 2^9
//   operand = whole number | variable | pi | function ( sum ) | ( sum )
//
// Operations on rational numbers are done exactly while they are short. Reading is charged to the
// place's budget, evaluation to the set's. x^n for a whole number n is defined as a product (x^0 =
// 1), any other power as exp(y log x).

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "document.hpp"
#include "functions.hpp"

namespace polhode::checker {

class formula {
 public:
  /// Reads the text that stands at a place. Malformed where it cannot be read, names what this
  /// checker does not know, or is longer than most_characters.
  static formula read(const place& where, const std::vector<std::string>& variables);
  static constexpr std::size_t most_characters = 20'000;
  /// Whether a text can be the name of a variable: a letter or _, then letters, digits and _;
  /// neither the name of something else, in capitals or not, nor what a reader takes for e, i or a
  /// number (l, I, O).
  static bool is_variable(std::string_view text);

  /// The values for all x, one for each variable, of the kinds interval, jet or rectangle; there is
  /// one at least. Throws undecided.
  template <class T>
  [[nodiscard]] T operator()(const std::vector<T>& x) const;
  /// The same of a formula in one variable, or in none.
  template <class T>
  [[nodiscard]] T operator()(const T& x) const {
    return (*this)(std::vector<T>{x});
  }
  /// The number, where the formula was found to be one.
  [[nodiscard]] std::optional<rational> exact_value() const;

 private:
  friend class formula_reader;
  enum class operation {
    number,
    variable,
    pi,
    negate,
    add,
    subtract,
    multiply,
    divide,
    power,  // by a whole number
    sqrt,
    exp,
    log,
    sin,
    cos,
    sinh,
    cosh,
    atan
  };
  struct instruction {
    operation what;
    std::size_t left = 0;  // of operands: earlier instructions; of a variable: its number
    std::size_t right = 0;
    rational number = 0;
    long exponent = 0;
  };
  std::vector<instruction> code_;  // the last is the result
};

extern template interval formula::operator()(const std::vector<interval>& x) const;
extern template jet formula::operator()(const std::vector<jet>& x) const;
extern template rectangle formula::operator()(const std::vector<rectangle>& x) const;

}  // namespace polhode::checker
