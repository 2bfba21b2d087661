#pragma once

// The free rotation of a rigid body in closed form, at any time: its angular momentum in the body
// and its attitude in space.
//
// Conventions. The body axes are those in which the inertia tensor T is given, or the moments: then
// they are principal axes. Moments may be equal. The attitude is the matrix R that takes
// coordinates in the body to coordinates in space: its columns are the body axes as seen in space.
// The angular momentum J and the angular velocity omega are given in the body axes, J = T omega;
//   dJ/dt = J x omega,   dR/dt = R [omega]x,   and R J does not change.
// Units are the caller's: time is in the unit that makes momentum/moment its inverse.
//
// Principal axes x, y, z are those of principal_axes.hpp, turned by half turns about them so that
// J_x < 0 (oscillating), J_z > 0 (rotating), or both (separatrix): these are symmetries of the
// motion. There, in units of |J| and I_y/|J|, J is one of the three solutions of motion.hpp. Which
// of them it is, and whether the motion is steady, is decided exactly. About J the body turns by
// the angle phi of the paper's Euler angles, dphi/dt = 1 - b J_x^2/(J_x^2 + J_y^2), which is an
// elliptic integral of the third kind; here it is had from theta functions (C. G. J. Jacobi, J.
// reine angew. Math. 39, 1850): src/rigid_body/rotor_series.hpp has the formula, its proof and the
// bounds of what its series leave out.

#include <array>
#include <concepts>
#include <memory>
#include <optional>

#include "polhode/arithmetic/boost_bridge.hpp"
#include "polhode/rigid_body/exact_rotation.hpp"
#include "polhode/rigid_body/motion.hpp"
#include "polhode/rigid_body/principal_axes.hpp"

namespace polhode {

/// A body with its motion at time 0, exact.
class initial_state {
 public:
  /// Throw input_error, which says what was given and what would be right, where a moment is not
  /// positive, and where the momentum (or velocity) is 0: such a body rests. The attitude is that
  /// of body axes along the axes of space.
  static initial_state from_momentum(const triple<rational>& moments,
                                     const triple<rational>& momentum);
  static initial_state from_angular_velocity(const triple<rational>& moments,
                                             const triple<rational>& omega);
  /// The same of a body by its inertia tensor, with J or omega in the body axes. The tensor is
  /// given in axes of its own: `turn` takes coordinates along these to those along the body axes.
  /// Throws input_error, too, where the turn is irrational and the sign of a component of J along a
  /// principal axis, or of c, is not decided.
  static initial_state from_tensor(std::shared_ptr<const principal_axes> tensor,
                                   const triple<rational>& momentum,
                                   const exact_rotation& turn = {});
  static initial_state from_tensor_and_velocity(std::shared_ptr<const principal_axes> tensor,
                                                const triple<rational>& omega,
                                                const exact_rotation& turn = {});
  /// The momentum by the squares of its components and their signs -1, 0, 1: the components
  /// themselves may be irrational. Throws input_error, too, where these contradict each other.
  static initial_state from_squared_momentum(const triple<rational>& moments,
                                             const triple<rational>& squares,
                                             const triple<int>& senses);
  /// The motion c of a body with I_y = 1 and |J| = 1, axes in the order x, y, z, from the middle of
  /// the twist: u_0 = 0, psi = 0. Throws input_error for c outside [-b, a].
  static initial_state at_middle_of_twist(const body& rigid, const rational& c);

  /// The attitude at time 0. Each throws input_error for what is no rotation: a matrix (by rows)
  /// with R R^T not exactly 1 or determinant -1, a quaternion w + x i + y j + z k of norm 0
  /// (another norm is divided out: it enters R squared).
  void set_matrix(const matrix3<rational>& rows);
  void set_quaternion(const std::array<rational, 4>& wxyz);
  /// R = R_i(first) R_j(second) R_k(third) about the axes i, j, k of the body (0 for x), each
  /// turned with it: z-x-z, the classical phi, theta, psi, or 2, 1, 0 for yaw, pitch and roll.
  /// Throws input_error where an axis follows itself.
  void set_euler_angles(const triple<rational>& angles, angle_unit unit = angle_unit::radians,
                        const triple<int>& axes = {2, 0, 2});

  /// The tensor with its principal axes, in the axes in which it is given, before the half turns.
  [[nodiscard]] const principal_axes& tensor() const { return *axes_; }
  /// J^2 and 2 H.
  [[nodiscard]] const exact_real& squared_momentum() const { return squared_momentum_; }
  [[nodiscard]] const exact_real& twice_energy() const { return twice_energy_; }
  /// The motion with its a, b and c: a >= 0 and 0 <= b < 1 are 0 where moments are equal.
  [[nodiscard]] const polhode::motion& motion() const { return motion_; }
  /// That of the motion, but equilibrium_y where J is exactly along y. An equilibrium is J parallel
  /// to omega; of a spherical top every motion is one.
  [[nodiscard]] polhode::regime regime() const { return regime_; }
  /// The principal axes where each is a body axis or the opposite of one: J_x = signs[0]
  /// J[order[0]].
  [[nodiscard]] std::optional<axis_order> along_body_axes() const;
  /// Unit vectors along x, y, z in the body axes, by rows, to about p bits.
  [[nodiscard]] matrix3<ball> frame(precision p) const;
  /// J_x^2/J^2, J_y^2/J^2, J_z^2/J^2 and the signs (-1, 0, 1) of J_x, J_y, J_z in the principal
  /// axes.
  [[nodiscard]] const triple<exact_real>& direction_squares() const { return squares_; }
  [[nodiscard]] const triple<int>& direction_signs() const { return senses_; }
  /// R at time 0, to about p bits.
  [[nodiscard]] matrix3<ball> attitude(precision p) const { return attitude_.matrix(p); }

