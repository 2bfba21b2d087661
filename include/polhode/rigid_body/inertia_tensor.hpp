#pragma once

// A body by its inertia tensor in any axes, with rational entries. Its principal moments are the
// roots of a cubic and in general irrational: they are enclosed, and what is a question of yes or
// no is decided in rationals.

#include <array>
#include <memory>
#include <optional>

#include "polhode/arithmetic/polynomial.hpp"
#include "polhode/rigid_body/body.hpp"

namespace polhode {

class inertia_tensor {
 public:
  /// By its entries xx, yy, zz, xy, xz, yz. Throws input_error where it is not positive definite,
  /// where two principal moments are equal (decided by Sturm's theorem), and where with a common
  /// denominator an entry has more than 4096 bits.
  explicit inertia_tensor(const std::array<rational, 6>& given);

  /// xx, yy, zz, xy, xz, yz, as given.
  [[nodiscard]] const std::array<rational, 6>& entries() const { return entries_; }

  /// Of the principal moments I_x, I_y, I_z, exactly. With the roots x > y > z > 0 of the
  /// characteristic polynomial chi and their sum T, the numbers T/2 - z = (x + y - z)/2 and T/2 - y
  /// = (x + z - y)/2 are positive, so that chi(T/2) = (T/2 - x)(T/2 - y)(T/2 - z) has the sign of y
  /// + z - x.
  [[nodiscard]] body_kind kind() const;

  /// I_x > I_y > I_z, each where it is rational. Either all are, or at most one is: the sum is.
  [[nodiscard]] const std::array<std::optional<rational>, 3>& exact_moments() const {
    return exact_;
  }

  [[nodiscard]] bool is_rational() const { return exact_[0] && exact_[1] && exact_[2]; }

  /// Of a tensor that is not rational, the squares of I and of J + 1 where they are rational
  /// numbers. Let one moment be rational and the others be conjugate, so that S, their sum, and P,
  /// their product, are rational. A number of their field is rational where it is its own
  /// conjugate. With I^2 = yz/((x-y)(x-z)) and (J+1)^2 = xy/((y-z)(x-z)):
  ///   x rational: I^2 = P/(x^2 - xS + P). (J+1)^2 is irrational: y (x-y) = -z (x-z) has sides of
  ///   two signs.
  ///   z rational: (J+1)^2 = P/(P - zS + z^2). I^2 is irrational: y (y-z) = -x (x-z).
  ///   y rational: either is where x^2 + z^2 = y (x+z), that is S^2 - 2P = yS, and then half the
  ///   sum of it and its conjugate: I^2 = y (S-y)/(2D), (J+1)^2 = y (S-y)/(2D) with D = (x-y)(y-z)
  ///   = yS - y^2 - P.
  /// No moment rational: neither is. With D = xyz and T = x+y+z, I^2 = D/(2x^3 - Tx^2 + D) = q
  /// would give x the polynomial 2q X^3 - qT X^2 + (q-1) D, which is no multiple of its own, X^3 -
  /// TX^2 + ..., as T > 0; (J+1)^2 is D/(2z^3 - Tz^2 + D) likewise.
  [[nodiscard]] std::optional<rational> exact_square_of_geometric_constant() const;
  [[nodiscard]] std::optional<rational> exact_square_of_second_constant() const;

  /// Each to about p bits or more (the best so far are kept), by bisection with Descartes' rule and
  /// interval Newton steps.
  [[nodiscard]] std::array<ball, 3> moments(precision p) const;

  /// From these, for x, y, z as above: a = (y - z)/z, b = (x - y)/x, the square of the geometric
  /// constant yz/((x-y)(x-z)) (1 exactly for a planar body), and J = q/(s + 1) with s^2 =
  /// xy/((y-z)(x-z)) and q = s^2 - 1 = z (x+y-z)/((y-z)(x-z)). Only the differences of moments
  /// cancel, by at most lost_bits() bits.
  [[nodiscard]] ball a(precision p) const;
  [[nodiscard]] ball b(precision p) const;
  [[nodiscard]] ball geometric_constant(precision p) const;
  [[nodiscard]] ball second_geometric_constant(precision p) const;

  /// With the integers of the tensor's multiple L and the trace T of that, the discriminant
  /// ((x-y)(y-z)(x-z))^2 is an integer and at least 1, each factor less than T: so each is above
  /// 1/T^2, and by T^3 smaller than the greatest moment at most.
  [[nodiscard]] precision lost_bits() const;

 private:
  /// S and P of the two other moments, where the i-th (0 for x) is the only rational one.
  struct conjugate_pair {
    rational moment;
    rational sum;
    rational product;
  };
  [[nodiscard]] std::optional<conjugate_pair> beside(std::size_t i) const;
  [[nodiscard]] std::optional<rational> square_with_rational_y() const;

  std::array<rational, 6> entries_;
  integer common_;                  // L
  rational trace_;                  // of L times the tensor
  rational_polynomial polynomial_;  // the characteristic one of that, with integer coefficients
  std::array<integer, 3> above_;    // the least integers that are not below its roots
  std::array<std::optional<rational>, 3> exact_;
  struct known_moments;
  std::shared_ptr<known_moments> known_;
};

/// I_x >= I_y >= I_z of a tensor where two of them are equal, which may not be positive; nothing
/// where all are different. By its entries xx, yy, zz, xy, xz, yz. The characteristic polynomial
/// x^3 - T x^2 + M x - D has the discriminant
///   18 T M D - 4 T^3 D + T^2 M^2 - 4 M^3 - 27 D^2.
/// Where that is 0, the double root is (T M - 9 D)/(2 (T^2 - 3 M)), or all are T/3 where T^2 = 3 M.
/// Proof: with the roots r, r, s, T = 2 r + s, M = r^2 + 2 r s and D = r^2 s, so that T^2 - 3 M is
/// (r - s)^2 and T M - 9 D is 2 r (r - s)^2.
[[nodiscard]] std::optional<std::array<rational, 3>> equal_principal_moments(
    const std::array<rational, 6>& tensor);

}  // namespace polhode
