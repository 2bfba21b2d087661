#pragma once

// A rigid body with three different principal moments of inertia, I_z < I_y < I_x, known exactly:
// rational numbers, or the roots of a tensor's characteristic polynomial. And bodies of which the
// moments are known to lie in ranges only.
//
// Of its free rotation only ratios matter: a = I_y/I_z - 1 > 0 and b = 1 - I_y/I_x in (0, 1).

#include <array>
#include <memory>
#include <optional>
#include <string>

#include "polhode/arithmetic/exact.hpp"
#include "polhode/arithmetic/exact_real.hpp"

namespace polhode {

/// Whether a mass distribution has these moments: its greatest moment is at most the sum of the
/// others, and is that sum where all mass lies in a plane. Undecided: some members of the ranges
/// given are physical and others are not.
enum class body_kind { physical, planar, non_physical, undecided };

/// "physical", "planar", "non-physical", "undecided".
[[nodiscard]] std::string to_text(body_kind kind);

class inertia_tensor;

class body {
 public:
  /// Throws input_error, which says what was given and what would be right, where a <= 0, b <= 0 or
  /// b >= 1.
  body(const exact_real& a, const exact_real& b);

  /// The principal moments in any order and any one unit. Throws input_error where one is not
  /// positive, or where two are equal: such a symmetric top has no intermediate axis.
  static body from_moments(const std::array<rational, 3>& given);

  /// The rotational constants of a molecule in any order and any one unit (1/cm, MHz): its moments
  /// are as their inverses. moments() are these inverses. Throws input_error as from_moments does.
  static body from_rotational_constants(const std::array<rational, 3>& given);

  /// The inertia tensor in any axes, by its entries xx, yy, zz, xy, xz, yz. Throws input_error as
  /// inertia_tensor does.
  static body from_inertia_tensor(const std::array<rational, 6>& given);
  static body from_inertia_tensor(std::shared_ptr<const inertia_tensor> given);

  [[nodiscard]] const exact_real& a() const { return a_; }
  [[nodiscard]] const exact_real& b() const { return b_; }
  /// The tensor that the body was made from, where its principal moments are not all rational: then
  /// a and b are irrational. A nullptr else.
  [[nodiscard]] const std::shared_ptr<const inertia_tensor>& irrational_tensor() const {
    return tensor_;
  }

  /// I_x, I_y, I_z, where the body was made from rational moments.
  [[nodiscard]] const std::optional<std::array<rational, 3>>& moments() const { return moments_; }
  /// Which of the moments given (0, 1 or 2) is I_x, which I_y, which I_z; {0, 1, 2} where they came
  /// in this order.
  [[nodiscard]] const std::array<int, 3>& order() const { return order_; }

  /// Physical where ab + 2b < 1, planar where ab + 2b = 1, else non-physical; in rationals (of a
  /// tensor inertia_tensor::kind), so never undecided. Proof: I_x = I_y/(1 - b) and I_z = I_y/(1 +
  /// a), so that I_x <= I_y + I_z is 1/(1 - b) <= (2 + a)/(1 + a), and this is 1 + a <= (2 + a)(1 -
  /// b).
  [[nodiscard]] body_kind kind() const;

  /// The paper's geometric constant (1 - b)/sqrt(b (a + b)), to about p bits. It is above, at or
  /// below 1 as the body is physical, planar or not: (1 - b)^2 - b (a + b) = 1 - 2b - ab.
  [[nodiscard]] ball geometric_constant(precision p) const;
  /// Its value where that is a rational number.
  [[nodiscard]] std::optional<rational> exact_geometric_constant() const;

  /// Its square, which is rational for some irrational a and b too (planar bodies).
  [[nodiscard]] exact_real square_of_geometric_constant() const;

  /// The paper's second geometric constant J = (a + 1)/sqrt(a (a + b)) - 1 > 0, to about p bits. It
  /// is computed as (s^2 - 1)/(s + 1) with s = J + 1, where s^2 - 1 = (1 + 2a - ab)/(a (a + b)) > 0
  /// is an exact_real: nothing cancels.
  [[nodiscard]] ball second_geometric_constant(precision p) const;
  /// The square of J + 1.
  [[nodiscard]] exact_real square_of_second_constant() const;
  [[nodiscard]] std::optional<rational> exact_second_geometric_constant() const;

 private:
  explicit body(std::shared_ptr<const inertia_tensor> irrational);

  exact_real a_;
  exact_real b_;
  std::shared_ptr<const inertia_tensor> tensor_;
  std::optional<std::array<rational, 3>> moments_;
  std::array<int, 3> order_{0, 1, 2};
};

/// Throws input_error, which says what was given, unless all three principal moments are positive.
/// Any one unit.
void refuse_unless_positive(const std::array<rational, 3>& moments);

/// The numbers from low to high, both included.
struct rational_range {
  rational low;
  rational high;

  friend bool operator==(const rational_range&, const rational_range&) = default;
};

/// A moment known to lie in [value - sigma, value + sigma]; independent of the others.
struct uncertain_moment {
  rational value;
  rational sigma;
};

/// A body with such moments.
class uncertain_body {
 public:
  /// The moments in any order. Throws input_error where a sigma is negative or a range reaches 0.
  explicit uncertain_body(const std::array<uncertain_moment, 3>& given);

  /// Of every member of the ranges, or undecided; planar only where every sigma is 0. The order of
  /// the moments need not be known, and they may be equal.
  ///
  /// All are physical exactly where each moment's upper end is at most the sum of the others' lower
  /// ends. None is exactly where one moment's lower end is above the sum of the others' upper ends:
  /// the sets of moments in which the first, the second, the third exceeds the sum of the others
  /// are open and disjoint, and the ranges' product is connected, so that it lies in one of them.
  [[nodiscard]] body_kind kind() const;

  /// Whether the ranges are disjoint: then the axes x, y, z are known, and the ranges below exist.
  [[nodiscard]] bool is_ordered() const { return ordered_.has_value(); }
  [[nodiscard]] const std::array<int, 3>& order() const { return order_; }
  /// Those of I_x, I_y, I_z, in this order. Nothing where not is_ordered().
  [[nodiscard]] const std::optional<std::array<rational_range, 3>>& ordered() const {
    return ordered_;
  }

  /// The range of the geometric constant: from its square I_y I_z/((I_x - I_y)(I_x - I_z)) it
  /// increases in I_y and I_z and decreases in I_x, so that the ends are its values at two corners.
  /// Undefined where not is_ordered().
  [[nodiscard]] ball geometric_constant(precision p) const;
  /// The same of J, where (J + 1)^2 = I_x I_y/((I_y - I_z)(I_x - I_z)) decreases in I_x and I_y and
  /// increases in I_z.
  [[nodiscard]] ball second_geometric_constant(precision p) const;
  /// a = I_y/I_z - 1 and b = 1 - I_y/I_x, by the corners. Undefined where not is_ordered().
  [[nodiscard]] ball a(precision p) const;
  [[nodiscard]] ball b(precision p) const;

 private:
  /// The bodies at two corners: each moment at its upper end where the flag says so, and at its
  /// other end.
  [[nodiscard]] std::array<body, 2> corners(bool x_up, bool y_up, bool z_up) const;

  std::array<rational_range, 3> given_;
  std::optional<std::array<rational_range, 3>> ordered_;  // of I_x, I_y, I_z
  std::array<int, 3> order_{0, 1, 2};
};

}  // namespace polhode