 private:
  explicit initial_state(std::shared_ptr<const principal_axes> axes) : axes_(std::move(axes)) {}
  /// From J and omega in the axes of the tensor.
  void settle(const triple<exact_real>& momentum, const triple<exact_real>& omega);
  /// From J^2 and 2 H, and the squares, over J^2, and signs of J's components in the principal
  /// axes.
  void settle();

  std::shared_ptr<const principal_axes> axes_;
  exact_rotation turn_;
  exact_real squared_momentum_ = 0;
  exact_real twice_energy_ = 0;
  polhode::motion motion_{0, 0, 0};
  polhode::regime regime_ = motion_.regime();
  triple<int> signs_{1, 1, 1};
  triple<exact_real> squares_{0, 0, 0};
  triple<int> senses_{0, 0, 0};
  exact_rotation attitude_;
};

/// In the body axes.
template <class T>
struct rotor_sample {
  triple<T> momentum;
  triple<T> angular_velocity;
};

/// phi is counted from 0 at time 0 and never reduced by turns; theta in [0, pi]; psi in [-pi, pi].
template <class T>
struct rotor_angles {
  T phi, theta, psi;
};

/// An attitude, with the numbers from which its other forms are computed.
template <class T>
struct rotor_attitude {
  /// R by rows.
  matrix3<T> matrix;
  /// J/|J| in the principal axes x, y, z.
  triple<T> direction;
  /// What angles() needs: phi is phase - atan2(lag[0], lag[1]); J_x and J_y times a common positive
  /// factor.
  T phase;
  std::array<T, 2> lag;
  std::array<T, 2> across;

  /// w, x, y, z of R, of norm 1; of the two, q and -q, the one whose component of greatest size is
  /// positive.
  [[nodiscard]] std::array<T, 4> quaternion() const;
  /// The paper's angles of the principal axes about J: J = |J| (-sin theta cos psi, sin theta sin
  /// psi, cos theta), and R_z(phi) R_y(theta) R_z(psi) takes them to axes of which the third is
  /// along J. (In z-x-z: phi + pi/2, theta, psi - pi/2.) Where J is exactly along z, psi is 0.
  [[nodiscard]] rotor_angles<T> angles() const;
};

namespace detail {
template <class T>
class rotor_motion;
}

/// The motion from a state; T is ball, mpfr_float or double, from the same templates. All that does
/// not depend on time is computed once. A sample costs the same at every time (but for log2(t/T)
/// bits more), momentum without any integral of the third kind. May be used by many threads at
/// once; copies share what they hold.
///   ball        enclosures. Components of J, omega and R have radii of at most 2^-p of |J|, of
///               |J|/I_i and of 1, where I_i is the moment along the component's axis and, where
///               that is no principal axis, I_z: precision is raised until they do (by up to 2^18
///               bits: beyond, they are as wide as they are). p = precision.
///   mpfr_float  the middle of the same computation: uncertified, to about p bits in the same
///               sense.
///   double      the state and t are taken as the exact numbers they are; then the error of J is a
///               few units of |J| in the last place, at any time below 2^50 periods. Computed in
///               long double.
template <class T>
class rotor {
 public:
  explicit rotor(const initial_state& state, precision p = 53);

  [[nodiscard]] rotor_sample<T> sample(const rational& t) const;
  [[nodiscard]] rotor_attitude<T> attitude(const rational& t) const;
  [[nodiscard]] rotor_sample<T> sample(double t) const requires std::same_as<T, double>;
  [[nodiscard]] rotor_attitude<T> attitude(double t) const requires std::same_as<T, double>;
  template <std::floating_point N>
  rotor_sample<T> sample(N t) const requires(!std::same_as<T, double>) = delete;
  template <std::floating_point N>
  rotor_attitude<T> attitude(N t) const requires(!std::same_as<T, double>) = delete;

  [[nodiscard]] const initial_state& state() const;
  /// |J|.
  [[nodiscard]] T momentum_size() const;
  /// The time in which J goes once around, 4 K/lambda; none where it is steady or on the
  /// separatrix.
  [[nodiscard]] std::optional<T> period() const;
  /// The angle by which the body has then turned about J: the Montgomery phase, unwrapped.
  [[nodiscard]] std::optional<T> phase_per_period() const;
  /// What was computed at once, for all times: elliptic integrals, those of repetitions with more
  /// digits included. Times so far that the digits do not suffice have their own, which are not
  /// counted.
  [[nodiscard]] const work_count& work() const;
  /// The mean of dphi/dt: that phase over the period; |J|/I where it is steady, |J|/I_y on the
  /// separatrix. It is the mean rate about J of the least axis. Where the motion is rotating, that
  /// is the wobble; where it is oscillating, J goes around the greatest axis, whose mean rate is
  /// this and 2 pi/period() more.
  [[nodiscard]] T mean_precession() const;

 private:
  std::shared_ptr<const detail::rotor_motion<T>> motion_;
};

extern template class rotor<ball>;
extern template class rotor<mpfr_float>;
extern template class rotor<double>;

}  // namespace polhode
