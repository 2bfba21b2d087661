#pragma once

// Elementary functions of real balls.
//
// A ball kept by midpoint and radius is evaluated at its midpoint by MPFR, correctly rounded, and
// its radius is carried through a bound of the function's change stated beside the code; a wide
// ball is evaluated at its end points and extrema, each rounded outward, so that the answer is the
// range itself but for one rounding at each end. Where a function is not defined on the whole of
// its operand the result is undefined; it is never a NaN passed on as a number.
//
//   function            domain            range                 IEEE 1788 name
//   exp                 R                 (0, inf)              exp
//   log                 (0, inf)          R                     log
//   exp2, exp10         R                 (0, inf)              exp2, exp10
//   log2, log10         (0, inf)          R                     log2, log10
//   sin, cos            R                 [-1, 1]               sin, cos
//   tan                 no odd pi/2       R                     tan
//   asin                [-1, 1]           [-pi/2, pi/2]         asin
//   acos                [-1, 1]           [0, pi]               acos
//   atan                R                 (-pi/2, pi/2)         atan
//   sinh, asinh         R                 R                     sinh, asinh
//   cosh                R                 [1, inf)              cosh
//   acosh               [1, inf)          [0, inf)              acosh
//   tanh                R                 (-1, 1)               tanh
//   atanh               (-1, 1)           R                     atanh
//   atan2(y, x)         R^2 without 0     (-pi, pi]             atan2
//   sqrt                [0, inf)          [0, inf)              sqrt
//   rsqrt               (0, inf)          (0, inf)              rSqrt
//   pow(x, n)           R; R\{0}, n < 0   -                     pown
//   pow(x, y)           (0, inf) x R, and {0} x (0, inf)        pow
//   root(x, n)          [0, inf); R, n odd                      rootn
//   expm1               R                 (-1, inf)             expm1
//   log1p               (-1, inf)         R                     logp1
//   sinpi, cospi        R                 [-1, 1]               sinPi, cosPi
//   floor, ceil, trunc  R                 integers              floor, ceil, trunc
//   round_ties_to_even, round_ties_to_away: R, integers         roundTiesToEven, roundTiesToAway
//   signum              R                 {-1, 0, 1}            sign
//   min, max            R^2               -                     min, max
//   hypot               R^2               [0, inf)              hypot
//   agm                 [0, inf)^2        [0, inf)              -

#include <utility>

#include "polhode/arithmetic/ball.hpp"
#include "polhode/arithmetic/inexact_operand.hpp"

