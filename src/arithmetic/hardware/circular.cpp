// Sine, cosine and tangent, at a point with proofs and of intervals.

#include <algorithm>
#include <cmath>
#include <utility>

#include "arithmetic/hardware/widening.hpp"
#include "polhode/arithmetic/double_interval.hpp"

namespace polhode {

using namespace detail::hardware;
namespace point = detail::approximation;
using detail::next_down;

namespace {

// x = k pi/2 + r, for |x| <= 2^20, k the integer nearest to 2 x / pi.
//
// |k| < 2^20, and the computed quotient is off by less than 2^-30, so |r| < 0.7854 + 2^-29. For
// k = 0 the computed r is x. For k != 0: k * half_pi_1 is exact (20 + 32 bits). |x| > 0.78 is a
// multiple of 2^-53, as is the product, and their difference d is below 1: exact. w = k * half_pi_2
// is exact (20 + 30 bits), |w| < 2^-12. h + l = d - w exactly, |l| <= 2^-54 (Fast2Sum).
// t = k * half_pi_3 is below 2^-44 and off by 2^-97 at most, with the error of half_pi_3 itself,
// 2^20 * 2^-118; l - t rounds by less than 2^-97. So the computed r = h + (l - t) is
// (r + e) (1 + d), |e| <= 2^-96, |d| <= u: off by u |r| + 2^-95.9.
//   Where |h| < 2^-30, next to a multiple of pi/2, that would be much of r. There d and w,
//   multiples of 2^-63, have
// an exact difference: l = 0. k * half_pi_4 is exact (20 + 31 bits); s + f = h - k * half_pi_4
// exactly, with |s| < 2^-29,
// |f| <= 2^-83; k * half_pi_5 is exact (20 + 25 bits) and below 2^-83; k * half_pi_6 is below
// 2^-109 and off by 2^-162, with the error of half_pi_6 itself, 2^20 * 2^-184; the two differences
// that follow are below 2^-81 and round by 2^-135 each. So the computed r is off by u |r| +
// 2^-133.9.
struct reduced_angle {
  double r;
  long k;
};
reduced_angle reduce_by_half_pi(double x) {
  const nearest k(x * point::two_over_pi);
  const double d = x - k.value * point::half_pi_1;
  const double w = k.value * point::half_pi_2;
  const double h = d - w;
  if (std::abs(h) < 0x1p-30 && k.integer != 0) {
    const double t = k.value * point::half_pi_4;
    const double s = h - t;
    const double f = detail::sum_error(h, -t, s);
    return {s + ((f - k.value * point::half_pi_5) - k.value * point::half_pi_6), k.integer};
  }
  const double l = detail::sum_error(d, -w, h);
  return {h + (l - k.value * point::half_pi_3), k.integer};
}

// sin r = r + r z A(z), z = r^2, A(z) = sum_{n=1}^{8} (-1)^n z^(n-1) / (2n + 1)!, |r| <= 0.78541.
// Roundings: coefficient 1; product with z (1 inside) and sum, 3; with z^2 (3 inside), 5; with z^4
// (7 inside), 9; then z, 2, and r, 1: 21. Sum of absolute values: sinh|r| - |r| < 0.0833 at the
// end, < 0.1061 |r| throughout. Error 21.01 u * 0.1061 |r| < 2.23 u |r|, the series' rest below
// |r|^19 / 19! < 2^-62 |r|; relative to |sin r| > 0.9003 |r|: 2.48 u. The last sum: u. The error
// of r, relative u: u again, for |r cot r| <= 1. Together 4.6 u, and 2^-95.9 absolutely if k != 0.
// Where z underflows, |r| < 2^-510, the true and the computed r z A are below u |r|, by far.
double sine_reduced(double r) {
  const double z = r * r;
  const double z2 = z * z;
  const double z4 = z2 * z2;
  const double c1 = -1.0 / 6 + z * (1.0 / 120);
  const double c3 = -1.0 / 5040 + z * (1.0 / 362880);
  const double c5 = -1.0 / 39916800 + z * (1.0 / 6227020800);
  const double c7 = -1.0 / 1307674368000 + z * (1.0 / 355687428096000);
  return r + r * (z * ((c1 + c3 * z2) + (c5 + c7 * z2) * z4));
}

// cos r = (1 - z/2) + z^2 C(z), C(z) = sum_{n=2}^{8} (-1)^n z^(n-2) / (2n)!.
// z/2 <= 0.3085 has one rounding: 0.31 u. 1 - z/2 is below 1: u/2. z^2 C: roundings 18 as above and
// z^2 (3) and product, 22; the sum of absolute values is below cosh 0.78541 - 1 - z/2 < 0.0163:
// 0.36 u; the series' rest is below z^9 / 18! < 0.02 u. The last sum, of 1 at most: u/2. The error
// of r moves cos by |sin r| (u |r| + 2^-95.9) < 0.56 u + 2^-96. Together 2.3 u and 2^-96
// absolutely; relative to cos r > 0.7071: 3.3 u.
double cosine_reduced(double r) {
  const double z = r * r;
  const double z2 = z * z;
  const double z4 = z2 * z2;
  const double c2 = 1.0 / 24 + z * (-1.0 / 720);
  const double c4 = 1.0 / 40320 + z * (-1.0 / 3628800);
  const double c6 = 1.0 / 479001600 + z * (-1.0 / 87178291200);
  const double c8 = 1.0 / 20922789888000;
  return (1 - 0.5 * z) + z2 * ((c2 + c4 * z2) + (c6 + c8 * z2) * z4);
}

}  // namespace

namespace detail::approximation {

// 4.6 u <= 8 u for both, and 2^-95.9 <= 2^-94 absolutely. Where one of them is below 2^-31, |r| is
// below 2^-30.9, and |h|, which differs from r by |l - t| < 2^-43 at most, below 2^-30: then
// 2^-133.9 <= 2^-132 for both.
circular sin_cos(double x) {
  const reduced_angle a = reduce_by_half_pi(x);
  const double s = sine_reduced(a.r);
  const double c = cosine_reduced(a.r);
  const bool swapped = (a.k & 1) != 0;
  const double sine = swapped ? c : s;
  const double cosine = swapped ? s : c;
  const double small = std::min(std::abs(sine), std::abs(cosine));
  const double absolute =
      a.k == 0 ? 0 : (small < 0x1p-31 ? circular_absolute_at_multiples : circular_absolute);
  return {(a.k & 2) != 0 ? -sine : sine, ((a.k + 1) & 2) != 0 ? -cosine : cosine, a.k, absolute};
}

}  // namespace detail::approximation

namespace {

constexpr double widest_reduced = 0x1p20;

/// The end of an interval, |x| <= 2^20, with floor(2 x / pi) between first and last. The computed r
/// has the sign of r where it is greater in size than `absolute`, for it is off by less beside a
/// rounding; if k = 0, r = x.
struct circular_end {
  point::circular at;
  long first_quadrant;
  long last_quadrant;
  double absolute;

