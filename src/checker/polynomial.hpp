#pragma once

// Polynomials with whole coefficients in the letters a ... z, expanded.

#include <array>
#include <map>
#include <string_view>
#include <vector>

#include "exact.hpp"

namespace polhode::checker {

class polynomial {
 public:
  polynomial() = default;
  explicit polynomial(const integer& n);
  /// Reads sums and products of letters, whole numbers, parentheses and whole powers up to 99.
  /// Throws std::invalid_argument.
  static polynomial read(std::string_view text);

  friend polynomial operator+(const polynomial& x, const polynomial& y);
  friend polynomial operator-(const polynomial& x, const polynomial& y);
  friend polynomial operator*(const polynomial& x, const polynomial& y);
  friend bool operator==(const polynomial& x, const polynomial& y) = default;

  [[nodiscard]] polynomial derivative(char letter) const;
  /// With another polynomial in the place of a letter.
  [[nodiscard]] polynomial with(char letter, const polynomial& other) const;

  using exponents = std::array<int, 26>;
  /// Exponents of a ... z with the coefficient, which is not 0.
  [[nodiscard]] const std::map<exponents, integer>& terms() const { return terms_; }

 private:
  void add(const exponents& e, const integer& coefficient);
  std::map<exponents, integer> terms_;  // no zeros
};

/// What is said of the letters of a polynomial: "b > 0, q = 1-b > 0, y = 1-x >= 0".
class letter_ranges {
 public:
  /// Throws std::invalid_argument where the text is no such list.
  explicit letter_ranges(std::string_view text);

  /// With what the letters stand for in the letters' places.
  [[nodiscard]] polynomial put_into(polynomial p) const;
  /// Whether p > 0 (or p >= 0 where not `strict`) is seen from signs: all ranges are hypotheses of
  /// the claims, every letter of p has one, no coefficient is negative, and for > 0 some term has
  /// only letters that are > 0.
  [[nodiscard]] bool show_sign(const polynomial& p, bool strict) const;

 private:
  struct range {
    char letter;
    bool defined;
    polynomial quantity;  // the letter itself where it is not defined
    bool strict;
  };
  [[nodiscard]] static bool is_hypothesis(const range& r);
  [[nodiscard]] bool are_hypotheses() const;
  std::vector<range> ranges_;
};

}  // namespace polhode::checker
