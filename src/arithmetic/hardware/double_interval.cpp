#include "polhode/arithmetic/double_interval.hpp"

#include <algorithm>
#include <ostream>

#include "polhode/arithmetic/mpfr_cell.hpp"

// Approximations at a point, with proofs, and the functions of intervals made of them.
//
// u = 2^-53: RN(t) = t (1 + d) with |d| <= u where nothing underflows, and |RN(t) - t| <= 2^(e-54)
// for |t| <= 2^e.
//
// LEMMA P (polynomials; N. Higham, Accuracy and Stability of Numerical Algorithms, 2nd ed. 2002,
// lemma 3.1). Let a sum of products be evaluated in any order such that each summand, from its
// factors to the result, passes through at most m roundings, those of its factors counted. Then the
// computed value is the sum of the summands, each times 1 + d, |d| <= g_m = m u / (1 - m u). So its
// error is at most g_m times the sum of the summands' absolute values.
//
// LEMMA W (widening). Let |f - y| <= b |y| + 2^-1075, for doubles y and b = 2^-n, 48 <= n <= 52.
// Then widened_down(y, b) <= f <= widened_up(y, b). Proof for the first, next_down(RN(v)), where v
// = y - E and E is the computed b |y|. Let s be the distance from RN(v) to the double below; v is
// at least RN(v) - s/2, so next_down(RN(v)) <= v - s/2.
//   |y| >= 2^-960: E = b |y| exactly, and s/2 > 2^-1075.
//   |y| < 2^-960: E is off by at most 2^-1075, and v is a multiple of 2^-1074. Either v is a double,
// and the step takes it down by 2^-1074 at least; or |v| > 2^-1021, and v lies 2^-1074 or more above
// next_down(RN(v)), as multiples of 2^-1074 do. So the result is at most v - 2^-1074
// <= y - b |y| - 2^-1075. []
//
// A relative error e with respect to f, e <= 2^-48, is one of e / (1 - e) < e (1 + 2^-47) with
// respect to y; the bounds have room for that, and it is not mentioned again.

