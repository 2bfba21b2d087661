#pragma once

// Rotations of which every digit can be had: by rational matrices and quaternions, by angles, and
// by axes that are given by vectors of any length.

#include <array>
#include <optional>
#include <vector>

#include "polhode/arithmetic/exact_real.hpp"

namespace polhode {

template <class T>
using triple = std::array<T, 3>;
/// By rows.
template <class T>
using matrix3 = std::array<std::array<T, 3>, 3>;

enum class angle_unit { radians, degrees };

/// Throws input_error for what is no rotation: rows with R R^T not exactly 1, or of determinant -1.
void refuse_unless_rotation(const matrix3<rational>& rows);

/// v -> q v q^*/|q|^2 of a quaternion w + x i + y j + z k, by rows. Throws input_error for 0.
[[nodiscard]] matrix3<rational> rotation_of(const std::array<rational, 4>& wxyz);

/// Sine and cosine, rational where they are known to be: at 0, and at multiples of 30 and 90
/// degrees.
[[nodiscard]] exact_real exact_sine(const rational& angle, angle_unit unit);
[[nodiscard]] exact_real exact_cosine(const rational& angle, angle_unit unit);

/// A rotation, as the product of rotations that are simple. What is rational of its matrix or of a
/// turned vector is known to be, where it follows without a relation between different sines,
/// cosines and roots.
class exact_rotation {
 public:
  /// The identity.
  exact_rotation() = default;
  /// Throws input_error as refuse_unless_rotation does.
  [[nodiscard]] static exact_rotation of_matrix(const matrix3<rational>& rows);
  /// A quaternion of any norm but 0, which input_error refuses.
  [[nodiscard]] static exact_rotation of_quaternion(const std::array<rational, 4>& wxyz);
  /// About the axis 0, 1 or 2, right-handed: about 2 it takes e_0 to (cos, sin, 0).
  [[nodiscard]] static exact_rotation about(std::size_t axis, const rational& angle,
                                            angle_unit unit);
  /// About a vector of any length. Throws input_error for 0.
  [[nodiscard]] static exact_rotation about(const triple<rational>& axis, const rational& angle,
                                            angle_unit unit);
  /// Takes e_0 to x/|x| and e_1 into the half plane of x and y. Throws input_error where x and y
  /// are parallel, or 0.
  [[nodiscard]] static exact_rotation with_axes(const triple<rational>& x,
                                                const triple<rational>& y);
  /// The rotation by the least angle that takes e_2 to z/|z|; where z is opposite to e_2, that
  /// about e_0. Throws input_error for 0.
  [[nodiscard]] static exact_rotation with_third_axis(const triple<rational>& z);

  /// First y, then x.
  friend exact_rotation operator*(const exact_rotation& x, const exact_rotation& y);
  [[nodiscard]] exact_rotation inverse() const;
  /// Whether it has no factor: one is left out where it turns by 0.
  [[nodiscard]] bool is_identity() const { return factors_.empty(); }

  [[nodiscard]] triple<exact_real> of(triple<exact_real> v) const;
  /// By rows, to about p bits.
  [[nodiscard]] matrix3<ball> matrix(precision p) const;
  /// The matrix, where it is known to be rational.
  [[nodiscard]] std::optional<matrix3<rational>> rational_matrix() const;

 private:
  /// Columns d_i/sqrt(s_i), or the inverse of that.
  struct frame {
    matrix3<rational> columns;
    triple<rational> squares;
    bool is_inverse = false;
  };
  /// About the axis, with the cosine and the sine over `divisor`, which have it in common.
  struct turn {
    std::size_t axis = 2;
    exact_real cosine = 1;
    exact_real sine = 0;
    exact_real divisor = 1;
  };
  /// One of the two.
  struct factor {
    std::optional<frame> by_columns;
    turn by_angle;
  };
  explicit exact_rotation(factor one) { factors_.push_back(std::move(one)); }
  /// The identity where it is none.
  [[nodiscard]] static exact_rotation of_turn(turn one);
  [[nodiscard]] static exact_rotation of_columns(const matrix3<rational>& columns);

  std::vector<factor> factors_;  // that turns first is the first
};

}  // namespace polhode
