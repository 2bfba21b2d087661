#pragma once

// Sums, products and powers of hyperexponential functions, as sums of such where they are.

#include <optional>
#include <vector>

#include "hyperexponential.hpp"

namespace polhode::detail {

using hyperexponential_sum = std::vector<hyperexponential>;
using maybe_sum = std::optional<hyperexponential_sum>;

/// Beyond so many terms a formula is left to other rules.
constexpr std::size_t most_terms = 16;
constexpr long greatest_degree = 32;

[[nodiscard]] bool is_integer(const rational& q);

/// The constant function q.
[[nodiscard]] hyperexponential number(const rational& q);
/// y^e
[[nodiscard]] hyperexponential power_of_variable(const rational& e);
/// (1 - y)^e
[[nodiscard]] hyperexponential power_of_complement(const rational& e);
/// f with c among its constants.
void multiply_by(hyperexponential& f, const constant_power& c);
/// f g, where at most one of them has a phase.
[[nodiscard]] hyperexponential product(hyperexponential f, const hyperexponential& g);
/// f cos(t), or f sin(t).
[[nodiscard]] hyperexponential with_phase(hyperexponential f, const rational_polynomial& t,
                                          bool is_sine);

/// Formulas as sums of hyperexponential functions of a variable y.
class taking_apart {
 public:
  /// `inside` is a point of the range, at which polynomials are made positive.
  explicit taking_apart(rational inside) : inside_(std::move(inside)) {}

  [[nodiscard]] hyperexponential of_polynomial(const rational_polynomial& p) const;

  /// f + g as one of its kind, where it is one.
  [[nodiscard]] maybe_sum added(const hyperexponential_sum& f, const hyperexponential_sum& g) const;
  [[nodiscard]] maybe_sum multiplied(const hyperexponential_sum& f,
                                     const hyperexponential_sum& g) const;
  [[nodiscard]] maybe_sum raised(const hyperexponential_sum& f, const rational& e) const;

  /// f as a polynomial with rational coefficients, without conditions.
  [[nodiscard]] static std::optional<rational_polynomial> as_polynomial(
      const hyperexponential_sum& f);

 private:
  /// Nothing where the exponents are not small natural numbers.
  [[nodiscard]] static std::optional<rational_polynomial> polynomial_of(
      const rational& coefficient, const std::vector<polynomial_power>& powers);

  /// Adds g to f; false where nothing can be said.
  [[nodiscard]] bool add(hyperexponential_sum& f, hyperexponential g) const;

  rational inside_;
};

}  // namespace polhode::detail
