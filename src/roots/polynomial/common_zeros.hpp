#pragma once

// The solutions of systems of polynomials where Newton's method proves nothing: multiple ones.
//
// The coordinates of a solution are roots of the eliminants (elimination.hpp): the real roots of
// these in a box are the coordinates of a few points, of which every solution in the box is one.
// Whether a polynomial g is 0 at such a point is decided by another eliminant, of t - g(x) and the
// eliminants themselves: unless g is 0 there, its size is at least that of the smallest root t, but
// 0, of it.

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "polhode/expression/expression.hpp"
#include "polhode/roots/newton.hpp"
#include "root_bracket.hpp"

namespace polhode::detail {

/// A real root of a polynomial without multiple roots.
class real_algebraic {
 public:
  /// The rational one.
  explicit real_algebraic(const rational& q);
  /// The one in the bracket, between its ends, of a polynomial without rational roots.
  real_algebraic(const std::vector<integer>& p, exact_interval bracket);

  [[nodiscard]] const std::optional<rational>& exact() const { return exact_; }
  /// A polynomial of which it is a root.
  [[nodiscard]] const rational_polynomial& polynomial() const { return polynomial_; }
  /// Whether it lies in the interval; nullopt where that is not decided.
  [[nodiscard]] std::optional<bool> is_in(const exact_interval& x);
  /// With p bits.
  [[nodiscard]] ball enclosure(precision p);

 private:
  std::optional<rational> exact_;
  rational_polynomial polynomial_;
  std::vector<integer> coefficients_;
  exact_interval bracket_;
};

/// A point of which each coordinate is one.
using algebraic_point = std::vector<real_algebraic>;

/// With p bits.
[[nodiscard]] std::vector<ball> enclosure_of(algebraic_point& x, precision p);
/// Whether a formula is 0 at the point; nullopt where it is no polynomial with rational
/// coefficients there, or would take long.
[[nodiscard]] std::optional<bool> is_zero_at(const expression& g, algebraic_point& x);

class common_zeros {
 public:
  /// Of as many components as variables.
  explicit common_zeros(std::span<const expression> components);

  /// unique, where the determinant of the derivatives is not 0, or multiple.
  struct solution {
    root_verdict verdict;
    algebraic_point at;
  };
  /// All solutions in a bounded box; nullopt where they are not known.
  [[nodiscard]] std::optional<std::vector<solution>> in(std::span<const ball> box);

 private:
  std::vector<expression> components_;
  std::optional<expression> jacobian_;
  std::vector<std::vector<real_algebraic>> coordinates_;  // empty where they are not known
};

}  // namespace polhode::detail
