// The logarithm and the inverse hyperbolic functions, at a point with proofs and of intervals.

#include <bit>
#include <cmath>
#include <cstdint>

#include "arithmetic/hardware/widening.hpp"
#include "polhode/arithmetic/double_interval.hpp"

namespace polhode {

using namespace detail::hardware;
namespace point = detail::approximation;
using detail::infinity;

namespace {

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

}  // namespace

namespace detail::approximation {

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
