// Scaling by powers of two, powers with integer exponents, and the length of a vector.

#include <algorithm>
#include <cmath>

#include "arithmetic/hardware/widening.hpp"
#include "polhode/arithmetic/double_interval.hpp"

namespace polhode {

using namespace detail::hardware;
using detail::infinity;
using detail::multiply_down;
using detail::multiply_up;
using detail::next_down;

double detail::scale_down(double x, long n) {
  n = std::clamp(n, -3000L, 3000L);  // beyond the distance of the least and the largest double
  while (n != 0 && x != 0 && std::abs(x) < infinity) {
    const long step = std::clamp(n, -1000L, 1000L);
    n -= step;
    const double product = x * power_of_two(step);
    // The way back is exact: it leads to x where nothing was rounded, and beyond x where the
    // product was rounded up, also where it was rounded up to the least normal number.
    x = product * power_of_two(-step) > x ? next_down(product) : product;
  }
  return x;
}

namespace {

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

double hypot_up(double_interval x, double_interval y) {
  if (x.is_undefined() || y.is_undefined()) return infinity;
  return hypot_end(x.magnitude(), y.magnitude(), true);
}

double_interval hypot(double_interval x, double_interval y) {
  if (x.is_undefined() || y.is_undefined()) return double_interval::undefined();
  return from_ends(hypot_end(x.mignitude(), y.mignitude(), false),
                   hypot_end(x.magnitude(), y.magnitude(), true));
}

}  // namespace polhode