namespace polhode {

[[nodiscard]] inline ball sqrt(const ball& x) {
  ball r(detail::room{x.precision()});
  sqrt(r, x);
  return r;
}
[[nodiscard]] inline ball square(const ball& x) {
  ball r(detail::room{x.precision()});
  square(r, x);
  return r;
}
[[nodiscard]] inline ball scale(const ball& x, long n) {
  ball r(detail::room{x.precision()});
  scale(r, x, n);
  return r;
}
/// |x|.
[[nodiscard]] ball abs(const ball& x);
/// x^n; x^0 = 1 everywhere.
[[nodiscard]] ball pow(const ball& x, long n);
/// x^y = exp(y log x) for x > 0, and 0^y = 0 for y > 0; an exact integer y is taken as such, for
/// every x.
[[nodiscard]] ball pow(const ball& x, const ball& y);
/// The same for an exact exponent, such as 1/3: x must be > 0, or >= 0 for an exponent > 0.
template <rational_like N>
[[nodiscard]] ball pow(const ball& x, const N& y) {
  return pow(x, ball(y, x.precision()));
}
/// The real n-th root, n >= 1; of negative x too where n is odd. root(x, 3) is the cube root.
[[nodiscard]] ball root(const ball& x, unsigned long n);
// The range of a step function is reached at the ends: exact single integers where the set has no
// jump inside.
/// The greatest integer <= x, the least one >= x, the one of these two that is nearer to 0.
[[nodiscard]] ball floor(const ball& x);
[[nodiscard]] ball ceil(const ball& x);
[[nodiscard]] ball trunc(const ball& x);
/// The nearest integer; half way between two, the even one, or the one farther from 0.
[[nodiscard]] ball round_ties_to_even(const ball& x);
[[nodiscard]] ball round_ties_to_away(const ball& x);
/// -1, 0 or 1. (sign_of is the question whether all members have the same.)
[[nodiscard]] ball signum(const ball& x);
[[nodiscard]] ball min(const ball& x, const ball& y);
[[nodiscard]] ball max(const ball& x, const ball& y);
/// sqrt(x^2 + y^2), without overflow on the way.
[[nodiscard]] ball hypot(const ball& x, const ball& y);
/// The angle in (-pi, pi] of the point (x, y), a member of each; undefined where that may be the
/// origin. [-pi, pi] where the rectangle has points below and on the negative half of the x axis.
[[nodiscard]] ball atan2(const ball& y, const ball& x);

// In three-address form, as in ball.hpp.
void exp(ball& result, const ball& x);
void log(ball& result, const ball& x);
/// 2^x, 10^x, and the logarithms to these bases.
void exp2(ball& result, const ball& x);
void exp10(ball& result, const ball& x);
void log2(ball& result, const ball& x);
void log10(ball& result, const ball& x);
/// 1 / sqrt(x).
void rsqrt(ball& result, const ball& x);
/// For |x| of more bits before the point than max(2^20, 4 * precision) the answer is [-1, 1]:
/// its reduction modulo pi would need pi to that many bits.
void sin(ball& result, const ball& x);
void cos(ball& result, const ball& x);
/// Both at once, for little more than the price of one.
void sin_cos(ball& sine, ball& cosine, const ball& x);
void tan(ball& result, const ball& x);
void asin(ball& result, const ball& x);
void acos(ball& result, const ball& x);
void atan(ball& result, const ball& x);
void sinh(ball& result, const ball& x);
void cosh(ball& result, const ball& x);
void tanh(ball& result, const ball& x);
void asinh(ball& result, const ball& x);
void acosh(ball& result, const ball& x);
void atanh(ball& result, const ball& x);
/// e^x - 1 and log(1 + x), without cancellation near 0.
void expm1(ball& result, const ball& x);
void log1p(ball& result, const ball& x);
/// sin(pi x) and cos(pi x), reduced exactly however large x is.
void sinpi(ball& result, const ball& x);
void cospi(ball& result, const ball& x);
/// The arithmetic-geometric mean of two numbers >= 0.
void agm(ball& result, const ball& x, const ball& y);

// The same, as expressions.
#define POLHODE_AS_EXPRESSION(f)               \
  [[nodiscard]] inline ball f(const ball& x) { \
    ball r(detail::room{x.precision()});       \
    f(r, x);                                   \
    return r;                                  \
  }
POLHODE_AS_EXPRESSION(exp)
POLHODE_AS_EXPRESSION(log)
POLHODE_AS_EXPRESSION(exp2)
POLHODE_AS_EXPRESSION(exp10)
POLHODE_AS_EXPRESSION(log2)
POLHODE_AS_EXPRESSION(log10)
POLHODE_AS_EXPRESSION(rsqrt)
POLHODE_AS_EXPRESSION(sin)
POLHODE_AS_EXPRESSION(cos)
POLHODE_AS_EXPRESSION(tan)
POLHODE_AS_EXPRESSION(asin)
POLHODE_AS_EXPRESSION(acos)
POLHODE_AS_EXPRESSION(atan)
POLHODE_AS_EXPRESSION(sinh)
POLHODE_AS_EXPRESSION(cosh)
POLHODE_AS_EXPRESSION(tanh)
POLHODE_AS_EXPRESSION(asinh)
POLHODE_AS_EXPRESSION(acosh)
POLHODE_AS_EXPRESSION(atanh)
POLHODE_AS_EXPRESSION(expm1)
POLHODE_AS_EXPRESSION(log1p)
POLHODE_AS_EXPRESSION(sinpi)
POLHODE_AS_EXPRESSION(cospi)
#undef POLHODE_AS_EXPRESSION

/// {sin x, cos x}.
[[nodiscard]] inline std::pair<ball, ball> sin_cos(const ball& x) {
  std::pair<ball, ball> r;
  sin_cos(r.first, r.second, x);
  return r;
}
[[nodiscard]] inline ball agm(const ball& x, const ball& y) {
  ball r(detail::room_for(x, y));
  agm(r, x, y);
  return r;
}

// Constants to p bits: the error is half a unit in the last place.
[[nodiscard]] ball pi(precision p);
[[nodiscard]] ball log_2(precision p);

}  // namespace polhode
