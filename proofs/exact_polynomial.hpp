#pragma once

// Identities and signs of polynomials, decided exactly.
//
// A polynomial is written as text in single lower-case letters with integer coefficients, "(1-b)^2
// - b*(a+b)", and is expanded over the rationals: two polynomials are the same function exactly
// when their expansions are equal. What a certificate prints is the text that was checked.

#include <array>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "polhode/arithmetic/exact.hpp"
#include "polhode/certificate/certificate.hpp"
#include "statements/claim_text.hpp"

namespace polhode::proofs {

/// A polynomial over Q in the letters a ... z, expanded.
class exact_polynomial {
 public:
  using exponents = std::array<int, 26>;

  exact_polynomial() = default;
  /// A constant.
  explicit exact_polynomial(const rational& q);
  /// The variable of that name. Throws std::invalid_argument unless it is a lower-case letter.
  static exact_polynomial variable(char name);
  /// Reads +, -, *, ^ with a whole exponent from 0 to 99, parentheses, letters and integers. Throws
  /// std::invalid_argument for anything else.
  static exact_polynomial parse(std::string_view text);

  friend exact_polynomial operator+(const exact_polynomial& x, const exact_polynomial& y);
  friend exact_polynomial operator-(const exact_polynomial& x, const exact_polynomial& y);
  friend exact_polynomial operator*(const exact_polynomial& x, const exact_polynomial& y);
  friend bool operator==(const exact_polynomial& x, const exact_polynomial& y) = default;

  [[nodiscard]] exact_polynomial derivative(char name) const;
  /// The polynomial with another put in the place of a variable.
  [[nodiscard]] exact_polynomial with(char name, const exact_polynomial& replacement) const;

  /// The terms: exponents of a ... z, and the coefficient, which is not 0.
  [[nodiscard]] const std::map<exponents, rational>& terms() const { return terms_; }

 private:
  void add(const exponents& e, const rational& coefficient);
  std::map<exponents, rational> terms_;  // without zeros
};

using statements::conclusion_of;
using statements::form_in_words;
using statements::is_sign;
using statements::polynomial_step;
using statements::sentence_of;
using statements::step_form;

/// Whether the step holds, decided by expansion. A sign holds where
///   the ranges of its letters are hypotheses of the claims (see hypotheses), and every letter of
///     `right` has one;
///   no coefficient of `right` is negative, so that its value is not; and for > 0 besides
///   one term is positive: its letters are all > 0.
/// Throws std::invalid_argument where a text is not a polynomial, or `letters` are no ranges.
[[nodiscard]] bool holds(const polynomial_step& step);

/// What the claims say of the quantities that letters stand for: a polynomial that is > 0, or >= 0.
/// A step may use these and no other. All of them hold at a = b = u = 1/4, c = 1/8, k = 1/2, x =
/// 3/4, y = 1/2, z = 1/4: no step speaks of nothing.
struct hypothesis {
  const char* quantity;
  bool strict;  // > 0; else >= 0
  const char* of;
};
[[nodiscard]] const std::vector<hypothesis>& hypotheses();

/// Adds each step to the certificate's facts, and to witness["polynomials"] in a form that can be
/// checked again. Returns whether all hold.
bool add_steps(certificate& c, const std::vector<polynomial_step>& steps);

}  // namespace polhode::proofs
