#pragma once

// What regions and complex balls have in common for the functions of this folder, which are
// templates over both.
//
// Each function is an analytic one, made of operations that are checked to be analytic where they
// are taken, and equal to the real function at real arguments: so it is the continuation. What is
// to be shown is that the identities used hold between analytic functions on a connected set that
// has real positive points; they are known there.

#include <algorithm>
#include <cmath>
#include <vector>

#include "polhode/arithmetic/boost_bridge.hpp"
#include "polhode/arithmetic/complex_ball.hpp"
#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "polhode/arithmetic/region.hpp"

namespace polhode::detail::in_plane {

constexpr double half_turn = 3.14159265358979;

template <class Z>
struct plane;

template <>
struct plane<region> {
  /// The number of bits to aim at, about.
  static precision bits(const region&) { return 30; }
  static bool is_known(const region& z) { return z.is_analytic(); }
  static region number(long n, const region& like) { return detail::constant_region(n, like); }
  static region failed(const region&) { return region::blocked(obstacle::unknown, ""); }
  static complex_ball set(const region& z) { return z.to_complex_ball(); }
  static region root(const region& z) { return sqrt(z); }
  static region enlarged(const region& z, const magnitude& error) {
    return z + region(complex_ball(0, 64).enlarged(error));
  }
  static double middle(const region& z) { return z.re().midpoint(); }
};

template <>
struct plane<complex_ball> {
  static precision bits(const complex_ball& z) { return z.precision() + 8; }
  static bool is_known(const complex_ball& z) { return !z.is_undefined(); }
  static complex_ball number(long n, const complex_ball& like) { return {n, like.precision()}; }
  static complex_ball failed(const complex_ball& like) {
    return complex_ball::undefined(like.precision());
  }
  static const complex_ball& set(const complex_ball& z) { return z; }
  static complex_ball root(const complex_ball& z) {
    return possibly_singular::sqrt(z) ? complex_ball::undefined(z.precision()) : sqrt(z);
  }
  static complex_ball enlarged(const complex_ball& z, const magnitude& error) {
    return z.enlarged(error);
  }
  static double middle(const complex_ball& z) {
    const mpfr_float m = midpoint(z.re);
    return mpfr_get_d(m.backend().data(), MPFR_RNDN);
  }
};

template <class Z>
bool is_known(const Z& z) {
  return plane<Z>::is_known(z);
}
template <class Z>
bool is_zero(const Z& z) {
  if (!is_known(z)) return false;
  const complex_ball set = plane<Z>::set(z);
  return sign_of(set.re) == certain_sign::zero && sign_of(set.im) == certain_sign::zero;
}
template <class Z>
bool is_right_of(const Z& z, long n) {
  return is_known(z) && certainly_greater(plane<Z>::set(z).re, n);
}
template <class Z>
bool is_left_of(const Z& z, long n) {
  return is_known(z) && certainly_less(plane<Z>::set(z).re, n);
}
template <class Z>
magnitude size(const Z& z) {
  return is_known(z) ? z.magnitude_upper() : magnitude::infinity();
}
inline magnitude power_up(const magnitude& x, long n) {
  magnitude result = magnitude::power_of_two(0);
  for (long k = 0; k < n; ++k) result = multiply_up(result, x);
  return result;
}
/// x^n/(1-x), or infinity.
inline magnitude geometric_rest(const magnitude& x, long n) {
  const magnitude one = magnitude::power_of_two(0);
  if (one <= x) return magnitude::infinity();
  return divide_up(power_up(x, n), subtract_down(one, x));
}
/// The square root with Re > 0; of exactly 0 it is 0.
template <class Z>
Z root_in_plane(const Z& z) {
  return is_zero(z) ? z : plane<Z>::root(z);
}

/// Whether a series in numbers of that size is to be used: it is small, or it does not shrink
/// further.
class shrinking {
 public:
  explicit shrinking(std::int64_t wanted) : wanted_(wanted) {}
  bool is_done(const magnitude& now) {
    const magnitude half = magnitude::power_of_two(-1);
    const bool done = now <= magnitude::power_of_two(wanted_) ||
                      (now <= half && last_ <= half && last_ <= scale(now, 1));
    last_ = now;
    return done;
  }

 private:
  std::int64_t wanted_;
  magnitude last_ = magnitude::infinity();
};

}  // namespace polhode::detail::in_plane
