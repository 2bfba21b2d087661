#include <stdexcept>
#include <string>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/rigid_body/rotor.hpp"
#include "rigid_body/vectors.hpp"

namespace polhode {
namespace {

int sign_of_rational(const rational& q) { return q > 0 ? 1 : (q < 0 ? -1 : 0); }

void refuse_rest(const triple<rational>& v, const char* what) {
  if (v[0] != 0 || v[1] != 0 || v[2] != 0) return;
  throw input_error(std::string(what) + " 0, 0, 0: the body rests; one component must not be 0");
}

triple<ball> turned_by(const matrix3<ball>& turn, const triple<ball>& v) {
  return {detail::dot(turn[0], v), detail::dot(turn[1], v), detail::dot(turn[2], v)};
}

}  // namespace

initial_state initial_state::from_momentum(const triple<rational>& moments,
                                           const triple<rational>& momentum) {
  refuse_unless_positive(moments);
  refuse_rest(momentum, "angular momentum");
  triple<rational> squares;
  triple<int> senses{};
  for (std::size_t i = 0; i < 3; ++i) {
    squares[i] = momentum[i] * momentum[i];
    senses[i] = sign_of_rational(momentum[i]);
  }
  return from_squared_momentum(moments, squares, senses);
}

initial_state initial_state::from_tensor(std::shared_ptr<const principal_axes> tensor,
                                         const triple<rational>& momentum,
                                         const exact_rotation& turn) {
  refuse_rest(momentum, "angular momentum");
  initial_state s(std::move(tensor));
  s.turn_ = turn;
  const triple<exact_real> inner = turn.inverse().of({momentum[0], momentum[1], momentum[2]});
  s.squared_momentum_ = detail::dot(momentum, momentum);
  s.settle(inner, s.axes_->solved(inner));
  return s;
}

initial_state initial_state::from_tensor_and_velocity(std::shared_ptr<const principal_axes> tensor,
                                                      const triple<rational>& omega,
                                                      const exact_rotation& turn) {
  refuse_rest(omega, "angular velocity");
  initial_state s(std::move(tensor));
  s.turn_ = turn;
  const triple<exact_real> inner = turn.inverse().of({omega[0], omega[1], omega[2]});
  const triple<exact_real> momentum = s.axes_->times(inner);
  s.squared_momentum_ = detail::dot(momentum, momentum);
  s.settle(momentum, inner);
  return s;
}

initial_state initial_state::from_squared_momentum(const triple<rational>& moments,
                                                   const triple<rational>& squares,
                                                   const triple<int>& senses) {
  refuse_unless_positive(moments);
  refuse_rest(squares, "angular momentum");
  for (std::size_t i = 0; i < 3; ++i) {
    const int sense = senses[i];
    if (sense >= -1 && sense <= 1 && sense * sense == sign_of_rational(squares[i])) continue;
    throw input_error("angular momentum: the square " + to_text(squares[i]) +
                      " does not go with the sign " + std::to_string(sense) +
                      "; it must be positive with -1 or 1, or 0 with 0");
  }
  initial_state s(std::make_shared<const principal_axes>(
      std::array<rational, 6>{moments[0], moments[1], moments[2], 0, 0, 0}));
  const rational square(squares[0] + squares[1] + squares[2]);
  s.squared_momentum_ = square;
  s.twice_energy_ =
      rational(squares[0] / moments[0] + squares[1] / moments[1] + squares[2] / moments[2]);
  const auto [order, signs] = *s.axes_->along_given_axes();
  for (std::size_t i = 0; i < 3; ++i) {
    const auto axis = static_cast<std::size_t>(order[i]);
    s.squares_[i] = rational(squares[axis] / square);
    s.senses_[i] = senses[axis] * signs[i];
  }
  s.settle();
  return s;
}

initial_state initial_state::from_angular_velocity(const triple<rational>& moments,
                                                   const triple<rational>& omega) {
  refuse_unless_positive(moments);
  refuse_rest(omega, "angular velocity");
  return from_momentum(moments, {rational(moments[0] * omega[0]), rational(moments[1] * omega[1]),
                                 rational(moments[2] * omega[2])});
}

initial_state initial_state::at_middle_of_twist(const body& rigid, const rational& c) {
  if (rigid.irrational_tensor()) {
    throw input_error(
        "the body's principal moments are irrational, and this start needs rational ones; give the "
        "tensor and the angular momentum");
  }
  const auto [x2, y2, z2] = polhode::motion(rigid, c).greatest_squares();
  const rational& x = x2.exact();
  const rational& z = z2.exact();
  return from_squared_momentum(
      {rational(1 / (1 - rigid.b().exact())), 1, rational(1 / (1 + rigid.a().exact()))}, {x, 0, z},
      {-sign_of_rational(x), 0, sign_of_rational(z)});
}

void initial_state::settle(const triple<exact_real>& momentum, const triple<exact_real>& omega) {
  twice_energy_ = detail::dot(momentum, omega);
  try {
    for (std::size_t i = 0; i < 3; ++i) {
      senses_[i] = axes_->sense_along(i, momentum);
      squares_[i] = axes_->square_along(i, momentum) / squared_momentum_;
    }
    for (std::size_t i = 0; i < 3; ++i) {
      if (senses_[(i + 1) % 3] == 0 && senses_[(i + 2) % 3] == 0) squares_[i] = 1;
    }
    settle();
  } catch (const std::domain_error&) {
    throw input_error(
        "the angular momentum: the sign of a component along a principal axis, or of c, is not "
        "decided; if it is 0, give the frame by a quaternion or a matrix of rational numbers");
  }
}

/// 2 H/J^2 is a rational number q > 0, and c = q I_y - 1 is rational where I_y is, and else
/// irrational: its sign is decided. Where moments are irrational they are different, and the motion
/// is an equilibrium where J is along an axis, two of its components being 0, which principal_axes
/// decides; by comparing c with a and -b enclosures would not. The same where a turn of the tensor
/// makes J or omega irrational; then c = a J_z^2/J^2 - b J_x^2/J^2, which is the same number, as
/// 2 H I_y/J^2 is the sum of (1 - b) J_x^2/J^2, J_y^2/J^2 and (1 + a) J_z^2/J^2, and rational where
/// a symmetric top is in an equilibrium.
void initial_state::settle() {
  const auto& [x, y, z] = axes_->moments();
  const exact_real a = y / z - 1;
  const exact_real b = 1 - y / x;
  const exact_real q = twice_energy_ / squared_momentum_;
  const exact_real c = q.is_rational() ? y * q - 1 : a * squares_[2] - b * squares_[0];
  const bool along_x = senses_[1] == 0 && senses_[2] == 0;
  const bool along_y = senses_[0] == 0 && senses_[2] == 0;
  const bool along_z = senses_[0] == 0 && senses_[1] == 0;
  if (a.is_rational() && b.is_rational() && c.is_rational()) {
    motion_ = polhode::motion(a, b, c);
  } else {
    const int sign =
        c.sign(turn_.is_identity() ? exact_real::most_bits : principal_axes::most_bits_of_sense);
    motion_ = polhode::motion(a, b, c,
                              along_x     ? regime::equilibrium_x
                              : along_z   ? regime::equilibrium_z
                              : sign == 0 ? regime::separatrix
                              : sign < 0  ? regime::oscillating
                                          : regime::rotating);
  }
  regime_ =
      motion_.regime() == regime::separatrix && along_y ? regime::equilibrium_y : motion_.regime();

  // A half turn about an axis changes the signs of the other two.
  const bool separatrix = regime_ == regime::separatrix;
  const bool turn_x = (regime_ == regime::oscillating || separatrix) && senses_[0] > 0;
  const bool turn_z = (regime_ == regime::rotating || separatrix) && senses_[2] < 0;
  if (turn_x) signs_[0] = -1;
  if (turn_z) signs_[2] = -1;
  if (turn_x != turn_z) signs_[1] = -1;
  for (std::size_t i = 0; i < 3; ++i) senses_[i] *= signs_[i];
}

std::optional<axis_order> initial_state::along_body_axes() const {
  if (!turn_.is_identity()) return std::nullopt;
  auto result = axes_->along_given_axes();
  if (result) {
    for (std::size_t i = 0; i < 3; ++i) result->signs[i] *= signs_[i];
  }
  return result;
}

matrix3<ball> initial_state::frame(precision p) const {
  const matrix3<ball> turn = turn_.matrix(p);
  matrix3<ball> result;
  for (std::size_t i = 0; i < 3; ++i) {
    result[i] = turned_by(turn, axes_->axis(i, p));
    for (ball& one : result[i]) one *= signs_[i];
  }
  return result;
}

void initial_state::set_matrix(const matrix3<rational>& rows) {
  attitude_ = exact_rotation::of_matrix(rows);
}

void initial_state::set_quaternion(const std::array<rational, 4>& wxyz) {
  attitude_ = exact_rotation::of_quaternion(wxyz);
}

void initial_state::set_euler_angles(const triple<rational>& angles, angle_unit unit,
                                     const triple<int>& axes) {
  exact_rotation turned;
  for (std::size_t i = 0; i < 3; ++i) {
    if (axes[i] < 0 || axes[i] > 2 || (i > 0 && axes[i] == axes[i - 1])) {
      throw input_error("Euler angles: the axes must be three of 0, 1, 2, none after itself");
    }
    turned = turned * exact_rotation::about(static_cast<std::size_t>(axes[i]), angles[i], unit);
  }
  attitude_ = turned;
}

}  // namespace polhode
