#pragma once

// Polynomials with whole coefficients in the letters a ... z, expanded.

#include <array>
#include <map>
#include <string_view>

#include "exact.hpp"

namespace polhode::checker {

class polynomial {
 public:
  polynomial() = default;
  explicit polynomial(const integer& n);
  /// Reads sums and products of letters, whole numbers, parentheses and whole powers up to 99. Throws std::invalid_argument.
  static polynomial read(std::string_view text);

  friend polynomial operator+(const polynomial& x, const polynomial& y);
  friend polynomial operator-(const polynomial& x, const polynomial& y);
  friend polynomial operator*(const polynomial& x, const polynomial& y);
  friend bool operator==(const polynomial& x, const polynomial& y) = default;

  [[nodiscard]] polynomial derivative(char letter) const;
  /// With another polynomial in the place of a letter.
  [[nodiscard]] polynomial with(char letter, const polynomial& other) const;
  /// Some coefficient is positive and none is negative: the value is positive where all letters are.
  [[nodiscard]] bool has_positive_coefficients() const;

 private:
  using exponents = std::array<int, 26>;
  void add(const exponents& e, const integer& coefficient);
  std::map<exponents, integer> terms_;  // no zeros
};

/// "q = 1-b, y = 1-x" put into p, one after another.
[[nodiscard]] polynomial with_letters(polynomial p, std::string_view letters);

}  // namespace polhode::checker
