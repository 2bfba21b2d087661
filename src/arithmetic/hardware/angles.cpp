// The angle of a point of the plane, and the inverse circular functions that are such angles, at a
// point with proofs and of intervals.

#include <algorithm>
#include <cmath>

#include "arithmetic/hardware/widening.hpp"
#include "polhode/arithmetic/double_interval.hpp"

namespace polhode {

using namespace detail::hardware;
namespace point = detail::approximation;
using detail::least_double;
using detail::next_up;

namespace {

// atan(b / a), 0 <= b <= a, 0 < a. It is 0 only for b = 0.
//
// z = RN(b / a). For z <= 1/16: t = z, c = 0. Else c = j/8, j the integer nearest to 8 z, and
// atan(b/a) = atan c + atan t, t = (b - c a) / (a + c b), |t| <= 0.0626.
// Both are scaled away from overflow and underflow first, exactly; b > a/17.
//   Error of t: c a is rounded by u c a (not at all for j = 1, 2, 4, 8); b - c a, the denominator
// (2) and the quotient round by 4.01 u relatively. With x = b/a: u (c' + 4.01 * 0.0626) / (1 + c
// x), where c' = 0 for those j and c for the others.
//   atan t = t + t S, S = sum_{n=1}^{6} (-1)^n t^2n / (2n+1), |t| <= 0.0626: |S| < 0.00132 with at
// most 20 roundings: 0.03 u |t|; the rest t^14 / 15 < 0.01 u; its sum: u |t|. Below |t| = 2^-54
// the value is t, off by t^2 / 3 relatively.
//   j = 0: u (quotient) + 0.03 u + 0.01 u + u < 2.1 u relatively; where z is subnormal, 2^-1075.
//   j = 1: the angle is above 0.0623, t off by 0.2511 u / 1.0078, atan c by 2^-57 = u / 16, the
// inner sum with its 0.04 by 1.04 * 0.0626 u = 0.0652 u, together 0.3767 u: relatively 6.05 u, and
// the last sum u: 7.1 u.
//   j >= 2: the angle is above 0.185. t is off by less than 0.67 u (j = 7: (0.875 + 0.2511) /
// (1 + 0.875 * 0.8124)), atan c by 2^-54 = 0.5 u for j >= 5, 0.25 u for j = 3, 4, 0.125 u for
// j = 2; the inner sum 0.0652 u. j = 2: t 0.2511 / 1.046 u, together 0.431 u: relatively 2.4 u;
// j = 3: t 0.561 u, together 0.877 u over 0.302: 2.9 u; j = 4: t 0.207 u: less; j >= 5: 1.24 u
// over 0.51: 2.5 u. The last sum: u. So below 4 u.
//   Altogether 7.1 u relatively; absolutely at most 1.74 u: 1.24 u, and 0.5 u for the last sum, a
// number below 1.
double first_octant(double b, double a) {
  double z = b / a;
  if (z < 0x1p-54) return z == 0 && b > 0 ? least_double : z;
  const double j = z > 0.0625 ? nearest(8 * z).value : 0;
  if (j > 0) {
    if (a > 0x1p1000) {
      a *= 0x1p-100;
      b *= 0x1p-100;
    } else if (a < 0x1p-900) {
      a *= 0x1p200;
      b *= 0x1p200;
    }
    const double c = 0.125 * j;
    z = (b - c * a) / (a + c * b);
  }
  const double y = z * z;
  const double y2 = y * y;
  const double c1 = -one_third + y * (1.0 / 5);
  const double c3 = -1.0 / 7 + y * (1.0 / 9);
  const double c5 = -1.0 / 11 + y * (1.0 / 13);
  const double value = z + z * (y * ((c1 + c3 * y2) + c5 * (y2 * y2)));
  return point::atan_of_eighths[static_cast<int>(j)] + value;
}

}  // namespace

namespace detail::approximation {

// Below the diagonal: 7.1 u. Above: pi/2 - (1.74 u), where half_pi is off by 0.56 u and the
// difference, at most 1.58, rounds by u: 3.3 u over 0.785: 4.3 u. For x < 0: pi - that; pi is
// off by 1.11 u, the angle at most by 3.3 u, the difference, at most 3.15, rounds by 2 u: 6.5 u
// over 1.57: 4.2 u. So 7.1 u <= 8 u.
double angle(double y, double x) {
  const double size = std::abs(x);
  const bool above = y > size;
  double value = first_octant(above ? size : y, above ? y : size);
  if (above) value = half_pi - value;
  return x < 0 ? 2 * half_pi - value : value;
}

// arg(w + i |x|) and arg(x + i w), w = sqrt((1 - x)(1 + x)), where w has a relative error of
// 3 u / 2 + u. The angle changes by sin(2 angle) / 2 <= angle of a relative change of w, and for
// obtuse angles by less. So 7.1 u + 2.6 u <= 16 u.
double asin(double x) {
  const double size = std::abs(x);
  return std::copysign(angle(size, std::sqrt((1 - size) * (1 + size))), x);
}
double acos(double x) { return angle(std::sqrt((1 - x) * (1 + x)), x); }

}  // namespace detail::approximation

namespace {

/// point::angle for the upper half-plane; its limit where y or x is infinite.
double angle_down(double y, double x) {
  if (y == 0) return 0;
  return y < 0 ? -widened_up(point::angle(-y, x), point::angle_bound)
               : widened_down(point::angle(y, x), point::angle_bound);
}
double angle_up(double y, double x) { return y == 0 ? 0 : -angle_down(-y, x); }

constexpr double half_pi_up = next_up(point::half_pi);
constexpr double pi_up = 2 * half_pi_up;

}  // namespace

double_interval asin(double_interval x) {
  if (!contains(unit_interval, x)) return double_interval::undefined();
  return limited(increasing(x, point::asin, point::asin_bound), half_pi_up);
}

double_interval acos(double_interval x) {
  if (!contains(unit_interval, x)) return double_interval::undefined();
  const double low = point::acos(x.upper());
  const double high = x.is_exact() ? low : point::acos(x.lower());
  return limited(from_ends(end_down(low, point::asin_bound), end_up(high, point::asin_bound)),
                 pi_up);
}

double_interval atan(double_interval x) {
  if (x.is_undefined()) return double_interval::undefined();
  const auto f = odd([](double end) { return point::angle(end, 1); });
  return limited(increasing(x, f, point::angle_bound), half_pi_up);
}

// The least and the greatest angle are at corners, and the side of the axes on which they lie
// decides at which. Where left > 0 does not hold, the left corners have left <= 0. An infinite
// corner is a limit: the corners chosen here are infinite in one coordinate at most.
double_interval atan2(double_interval y, double_interval x) {
  if (x.is_undefined() || y.is_undefined()) return double_interval::undefined();
  const double left = x.lower();
  const double right = x.upper();
  const double bottom = y.lower();
  const double top = y.upper();
  if (left > 0) {
    return limited(from_ends(angle_down(bottom, bottom >= 0 ? right : left),
                             angle_up(top, top >= 0 ? left : right)),
                   half_pi_up);
  }
  if (bottom > 0) {
    return limited(from_ends(angle_down(right >= 0 ? bottom : top, right), angle_up(bottom, left)),
                   pi_up);
  }
  if (top < 0) {
    return limited(from_ends(angle_down(top, left), angle_up(right >= 0 ? top : bottom, right)),
                   pi_up);
  }
  return double_interval::undefined();
}

}  // namespace polhode
