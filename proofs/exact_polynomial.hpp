#pragma once

// Identities and signs of polynomials, decided exactly.
//
// A polynomial is written as text in single lower-case letters with integer coefficients, "(1-b)^2 - b*(a+b)", and is
// expanded over the rationals: two polynomials are the same function exactly when their expansions are equal. What a
// certificate prints is the text that was checked.

#include <array>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "polhode/arithmetic/exact.hpp"
#include "polhode/certificate/certificate.hpp"

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

/// One step of a proof: an exact question about polynomials, and what the proof needs it for.
struct polynomial_step {
  enum class kind {
    identity,  // "p = q"
    sign,  // "p = q > 0" or "p = q >= 0": no coefficient of q is negative, nor is any of its letters
    slope  // "d/dx (p) / (q) = r": p_x q - p q_x = r, the numerator of the derivative of p/q over q^2
  };
  kind what;
  std::string left;   // p
  std::string over;   // q of a slope
  std::string right;  // q, or r
  /// Of a sign: "b > 0, q = 1-b > 0, y = 1-x >= 0", the range of every letter of `right`; what a letter stands for is put into
  /// `right` before it is compared.
  std::string letters;
  bool strict = false;  // of a sign: > 0 is concluded, not >= 0
  char variable = 'x';  // of a slope
  std::string meaning;  // what it says in the proof

  /// Decided by expansion. A sign holds where
  ///   the ranges are hypotheses of the claims (see hypotheses), and every letter of `right` has one;
  ///   no coefficient of `right` is negative, so that its value is not; and for > 0 besides
  ///   one term is positive: its letters are all > 0.
  /// Throws std::invalid_argument where a text is not a polynomial, or `letters` are no ranges.
  [[nodiscard]] bool holds() const;
  /// "(1-b)^2 - b*(a+b) = 1 - 2*b - a*b, expanded over Q"
  [[nodiscard]] std::string statement() const;
};

[[nodiscard]] polynomial_step identity(std::string left, std::string right, std::string meaning);
/// left = right > 0 for letters with these ranges.
[[nodiscard]] polynomial_step positive(std::string left, std::string right, std::string letters,
                                       std::string meaning);
/// left = right >= 0 for letters with these ranges.
[[nodiscard]] polynomial_step not_negative(std::string left, std::string right, std::string letters,
                                           std::string meaning);

/// What the claims say of the quantities that letters stand for: a polynomial that is > 0, or >= 0. A step may use these and no
/// other. All of them hold at a = b = u = 1/4, c = 1/8, k = 1/2, x = 3/4, y = 1/2, z = 1/4: no step speaks of nothing.
struct hypothesis {
  const char* quantity;
  bool strict;  // > 0; else >= 0
  const char* of;
};
[[nodiscard]] const std::vector<hypothesis>& hypotheses();

[[nodiscard]] polynomial_step slope(char variable, std::string numerator, std::string denominator,
                                    std::string result, std::string meaning);

/// Adds each step to the certificate's facts, and to witness["polynomials"] in a form that can be checked again.
/// Returns whether all hold.
bool add_steps(certificate& c, const std::vector<polynomial_step>& steps);

}  // namespace polhode::proofs
