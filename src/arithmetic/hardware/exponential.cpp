// The exponential and the hyperbolic functions, at a point with proofs and of intervals.

#include <algorithm>
#include <cmath>

#include "arithmetic/hardware/widening.hpp"
#include "polhode/arithmetic/double_interval.hpp"

namespace polhode {

using namespace detail::hardware;
namespace point = detail::approximation;
using detail::infinity;
using detail::largest_double;
using detail::least_double;

namespace {

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

}  // namespace

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

}  // namespace detail::approximation

namespace {

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

}  // namespace

double_interval exp(double_interval x) {
  if (x.is_undefined()) return double_interval::undefined();
  return from_ends(exp_down(x.lower()), exp_up(x.upper()));
}

double_interval expm1(double_interval x) {
  if (x.is_undefined()) return double_interval::undefined();
  return from_ends(expm1_down(x.lower()), expm1_up(x.upper()));
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

}  // namespace polhode
