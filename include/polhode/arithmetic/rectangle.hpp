#pragma once

// Complex functions of rectangles: z = re + i im, where re and im run over two sets of reals on
// their own. The set formulas are written here once, over the type R of these sets: `ball`
// (complex_ball.hpp) or an interval of hardware doubles. The inclusion principle of ball.hpp holds
// throughout: f(z) lies in the result for every member z of the operand at which f is defined.
//
// How a range is found. Where each of x = re and y = im occurs once in a formula, interval
// evaluation gives the range itself (exp, log, arg, sin, cos, sinh, cosh, square, products).
// Elsewhere the parts of f are monotone in x and in |y|, or have one extremum whose place and
// value are known, and the range is that of a few corners, each evaluated at a point (sqrt,
// reciprocal, asin, acos, atan and their hyperbolic kin, tan, tanh). The lines above each function
// prove it, mostly from the Cauchy-Riemann equations: with f' = p + i q,
// df = (p dx - q dy) + i (q dx + p dy).
// A narrow operand (a ball by midpoint and radius in both parts) goes by the mean value theorem, at
// its midpoint m: f(z) - f(m) is in the convex hull of f' over the operand, times (z - m).
//
// BRANCH CUTS. A function with cuts encloses the principal value at every member. On a cut itself a
// part that is 0 counts as +0, as in C99 annex G and Boost: the value is the limit from above, or,
// for cuts on the imaginary axis, from the right. So an operand with im in [0, y] has the values
// of the upper side only, one with im < 0 those of the lower side only, and one across the cut has
// the hull of both.
//
//   function           cut                            continuous from   undefined at
//   sqrt               (-inf, 0)                      above             -
//   log, arg           (-inf, 0)                      above             0
//   pow(z, w)          (-inf, 0), w not an integer    above             0, unless z = 0, re w > 0
//   asin, acos         (-inf, -1), (1, inf)           above             -
//   acosh              (-inf, 1)                      above             -
//   atanh              (-inf, -1), (1, inf)           above             -1, 1
//   atan               i (-inf, -1), i (1, inf)       the right         -i, i
//   asinh              i (-inf, -1), i (1, inf)       the right         -
//   agm(z)             (-inf, 0)                      above             -
//   reciprocal, z / w  -                              -                 0
//   tan                -                              -                 odd multiples of pi/2
//   tanh               -                              -                 i times those
//
// Whether f is analytic on a neighbourhood of the operand is another question than where its values
// lie, and has its own answer: possibly_singular::f(z), at the end of this file.

#include "polhode/language.hpp"

#include <algorithm>
#include <utility>