  explicit circular_end(double x) : at(point::sin_cos(x)), absolute(at.absolute) {
    const long k = at.turns;
    // The sign of r is that of the function that is small at k pi/2.
    const double small = (k & 1) != 0 ? at.cosine : at.sine;
    const double r = ((k + 1) & 2) != 0 ? -small : small;
    first_quadrant = r > absolute || (k == 0 && r == 0) ? k : k - 1;
    last_quadrant = r < -absolute ? k - 1 : k;
  }
  [[nodiscard]] double down(double value) const {
    const double margin = point::circular_bound * std::abs(value) + absolute;
    return value == 0 && absolute == 0 ? 0 : std::max(next_down(value - margin), -1.0);
  }
  [[nodiscard]] double up(double value) const { return -down(-value); }
  [[nodiscard]] double_interval sine() const { return from_ends(down(at.sine), up(at.sine)); }
  [[nodiscard]] double_interval cosine() const {
    if (at.turns == 0 && at.sine == 0) return 1;  // x = 0
    return from_ends(down(at.cosine), up(at.cosine));
  }
};

/// Whether (x, y] may hold j pi/2 with j = residue modulo 4, or modulo 2.
bool passes(const circular_end& x, const circular_end& y, long residue, long modulus) {
  const long first = x.first_quadrant + 1;
  return first + ((residue - first) & (modulus - 1)) <= y.last_quadrant;
}

/// The hull of the values at the ends, up to 1 where the interval passes `top`, down to -1 half a
/// circle later.
double_interval circular_range(const circular_end& x, const circular_end& y, double_interval at_x,
                               double_interval at_y, long top) {
  const double_interval values = hull(at_x, at_y);
  return from_ends(passes(x, y, top + 2, 4) ? -1 : values.lower(),
                   passes(x, y, top, 4) ? 1 : values.upper());
}

bool is_reducible(double_interval x) {
  return x.lower() >= -widest_reduced && x.upper() <= widest_reduced;
}

}  // namespace

bool needs_wider_range(double_interval x) {
  return x.is_bounded() && x.width() < 7 && x.magnitude() > widest_reduced;
}

double_interval sin(double_interval x) {
  if (x.is_undefined()) return double_interval::undefined();
  if (!is_reducible(x)) return unit_interval;
  const circular_end a(x.lower());
  if (x.is_exact()) return a.sine();
  const circular_end b(x.upper());
  return circular_range(a, b, a.sine(), b.sine(), 1);
}

double_interval cos(double_interval x) {
  if (x.is_undefined()) return double_interval::undefined();
  if (!is_reducible(x)) return unit_interval;
  const circular_end a(x.lower());
  if (x.is_exact()) return a.cosine();
  const circular_end b(x.upper());
  return circular_range(a, b, a.cosine(), b.cosine(), 0);
}

std::pair<double_interval, double_interval> sin_cos(double_interval x) {
  if (x.is_undefined()) return {double_interval::undefined(), double_interval::undefined()};
  if (!is_reducible(x)) return {unit_interval, unit_interval};
  const circular_end a(x.lower());
  if (x.is_exact()) return {a.sine(), a.cosine()};
  const circular_end b(x.upper());
  return {circular_range(a, b, a.sine(), b.sine(), 1),
          circular_range(a, b, a.cosine(), b.cosine(), 0)};
}

// Between two poles tan rises. At an end it lies in the quotient of the enclosures of sin and cos:
// 16 u and its 4.6 u beside it for each of the two, and the quotient's rounding.
double_interval tan(double_interval x) {
  if (x.is_undefined() || !is_reducible(x)) return double_interval::undefined();
  const circular_end a(x.lower());
  const double_interval low = a.sine() / a.cosine();
  if (x.is_exact()) return low;
  const circular_end b(x.upper());
  const double_interval high = b.sine() / b.cosine();
  if (passes(a, b, 1, 2) || low.is_undefined() || high.is_undefined()) {
    return double_interval::undefined();
  }
  return from_ends(low.lower(), high.upper());
}

}  // namespace polhode
