#include "polhode/rigid_body/exact_rotation.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "polhode/arithmetic/certain_digits.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/text.hpp"
#include "rigid_body/vectors.hpp"

namespace polhode {
namespace {

using detail::cross;
using detail::dot;

bool is_zero(const triple<rational>& v) { return v[0] == 0 && v[1] == 0 && v[2] == 0; }

/// Bits before the point of q, about.
precision bits_before_point(const rational& q) {
  const auto bits = [](const integer& n) {
    return static_cast<precision>(mpz_sizeinbase(n.backend().data(), 2));
  };
  return std::max<precision>(bits(numerator(q)) - bits(denominator(q)) + 1, 0);
}

/// Of a number of radians that is not 0, or of degrees where that sine is irrational.
exact_real irrational_sine(const rational& angle, angle_unit unit) {
  const bool has_degrees = unit == angle_unit::degrees;
  return exact_real::irrational(
      [angle, has_degrees](precision p) {
        // Of a large angle p bits are wanted behind the point.
        const precision bits = p + 8 + bits_before_point(angle);
        ball x(angle, bits);
        if (has_degrees) x = ball(rational(angle / 180), bits) * pi(bits);
        return sin(x).with_precision(p);
      },
      size_in_bits(angle));
}

/// Of q >= 0.
exact_real root_of(const rational& q) {
  if (const auto root = exact_root(q, 2)) return *root;
  return exact_real::irrational([q](precision p) { return sqrt(ball(q, p)); }, size_in_bits(q));
}

/// Between 0 and 360, less 360.
rational within_a_turn(const rational& degrees) {
  return rational(degrees - 360 * floor_of(rational(degrees / 360)));
}

}  // namespace

void refuse_unless_rotation(const matrix3<rational>& rows) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = i; j < 3; ++j) {
      const rational product = dot(rows[i], rows[j]);
      if (product == (i == j ? 1 : 0)) continue;
      throw input_error(
          "attitude matrix: rows " + std::to_string(i + 1) + " and " + std::to_string(j + 1) +
          " have the product " + to_text(product) + ", and must have exactly " +
          (i == j ? "1" : "0") +
          ", as of a rotation; a quaternion, whose norm is divided out, can be given instead");
    }
  }
  if (dot(rows[0], cross(rows[1], rows[2])) < 0) {
    throw input_error("attitude matrix: its determinant is -1, a reflection; it must be 1");
  }
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

/// A sine is rational at these multiples of 180 degrees alone among the rational ones (I. Niven,
/// Irrational Numbers, 1956, Corollary 3.12), and at 0 alone among the rational numbers of radians
/// (F. Lindemann, 1882).
exact_real exact_sine(const rational& angle, angle_unit unit) {
  if (angle == 0) return 0;
  if (unit == angle_unit::radians) return irrational_sine(angle, unit);
  const rational degrees = within_a_turn(angle);
  if (degrees == 0 || degrees == 180) return 0;
  if (degrees == 90) return 1;
  if (degrees == 270) return -1;
  if (degrees == 30 || degrees == 150) return rational(1, 2);
  if (degrees == 210 || degrees == 330) return rational(-1, 2);
  return irrational_sine(degrees, unit);
}

exact_real exact_cosine(const rational& angle, angle_unit unit) {
  if (angle == 0) return 1;
  if (unit == angle_unit::degrees) return exact_sine(rational(angle + 90), unit);
  return exact_real::irrational(
      [angle](precision p) {
        return cos(ball(angle, p + 8 + bits_before_point(angle))).with_precision(p);
      },
      size_in_bits(angle));
}

exact_rotation exact_rotation::of_columns(const matrix3<rational>& columns) {
  frame result{columns, {}, false};
  for (std::size_t i = 0; i < 3; ++i) result.squares[i] = dot(columns[i], columns[i]);
  return exact_rotation(factor{std::move(result), {}});
}

exact_rotation exact_rotation::of_turn(turn one) {
  if (one.sine.is_rational() && one.sine == 0 && one.cosine == one.divisor) return {};
  return exact_rotation(factor{std::nullopt, std::move(one)});
}

exact_rotation exact_rotation::of_matrix(const matrix3<rational>& rows) {
  refuse_unless_rotation(rows);
  matrix3<rational> columns;
  bool is_identity = true;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      columns[k][i] = rows[i][k];
      is_identity = is_identity && rows[i][k] == (i == k ? 1 : 0);
    }
  }
  return is_identity ? exact_rotation() : of_columns(columns);
}

exact_rotation exact_rotation::of_quaternion(const std::array<rational, 4>& wxyz) {
  return of_matrix(rotation_of(wxyz));
}

exact_rotation exact_rotation::about(std::size_t axis, const rational& angle, angle_unit unit) {
  const exact_real sine = exact_sine(angle, unit);
  if (unit == angle_unit::degrees && !sine.is_rational()) {
    const rational degrees = within_a_turn(angle);
    if (degrees / 45 == floor_of(rational(degrees / 45))) {  // an odd multiple of 45 degrees
      return of_turn(
          {axis, degrees < 90 || degrees > 270 ? 1 : -1, degrees < 180 ? 1 : -1, root_of(2)});
    }
  }
  return of_turn({axis, exact_cosine(angle, unit), sine, 1});
}

