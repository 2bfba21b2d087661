// The forms of an attitude: quaternion and angles.

#include <cmath>

#include "polhode/arithmetic/elementary.hpp"
#include "rigid_body/rotor_scalars.hpp"

namespace polhode {
namespace {

double square_root(double x) { return std::sqrt(x); }
template <class T>
T square_root(const T& x) {
  return detail::root_of(x);
}
double arc(double y, double x) { return std::atan2(y, x); }
mpfr_float arc(const mpfr_float& y, const mpfr_float& x) { return detail::angle_of(y, x); }
ball arc(const ball& y, const ball& x) {
  const ball angle = detail::angle_of(y, x);
  const ball half = pi(angle.precision());
  return certainly_less(half, angle) ? angle - 2 * half : angle;
}
bool is_origin(double x, double y) {
  return x == 0 && y == 0;
}  // NOLINT: the numbers that they are
template <class T>
bool is_origin(const T& x, const T& y) {
  return detail::is_zero_number(x) && detail::is_zero_number(y);
}
mpfr_float middle_of(const ball& x) { return midpoint(x); }
template <class T>
const T& middle_of(const T& x) {
  return x;
}

}  // namespace

template <class T>
std::array<T, 4> rotor_attitude<T>::quaternion() const {
  const auto& m = matrix;
  // Four times the squares of w, x, y, z, of which the greatest is at least 1 (S. W. Shepperd, J.
  // Guidance and Control 1, 1978).
  const std::array<T, 4> squares{
      T(1 + m[0][0] + m[1][1] + m[2][2]), T(1 + m[0][0] - m[1][1] - m[2][2]),
      T(1 - m[0][0] + m[1][1] - m[2][2]), T(1 - m[0][0] - m[1][1] + m[2][2])};
  std::size_t k = 0;
  for (std::size_t i = 1; i < 4; ++i) {
    if (middle_of(squares[k]) < middle_of(squares[i])) k = i;
  }
  const T root = square_root(squares[k]);  // twice the greatest
  const T factor = T(1 / (2 * root));
  const auto sum = [&](std::size_t i, std::size_t j) { return T((m[i][j] + m[j][i]) * factor); };
  const auto difference = [&](std::size_t i, std::size_t j) {
    return T((m[i][j] - m[j][i]) * factor);
  };
  const T itself = T(root / 2);
  switch (k) {
    case 0:
      return {itself, difference(2, 1), difference(0, 2), difference(1, 0)};
    case 1:
      return {difference(2, 1), itself, sum(0, 1), sum(0, 2)};
    case 2:
      return {difference(0, 2), sum(0, 1), itself, sum(1, 2)};
    default:
      return {difference(1, 0), sum(0, 2), sum(1, 2), itself};
  }
}

template <class T>
rotor_angles<T> rotor_attitude<T>::angles() const {
  const auto& [x, y, z] = direction;
  T psi = T(x - x);
  T sine = psi;
  if (!is_origin(across[0], across[1])) {
    sine = square_root(T(x * x + y * y));
    psi = arc(across[1], T(-across[0]));
  }
  return {T(phase - arc(lag[0], lag[1])), arc(sine, z), std::move(psi)};
}

template struct rotor_attitude<ball>;
template struct rotor_attitude<mpfr_float>;
template struct rotor_attitude<double>;

}  // namespace polhode
