#pragma once

// Polynomials with rational coefficients: what can be decided exactly about their roots.

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "polhode/arithmetic/exact.hpp"
#include "polhode/arithmetic/jet.hpp"

namespace polhode {

class rational_polynomial {
 public:
  /// 0.
  rational_polynomial() = default;
  /// Coefficients of 1, x, x^2, ...
  explicit rational_polynomial(std::vector<rational> coefficients);
  [[nodiscard]] static rational_polynomial variable() {
    return rational_polynomial({rational(0), rational(1)});
  }

  /// -1 for the polynomial 0.
  [[nodiscard]] long degree() const { return static_cast<long>(coefficients_.size()) - 1; }
  [[nodiscard]] bool is_zero() const { return coefficients_.empty(); }
  [[nodiscard]] const std::vector<rational>& coefficients() const { return coefficients_; }
  [[nodiscard]] const rational& leading() const { return coefficients_.back(); }
  /// Bits of the longest numerator or denominator.
  [[nodiscard]] std::size_t height() const;

  friend rational_polynomial operator+(const rational_polynomial& p, const rational_polynomial& q);
  friend rational_polynomial operator-(const rational_polynomial& p, const rational_polynomial& q);
  friend rational_polynomial operator*(const rational_polynomial& p, const rational_polynomial& q);
  friend bool operator==(const rational_polynomial&, const rational_polynomial&) = default;

  [[nodiscard]] rational operator()(const rational& x) const;
  [[nodiscard]] ball operator()(const ball& x) const;
  [[nodiscard]] rational_polynomial derivative() const;
  /// {f, f', f''/2!, ..., f^(n)/n!} at x by repeated synthetic division: for a point x the Taylor
  /// coefficients with no loss but rounding.
  [[nodiscard]] jet<ball, dynamic_order> series(const ball& x, int n) const;

 private:
  void trim();
  std::vector<rational> coefficients_;  // without leading zeros
};

/// A factor and how often it occurs.
struct repeated_factor {
  rational_polynomial factor;
  long multiplicity;
};

/// numerator / (product of factor^multiplicity), defined where no factor is 0: of those too whose
/// multiplicity is 0.
struct rational_quotient {
  rational_polynomial numerator;
  std::vector<repeated_factor> divisors;
};

/// The product of factor^multiplicity.
[[nodiscard]] rational_polynomial denominator_of(const rational_quotient& q);

/// {q, r} with p = q d + r and deg r < deg d. Hypothesis: d is not 0.
[[nodiscard]] std::pair<rational_polynomial, rational_polynomial> divide(
    const rational_polynomial& p, const rational_polynomial& d);
/// The coefficients of the positive multiple of p whose coefficients are integers without a common
/// divisor. Hypothesis: p is not 0.
[[nodiscard]] std::vector<integer> primitive_coefficients(const rational_polynomial& p);
/// The greatest common divisor with leading coefficient 1; 0 for 0 and 0.
[[nodiscard]] rational_polynomial gcd(const rational_polynomial& p, const rational_polynomial& q);

/// p up to a constant as a product of factor^multiplicity, each factor without multiple roots, no
/// two with a common root, in the order of the multiplicities (D. Y. Y. Yun, On square-free
/// decomposition algorithms, 1976; J. von zur Gathen, J. Gerhard, Modern Computer Algebra,
/// algorithm 14.21). So the roots of a factor are exactly the roots of p with that multiplicity.
/// Hypothesis: p is not 0.
[[nodiscard]] std::vector<repeated_factor> square_free_decomposition(const rational_polynomial& p);

/// B >= |x| for every complex root x: 2 max |a_(n-k) / a_n|^(1/k) (M. Fujiwara, 1916), with each
/// root replaced by a power of two above it. Hypothesis: p is not 0.
[[nodiscard]] rational root_bound(const rational_polynomial& p);

/// The number of different real roots in [lower, upper], ends included (Sturm 1829). Hypothesis: p
/// is not 0.
[[nodiscard]] long count_real_roots(const rational_polynomial& p, const rational& lower,
                                    const rational& upper);

}  // namespace polhode