namespace polhode {

/// What this file needs of R beyond + - * /, unary -, sqrt, square, scale, exp, log, log1p, sin,
/// cos, sinh, cosh, tanh, atan, pow(x, n), hypot, abs, hull, intersection, contains_zero,
/// certainly_positive and certainly_negative. Specialised beside each R; the members are those of
/// real_set<ball>, the ones for narrow sets only where has_narrow.
template <class R>
struct real_set;

template <class R>
struct rectangle {
  R re;
  R im;
};

template <class R>
[[nodiscard]] bool is_undefined(const rectangle<R>& z) {
  return real_set<R>::is_undefined(z.re) || real_set<R>::is_undefined(z.im);
}
/// 0 is a member.
template <class R>
[[nodiscard]] bool contains_zero(const rectangle<R>& z) {
  return contains_zero(z.re) && contains_zero(z.im);
}

namespace detail::rectangles {

// Bits beyond the operand's precision in which a chain of at most 2^5 roundings is done, so that it
// costs less than 2^-4 of a unit in the last place of the result.
inline constexpr long guard = 10;

template <class R>
[[nodiscard]] R integer(long n, const R& like) {
  return real_set<R>::integer(n, like);
}
template <class R>
[[nodiscard]] R half(const R& x) {
  return scale(x, -1);
}
template <class R>
[[nodiscard]] bool not_negative(const R& x) {
  return real_set<R>::not_negative(x);
}
template <class R>
[[nodiscard]] rectangle<R> undefined_like(const rectangle<R>& z) {
  return {real_set<R>::undefined(z.re), real_set<R>::undefined(z.im)};
}
template <class R>
[[nodiscard]] rectangle<R> raised(const rectangle<R>& z, long bits) {
  return {real_set<R>::raised(z.re, bits), real_set<R>::raised(z.im, bits)};
}
template <class R>
[[nodiscard]] rectangle<R> rounded(const rectangle<R>& z, const rectangle<R>& like) {
  return {real_set<R>::rounded(z.re, like.re), real_set<R>::rounded(z.im, like.im)};
}
template <class R>
[[nodiscard]] rectangle<R> hull_of(const rectangle<R>& z, const rectangle<R>& w) {
  return {hull(z.re, w.re), hull(z.im, w.im)};
}
/// i z and -i z.
template <class R>
[[nodiscard]] rectangle<R> times_i(const rectangle<R>& z) {
  return {-z.im, z.re};
}
template <class R>
[[nodiscard]] rectangle<R> divided_by_i(const rectangle<R>& z) {
  return {z.im, -z.re};
}

template <class R>
[[nodiscard]] bool is_narrow(const rectangle<R>& z) {
  return real_set<R>::is_narrow(z.re) && real_set<R>::is_narrow(z.im);
}
/// The midpoint as an exact point, with guard bits.
template <class R>
[[nodiscard]] rectangle<R> midpoint(const rectangle<R>& z) {
  return raised(rectangle<R>{real_set<R>::middle(z.re), real_set<R>::middle(z.im)}, guard);
}
template <class R>
[[nodiscard]] rectangle<R> coarse(const rectangle<R>& z) {
  return {real_set<R>::coarse(z.re), real_set<R>::coarse(z.im)};
}
template <class R>
[[nodiscard]] bool is_exact(const rectangle<R>& z) {
  return real_set<R>::is_exact(z.re) && real_set<R>::is_exact(z.im);
}

/// f(midpoint) grown by the mean value theorem to hold f(z): slope() gives f' over z (any branch of
/// it: only sizes count) and is not asked where z is exact. False where f' changes much over z: the
/// corners do better there.
template <class R, class Slope>
[[nodiscard]] bool spread(rectangle<R>& value, const rectangle<R>& z, Slope&& slope) {
  value = rounded(value, z);
  if (is_exact(z)) return true;
  const rectangle<R> s = slope();
  if (!real_set<R>::is_steady(s)) return false;
  return real_set<R>::enlarge(value.re, s.re, z.re, s.im, z.im) &&
         real_set<R>::enlarge(value.im, s.im, z.re, s.re, z.im);
}

/// 1 / z by interval evaluation, for the slope of a narrow set: good in each part where z is.
template <class R>
[[nodiscard]] rectangle<R> inverse(const rectangle<R>& z) {
  const R norm = square(real_set<R>::modulus(z.re, z.im));
  return {z.re / norm, -(z.im / norm)};
}
/// 1 - z^2, not less accurate in one part than in the other.
template <class R>
[[nodiscard]] rectangle<R> one_minus_square(const rectangle<R>& z) {
  const R one = integer(1, z.re);
  const R x = real_set<R>::coarse(z.re);
  const R y = real_set<R>::coarse(z.im);
  return {real_set<R>::coarse(one - z.re) * real_set<R>::coarse(one + z.re) + square(y),
          scale(-(x * y), 1)};
}

/// A set by its ends, each as a point (see real_set<ball>::lower_end on infinite ones).
template <class R>
struct ends {
  explicit ends(const R& x) : lower(real_set<R>::lower_end(x)), upper(real_set<R>::upper_end(x)) {}
  R lower;
  R upper;
};

/// The range of an f(x, y) that is odd in y, with f(., 0) the limit from above, where f(x, y), for
/// y >= 0, is increasing in y and is least at x = inner and greatest at x = outer.
template <class R, class F>
[[nodiscard]] R odd_in_y(const R& y, const R& inner, const R& outer, F&& f) {
  if (not_negative(y)) {
    const ends<R> e(y);
    return hull(f(inner, e.lower), f(outer, e.upper));
  }
  if (certainly_negative(y)) {
    const ends<R> e(-y);
    return -hull(f(inner, e.lower), f(outer, e.upper));
  }
  const ends<R> e(y);
  return hull(-f(outer, -e.lower), f(outer, e.upper));
}

/// The range of an f(x, y) that is odd in x and, for x > 0, decreasing in |y| and, for each |y|,
/// increasing in x up to peak_place(|y|), where it is peak_value(|y|), and decreasing from there.
template <class R, class F, class Place, class Value>
[[nodiscard]] R odd_with_peak(const R& x, const R& y, F&& f, Place&& peak_place,
                              Value&& peak_value) {
  const ends<R> ey(abs(y));
  // The values at |y| = ey.lower for 0 < low <= x <= high hold the greatest, those at the other
  // end of |y| the least.
  const auto greatest = [&](const R& low, const R& high, R sides) {
    const R place = peak_place(ey.lower);
    if (certainly_negative(place - low) || certainly_positive(place - high)) return sides;
    return hull(sides, peak_value(ey.lower));
  };
  const auto on_positive = [&](const R& positive) {
    const ends<R> e(positive);
    return greatest(e.lower, e.upper,
                    hull(hull(f(e.lower, ey.lower), f(e.upper, ey.lower)),
                         hull(f(e.lower, ey.upper), f(e.upper, ey.upper))));
  };
  if (certainly_positive(x)) return on_positive(x);
  if (certainly_negative(x)) return -on_positive(-x);
  const ends<R> e(x);
  const R zero = integer(0, x);
  R r = zero;
  if (certainly_positive(e.upper)) {
    r = hull(r, greatest(zero, e.upper, f(e.upper, ey.lower)));
  }
  if (certainly_negative(e.lower)) {
    r = hull(r, -greatest(zero, -e.lower, f(-e.lower, ey.lower)));
  }
  return r;
}

}  // namespace detail::rectangles

// ---------------------------------------------------------------------------------------------
// Field operations.

template <class R>
[[nodiscard]] rectangle<R> operator-(const rectangle<R>& z) {
  return {-z.re, -z.im};
}
template <class R>
[[nodiscard]] rectangle<R> conj(const rectangle<R>& z) {
  return {z.re, -z.im};
}
template <class R>
[[nodiscard]] rectangle<R> operator+(const rectangle<R>& z, const rectangle<R>& w) {
  return {z.re + w.re, z.im + w.im};
}
template <class R>
[[nodiscard]] rectangle<R> operator-(const rectangle<R>& z, const rectangle<R>& w) {
  return {z.re - w.re, z.im - w.im};
}
/// The range of each part: all four factors are free of each other.
template <class R>
[[nodiscard]] rectangle<R> operator*(const rectangle<R>& z, const rectangle<R>& w) {
  return {z.re * w.re - z.im * w.im, z.re * w.im + z.im * w.re};
}
template <class R>
[[nodiscard]] rectangle<R> operator*(const rectangle<R>& z, const R& x) {
  return {z.re * x, z.im * x};
}
/// z^2 = x^2 - y^2 + 2 i x y: the range of each part.
template <class R>
[[nodiscard]] rectangle<R> square(const rectangle<R>& z) {
  return {square(z.re) - square(z.im), scale(z.re * z.im, 1)};
}

/// 1 / z: the range of each part for a wide operand. Undefined where z holds 0.
// Re = g(x, y) and Im = -g(y, x) with g = x / (x^2 + y^2), which is odd in x, and for x > 0
// decreasing in |y|; dg/dx has the sign of y^2 - x^2, so that its peak is g(|y|, y) = 1 / (2 |y|).
template <class R>
[[nodiscard]] rectangle<R> reciprocal(const rectangle<R>& z) {
  namespace d = detail::rectangles;
  if (is_undefined(z) || contains_zero(z)) return d::undefined_like(z);
  if constexpr (real_set<R>::has_narrow) {
    if (d::is_narrow(z)) return real_set<R>::quotient(real_set<R>::unit(z.re), z);
  }
  const auto g = [](const R& x, const R& y) {
    // Of ends x, y >= 0: by the quotient of the smaller by the greater, which does not overflow.
    if (contains_zero(x) || certainly_less(x, y)) {
      const R q = x / y;
      return q / (x * q + y);
    }
    return d::integer(1, x) / (x + y * (y / x));
  };
  const auto place = [](const R& y) { return y; };
  const auto peak = [](const R& y) { return d::integer(1, y) / scale(y, 1); };
  const rectangle<R> w = d::raised(z, d::guard);
  return d::rounded(rectangle<R>{d::odd_with_peak(w.re, w.im, g, place, peak),
                                 -d::odd_with_peak(w.im, w.re, g, place, peak)},
                    z);
}

/// Undefined where w holds 0. For wide operands z times the range of 1 / w, for narrow ones the
/// midpoints' quotient and its change to first order; for what lies between the common part.
template <class R>
[[nodiscard]] rectangle<R> operator/(const rectangle<R>& z, const rectangle<R>& w) {
  namespace d = detail::rectangles;
  if (is_undefined(z) || is_undefined(w) || contains_zero(w)) return d::undefined_like(z);
  if constexpr (real_set<R>::has_narrow) {
    rectangle<R> centred = real_set<R>::quotient(z, w);
    if (d::is_narrow(z) && d::is_narrow(w)) return centred;
    rectangle<R> r = z * reciprocal(w);
    if (is_undefined(centred)) return r;
    return {intersection(r.re, centred.re), intersection(r.im, centred.im)};
  } else {
    return z * reciprocal(w);
  }
}

/// |z|: the range.
template <class R>
[[nodiscard]] R abs(const rectangle<R>& z) {
  return hypot(z.re, z.im);
}

namespace detail::rectangles {

/// z^n for n >= 1 by squarings: of a point, within n 2^(3 - precision) of its size.
template <class R>
[[nodiscard]] rectangle<R> power_by_squarings(rectangle<R> z, unsigned long n) {
  while (n % 2 == 0) {
    z = square(z);
    n /= 2;
  }
  rectangle<R> r = z;
  for (n /= 2; n != 0; n /= 2) {
    z = square(z);
    if (n % 2 != 0) r = r * z;
  }
  return r;
}

/// arg z in (-pi, pi], without a last rounding. x and y occur once in each line: the range.
template <class R>
[[nodiscard]] R argument(const R& x, const R& y) {
  if (certainly_positive(x)) return atan(y / x);
  const R pi = real_set<R>::pi(x);
  if (certainly_positive(y)) return half(pi) - atan(x / y);
  if (certainly_negative(y)) return -half(pi) - atan(x / y);
  if (certainly_negative(x)) return not_negative(y) ? pi + atan(y / x) : hull(-pi, pi);
  return real_set<R>::undefined(x);  // 0 is a member
}

/// log |z|, without a last rounding.
// The range, since x^2 and y^2 occur once. Near |z| = 1 it is log1p(t) / 2 with t = (x^2 - 1) +
// y^2, |x| >= |y|. For a point of p bits there x^2 is an integer times 4^-p (as |x| >= 1/2), so is
// y^2 times some 4^-k with k >= p, and 2p + 16 bits hold x^2 - 1 exactly; either the two summands
// of t do not cancel, or they have about the same exponent and the sum is exact too. So log |z|
// has a relative error of a few 2^-p.
template <class R>
[[nodiscard]] R log_modulus(const R& x, const R& y) {
  const R one = integer(1, x);
  const R norm = square(x) + square(y);
  if (certainly_positive(norm - half(one)) && certainly_negative(norm - scale(one, 1))) {
    const bool x_leads = !certainly_positive(abs(y) - abs(x));
    const R lead = real_set<R>::doubled(abs(x_leads ? x : y));
    const R rest = real_set<R>::doubled(x_leads ? y : x);
    const R exact_one = integer(1, lead);
    R less_one = lead;
    if constexpr (real_set<R>::has_narrow) {
      less_one = square(lead) - exact_one;
    } else {  // increasing in |x|: the range
      const auto f = [&](const R& s) { return (s - exact_one) * (s + exact_one); };
      const ends<R> e(lead);
      less_one = hull(f(e.lower), f(e.upper));
    }
    return half(log1p(real_set<R>::rounded(less_one + square(rest), one)));
  }
  // The norm of a number near the ends of the range of exponents may be of no use.
  if (real_set<R>::is_bounded(norm) && certainly_positive(norm)) return half(log(norm));
  return log(hypot(x, y));
}

}  // namespace detail::rectangles

/// arg z in (-pi, pi]: the range. Undefined where z holds 0.
template <class R>
[[nodiscard]] R arg(const rectangle<R>& z) {
  namespace d = detail::rectangles;
  if (is_undefined(z)) return real_set<R>::undefined(z.re);
  const rectangle<R> w = d::raised(z, d::guard);
  return real_set<R>::rounded(d::argument(w.re, w.im), z.re);
}

/// log |z| + i arg z: the range of each part. Undefined where z holds 0.
template <class R>
[[nodiscard]] rectangle<R> log(const rectangle<R>& z) {
  namespace d = detail::rectangles;
  if (is_undefined(z) || contains_zero(z)) return d::undefined_like(z);
  const rectangle<R> w = d::raised(z, d::guard);
  return d::rounded(rectangle<R>{d::log_modulus(w.re, w.im), d::argument(w.re, w.im)}, z);
}

// ---------------------------------------------------------------------------------------------
// The exponential and its kin: products of real functions of x and of y, so that each part is its
// range.

/// e^x (cos y + i sin y).
template <class R>
[[nodiscard]] rectangle<R> exp(const rectangle<R>& z) {
  namespace d = detail::rectangles;
  if (is_undefined(z)) return d::undefined_like(z);
  const rectangle<R> w = d::raised(z, d::guard);
  const R size = exp(w.re);
  const auto [sine, cosine] = real_set<R>::sin_cos(w.im);
  return d::rounded(rectangle<R>{size * cosine, size * sine}, z);
}

/// sin x cosh y + i cos x sinh y.
template <class R>
[[nodiscard]] rectangle<R> sin(const rectangle<R>& z) {
  namespace d = detail::rectangles;
  if (is_undefined(z)) return d::undefined_like(z);
  const rectangle<R> w = d::raised(z, d::guard);
  const auto [sine, cosine] = real_set<R>::sin_cos(w.re);
  const auto [sinh_y, cosh_y] = real_set<R>::sinh_cosh(w.im);
  return d::rounded(rectangle<R>{sine * cosh_y, cosine * sinh_y}, z);
}

/// cos x cosh y - i sin x sinh y.
template <class R>
[[nodiscard]] rectangle<R> cos(const rectangle<R>& z) {
  namespace d = detail::rectangles;
  if (is_undefined(z)) return d::undefined_like(z);
  const rectangle<R> w = d::raised(z, d::guard);
  const auto [sine, cosine] = real_set<R>::sin_cos(w.re);
  const auto [sinh_y, cosh_y] = real_set<R>::sinh_cosh(w.im);
  return d::rounded(rectangle<R>{cosine * cosh_y, -(sine * sinh_y)}, z);
}

/// -i sin(i z).
template <class R>
[[nodiscard]] rectangle<R> sinh(const rectangle<R>& z) {
  namespace d = detail::rectangles;
  return d::divided_by_i(sin(d::times_i(z)));
}
/// cos(i z).
template <class R>
[[nodiscard]] rectangle<R> cosh(const rectangle<R>& z) {
  return cos(detail::rectangles::times_i(z));
}

namespace detail::rectangles {

// tan z = (sin 2x + i sinh 2y) / (cos 2x + cosh 2y), for small |y| as
//     (sin x cos x + i sinh y cosh y) / (cos^2 x + sinh^2 y),
// and for other y, with q = e^(-2|y|) < 1/e, as
//     (2 q sin 2x + i sign(y) (1 - q^2)) / ((1 - q)^2 + 4 q cos^2 x).
// Both denominators are sums of terms >= 0, and nothing overflows in the second form: for a point
// all relative errors are small.

/// |y| > 1/2: where the second form is used.
template <class R>
[[nodiscard]] bool is_away_from_zero(const R& y) {
  return certainly_positive(abs(y) - half(integer(1, y)));
}

/// Im tan for cos^2 x = c, by interval evaluation.
template <class R>
[[nodiscard]] R im_tan(const R& c, const R& y) {
  if (is_away_from_zero(y)) {
    const R one = integer(1, y);
    const R q = exp(scale(-abs(y), 1));
    const R im = (one - square(q)) / (square(one - q) + scale(q * c, 2));
    return certainly_negative(y) ? -im : im;
  }
  const auto [sinh_y, cosh_y] = real_set<R>::sinh_cosh(y);
  return sinh_y * cosh_y / (c + square(sinh_y));
}

/// tan by interval evaluation; undefined where the denominator may vanish.
template <class R>
[[nodiscard]] rectangle<R> plain_tan(const R& x, const R& y) {
  const auto [sine, cosine] = real_set<R>::sin_cos(x);
  const R c = square(cosine);
  if (is_away_from_zero(y)) {
    const R one = integer(1, x);
    const R q = exp(scale(-abs(y), 1));
    const R divisor = square(one - q) + scale(q * c, 2);
    const R im = (one - square(q)) / divisor;
    return {scale(q * (sine * cosine), 2) / divisor, certainly_negative(y) ? -im : im};
  }
  const auto [sinh_y, cosh_y] = real_set<R>::sinh_cosh(y);
  const R divisor = c + square(sinh_y);
  return {sine * cosine / divisor, sinh_y * cosh_y / divisor};
}

/// The range of Im tan for y >= 0, given that of cos^2 x.
// Im is decreasing in c = cos^2 x. With v = 2y, dIm/dv has the sign of 1 + cos 2x cosh v: for each
// x Im is increasing up to cosh v = -1 / cos 2x, that is tanh^2 y = c / (1 - c), where it is 1 /
// sqrt(1 - cos^2 2x) = 1 / (2 sqrt(c (1 - c))), and decreasing from there. So its greatest value
// lies at the least c and an end of y or that place, its least at the greatest c and an end of y.
template <class R>
[[nodiscard]] R im_tan_above(const R& cosine_squared, const R& y) {
  const ends<R> c(cosine_squared);
  const ends<R> e(y);
  R r = hull(hull(im_tan(c.lower, e.lower), im_tan(c.lower, e.upper)),
             hull(im_tan(c.upper, e.lower), im_tan(c.upper, e.upper)));
  const R rest = integer(1, y) - c.lower;
  if (!certainly_positive(rest - c.lower)) return r;  // increasing for all y
  const R place = sqrt(c.lower / rest);               // of tanh y
  if (certainly_negative(place - tanh(e.lower)) || certainly_positive(place - tanh(e.upper))) {
    return r;
  }
  return hull(r, half(integer(1, y) / sqrt(c.lower * rest)));
}

/// The range of Re tan.
// With u = 2x and v = 2y, Re = sin u / (cos u + cosh v) is monotone in |v| for each u, so that its
// extremes lie at the least or the greatest |v|. For each v >= 0, dRe/du has the sign of 1 + cos u
// cosh v. That is 0 where tan x = (1 - cos u) / sin u = +-(cosh v + 1) / sinh v = +-coth y, and
// there Re = +-1 / sinh v. Those are the zeros of cos x -+ tanh y sin x, simple and at distances
// of pi.
template <class R>
[[nodiscard]] R re_tan(const R& x, const R& y) {
  const ends<R> ex(x);
  const ends<R> ey(abs(y));
  const bool is_short = certainly_positive(real_set<R>::pi(x) - (ex.upper - ex.lower));
  const std::pair<R, R> low = real_set<R>::sin_cos(ex.lower);
  const std::pair<R, R> high = real_set<R>::sin_cos(ex.upper);
  const auto have_one_sign = [](const R& s, const R& t) {
    return (certainly_positive(s) && certainly_positive(t)) ||
           (certainly_negative(s) && certainly_negative(t));
  };
  const auto at = [&](const R& size) {
    R r = hull(plain_tan(ex.lower, size).re, plain_tan(ex.upper, size).re);
    const R t = tanh(size);
    const bool passes_top =
        !is_short || !have_one_sign(low.second - t * low.first, high.second - t * high.first);
    const bool passes_bottom =
        !is_short || !have_one_sign(low.second + t * low.first, high.second + t * high.first);
    if (!passes_top && !passes_bottom) return r;
    const R peak = integer(1, size) / sinh(scale(size, 1));
    if (real_set<R>::is_undefined(r)) r = hull(-peak, peak);  // an end of x at infinity
    if (passes_top) r = hull(r, peak);
    if (passes_bottom) r = hull(r, -peak);
    return r;
  };
  return hull(at(ey.lower), at(ey.upper));
}

}  // namespace detail::rectangles

/// tan z: the range of each part. Undefined where z holds, or to the precision at hand may hold, a
/// pole.
template <class R>
[[nodiscard]] rectangle<R> tan(const rectangle<R>& z) {
  namespace d = detail::rectangles;
  if (is_undefined(z)) return d::undefined_like(z);
  if constexpr (real_set<R>::has_narrow) {
    if (d::is_narrow(z)) {
      const rectangle<R> m = d::midpoint(z);
      rectangle<R> value = d::plain_tan(m.re, m.im);
      const auto slope =
          [&] {  // 1 / cos^2 = 1 + tan^2; at few bits the distance from a pole would be lost
            return d::is_away_from_zero(z.im)
                       ? square(d::plain_tan(z.re, z.im)) + real_set<R>::unit(z.re)
                       : d::inverse(square(cos(z)));
          };
      if (!is_undefined(value) && d::spread(value, z, slope)) return value;
    }
  }
  const rectangle<R> w = d::raised(z, d::guard);
  if (contains_zero(w.im) && contains_zero(cos(w.re))) return d::undefined_like(z);
  const R c = square(cos(w.re));
  R im = w.im;
  if (d::not_negative(w.im)) {
    im = d::im_tan_above(c, w.im);
  } else if (certainly_negative(w.im)) {
    im = -d::im_tan_above(c, -w.im);
  } else {
    const d::ends<R> e(w.im);
    const R zero = d::integer(0, w.im);
    im = hull(-d::im_tan_above(c, hull(zero, -e.lower)), d::im_tan_above(c, hull(zero, e.upper)));
  }
  const rectangle<R> r{d::re_tan(w.re, w.im), im};
  return is_undefined(r) ? d::undefined_like(z) : d::rounded(r, z);
}

/// -i tan(i z).
template <class R>
[[nodiscard]] rectangle<R> tanh(const rectangle<R>& z) {
  namespace d = detail::rectangles;
  return d::divided_by_i(tan(d::times_i(z)));
}

// ---------------------------------------------------------------------------------------------
// The square root.

namespace detail::rectangles {

/// sqrt(x + i y) for y >= 0, at a point or a narrow set: with r = |z|,
/// x >= 0: u = sqrt((r + x) / 2), v = y / (2u);  x < 0: v = sqrt((r - x) / 2), u = y / (2v).
/// No difference is formed: small relative errors in both parts.
template <class R>
[[nodiscard]] rectangle<R> upper_sqrt(const R& x, const R& y) {
  const R r = real_set<R>::modulus(x, y);
  if (certainly_negative(x)) {
    const R v = sqrt(half(r - x));
    return {y / scale(v, 1), v};
  }
  const R u = sqrt(half(r + x));
  // v^2 = (r - x) / 2 <= r / 2 serves at 0 itself.
  return {u, contains_zero(u) ? hull(integer(0, x), sqrt(half(r))) : y / scale(u, 1)};
}
/// 1 / sqrt z or its conjugate, as a slope: conj(sqrt z) / |z|.
template <class R>
[[nodiscard]] rectangle<R> inverse_sqrt(const rectangle<R>& z) {
  const rectangle<R> root = upper_sqrt(z.re, abs(z.im));
  const R size = real_set<R>::modulus(z.re, z.im);
  return {root.re / size, root.im / size};
}

}  // namespace detail::rectangles

/// The square root with re >= 0: the range of each part. sqrt(x) = i sqrt(-x) for x < 0.
// f' = 1 / (2 sqrt z) = (u - i v) / (2 |z|), so u is increasing in x, v is increasing in y, and
// where y >= 0, and so v >= 0, u is increasing in y and v is decreasing in x. The mirror image of z
// has the mirror image of the root.
template <class R>
[[nodiscard]] rectangle<R> sqrt(const rectangle<R>& z) {
  namespace d = detail::rectangles;
  if (is_undefined(z)) return d::undefined_like(z);
  if constexpr (real_set<R>::has_narrow) {
    if (d::is_narrow(z)) {
      const rectangle<R> m = d::midpoint(z);
      rectangle<R> value = d::upper_sqrt(m.re, abs(m.im));
      if (certainly_negative(m.im)) value.im = -value.im;
      const auto slope = [&] {
        const rectangle<R> c = d::coarse(z);
        return d::inverse_sqrt(rectangle<R>{scale(c.re, 2), scale(c.im, 2)});
      };
      if (d::spread(value, z, slope)) return value;
    }
  }
  const rectangle<R> w = d::raised(z, d::guard);
  const d::ends<R> ex(w.re);
  const d::ends<R> size(abs(w.im));
  const auto re = [](const R& x, const R& y) { return d::upper_sqrt(x, y).re; };
  const auto im = [](const R& x, const R& y) { return d::upper_sqrt(x, y).im; };
  return d::rounded(rectangle<R>{hull(re(ex.lower, size.lower), re(ex.upper, size.upper)),
                                 d::odd_in_y(w.im, ex.upper, ex.lower, im)},
                    z);
}

// ---------------------------------------------------------------------------------------------
// Inverse circular and hyperbolic functions.

namespace detail::rectangles {

/// A point x + i y, x >= 0, y >= 0, in the ellipses and hyperbolas with foci +-1: with r = |z + 1|
/// and s = |z - 1|, a = (r + s) / 2 and b = (r - s) / 2 = x / a,
///     asin z = asin b + i acosh a,    acos z = acos b - i acosh a
/// (T. E. Hull, T. F. Fairgrieve, P. T. P. Tang, Implementing the complex arcsine and arccosine
/// functions using exception handling, ACM TOMS 23, 1997). As there, a - 1 and a - x are formed
/// from r - (x + 1) = y^2 / (r + (x + 1)) and its like, as sums of terms >= 0: from an exact point
/// every step has a small relative error, and so have all three results, for tiny and huge
/// arguments and near the branch points.
template <class R>
class confocal {
 public:
  confocal(const R& x, const R& y) : x_(x), excess_(x), gap_(x), a_(x) {
    const R one = integer(1, x);
    const R beyond = x + one;
    const R offset = x - one;
    const R r = real_set<R>::modulus(beyond, y);
    const R s = real_set<R>::modulus(offset, y);
    const R from_left = y * (y / (r + beyond));  // r - (x + 1)
    // s - |x - 1|, which is 0 where z = 1.
    const R span = s + abs(offset);
    const R from_right = contains_zero(span) ? hull(integer(0, x), s) : y * (y / span);
    const bool inside = certainly_negative(offset);
    excess_ = half(from_left + (inside ? from_right : s + offset));
    gap_ = half(from_left + (inside ? s - offset : from_right));
    a_ = half(r + s);
  }
  /// acosh a = log1p(a - 1 + sqrt((a - 1)(a + 1))) >= 0.
  [[nodiscard]] R height() const {
    return log1p(excess_ + sqrt(excess_) * sqrt(excess_ + integer(2, x_)));
  }
  /// asin b = atan2(x, sqrt((a - x)(a + x))) in [0, pi/2], or acos b, the complement of it.
  [[nodiscard]] R angle(bool complement) const {
    const R side = sqrt(gap_) * sqrt(a_ + x_);
    R angle = complement ? argument(x_, side) : argument(side, x_);
    if (!real_set<R>::is_undefined(angle)) return angle;
    return hull(integer(0, x_), half(real_set<R>::pi(x_)));  // an end at infinity
  }

