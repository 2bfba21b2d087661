#pragma once

// The principal moments and axes of an inertia tensor with rational entries, which are algebraic
// numbers: what is a question of yes or no about them is decided exactly.

#include <array>
#include <memory>
#include <optional>

#include "polhode/rigid_body/inertia_tensor.hpp"

namespace polhode {

/// Principal axes x, y, z of which each is one of the axes 0, 1, 2 in which the tensor was given,
/// or the opposite of one.
struct axis_order {
  std::array<int, 3> order{0, 1, 2};
  std::array<int, 3> signs{1, 1, 1};
};

/// Unit vectors v_x, v_y, v_z along the axes of the moments I_x >= I_y >= I_z, right-handed. Of v_x
/// and of v_y the first component that is not 0 is positive. Where moments are equal, one of the
/// frames that there are.
class principal_axes {
 public:
  using vector = std::array<rational, 3>;
  using exact_vector = std::array<exact_real, 3>;

  /// The entries xx, yy, zz, xy, xz, yz. Throws input_error where a principal moment is not
  /// positive, and as inertia_tensor does where an entry has too many bits.
  explicit principal_axes(const std::array<rational, 6>& tensor);

  /// xx, yy, zz, xy, xz, yz, as given.
  [[nodiscard]] const std::array<rational, 6>& tensor() const { return tensor_; }
  /// I_x, I_y, I_z.
  [[nodiscard]] const std::array<exact_real, 3>& moments() const { return moments_; }
  /// The same where all three are rational.
  [[nodiscard]] std::optional<vector> rational_moments() const;
  /// Never undecided.
  [[nodiscard]] body_kind kind() const;
  /// I_y + I_z - I_x; 0 exactly where the body is planar.
  [[nodiscard]] exact_real margin() const;
  /// The body with these moments, where they are different.
  [[nodiscard]] const std::optional<body>& rigid() const { return rigid_; }

  /// Where every axis is one of those given.
  [[nodiscard]] std::optional<axis_order> along_given_axes() const;
  /// v_i to about p bits, i = 0 for x.
  [[nodiscard]] std::array<ball, 3> axis(std::size_t i, precision p) const;
  /// (v_i w)^2; a rational 0 where w is rational and it is 0.
  [[nodiscard]] exact_real square_along(std::size_t i, const exact_vector& w) const;
  /// The sign of v_i w: -1, 0 or 1. Throws std::domain_error where w is irrational and
  /// most_bits_of_sense do not decide.
  [[nodiscard]] int sense_along(std::size_t i, const exact_vector& w) const;
  static constexpr precision most_bits_of_sense = 1L << 15;

  /// The entries of v_i v_i^T, the projector onto the axis.
  [[nodiscard]] std::array<exact_real, 6> projector(std::size_t i) const;

  /// The tensor times a vector, and its inverse times a vector.
  [[nodiscard]] exact_vector times(const exact_vector& w) const;
  [[nodiscard]] exact_vector solved(const exact_vector& w) const;

 private:
  /// An axis is along a rational vector, which need not be of length 1, or it is irrational; then
  /// `leading` is the first component of it that is not 0.
  struct axis_data {
    std::optional<vector> direction;
    std::size_t leading = 0;
  };
  void set_along_given_axes();
  void set_symmetric(const vector& moments);
  void set_different();
  [[nodiscard]] exact_real projected(std::size_t i, const exact_vector& u,
                                     const exact_vector& w) const;
  /// v_z as it would be by the rule of v_x and v_y, times this, makes the frame right-handed.
  [[nodiscard]] int orientation() const;
  [[nodiscard]] std::array<ball, 3> unoriented(std::size_t i, precision p) const;

  std::array<rational, 6> tensor_;
  std::array<exact_real, 3> moments_{0, 0, 0};
  std::array<axis_data, 3> axes_;
  std::shared_ptr<const inertia_tensor> irrational_;
  std::optional<body> rigid_;
};

/// The physical tensor that is nearest to a non-physical one in the Frobenius norm.
struct nearest_physical_tensor {
  /// d = I_x - I_y - I_z > 0.
  exact_real excess = 0;
  /// The norm of the difference, d/sqrt(3).
  [[nodiscard]] ball distance(precision p) const;
  /// xx, yy, zz, xy, xz, yz; and its principal moments: it is planar.
  std::array<exact_real, 6> tensor{0, 0, 0, 0, 0, 0};
  std::array<exact_real, 3> moments{0, 0, 0};
};

/// Nothing where the tensor is physical.
///
/// It is T + (d/3)(1 - 2 v_x v_x^T), with the moments I_x - d/3, I_y + d/3, I_z + d/3. Proof. For
/// symmetric A and B with the eigenvalues a_i and b_i, each in descending order, the squared norm
/// of A - B is at least the sum of (a_i - b_i)^2 (A. J. Hoffman, H. W. Wielandt, Duke Math. J. 20,
/// 1953). The moments of a physical B have b_1 <= b_2 + b_3, a half-space at the distance d/sqrt(3)
/// from (I_x, I_y, I_z), of which the nearest point is the one above. It is in descending order, as
/// I_x - I_y = d + I_z > 2d/3, and positive; the tensor has it with the axes of T and attains the
/// bound. It is the only one: the B with 2 b_1 <= tr B are a convex set.
[[nodiscard]] std::optional<nearest_physical_tensor> nearest_physical(const principal_axes& of);

}  // namespace polhode
