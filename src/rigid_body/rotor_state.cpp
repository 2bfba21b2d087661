#include <algorithm>
#include <string>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/rigid_body/rotor.hpp"

namespace polhode {
namespace {

int sign_of_rational(const rational& q) { return q > 0 ? 1 : (q < 0 ? -1 : 0); }

void refuse_rest(const triple<rational>& v, const char* what) {
  if (v[0] != 0 || v[1] != 0 || v[2] != 0) return;
  throw input_error(std::string(what) + " 0, 0, 0: the body rests; one component must not be 0");
}

/// Bits before the point of q, about.
precision bits_before_point(const rational& q) {
  const auto bits = [](const integer& n) {
    return static_cast<precision>(mpz_sizeinbase(n.backend().data(), 2));
  };
  return std::max<precision>(bits(numerator(q)) - bits(denominator(q)) + 1, 0);
}

rational determinant(const matrix3<rational>& m) {
  return rational(m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                  m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                  m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]));
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
                                         const triple<rational>& momentum) {
  refuse_rest(momentum, "angular momentum");
  initial_state s(std::move(tensor));
  const triple<rational> omega = s.axes_->solved(momentum);
  for (std::size_t i = 0; i < 3; ++i) {
    s.squared_momentum_ += momentum[i] * momentum[i];
    s.twice_energy_ += momentum[i] * omega[i];
  }
  for (std::size_t i = 0; i < 3; ++i) {
    s.squares_[i] = s.axes_->square_along(i, momentum) / s.squared_momentum_;
    s.senses_[i] = s.axes_->sense_along(i, momentum);
  }
  s.settle();
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
  for (std::size_t i = 0; i < 3; ++i) {
    s.squared_momentum_ += squares[i];
    s.twice_energy_ += squares[i] / moments[i];
  }
  const auto [order, signs] = *s.axes_->along_given_axes();
  for (std::size_t i = 0; i < 3; ++i) {
    const auto axis = static_cast<std::size_t>(order[i]);
    s.squares_[i] = rational(squares[axis] / s.squared_momentum_);
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

/// 2 H/J^2 is a rational number q > 0, and c = q I_y - 1 is rational where I_y is, and else
/// irrational: its sign is decided. Where moments are irrational they are different, and the motion
/// is an equilibrium where J is along an axis, two of its components being 0, which principal_axes
/// decides; by comparing c with a and -b enclosures would not.
void initial_state::settle() {
  const auto& [x, y, z] = axes_->moments();
  const exact_real a = y / z - 1;
  const exact_real b = 1 - y / x;
  const exact_real c = y * rational(twice_energy_ / squared_momentum_) - 1;
  const bool along_x = senses_[1] == 0 && senses_[2] == 0;
  const bool along_y = senses_[0] == 0 && senses_[2] == 0;
  const bool along_z = senses_[0] == 0 && senses_[1] == 0;
  if (axes_->rational_moments()) {
    motion_ = polhode::motion(a, b, c);
  } else {
    const int sign = c.sign();
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
  auto result = axes_->along_given_axes();
  if (result) {
    for (std::size_t i = 0; i < 3; ++i) result->signs[i] *= signs_[i];
  }
  return result;
}

matrix3<ball> initial_state::frame(precision p) const {
  matrix3<ball> result;
  for (std::size_t i = 0; i < 3; ++i) {
    result[i] = axes_->axis(i, p);
    for (ball& one : result[i]) one *= signs_[i];
  }
  return result;
}

void refuse_unless_rotation(const matrix3<rational>& rows) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = i; j < 3; ++j) {
      const rational product(rows[i][0] * rows[j][0] + rows[i][1] * rows[j][1] +
                             rows[i][2] * rows[j][2]);
      if (product == (i == j ? 1 : 0)) continue;
      throw input_error(
          "attitude matrix: rows " + std::to_string(i + 1) + " and " + std::to_string(j + 1) +
          " have the product " + to_text(product) + ", and must have exactly " +
          (i == j ? "1" : "0") +
          ", as of a rotation; a quaternion, whose norm is divided out, can be given instead");
    }
  }
  if (determinant(rows) < 0) {
    throw input_error("attitude matrix: its determinant is -1, a reflection; it must be 1");
  }
}

void initial_state::set_matrix(const matrix3<rational>& rows) {
  refuse_unless_rotation(rows);
  matrix_ = rows;
  angles_.reset();
}

matrix3<rational> rotation_of(const std::array<rational, 4>& wxyz) {
  const auto& [w, x, y, z] = wxyz;
  const rational norm(w * w + x * x + y * y + z * z);
  if (norm == 0) {
    throw input_error(
        "attitude quaternion 0, 0, 0, 0: it must not be 0, and stands for itself over its norm");
  }
  return {{{rational((w * w + x * x - y * y - z * z) / norm), rational(2 * (x * y - w * z) / norm),
            rational(2 * (x * z + w * y) / norm)},
           {rational(2 * (x * y + w * z) / norm), rational((w * w - x * x + y * y - z * z) / norm),
            rational(2 * (y * z - w * x) / norm)},
           {rational(2 * (x * z - w * y) / norm), rational(2 * (y * z + w * x) / norm),
            rational((w * w - x * x - y * y + z * z) / norm)}}};
}

void initial_state::set_quaternion(const std::array<rational, 4>& wxyz) {
  matrix_ = rotation_of(wxyz);
  angles_.reset();
}

void initial_state::set_euler_angles(const triple<rational>& angles, angle_unit unit,
                                     const triple<int>& axes) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (axes[i] >= 0 && axes[i] < 3 && (i == 0 || axes[i] != axes[i - 1])) continue;
    throw input_error("Euler angles: the axes must be three of 0, 1, 2, none after itself");
  }
  angles_ = angles;
  unit_ = unit;
  angle_axes_ = axes;
}

matrix3<ball> initial_state::attitude(precision p) const {
  matrix3<ball> r;
  if (!angles_) {
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) r[i][j] = ball(matrix_[i][j], p);
    }
    return r;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) r[i][j] = ball(i == j ? 1 : 0, p);
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const rational& angle = (*angles_)[i];
    // Of a large angle p bits are wanted behind the point.
    const precision bits = p + 8 + bits_before_point(angle);
    ball x(angle, bits);
    if (unit_ == angle_unit::degrees) x = ball(rational(angle / 180), bits) * pi(bits);
    const auto [sine, cosine] = sin_cos(x);
    const ball s = sine.with_precision(p);
    const ball c = cosine.with_precision(p);
    // By the rotation about e_k, which takes e_m to c e_m + s e_n.
    const auto m = static_cast<std::size_t>((angle_axes_[i] + 1) % 3);
    const auto n = static_cast<std::size_t>((angle_axes_[i] + 2) % 3);
    for (triple<ball>& row : r) {
      const ball before = row[m];
      row[m] = c * before + s * row[n];
      row[n] = c * row[n] - s * before;
    }
  }
  return r;
}

}  // namespace polhode
