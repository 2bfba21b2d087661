#include "scene/exact_quaternion.hpp"

#include <algorithm>

#include "polhode/rigid_body/rotor.hpp"

namespace polhode::detail {

namespace {

/// Of a rotation with rational entries: 4 q_i^2 and 4 q_i q_k are sums of these. Where the greatest
/// component is rational, all are; where it is not, a component is 0 or not rational.
exact_quaternion quaternion_of(const matrix3<rational>& m) {
  const std::array<rational, 4> squares{
      1 + m[0][0] + m[1][1] + m[2][2], 1 + m[0][0] - m[1][1] - m[2][2],
      1 - m[0][0] + m[1][1] - m[2][2], 1 - m[0][0] - m[1][1] + m[2][2]};
  const auto g =
      static_cast<std::size_t>(std::max_element(squares.begin(), squares.end()) - squares.begin());
  const std::array<rational, 3> with_w{m[2][1] - m[1][2], m[0][2] - m[2][0], m[1][0] - m[0][1]};
  matrix3<rational> others;  // 4 q_i q_k of x, y, z
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) others[i][k] = m[i][k] + m[k][i];
  }
  const auto greatest = exact_root(rational(squares[g] / 4), 2);
  exact_quaternion result;
  for (std::size_t k = 0; k < 4; ++k) {
    if (k == g) {
      result[k] = greatest;
      continue;
    }
    const rational product =
        g == 0 ? with_w[k - 1] : (k == 0 ? with_w[g - 1] : others[g - 1][k - 1]);
    if (product == 0) {
      result[k] = rational(0);
    } else if (greatest) {
      result[k] = product / (4 * *greatest);
    }
  }
  return result;
}

/// Of R_z(phi) R_x(theta) R_z(psi): cos(theta/2) and sin(theta/2) times cosines and sines of (phi +
/// psi)/2 and (phi - psi)/2.
exact_quaternion quaternion_of(const rational_vector& phi_theta_psi, angle_unit unit) {
  const auto& [phi, theta, psi] = phi_theta_psi;
  const bool has_degrees = unit == angle_unit::degrees;
  const auto cosine = [&](const rational& x) { return exact_cosine(x, unit).as_rational(); };
  const auto sine = [&](const rational& x) { return exact_sine(x, unit).as_rational(); };
  const auto product = [](const std::optional<rational>& x,
                          const std::optional<rational>& y) -> std::optional<rational> {
    if ((x && *x == 0) || (y && *y == 0)) return rational(0);
    return x && y ? std::optional(rational(*x * *y)) : std::nullopt;
  };
  const rational half = theta / 2;
  const rational sum = (phi + psi) / 2;
  const rational difference = (phi - psi) / 2;
  exact_quaternion result{product(cosine(half), cosine(sum)),
                          product(sine(half), cosine(difference)),
                          product(sine(half), sine(difference)), product(cosine(half), sine(sum))};
  if (!has_degrees) return result;
  // 2 cos x cos y = cos(x + y) + cos(x - y), where these are rational and the factors are not.
  const auto of_sum = [&](std::optional<rational>& to, const rational& x, const rational& y) {
    const auto one = cosine(x + y);
    const auto other = cosine(x - y);
    if (!to && one && other) to = (*one + *other) / 2;
  };
  of_sum(result[0], half, sum);
  of_sum(result[1], half - 90, difference);
  of_sum(result[2], half - 90, difference - 90);
  of_sum(result[3], half, sum - 90);
  return result;
}

constexpr precision bits_of_search = 256;

mpfr_float in_mpfr(const rational& q) { return midpoint(ball(q, bits_of_search)); }

/// (x + x^-T)/2, with the cofactors over the determinant as x^-T.
matrix3<mpfr_float> polar_step(const matrix3<mpfr_float>& x) {
  matrix3<mpfr_float> cofactors;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& u = x[(i + 1) % 3];
    const auto& v = x[(i + 2) % 3];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t m = (k + 1) % 3;
      const std::size_t n = (k + 2) % 3;
      cofactors[i][k] = u[m] * v[n] - u[n] * v[m];
    }
  }
  const mpfr_float determinant =
      x[0][0] * cofactors[0][0] + x[0][1] * cofactors[0][1] + x[0][2] * cofactors[0][2];
  matrix3<mpfr_float> result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k)
      result[i][k] = (x[i][k] + cofactors[i][k] / determinant) / 2;
  }
  return result;
}

/// To 128 bits.
rational rounded(const mpfr_float& x) {
  constexpr int bits = 128;
  integer n;
  mpfr_get_z(n.backend().data(), mpfr_float(ldexp(x, bits)).backend().data(), MPFR_RNDN);
  return {n, integer(1) << bits};
}

}  // namespace

projected_rotation nearest_rotation(const matrix3<rational>& rows) {
  matrix3<mpfr_float> x;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) x[i][k] = in_mpfr(rows[i][k]);
  }
  constexpr int steps = 60;  // it converges quadratically, after halving what is large
  for (int i = 0; i < steps; ++i) x = polar_step(x);
  // 4 q q_k for each component q_k, with the q of the greatest size.
  const std::array<std::array<mpfr_float, 4>, 4> products{
      {{1 + x[0][0] + x[1][1] + x[2][2], x[2][1] - x[1][2], x[0][2] - x[2][0], x[1][0] - x[0][1]},
       {x[2][1] - x[1][2], 1 + x[0][0] - x[1][1] - x[2][2], x[0][1] + x[1][0], x[0][2] + x[2][0]},
       {x[0][2] - x[2][0], x[0][1] + x[1][0], 1 - x[0][0] + x[1][1] - x[2][2], x[1][2] + x[2][1]},
       {x[1][0] - x[0][1], x[0][2] + x[2][0], x[1][2] + x[2][1], 1 - x[0][0] - x[1][1] + x[2][2]}}};
  std::size_t greatest = 0;
  for (std::size_t i = 1; i < 4; ++i) {
    if (products[i][i] > products[greatest][greatest]) greatest = i;
  }
  projected_rotation result;
  for (std::size_t i = 0; i < 4; ++i) {
    if (!isfinite(products[greatest][i])) throw input_error("the matrix has no nearest rotation");
    result.quaternion[i] = rounded(products[greatest][i]);
  }
  const matrix3<rational> rotation = rotation_of(result.quaternion);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const rational off(rows[i][k] - rotation[i][k]);
      result.squared_distance += off * off;
    }
  }
  return result;
}

exact_quaternion quaternion_at_0(const scene_state& state) {
  if (state.euler) {
    if (state.euler_axes != triple<int>{2, 0, 2}) return {};
    return quaternion_of(*state.euler, state.euler_unit);
  }
  if (state.matrix) return quaternion_of(*state.matrix);
  if (state.quaternion) return quaternion_of(rotation_of(*state.quaternion));
  return {rational(1), rational(0), rational(0), rational(0)};
}

}  // namespace polhode::detail