/// In a frame with the axis as its third.
exact_rotation exact_rotation::about(const triple<rational>& axis, const rational& angle,
                                     angle_unit unit) {
  if (is_zero(axis)) throw input_error("a rotation's axis 0, 0, 0: one component must not be 0");
  const triple<rational> across = cross(axis, {0, 0, 1});
  if (is_zero(across)) return about(2, axis[2] > 0 ? angle : rational(-angle), unit);
  exact_rotation turned = about(2, angle, unit);
  if (turned.is_identity()) return turned;
  const exact_real sine = exact_sine(angle, unit);
  if (sine.is_rational() && sine == 0) {  // by 180 degrees
    return of_quaternion({0, axis[0], axis[1], axis[2]});
  }
  const exact_rotation to = of_columns({across, cross(axis, across), axis});
  return to * turned * to.inverse();
}

exact_rotation exact_rotation::with_axes(const triple<rational>& x, const triple<rational>& y) {
  const triple<rational> z = cross(x, y);
  if (is_zero(z)) throw input_error("the axes x and y of a frame are parallel, or 0");
  const triple<rational> second = cross(z, x);
  if (x[1] == 0 && x[2] == 0 && x[0] > 0 && second[2] == 0 && second[1] > 0) return {};
  return of_columns({x, second, z});
}

exact_rotation exact_rotation::with_third_axis(const triple<rational>& z) {
  if (is_zero(z)) throw input_error("a frame's axis z 0, 0, 0: one component must not be 0");
  const rational across2(z[0] * z[0] + z[1] * z[1]);
  if (across2 == 0) return z[2] > 0 ? exact_rotation() : about(0, 180, angle_unit::degrees);
  // About e_2 x z, by the angle with these; in a frame with that axis as its first.
  const triple<rational> axis{-z[1], z[0], 0};
  const exact_rotation to = of_columns({axis, cross({0, 0, 1}, axis), {0, 0, 1}});
  const exact_real length = root_of(rational(across2 + z[2] * z[2]));
  return to * of_turn({0, z[2], root_of(across2), length}) * to.inverse();
}

exact_rotation operator*(const exact_rotation& x, const exact_rotation& y) {
  exact_rotation result = y;
  result.factors_.insert(result.factors_.end(), x.factors_.begin(), x.factors_.end());
  return result;
}

exact_rotation exact_rotation::inverse() const {
  exact_rotation result = *this;
  std::reverse(result.factors_.begin(), result.factors_.end());
  for (factor& one : result.factors_) {
    if (one.by_columns) {
      one.by_columns->is_inverse = !one.by_columns->is_inverse;
    } else {
      one.by_angle.sine = -one.by_angle.sine;
    }
  }
  return result;
}

triple<exact_real> exact_rotation::of(triple<exact_real> v) const {
  for (const factor& one : factors_) {
    if (!one.by_columns) {
      const turn& by = one.by_angle;
      exact_real& m = v[(by.axis + 1) % 3];
      exact_real& n = v[(by.axis + 2) % 3];
      const exact_real before = m;
      m = (by.cosine * before - by.sine * n) / by.divisor;
      n = (by.sine * before + by.cosine * n) / by.divisor;
      continue;
    }
    const auto& [columns, squares, is_inverse] = *one.by_columns;
    triple<exact_real> to{0, 0, 0};
    for (std::size_t i = 0; i < 3; ++i) {
      const exact_real length = root_of(squares[i]);
      if (is_inverse) {
        to[i] = dot(columns[i], v) / length;
        continue;
      }
      for (std::size_t k = 0; k < 3; ++k) to[k] = to[k] + columns[i][k] * v[i] / length;
    }
    v = to;
  }
  return v;
}

matrix3<ball> exact_rotation::matrix(precision p) const {
  matrix3<ball> result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) result[i][k] = ball(i == k ? 1 : 0, p);
  }
  for (const factor& one : factors_) {
    matrix3<ball> rows;
    if (one.by_columns) {
      const auto& [columns, squares, is_inverse] = *one.by_columns;
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
          const ball entry = columns[i][k] / root_of(squares[i]).at(p);
          (is_inverse ? rows[i][k] : rows[k][i]) = entry;
        }
      }
    } else {
      const turn& by = one.by_angle;
      const std::size_t m = (by.axis + 1) % 3;
      const std::size_t n = (by.axis + 2) % 3;
      for (auto& row : rows) row.fill(ball(0, p));
      rows[by.axis][by.axis] = ball(1, p);
      rows[m][m] = rows[n][n] = (by.cosine / by.divisor).at(p);
      rows[n][m] = (by.sine / by.divisor).at(p);
      rows[m][n] = -rows[n][m];
    }
    matrix3<ball> product;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        product[i][k] =
            rows[i][0] * result[0][k] + rows[i][1] * result[1][k] + rows[i][2] * result[2][k];
      }
    }
    result = product;
  }
  return result;
}

std::optional<matrix3<rational>> exact_rotation::rational_matrix() const {
  matrix3<rational> result;
  for (std::size_t k = 0; k < 3; ++k) {
    triple<exact_real> unit{0, 0, 0};
    unit[k] = 1;
    const triple<exact_real> column = of(unit);
    for (std::size_t i = 0; i < 3; ++i) {
      if (!column[i].is_rational()) return std::nullopt;
      result[i][k] = column[i].exact();
    }
  }
  return result;
}

}  // namespace polhode