 private:
  R x_;
  R excess_;  // a - 1
  R gap_;     // a - x
  R a_;
};

/// asin b or acos b for a point x of any sign.
template <class R>
[[nodiscard]] R signed_angle(const R& x, const R& y, bool complement) {
  if (!certainly_negative(x)) return confocal<R>(x, y).angle(complement);
  const R angle = confocal<R>(-x, y).angle(complement);
  return complement ? real_set<R>::pi(x) - angle : -angle;
}

/// {asin b, or acos b; acosh a with the sign of y, + for 0}: the ranges.
// a is convex and even in x and in y, so it is increasing in |x| and in |y|. b is odd in x; it is
// increasing in x, as db/dx = ((x + 1)/r - (x - 1)/s)/2 and t / sqrt(t^2 + y^2) is increasing in
// t; and |b| = |x| / a is decreasing in |y|.
template <class R>
[[nodiscard]] rectangle<R> inverse_sine(const rectangle<R>& z, bool complement) {
  if (is_undefined(z)) return undefined_like(z);
  if constexpr (real_set<R>::has_narrow) {
    if (is_narrow(z)) {
      const rectangle<R> m = midpoint(z);
      const bool left = certainly_negative(m.re);
      const confocal<R> c(abs(m.re), abs(m.im));
      const R height = c.height();
      const R angle = c.angle(complement);
      const R whole = left && complement ? real_set<R>::pi(m.re) - angle : left ? -angle : angle;
      rectangle<R> value{whole, certainly_negative(m.im) ? -height : height};
      const auto slope = [&] { return inverse_sqrt(one_minus_square(z)); };
      if (spread(value, z, slope)) return value;
    }
  }
  const rectangle<R> w = raised(z, guard);
  const ends<R> ex(w.re);
  const ends<R> size_x(abs(w.re));
  const ends<R> size_y(abs(w.im));
  const R at_right = signed_angle(
      ex.upper, certainly_positive(ex.upper) ? size_y.lower : size_y.upper, complement);
  const R at_left = signed_angle(
      ex.lower, certainly_negative(ex.lower) ? size_y.lower : size_y.upper, complement);
  const auto height = [](const R& x, const R& y) { return confocal<R>(x, y).height(); };
  return rounded(
      rectangle<R>{hull(at_left, at_right), odd_in_y(w.im, size_x.lower, size_x.upper, height)}, z);
}

}  // namespace detail::rectangles

/// asin z, re in [-pi/2, pi/2]: the range of each part. asin(x) = pi/2 + i acosh(x) for x > 1.
template <class R>
[[nodiscard]] rectangle<R> asin(const rectangle<R>& z) {
  return detail::rectangles::inverse_sine(z, false);
}
/// acos z = pi/2 - asin z, re in [0, pi]: the range of each part.
template <class R>
[[nodiscard]] rectangle<R> acos(const rectangle<R>& z) {
  return conj(detail::rectangles::inverse_sine(z, true));
}
/// acosh z, re >= 0, im in (-pi, pi]: i acos z where im >= 0, -i acos z where im < 0.
template <class R>
[[nodiscard]] rectangle<R> acosh(const rectangle<R>& z) {
  namespace d = detail::rectangles;
  rectangle<R> w = d::inverse_sine(z, true);
  if (is_undefined(w)) return w;
  if (d::not_negative(z.im)) return {std::move(w.im), std::move(w.re)};
  if (certainly_negative(z.im)) return {-w.im, -w.re};
  // acos b over both sides; acosh a over both sides is even in y, and least at the least |y|,
  // which is 0.
  const rectangle<R> above = d::inverse_sine(rectangle<R>{z.re, abs(z.im)}, true);
  const d::ends<R> e(z.im);
  const auto side = [&](const R& end) {
    return d::inverse_sine(rectangle<R>{z.re, hull(d::integer(0, end), end)}, true).re;
  };
  return d::rounded(rectangle<R>{above.im, hull(-side(-e.lower), side(e.upper))}, z);
}
/// asinh z = -i asin(i z), im in [-pi/2, pi/2]: the range of each part.
template <class R>
[[nodiscard]] rectangle<R> asinh(const rectangle<R>& z) {
  namespace d = detail::rectangles;
  return d::divided_by_i(asin(d::times_i(z)));
}

namespace detail::rectangles {

/// Re atanh at a point x >= 0: log1p(4 x / ((1 - x)^2 + y^2)) / 4, with a small relative error.
// For x >= 2 as 4 / (x - 2 + (1 + y^2) / x), which does not overflow.
template <class R>
[[nodiscard]] R re_atanh(const R& x, const R& y) {
  const R one = integer(1, x);
  const R rest = x - scale(one, 1);
  const R ratio = certainly_positive(rest) ? integer(4, x) / (rest + (one + square(y)) / x)
                                           : scale(x, 2) / (square(x - one) + square(y));
  return scale(log1p(ratio), -2);
}
/// Im atanh at a point y >= 0: arg((1 - x)(1 + x) - y^2 + 2 i y) / 2.
// The difference cancels only where y^2 is near 1 - x^2 <= 1. There the argument is at least pi/4,
// and it changes by less than the difference's error, of the order of 2^-p y^2, divided by 2 y.
template <class R>
[[nodiscard]] R im_atanh(const R& x, const R& y) {
  const R one = integer(1, x);
  const R angle = argument((one - x) * (one + x) - square(y), scale(y, 1));
  if (!real_set<R>::is_undefined(angle)) return half(angle);
  return hull(integer(0, x), half(real_set<R>::pi(x)));  // an end at infinity
}

/// The range of Im atanh over x and y, y >= 0.
template <class R>
[[nodiscard]] R im_atanh_above(const R& x, const R& y) {
  const ends<R> ex(abs(x));
  const ends<R> ey(y);
  R r = hull(hull(im_atanh(ex.lower, ey.lower), im_atanh(ex.lower, ey.upper)),
             hull(im_atanh(ex.upper, ey.lower), im_atanh(ex.upper, ey.upper)));
  const R one = integer(1, x);
  if (!certainly_positive(ex.lower - one)) return r;
  const R place = sqrt((ex.lower - one) * (ex.lower + one));
  if (certainly_negative(place - ey.lower) || certainly_positive(place - ey.upper)) return r;
  return hull(r, half(half(real_set<R>::pi(x)) + atan(place)));
}

}  // namespace detail::rectangles

/// atanh z = (log(1 + z) - log(1 - z)) / 2, im in [-pi/2, pi/2]: the range of each part.
/// atanh(x) has im = pi/2 for |x| > 1. Undefined where z holds 1 or -1.
// With f' = 1 / (1 - z^2) = (1 - x^2 + y^2 + 2 i x y) / |1 - z^2|^2. Re is odd in x; for x > 0 it
// is decreasing in |y|, and increasing in x up to x = sqrt(1 + y^2), where it is log((x + 1)/(x -
// 1)) / 4 = log1p(2/(x - 1)) / 4. Im is odd in y and even in x; for y > 0 it is increasing in |x|,
// and in y it is increasing where |x| <= 1 and otherwise decreasing down to y = sqrt(x^2 - 1),
// where 1 - x^2 - y^2 = -2 y^2 and Im = (pi/2 + atan y) / 2. So its greatest value lies at the
// greatest |x| and an end of y, its least at the least |x| and such an end or that place.
template <class R>
[[nodiscard]] rectangle<R> atanh(const rectangle<R>& z) {
  namespace d = detail::rectangles;
  const rectangle<R> unit = real_set<R>::unit(z.re);
  if (is_undefined(z) || contains_zero(z - unit) || contains_zero(z + unit)) {
    return d::undefined_like(z);
  }
  if constexpr (real_set<R>::has_narrow) {
    if (d::is_narrow(z)) {
      const rectangle<R> m = d::midpoint(z);
      const R re = d::re_atanh(abs(m.re), m.im);
      const R im = d::im_atanh(m.re, abs(m.im));
      rectangle<R> value{certainly_negative(m.re) ? -re : re, certainly_negative(m.im) ? -im : im};
      const auto slope = [&] { return d::inverse(d::one_minus_square(z)); };
      if (d::spread(value, z, slope)) return value;
    }
  }
  const rectangle<R> w = d::raised(z, d::guard);
  const R one = d::integer(1, w.re);
  const auto re = [](const R& x, const R& y) { return d::re_atanh(x, y); };
  const auto place = [&](const R& y) { return sqrt(one + square(y)); };
  const auto peak = [&](const R& y) {
    const R x = sqrt(one + square(y));
    return scale(log1p(scale((x + one) / square(y), 1)), -2);  // x - 1 = y^2 / (x + 1)
  };
  rectangle<R> r = w;
  r.re = d::odd_with_peak(w.re, w.im, re, place, peak);
  if (d::not_negative(w.im)) {
    r.im = d::im_atanh_above(w.re, w.im);
  } else if (certainly_negative(w.im)) {
    r.im = -d::im_atanh_above(w.re, -w.im);
  } else {
    const d::ends<R> e(w.im);
    const R zero = d::integer(0, w.im);
    r.im = hull(-d::im_atanh_above(w.re, hull(zero, -e.lower)),
                d::im_atanh_above(w.re, hull(zero, e.upper)));
  }
  return d::rounded(r, z);
}

/// atan z = -i atanh(i z), re in [-pi/2, pi/2]: the range of each part. Undefined where z holds i
/// or -i.
template <class R>
[[nodiscard]] rectangle<R> atan(const rectangle<R>& z) {
  namespace d = detail::rectangles;
  return d::divided_by_i(atanh(d::times_i(z)));
}

// ---------------------------------------------------------------------------------------------
// Powers.

/// z^n; z^0 = 1 everywhere. Undefined where n < 0 and z holds 0.
/// Of a wide operand: the common part of repeated squaring and of |z|^n e^(i n arg z).
template <class R>
[[nodiscard]] rectangle<R> pow(const rectangle<R>& z, long n) {
  namespace d = detail::rectangles;
  if (is_undefined(z)) return d::undefined_like(z);
  if (n == 0) return real_set<R>::unit(z.re);
  if (n == 1) return z;
  if (n == 2) return square(z);
  if (n == -1) return reciprocal(z);
  if (n < 0 && contains_zero(z)) return d::undefined_like(z);
  const unsigned long size =
      n < 0 ? 0 - static_cast<unsigned long>(n) : static_cast<unsigned long>(n);
  // Roundings grow by a factor n, which the working precision has on top.
  long extra = d::guard;
  for (unsigned long rest = size; rest != 0; rest /= 2) ++extra;
  const auto power = [&](const rectangle<R>& w) {
    const rectangle<R> r = d::power_by_squarings(w, size);
    return n < 0 ? reciprocal(r) : r;
  };
  if constexpr (real_set<R>::has_narrow) {
    if (d::is_narrow(z)) {
      const rectangle<R> m{real_set<R>::middle(z.re), real_set<R>::middle(z.im)};
      rectangle<R> value = power(d::raised(m, extra));
      const auto slope = [&] {  // n z^(n-1)
        const rectangle<R> c = d::coarse(z);
        return n > 0 ? d::power_by_squarings(c, size - 1) * d::integer(n, c.re)
                     : d::inverse(d::power_by_squarings(c, size + 1)) * d::integer(n, c.re);
      };
      if (d::spread(value, z, slope)) return value;
    }
  }
  const rectangle<R> w = d::raised(z, extra);
  rectangle<R> r = power(w);
  if (!contains_zero(w)) {
    const R angle = d::argument(w.re, w.im) * d::integer(n, w.im);
    const R modulus = pow(hypot(w.re, w.im), n);
    const auto [sine, cosine] = real_set<R>::sin_cos(angle);
    const rectangle<R> polar{modulus * cosine, modulus * sine};
    r = is_undefined(r) ? polar
                        : rectangle<R>{intersection(r.re, polar.re), intersection(r.im, polar.im)};
  }
  return d::rounded(r, z);
}

/// z^w = exp(w log z); an exact integer w is taken as such, and 0^w = 0 for re w > 0. Undefined
/// where z holds 0 and something else.
template <class R>
[[nodiscard]] rectangle<R> pow(const rectangle<R>& z, const rectangle<R>& w) {
  namespace d = detail::rectangles;
  if (is_undefined(z) || is_undefined(w)) return d::undefined_like(z);
  long n = 0;
  if (real_set<R>::is_machine_integer(w.re, n) && real_set<R>::is_zero(w.im)) return pow(z, n);
  if (real_set<R>::is_zero(z.re) && real_set<R>::is_zero(z.im) && certainly_positive(w.re)) {
    return {d::integer(0, w.re), d::integer(0, w.im)};
  }
  if (contains_zero(z)) return d::undefined_like(z);
  // The bits of w log z before the point are lost to its last places in exp.
  const rectangle<R> size = d::coarse(w) * log(d::coarse(z));
  const long extra =
      std::max(real_set<R>::bits_before_point(size.re), real_set<R>::bits_before_point(size.im)) +
      d::guard;
  const rectangle<R> exponent = d::raised(w, extra) * log(d::raised(z, extra));
  return d::rounded(exp(exponent), z);
}

// ---------------------------------------------------------------------------------------------
// Analyticity.

/// possibly_singular::f(z) is false only where f is proved analytic on a neighbourhood of the
/// whole set z: neither a cut nor a branch point nor a pole of f touches it, not even with a
/// single common point. The functions without one (exp, sin, cos, sinh, cosh, z^n for n >= 0) are
/// analytic everywhere; abs, arg and conj nowhere. An undefined operand is possibly singular.
namespace possibly_singular {

template <class R>
[[nodiscard]] bool reciprocal(const rectangle<R>& z) {
  return is_undefined(z) || contains_zero(z);
}
/// z / w as a function of both.
template <class R>
[[nodiscard]] bool division(const rectangle<R>& z, const rectangle<R>& w) {
  return is_undefined(z) || possibly_singular::reciprocal(w);
}
/// The half line (-inf, 0].
template <class R>
[[nodiscard]] bool sqrt(const rectangle<R>& z) {
  return is_undefined(z) || (contains_zero(z.im) && !certainly_positive(z.re));
}
template <class R>
[[nodiscard]] bool log(const rectangle<R>& z) {
  return possibly_singular::sqrt(z);
}
template <class R>
[[nodiscard]] bool agm(const rectangle<R>& z) {
  return possibly_singular::sqrt(z);
}
template <class R>
[[nodiscard]] bool pow(const rectangle<R>& z, long n) {
  return is_undefined(z) || (n < 0 && contains_zero(z));
}
/// z^w as a function of both.
template <class R>
[[nodiscard]] bool pow(const rectangle<R>& z, const rectangle<R>& w) {
  return is_undefined(w) || possibly_singular::sqrt(z);
}
/// The half lines (-inf, -1] and [1, inf).
template <class R>
[[nodiscard]] bool asin(const rectangle<R>& z) {
  if (is_undefined(z)) return true;
  const R one = real_set<R>::integer(1, z.re);
  return contains_zero(z.im) && !(certainly_negative(z.re - one) && certainly_positive(z.re + one));
}
template <class R>
[[nodiscard]] bool acos(const rectangle<R>& z) {
  return possibly_singular::asin(z);
}
template <class R>
[[nodiscard]] bool atanh(const rectangle<R>& z) {
  return possibly_singular::asin(z);
}
/// The half line (-inf, 1].
template <class R>
[[nodiscard]] bool acosh(const rectangle<R>& z) {
  return is_undefined(z) ||
         (contains_zero(z.im) && !certainly_positive(z.re - real_set<R>::integer(1, z.re)));
}
/// The half lines i (-inf, -1] and i [1, inf).
template <class R>
[[nodiscard]] bool asinh(const rectangle<R>& z) {
  return possibly_singular::asin(detail::rectangles::times_i(z));
}
template <class R>
[[nodiscard]] bool atan(const rectangle<R>& z) {
  return possibly_singular::asinh(z);
}
/// The odd multiples of pi/2.
template <class R>
[[nodiscard]] bool tan(const rectangle<R>& z) {
  return is_undefined(z) || (contains_zero(z.im) && contains_zero(cos(z.re)));
}
template <class R>
[[nodiscard]] bool tanh(const rectangle<R>& z) {
  return possibly_singular::tan(detail::rectangles::times_i(z));
}

}  // namespace possibly_singular
}  // namespace polhode
