#pragma once

// Between balls and boost::multiprecision::mpfr_float. In the other direction a ball is constructed
// from an mpfr_float, exactly: ball(x).

#include <boost/multiprecision/mpfr.hpp>

#include "polhode/arithmetic/ball.hpp"

namespace polhode {

/// The library's uncertified multiple-precision scalar.
using boost::multiprecision::mpfr_float;

/// An mpfr_float of exactly p bits, zero. (mpfr_float counts its precision in decimal digits and
/// takes a default of the thread; this sets bits, and reads no default.)
[[nodiscard]] inline mpfr_float zero_of_precision(precision p) {
  mpfr_float r;
  mpfr_set_prec(r.backend().data(), checked_precision(p));
  mpfr_set_zero(r.backend().data(), 1);
  return r;
}

/// The bits of an mpfr_float.
[[nodiscard]] inline precision precision_of(const mpfr_float& x) {
  return mpfr_get_prec(x.backend().data());
}
[[nodiscard]] inline precision precision_of(const ball& x) { return x.precision(); }

/// A lower (upper) bound of the set, and a number near its middle, at the ball's precision.
/// NaN where the ball is undefined.
[[nodiscard]] inline mpfr_float lower(const ball& x) {
  mpfr_float r = zero_of_precision(x.precision());
  x.lower(r.backend().data());
  return r;
}
[[nodiscard]] inline mpfr_float upper(const ball& x) {
  mpfr_float r = zero_of_precision(x.precision());
  x.upper(r.backend().data());
  return r;
}
[[nodiscard]] inline mpfr_float midpoint(const ball& x) {
  mpfr_float r = zero_of_precision(x.precision());
  x.midpoint(r.backend().data());
  return r;
}

}  // namespace polhode
