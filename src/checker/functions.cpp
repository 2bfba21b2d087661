#include "functions.hpp"

#include <algorithm>

namespace polhode::checker {
namespace {

interval point(const integer& units, precision bits) { return {units, units, bits}; }

interval number(long n, const interval& like) { return {rational(n), like.bits()}; }

/// The set, of which only the members in [-1, 1] count.
interval within_one(const interval& x) {
  const integer one = integer(1) << static_cast<unsigned>(x.bits());
  return {std::min<integer>(std::max<integer>(x.low(), -one), one),
          std::max<integer>(std::min<integer>(x.high(), one), -one), x.bits()};
}

/// f(low) to f(high) of a function that increases.
template <class F>
interval from_ends(const interval& x, const F& f) {
  const interval low = f(point(x.low(), x.bits()));
  return x.low() == x.high() ? low : hull(low, f(point(x.high(), x.bits())));
}

/// e^x of one number. What is far below a unit costs nothing, and what is far too great for a
/// formula is not worked out.
interval exp_of(const interval& x) {
  constexpr long greatest = 4096;
  const precision bits = x.bits();
  if (x.low() > (integer(greatest) << static_cast<unsigned>(bits))) {
    throw undecided("an argument of exp is too great");
  }
  // e^x < 2^x for x < 0.
  if (x.high() < -(integer(bits) << static_cast<unsigned>(bits))) {
    return {integer(0), integer(1), bits};
  }
  return exp(x);
}

struct hyperbolic {
  interval sine;
  interval cosine;
};
/// sinh and cosh of one number: (e^x - e^-x)/2, (e^x + e^-x)/2.
hyperbolic hyperbolic_of(const interval& x) {
  const interval up = exp_of(x);
  const interval down = exp_of(-x);
  return {(up - down).scaled(-1), (up + down).scaled(-1)};
}
/// sinh increases; cosh is even, least at 0 and increases beyond.
hyperbolic hyperbolic_over(const interval& x) {
  hyperbolic low = hyperbolic_of(point(x.low(), x.bits()));
  if (x.low() == x.high()) return low;
  const hyperbolic high = hyperbolic_of(point(x.high(), x.bits()));
  interval cosine = hull(low.cosine, high.cosine);
  if (x.low() < 0 && x.high() > 0) cosine = hull(cosine, number(1, x));
  return {hull(low.sine, high.sine), cosine};
}

}  // namespace

// ---------------------------------------------------------------------------------------------
// Real intervals

sine_and_cosine sin_cos_over(const interval& x) {
  const precision bits = x.bits();
  const integer middle = floor_shift(x.low() + x.high(), 1);
  const integer radius = std::max<integer>(x.high() - middle, middle - x.low());
  sine_and_cosine at = sin_cos(point(middle, bits));
  if (radius == 0) return at;
  const interval r = point(radius, bits);
  const interval sine = interval::around_zero(radius, bits);
  const interval cosine = hull(number(1, x), number(1, x) - (r * r).scaled(-1));
  return {within_one(at.sine * cosine + at.cosine * sine),
          within_one(at.cosine * cosine - at.sine * sine)};
}
interval sin(const interval& x) { return sin_cos_over(x).sine; }
interval cos(const interval& x) { return sin_cos_over(x).cosine; }
interval sinh(const interval& x) { return hyperbolic_over(x).sine; }
interval cosh(const interval& x) { return hyperbolic_over(x).cosine; }
interval exp_over(const interval& x) { return from_ends(x, exp_of); }
interval atan_over(const interval& x) {
  return from_ends(x, [](const interval& end) { return atan(end); });
}

// ---------------------------------------------------------------------------------------------
// Jets: the rules of differentiation

jet operator-(const jet& x) { return {-x.value, -x.slope}; }
jet operator+(const jet& x, const jet& y) { return {x.value + y.value, x.slope + y.slope}; }
jet operator-(const jet& x, const jet& y) { return {x.value - y.value, x.slope - y.slope}; }
jet operator*(const jet& x, const jet& y) {
  return {x.value * y.value, x.slope * y.value + x.value * y.slope};
}
jet operator/(const jet& x, const jet& y) {
  const interval quotient = x.value / y.value;
  return {quotient, (x.slope - quotient * y.slope) / y.value};
}
jet square(const jet& x) { return {square(x.value), (x.value * x.slope).scaled(1)}; }
jet sqrt(const jet& x) {
  const interval root = sqrt(x.value);
  return {root, x.slope / root.scaled(1)};
}
jet exp_over(const jet& x) {
  const interval value = exp_over(x.value);
  return {value, value * x.slope};
}
jet log(const jet& x) { return {log(x.value), x.slope / x.value}; }
jet sin(const jet& x) {
  const sine_and_cosine at = sin_cos_over(x.value);
  return {at.sine, at.cosine * x.slope};
}
jet cos(const jet& x) {
  const sine_and_cosine at = sin_cos_over(x.value);
  return {at.cosine, -(at.sine * x.slope)};
}
jet sinh(const jet& x) {
  const hyperbolic at = hyperbolic_over(x.value);
  return {at.sine, at.cosine * x.slope};
}
jet cosh(const jet& x) {
  const hyperbolic at = hyperbolic_over(x.value);
  return {at.cosine, at.sine * x.slope};
}
jet atan_over(const jet& x) {
  return {atan_over(x.value), x.slope / (number(1, x.value) + square(x.value))};
}

// ---------------------------------------------------------------------------------------------
// Rectangles

rectangle operator-(const rectangle& z) { return {-z.re, -z.im}; }
rectangle operator+(const rectangle& z, const rectangle& w) { return {z.re + w.re, z.im + w.im}; }
rectangle operator-(const rectangle& z, const rectangle& w) { return {z.re - w.re, z.im - w.im}; }
rectangle operator*(const rectangle& z, const rectangle& w) {
  return {z.re * w.re - z.im * w.im, z.re * w.im + z.im * w.re};
}
rectangle operator/(const rectangle& z, const rectangle& w) {
  // z conj(w) / |w|^2; the divisor's rectangle excludes 0 where |w|^2 > 0.
  const interval size = square(w.re) + square(w.im);
  return {(z.re * w.re + z.im * w.im) / size, (z.im * w.re - z.re * w.im) / size};
}
rectangle square(const rectangle& z) {
  return {square(z.re) - square(z.im), (z.re * z.im).scaled(1)};
}

namespace {
void expect_off_the_cut(const rectangle& z, const char* what) {
  if (z.re.is_positive() || z.im.is_positive() || z.im.is_negative()) return;
  throw undecided(what);
}
}  // namespace

rectangle sqrt(const rectangle& z) {
  expect_off_the_cut(z, "a number is not known to be off the cut of the square root");
  // For w = sqrt(z): 2 (Re w)^2 = |z| + Re z, 2 (Im w)^2 = |z| - Re z, 2 Re w Im w = Im z, Re w >
  // 0. Of the two ways that is taken whose divisor is not near 0.
  const interval size = sqrt(square(z.re) + square(z.im));
  const integer middle = z.re.low() + z.re.high();
  if (z.re.is_positive() || middle > 0) {
    const interval re = sqrt((size + z.re).scaled(-1));
    return {re, z.im / re.scaled(1)};
  }
  const interval im_size = sqrt((size - z.re).scaled(-1));
  const interval im = z.im.is_positive() ? im_size : -im_size;
  return {z.im / im.scaled(1), im};
}
rectangle exp_over(const rectangle& z) {
  const interval size = exp_over(z.re);
  const sine_and_cosine turn = sin_cos_over(z.im);
  return {size * turn.cosine, size * turn.sine};
}
rectangle log(const rectangle& z) {
  expect_off_the_cut(z, "a number is not known to be off the cut of the logarithm");
  const interval size = log(square(z.re) + square(z.im)).scaled(-1);
  if (z.re.is_positive()) return {size, atan_over(z.im / z.re)};
  // arg z = pi/2 - arctan(Re z/Im z) above the real axis, -pi/2 - ... below it.
  const interval quarter = pi(z.re.bits()).scaled(-1);
  const interval rest = atan_over(z.re / z.im);
  return {size, (z.im.is_positive() ? quarter : -quarter) - rest};
}
rectangle sin(const rectangle& z) {
  const sine_and_cosine x = sin_cos_over(z.re);
  const hyperbolic y = hyperbolic_over(z.im);
  return {x.sine * y.cosine, x.cosine * y.sine};
}
rectangle cos(const rectangle& z) {
  const sine_and_cosine x = sin_cos_over(z.re);
  const hyperbolic y = hyperbolic_over(z.im);
  return {x.cosine * y.cosine, -(x.sine * y.sine)};
}
rectangle sinh(const rectangle& z) {
  const hyperbolic x = hyperbolic_over(z.re);
  const sine_and_cosine y = sin_cos_over(z.im);
  return {x.sine * y.cosine, x.cosine * y.sine};
}
rectangle cosh(const rectangle& z) {
  const hyperbolic x = hyperbolic_over(z.re);
  const sine_and_cosine y = sin_cos_over(z.im);
  return {x.cosine * y.cosine, x.sine * y.sine};
}
rectangle atan_over(const rectangle& z) {
  // arctan z = (log(1 + iz) - log(1 - iz))/(2i): 1 + iz and 1 - iz are on the cut of the logarithm
  // only for z = iy, |y| >= 1.
  const interval one = number(1, z.re);
  const rectangle difference = log(rectangle{one - z.im, z.re}) - log(rectangle{one + z.im, -z.re});
  return {difference.im.scaled(-1), -difference.re.scaled(-1)};
}

// ---------------------------------------------------------------------------------------------
// Constants and sizes

interval constant(const rational& q, const interval& like) { return {q, like.bits()}; }
jet constant(const rational& q, const jet& like) {
  return {constant(q, like.value), number(0, like.value)};
}
rectangle constant(const rational& q, const rectangle& like) {
  return {constant(q, like.re), number(0, like.re)};
}
interval pi_like(const interval& like) { return pi(like.bits()); }
jet pi_like(const jet& like) { return {pi_like(like.value), number(0, like.value)}; }
rectangle pi_like(const rectangle& like) { return {pi_like(like.re), number(0, like.re)}; }
long bits_before_point(const interval& x) { return bit_length(x.magnitude()) - x.bits(); }
long bits_before_point(const jet& x) {
  return std::max(bits_before_point(x.value), bits_before_point(x.slope));
}
long bits_before_point(const rectangle& z) {
  return std::max(bits_before_point(z.re), bits_before_point(z.im));
}

}  // namespace polhode::checker