namespace polhode {

namespace point = detail::approximation;
using detail::infinity;
using detail::largest_double;
using detail::least_double;
using detail::least_normal_double;
using detail::multiply_down;
using detail::multiply_up;
using detail::next_down;
using detail::next_up;

namespace {

constexpr double one_third = 1.0 / 3;

/// 2^n for -1022 <= n <= 1023.
double power_of_two(long n) {
  return std::bit_cast<double>(static_cast<std::int64_t>(n + 1023) << 52);
}

/// The integer nearest to t, but for ties and for t's neighbourhood of them, as a double and as an
/// integer: |t| < 2^31. The sum's last place is 1.
struct nearest {
  double value;
  long integer;
  explicit nearest(double t) {
    constexpr double shift = 0x1.8p52;
    const double sum = t + shift;
    value = sum - shift;
    integer = static_cast<std::int32_t>(std::bit_cast<std::uint64_t>(sum) & 0xffffffffU);
  }
};

double widened_down(double y, double bound) { return next_down(y - bound * std::abs(y)); }
double widened_up(double y, double bound) { return next_up(y + bound * std::abs(y)); }
/// The same for approximations that are 0 only where the function is.
double end_down(double y, double bound) { return y == 0 ? 0 : widened_down(y, bound); }
double end_up(double y, double bound) { return y == 0 ? 0 : widened_up(y, bound); }

double_interval from_ends(double lower, double upper) {
  return {detail::unchecked{}, lower, upper};
}

// ---------------------------------------------------------------------------------------------
// e^x = 2^k e^r, where r = x - k log 2 and k is the integer nearest to x / log 2.
//
// Reduction, |x| <= 746. The computed x / log 2 is off by at most 1100 * 3u < 2^-41, so
// |r| <= (1/2 + 2^-41) log 2 < 0.3467, |k| < 1100. For k = 0 the computed r is x. For k != 0:
// k * log_2_high is exact (11 + 42 bits). |x| > 0.34 makes x a multiple of 2^-54, as is the
// product, and the difference is below 2^-1: x - k * log_2_high is exact too. k * log_2_low < 2^-32
// has an error below 2^-85, with that of log_2_low itself. The last subtraction rounds by 2^-55.
// So the computed r is off by at most 2^-55 + 2^-85 =: 0.2501 u.
struct reduced {
  double r;
  long k;
};
reduced reduce_by_log_2(double x) {
  const nearest k(x * point::log2_e);
  return {(x - k.value * point::log_2_high) - k.value * point::log_2_low, k.integer};
}

// p = r + r^2 Q(r), Q(r) = sum_{i=2}^{13} r^(i-2) / i!, for |r| <= 0.3467; either |r| >= 2^-54, so
// that nothing underflows, or only 1 + p is of interest, to which underflows are nothing.
// Roundings, at most: 1 for a coefficient; r^2, r^4, r^8 have 1, 3, 7 in them; the longest way to Q
// is c13 r r^2 r^8 with 1 + 2 + (1 + 2) + (7 + 2) = 15. With r^2 and the product: 17.
// The sum of the |r^i / i!|, i >= 2, is at most e^0.3467 - 1 - 0.3467 < 0.0677 < 0.1953 |r| at the
// end of the range, and 0.1953 |r| throughout, since it rises faster than |r|. So the computed r^2
// Q is off by 17.01 u * 0.1953 |r| < 3.33 u |r|; the series' rest is below |r|^14 / 14! * 1.03 <
// 0.12 u |r|. Together 3.45 u |r|, and the last sum rounds by u |p|. Relative to
// |e^r - 1| >= |r| (1 - e^-0.3467) / 0.3467 > 0.845 |r| that is 4.1 u + u = 5.1 u.
double expm1_reduced(double r) {
  const double r2 = r * r;
  const double r4 = r2 * r2;
  const double r8 = r4 * r4;
  const double c2 = 1.0 / 2 + r * (1.0 / 6);
  const double c4 = 1.0 / 24 + r * (1.0 / 120);
  const double c6 = 1.0 / 720 + r * (1.0 / 5040);
  const double c8 = 1.0 / 40320 + r * (1.0 / 362880);
  const double c10 = 1.0 / 3628800 + r * (1.0 / 39916800);
  const double c12 = 1.0 / 479001600 + r * (1.0 / 6227020800);
  const double q = ((c2 + c4 * r2) + (c6 + c8 * r2) * r4) + (c10 + c12 * r2) * r8;
  return r + r2 * q;
}

// ---------------------------------------------------------------------------------------------
// log(m) = 2 atanh(s) = 2 s (1 + S(s^2)), s = (m - 1) / (m + 1) = f / (f + 2), f = m - 1,
// S(z) = sum_{n=1}^{10} z^n / (2n + 1), for |s| <= 0.1716, z <= 0.02945.
//
// Hypotheses: numerator = f exactly, denominator = f + 2 with one rounding; |s| >= 2^-55 or s = 0.
// The computed s has 2 roundings, its square 5. A summand c_n z^n has 5 n of these, and at most 16
// others: for c_8 and c_10, the longest ways, 13. The error of S is at most
// sum (5 n + 16) 1.01 u z^n / (2n + 1) < 0.22 u; S < 0.0101; the series' rest is below
// z^11 / 23 * 1.04 < 2^-60 < 0.01 u. So 2 s S is off by (0.22 + 0.0101 * 3.01 + 0.01) u |2s|
// < 0.27 u |2s|; 2 s by 2.01 u |2s|; the sum rounds by u. Relative to |log m| >= |2s|: 3.3 u.
double log_of_quotient(double numerator, double denominator) {
  const double s = numerator / denominator;
  const double z = s * s;
  const double z2 = z * z;
  const double z4 = z2 * z2;
  const double z8 = z4 * z4;
  const double c1 = one_third + z * (1.0 / 5);
  const double c3 = 1.0 / 7 + z * (1.0 / 9);
  const double c5 = 1.0 / 11 + z * (1.0 / 13);
  const double c7 = 1.0 / 15 + z * (1.0 / 17);
  const double c9 = 1.0 / 19 + z * (1.0 / 21);
  const double sum = z * (((c1 + c3 * z2) + (c5 + c7 * z2) * z4) + c9 * z8);
  const double twice = s + s;
  return twice + twice * sum;
}

// ---------------------------------------------------------------------------------------------
// x = k pi/2 + r, for |x| <= 2^20, k the integer nearest to 2 x / pi.
//
// |k| < 2^20, and the computed quotient is off by less than 2^-30, so |r| < 0.7854 + 2^-29. For
// k = 0 the computed r is x. For k != 0: k * half_pi_1 is exact (20 + 32 bits). |x| > 0.78 is a
// multiple of 2^-53, as is the product, and their difference d is below 1: exact. w = k * half_pi_2
// is exact (20 + 30 bits), |w| < 2^-12. h + l = d - w exactly, |l| <= 2^-54 (Fast2Sum).
// t = k * half_pi_3 is below 2^-44 and off by 2^-97 at most, with the error of half_pi_3 itself,
// 2^20 * 2^-118; l - t rounds by less than 2^-97. So the computed r = h + (l - t) is
// (r + e) (1 + d), |e| <= 2^-96, |d| <= u: off by u |r| + 2^-95.9.
//   Where |h| < 2^-30, next to a multiple of pi/2, that would be much of r. There d and w, multiples of 2^-63, have
// an exact difference: l = 0. k * half_pi_4 is exact (20 + 31 bits); s + f = h - k * half_pi_4 exactly, with |s| < 2^-29,
// |f| <= 2^-83; k * half_pi_5 is exact (20 + 25 bits) and below 2^-83; k * half_pi_6 is below 2^-109 and off by 2^-162, with
// the error of half_pi_6 itself, 2^20 * 2^-184; the two differences that follow are below 2^-81 and round by 2^-135 each. So
// the computed r is off by u |r| + 2^-133.9.
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

// ---------------------------------------------------------------------------------------------
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

// ---------------------------------------------------------------------------------------------

namespace detail::approximation {

// 1 + p, where p is off by 3.45 u |r| + u |p|, and |p| <= 0.4145: the error of p is at most
// 1.2 u + 0.4145 u, or 1.2 u + 0.293 u where r < 0, which over e^r is 1.62 u for r >= 0 and
// 1.5 / 0.7070 u < 2.13 u for r < 0. The reduction: 0.26 u. The last sum: u. Together 3.4 u <= 4 u.
scaled exp(double x) {
  const reduced e = reduce_by_log_2(x);
  return {1 + expm1_reduced(e.r), e.k};
}

// k = 0: 5.1 u, by expm1_reduced; below 2^-54 the value is x, off by 0.6 |x| relatively.
// k != 0: 2^k p + (2^k - 1). The product is exact, and |p - (e^r - 1)| is at most
// 1.2 u + u |p| + 0.26 u e^r: below 1.76 u for r < 0, where |p| < 0.293, and below 1.99 u for r >=
// 0. Relative to the size of the result, 2^k e^r - 1:
//   k = 1, r < 0:  2 * 1.76 u / (2 * 0.7070 - 1) < 8.6 u;   k = 1, r >= 0:  2 * 1.99 u / 1;
//   k = 2:         4 * 1.99 u / (4 * 0.7070 - 1) < 4.4 u;   k > 2: less;
//   k = -1:        1.99 u / 2 / (1 - 1.4145 / 2) < 3.5 u;   k < -1: less.
// 2^k - 1 is exact for |k| <= 53; for others it rounds by at most 1.42 u of the result. The last
// sum: u. Together 9.6 u <= 16 u.
double expm1(double x) {
  if (std::abs(x) < 0x1p-54) return x;
  const reduced e = reduce_by_log_2(x);
  const double p = expm1_reduced(e.r);
  if (e.k == 0) return p;
  const double power = power_of_two(e.k);
  return power * p + (power - 1);
}

// x = 2^k m, 0.7071 <= m < 1.4143, m - 1 exact (a multiple of 2^-53 below 2^-1).
// log x = k log 2 + log m. k = 0: 3.3 u. Else: k * log_2_high is exact (|k| < 2^11); log m is off
// by 3.3 u * 0.3467 < 1.15 u; k * log_2_low, below 2^-32, by 2^-85; the inner sum, below 1/2, by
// 2^-55 = 0.25 u; together 1.41 u over |log x| > 0.3465: 4.1 u. The last sum: u. Together 5.1 u <=
// 8 u.
double log(double x, int n) {
  constexpr std::int64_t lowest = 0x3fe6a09e00000000;  // 0.70710...: half of m's upper limit
  if (x < least_normal_double) {
    x *= 0x1p54;
    n -= 54;
  }
  const auto bits = std::bit_cast<std::int64_t>(x);
  const std::int64_t exponent = (bits - lowest) >> 52;
  const double f = std::bit_cast<double>(bits - exponent * (std::int64_t{1} << 52)) - 1;
  const auto k = static_cast<double>(exponent + n);
  const double log_m = log_of_quotient(f, f + 2);
  return k * log_2_high + (log_m + k * log_2_low);
}

// |x| < 2^-54: x, off by 0.6 |x| relatively. -0.2928 <= x <= 0.4142: 3.3 u, by log_of_quotient with
// |s| < 0.1716. Else the rounding of 1 + x moves its logarithm by 1.01 u, which is above 0.3463 in
// size: 3 u. With log's 5.1 u, 8.2 u <= 16 u.
double log1p(double x) {
  if (std::abs(x) < 0x1p-54) return x;
  if (x >= -0.2928 && x <= 0.4142) return log_of_quotient(x, 2 + x);
  return log(1 + x);
}

// 4.6 u <= 8 u for both, and 2^-95.9 <= 2^-94 absolutely. Where one of them is below 2^-31, |r| is below 2^-30.9, and |h|,
// which differs from r by |l - t| < 2^-43 at most, below 2^-30: then 2^-133.9 <= 2^-132 for both.
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

// (E + E / (E + 1)) / 2, E = e^x - 1 with 9.6 u. The quotient changes relatively by 1 / (E + 1) <=
// 1 of E's change: 11.7 u; the sum of two positive numbers: at most that and u: 12.8 u <= 16 u.
double sinh(double x) {
  const double e = expm1(x);
  return 0.5 * (e + e / (e + 1));
}
// (e + 1/e) / 2: 3.4 u, and u for the quotient and u for the sum: 5.5 u <= 8 u.
double cosh(double x) {
  const scaled s = exp(x);
  const double e = s.fraction * power_of_two(s.exponent);
  return 0.5 * (e + 1 / e);
}
// E / (E + 2), E = e^2x - 1: 9.6 u, times 2 / (E + 2) <= 1, and 2 u: 11.7 u <= 16 u. Above 22 the
// value is 1, off by 2 e^-44 < 2^-62.
double tanh(double x) {
  if (x > 22) return 1;
  const double e = expm1(2 * x);
  return e / (e + 2);
}

// log1p changes relatively by a / ((1 + a) log(1 + a)) <= 1 of the relative change of a > 0.
//
// asinh x = log1p(x + x^2 / (1 + sqrt(1 + x^2))). x^2: u; 1 + x^2: 2 u; its root: 2 u; 1 + that: 3
// u; the quotient: 5 u; it is at most x, so the sum: 2.6 u + u. With log1p's 8.2 u: 11.8 u <= 16 u.
// Above 2^28: log(2 x), off by at most 1 / (4 x^2) = 2^-58. Below 2^-54: x, off by x^2 / 6
// relatively.
double asinh(double x) {
  if (x > 0x1p28) return log(x, 1);
  if (x < 0x1p-54) return x;
  const double square = x * x;
  return log1p(x + square / (1 + std::sqrt(1 + square)));
}
// acosh x = log1p(t + sqrt(t (t + 2))), t = x - 1: u; t + 2: 2 u; the product: 4 u; its root: 3 u;
// the sum: 4 u. With 8.2 u: 12.3 u <= 16 u. Above 2^28: log(2 x), off by at most 1 / (2 x^2) =
// 2^-57.
double acosh(double x) {
  if (x > 0x1p28) return log(x, 1);
  const double t = x - 1;
  return log1p(t + std::sqrt(t * (t + 2)));
}
// atanh x = log1p(2 x / (1 - x)) / 2: 2 u, and 8.2 u: 10.3 u <= 16 u. Below 2^-54: x, off by x^2 /
// 3.
double atanh(double x) {
  if (x < 0x1p-54) return x;
  return 0.5 * log1p(2 * x / (1 - x));
}

}  // namespace detail::approximation

// ---------------------------------------------------------------------------------------------
// Ends.

double detail::scale_down(double x, long n) {
  n = std::clamp(n, -3000L, 3000L);  // beyond the distance of the least and the largest double
  while (n != 0 && x != 0 && std::abs(x) < infinity) {
    const long step = std::clamp(n, -1000L, 1000L);
    n -= step;
    const double product = x * power_of_two(step);
    // The way back is exact: it leads to x where nothing was rounded, and beyond x where the product was rounded up,
    // also where it was rounded up to the least normal number.
    x = product * power_of_two(-step) > x ? next_down(product) : product;
  }
  return x;
}

namespace {

/// Of a function that rises with x from approximations at the ends.
template <class Approximation>
double_interval increasing(double_interval x, Approximation&& f, double bound) {
  const double a = x.lower();
  const double b = x.upper();
  const double low = f(a);
  const double high = a == b ? low : f(b);
  return from_ends(end_down(low, bound), end_up(high, bound));
}

/// f(|x|) with the sign of x.
template <class Approximation>
auto odd(Approximation&& f) {
  return [f](double x) { return std::copysign(f(std::abs(x)), x); };
}

// 2^shift e^x, for a shift of 0 or -1, and the latter for x > 0 only. e^712 / 2 is above the
// largest double, e^-746 below half of the least one.
double exp_down(double x, long shift = 0) {
  if (x > 712) return largest_double;
  if (x < -746) return 0;
  const point::scaled e = point::exp(x);
  const double fraction = widened_down(e.fraction, point::exp_bound);
  const double low = std::abs(x) < 700 ? fraction * power_of_two(e.exponent + shift)  // exact
                                       : detail::scale_down(fraction, e.exponent + shift);
  return std::max(low, shift == 0 && x >= 0 ? 1.0 : 0.0);
}
double exp_up(double x, long shift = 0) {
  if (x > 712) return infinity;
  if (x < -746) return least_double;
  const point::scaled e = point::exp(x);
  const double fraction = widened_up(e.fraction, point::exp_bound);
  const double high = std::abs(x) < 700 ? fraction * power_of_two(e.exponent + shift)
                                        : detail::scale_up(fraction, e.exponent + shift);
  return std::min(high, shift == 0 && x <= 0 ? 1.0 : infinity);
}

// Above 40, e^x - 1 is e^x but for 2^-57, and sinh and cosh are e^x / 2 but for 2^-115: with 3.4 u,
// within the bound of exp.
constexpr double exponential_from = 40;

double expm1_down(double x) {
  if (x < -exponential_from) return -1;
  if (x > exponential_from) return exp_down(x);
  return std::max(end_down(point::expm1(x), point::expm1_bound), -1.0);
}
double expm1_up(double x) {
  if (x < -exponential_from) return -1 + 0x1p-53;  // e^-40 < 2^-57
  if (x > exponential_from) return exp_up(x);
  return end_up(point::expm1(x), point::expm1_bound);
}

double sinh_down(double x);
double sinh_up(double x) {
  if (x < 0) return -sinh_down(-x);
  return x > exponential_from ? exp_up(x, -1) : end_up(point::sinh(x), point::sinh_bound);
}
double sinh_down(double x) {
  if (x < 0) return -sinh_up(-x);
  return x > exponential_from ? exp_down(x, -1) : end_down(point::sinh(x), point::sinh_bound);
}

/// point::angle for the upper half-plane; its limit where y or x is infinite.
double angle_down(double y, double x) {
  if (y == 0) return 0;
  return y < 0 ? -widened_up(point::angle(-y, x), point::angle_bound)
               : widened_down(point::angle(y, x), point::angle_bound);
}
double angle_up(double y, double x) { return y == 0 ? 0 : -angle_down(-y, x); }

/// The angles -limit and limit, rounded outward, are never passed.
double_interval limited(double_interval x, double limit) {
  return from_ends(std::max(x.lower(), -limit), std::min(x.upper(), limit));
}
constexpr double half_pi_up = next_up(point::half_pi);
constexpr double pi_up = 2 * half_pi_up;

// ---------------------------------------------------------------------------------------------
// Quadrants.

constexpr double widest_reduced = 0x1p20;

/// The end of an interval, |x| <= 2^20, with floor(2 x / pi) between first and last. The computed r has the sign of
/// r where it is greater in size than `absolute`, for it is off by less beside a rounding; if k = 0, r = x.
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

constexpr double_interval unit_interval(detail::unchecked{}, -1, 1);

bool is_reducible(double_interval x) {
  return x.lower() >= -widest_reduced && x.upper() <= widest_reduced;
}

/// x^n for n >= 1 and an end x >= 0.
template <double (*multiply)(double, double)>
double power(double x, unsigned long n) {
  double result = 1;
  bool started = false;
  for (double square = x;; square = multiply(square, square)) {
    if ((n & 1U) != 0) {
      result = started ? multiply(result, square) : square;
      started = true;
    }
    n >>= 1U;
    if (n == 0) return result;
  }
}

/// sqrt(x^2 + y^2) for ends x, y >= 0. The larger one is brought between 2^-474 and 2^500, where
/// its square is at least 2^-948: an underflow in the other square is nothing beside it.
double hypot_end(double x, double y, bool up) {
  const double large = std::max(x, y);
  const double small = std::min(x, y);
  if (small == 0 || large == infinity) return large;
  const long shift = large > 0x1p500 ? -600 : large < 0x1p-200 ? 600 : 0;
  if (shift == 0) {
    if (up) {
      return detail::sqrt_up(detail::add_up(multiply_up(small, small), multiply_up(large, large)));
    }
    return std::max(large, detail::sqrt_down(detail::add_down(multiply_down(small, small),
                                                              multiply_down(large, large))));
  }
  const auto length = [shift](double s, double l, auto&& scaled, auto&& multiply, auto&& add,
                              auto&& root) {
    s = scaled(s, shift);
    l = scaled(l, shift);
    return scaled(root(add(multiply(s, s), multiply(l, l))), -shift);
  };
  if (up) {
    return length(small, large, detail::scale_up, multiply_up, detail::add_up, detail::sqrt_up);
  }
  return std::max(large, length(small, large, detail::scale_down, multiply_down, detail::add_down,
                                detail::sqrt_down));
}

}  // namespace

// ---------------------------------------------------------------------------------------------

bool double_interval::environment_is_sound() {
  volatile double one = 1;
  volatile double half_step = 0x1p-53;
  volatile double more = 0x1.8p-53;
  volatile double least_normal = least_normal_double;
  volatile double least = least_double;
  const bool to_nearest = one + half_step == 1 && one + more > 1 && -one - half_step == -1 &&
                          -one - more < -1 && one - 0x1p-55 == 1;
  const bool keeps_subnormals =
      least_normal * 0.5 > 0 && least + least == 2 * least_double && least > 0;
  return to_nearest && keeps_subnormals;
}

double_interval double_interval::from_integer(mpz_srcptr n) {
  detail::mpfr_cell end(53);
  mpfr_set_z(end.get(), n, MPFR_RNDD);
  const double low = mpfr_get_d(end.get(), MPFR_RNDD);
  mpfr_set_z(end.get(), n, MPFR_RNDU);
  return ends(low, mpfr_get_d(end.get(), MPFR_RNDU));
}

double_interval double_interval::from_rational(mpq_srcptr q) {
  constexpr std::size_t bits = 53;
  if (mpz_sizeinbase(mpq_numref(q), 2) <= bits && mpz_sizeinbase(mpq_denref(q), 2) <= bits) {
    const double n = mpz_get_d(mpq_numref(q));
    const double d = mpz_get_d(mpq_denref(q));
    const double nearest = n / d;
    // n - d nearest is a double (the remainder of a division), far above the least one; its sign is that of
    // n/d - nearest.
    const double rest = std::fma(-nearest, d, n);
    if (rest == 0) return double_interval(nearest);
    return rest > 0 ? ends(nearest, detail::next_up(nearest))
                    : ends(detail::next_down(nearest), nearest);
  }
  detail::mpfr_cell end(53);
  mpfr_set_q(end.get(), q, MPFR_RNDD);
  const double low = mpfr_get_d(end.get(), MPFR_RNDD);
  mpfr_set_q(end.get(), q, MPFR_RNDU);
  return ends(low, mpfr_get_d(end.get(), MPFR_RNDU));
}

double_interval double_interval::from_ball(const ball& x) {
  if (x.is_undefined()) return undefined();
  detail::mpfr_cell end(53);
  x.lower(end.get());
  const double low = mpfr_get_d(end.get(), MPFR_RNDD);
  x.upper(end.get());
  return ends(low, mpfr_get_d(end.get(), MPFR_RNDU));
}

ball to_ball(const double_interval& x, precision p) {
  if (x.is_undefined()) return ball::undefined(p);
  detail::mpfr_cell lower(53);
  detail::mpfr_cell upper(53);
  mpfr_set_d(lower.get(), x.lower(), MPFR_RNDN);
  mpfr_set_d(upper.get(), x.upper(), MPFR_RNDN);
  return ball::from_end_points(lower.get(), upper.get(), p);
}

std::ostream& operator<<(std::ostream& out, const double_interval& x) {
  if (x.is_undefined()) return out << "undefined";
  detail::mpfr_cell lower(53);
  detail::mpfr_cell upper(53);
  mpfr_set_d(lower.get(), x.lower(), MPFR_RNDN);
  mpfr_set_d(upper.get(), x.upper(), MPFR_RNDN);
  char text[80];
  mpfr_snprintf(text, sizeof text, "[%.17RDg, %.17RUg]", lower.get(), upper.get());
  return out << text;
}

double_interval pow(double_interval x, long n) {
  if (x.is_undefined()) return double_interval::undefined();
  if (n == 0) return 1;
  const auto count = static_cast<unsigned long>(n);
  const unsigned long size = n < 0 ? 0UL - count : count;
  const bool is_even = size % 2 == 0;
  if (n > 0) {
    const double_interval base = is_even ? abs(x) : x;
    const double a = base.lower();
    const double b = base.upper();
    return from_ends(a < 0 ? -power<multiply_up>(-a, size) : power<multiply_down>(a, size),
                     b < 0 ? -power<multiply_down>(-b, size) : power<multiply_up>(b, size));
  }
  if (contains_zero(x)) return double_interval::undefined();
  // The least |x|^|n| may underflow to 0, which is no member: a limit.
  const double low = detail::divide_down(1, power<multiply_up>(x.magnitude(), size));
  const double least_power = power<multiply_down>(x.mignitude(), size);
  const double high = least_power == 0 ? infinity : detail::divide_up(1, least_power);
  const double_interval result = from_ends(low, high);
  return certainly_negative(x) && !is_even ? -result : result;
}

double_interval hypot(double_interval x, double_interval y) {
  if (x.is_undefined() || y.is_undefined()) return double_interval::undefined();
  return from_ends(hypot_end(x.mignitude(), y.mignitude(), false),
                   hypot_end(x.magnitude(), y.magnitude(), true));
}

double_interval exp(double_interval x) {
  if (x.is_undefined()) return double_interval::undefined();
  return from_ends(exp_down(x.lower()), exp_up(x.upper()));
}

double_interval expm1(double_interval x) {
  if (x.is_undefined()) return double_interval::undefined();
  return from_ends(expm1_down(x.lower()), expm1_up(x.upper()));
}

double_interval log(double_interval x) {
  if (!certainly_positive(x)) return double_interval::undefined();
  const auto f = [](double end) { return end == infinity ? infinity : point::log(end); };
  const double low = f(x.lower());
  const double high = x.is_exact() ? low : f(x.upper());
  return from_ends(end_down(low, point::log_bound), end_up(high, point::log_bound));
}

double_interval log1p(double_interval x) {
  if (!certainly_greater(x, -1)) return double_interval::undefined();
  return increasing(
      x, [](double end) { return end == infinity ? infinity : point::log1p(end); },
      point::log1p_bound);
}

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

// The least and the greatest angle are at corners, and the side of the axes on which they lie decides
// at which. Where left > 0 does not hold, the left corners have left <= 0. An infinite corner is a
// limit: the corners chosen here are infinite in one coordinate at most.
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

double_interval sinh(double_interval x) {
  if (x.is_undefined()) return double_interval::undefined();
  return from_ends(sinh_down(x.lower()), sinh_up(x.upper()));
}

double_interval cosh(double_interval x) {
  if (x.is_undefined()) return double_interval::undefined();
  const double a = x.mignitude();
  const double b = x.magnitude();
  const double low =
      a > exponential_from ? exp_down(a, -1) : widened_down(point::cosh(a), point::cosh_bound);
  if (b == 0) return 1;
  return from_ends(std::max(low, 1.0), b > exponential_from
                                           ? exp_up(b, -1)
                                           : widened_up(point::cosh(b), point::cosh_bound));
}

double_interval tanh(double_interval x) {
  if (x.is_undefined()) return double_interval::undefined();
  return limited(increasing(x, odd(point::tanh), point::sinh_bound), 1);
}

double_interval asinh(double_interval x) {
  if (x.is_undefined()) return double_interval::undefined();
  const auto f = odd([](double end) { return end == infinity ? infinity : point::asinh(end); });
  return increasing(x, f, point::sinh_bound);
}

double_interval acosh(double_interval x) {
  if (!certainly_less_equal(1, x)) return double_interval::undefined();
  const auto f = [](double end) { return end == infinity ? infinity : point::acosh(end); };
  return increasing(x, f, point::sinh_bound);
}

double_interval atanh(double_interval x) {
  if (!certainly_less(-1, x) || !certainly_less(x, 1)) return double_interval::undefined();
  return increasing(x, odd(point::atanh), point::sinh_bound);
}

}  // namespace polhode
