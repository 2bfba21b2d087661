// The arithmetic-geometric mean of complex balls.

#include <algorithm>
#include <utility>

#include "arithmetic/ball/ball_access.hpp"
#include "polhode/arithmetic/complex_ball.hpp"

namespace polhode {

namespace {

// The ratio's logarithm halves with each step until it is of order 1 (63 steps at most in MPFR's
// range of exponents), then digits double.
constexpr int most_agm_steps = 140;

/// The square of half side m: it holds every number of size up to m.
complex_ball square_of_half_side(const magnitude& m, precision p) {
  const ball side = ball(0, p).enlarged(m);
  return {side, side};
}

bool is_exactly_zero(const complex_ball& z) {
  return sign_of(z.re) == certain_sign::zero && sign_of(z.im) == certain_sign::zero;
}

ball without_negatives(const ball& x) {
  if (real_set<ball>::not_negative(x) || x.is_undefined()) return x;
  return intersection(x, hull(ball(0, x.precision()), abs(x)));
}

/// The mean of members a, b with arguments in [-pi/2, pi/2] that differ by less than pi. Then the
/// root of a b whose argument is half the sum of theirs, sqrt(a) sqrt(b), lies with (a + b) / 2 in
/// the convex cone between a and b, at its half angle: the two differ in argument by less than
/// pi/2, which makes it the right choice, and the hypothesis holds for the next pair. It is the
/// principal root of a b.
///
/// The error. For right choices, with roots so taken that b_{n+1} = sqrt(a_n) sqrt(b_n):
///     a_{n+1} - b_{n+1} = (sqrt a_n - sqrt b_n)^2 / 2,
///     a_{n+1} + b_{n+1} = (sqrt a_n + sqrt b_n)^2 / 2,
/// and the right choice says |sqrt a_n - sqrt b_n| <= |sqrt a_n + sqrt b_n|. So
///   (1) |a_{n+1} - b_{n+1}| <= |a_n - b_n| / 2 (Cox 1984, section 2), and as
///       |a_{n+1} - a_n| = |a_n - b_n| / 2, |M - a_n| <= |a_n - b_n|;
///   (2) |sqrt a_n + sqrt b_n|^2 >= |a_n| + |b_n| (the parallelogram law), hence
///       |M - a_{n+1}| <= |a_{n+1} - b_{n+1}| = |a_n - b_n|^2 / (2 |sqrt a_n + sqrt b_n|^2)
///                     <= |a_n - b_n|^2 / (2 (|a_n| + |b_n|));
///   (3) |M| <= max(|a_n|, |b_n|), as that maximum does not increase.
complex_ball mean_in_right_half_plane(complex_ball a, complex_ball b, precision p) {
  if (is_exactly_zero(a) || is_exactly_zero(b)) return {0, a.precision()};
  magnitude last = magnitude::infinity();
  for (int step = 0;; ++step) {
    a.re = without_negatives(a.re);
    b.re = without_negatives(b.re);
    const magnitude distance = (a - b).magnitude_upper();
    const magnitude size = add_down(a.magnitude_lower(), b.magnitude_lower());
    const magnitude error =
        divide_up(scale(multiply_up(distance, distance), -1), size);  // infinite for size 0
    const bool is_last = error <= scale(size, -(std::int64_t{p} + 1));
    // Where the distance of the sets hardly falls any more, it is that of members of wide sets.
    const bool stalls = scale(distance, 4) >= multiply_up(last, magnitude::from_integer_up(15));
    const complex_ball next = scale(a + b, -1);
    if (is_last || stalls || step == most_agm_steps) {
      complex_ball r =
          square_of_half_side(max(a.magnitude_upper(), b.magnitude_upper()), a.precision());
      const complex_ball by_distance = a.enlarged(distance);
      if (!distance.is_infinite()) r = intersection(r, by_distance);
      if (!error.is_infinite()) r = intersection(r, next.enlarged(error));
      return r;
    }
    last = distance;
    const complex_ball product = a * b;
    b = possibly_singular::sqrt(product) ? sqrt(a) * sqrt(b) : sqrt(product);
    a = next;
  }
}

/// agm(z) for im z >= 0, as a limit from above where im z = 0.
complex_ball agm_above(const complex_ball& z, precision p) {
  const complex_ball one(1, z.precision());
  if (real_set<ball>::not_negative(z.re)) return mean_in_right_half_plane(one, z, p);
  // After one step, with the root in the closed first quadrant: it is the right choice, or the
  // limit of it, since sqrt(z) / ((1 + z) / 2) = 2 / (s + 1/s) with s = sqrt(z), re s > 0 off the
  // cut. Both means lie in the closed upper half plane, and the geometric one on its edge only for
  // z >= 0; times -i they satisfy the hypothesis.
  const complex_ball arithmetic = scale(one + z, -1);
  const complex_ball geometric = sqrt(z);
  const auto turned = [](const complex_ball& w) { return complex_ball(w.im, -w.re); };
  return times_i(mean_in_right_half_plane(turned(arithmetic), turned(geometric), p));
}

}  // namespace

complex_ball agm(const complex_ball& z) {
  const precision p = z.precision();
  if (z.is_undefined()) return z;
  if (real_set<ball>::is_zero(z.im) && real_set<ball>::not_negative(z.re)) {
    return complex_ball(agm(ball(1, p), z.re));
  }
  // Each of some log2(p) + 70 steps adds a few roundings.
  const complex_ball w = z.with_precision(p + 12);
  if (certainly_positive(w.re)) {
    return mean_in_right_half_plane(complex_ball(1, w.precision()), w, p + 4).with_precision(p);
  }
  if (real_set<ball>::not_negative(w.im)) return agm_above(w, p + 4).with_precision(p);
  if (certainly_negative(w.im)) return conj(agm_above(conj(w), p + 4)).with_precision(p);
  const ball zero(0, w.precision());
  const complex_ball above(w.re, hull(zero, real_set<ball>::upper_end(w.im)));
  const complex_ball below(w.re, hull(zero, -real_set<ball>::lower_end(w.im)));
  return hull(agm_above(above, p + 4), conj(agm_above(below, p + 4))).with_precision(p);
}

complex_ball agm(const complex_ball& z, const complex_ball& w) {
  const precision p = std::max(z.precision(), w.precision());
  if (z.is_undefined() || w.is_undefined()) return complex_ball::undefined(p);
  if (is_exactly_zero(z) || is_exactly_zero(w)) return {0, p};
  const complex_ball a = z.with_precision(p + 8);
  const complex_ball b = w.with_precision(p + 8);
  if (!contains_zero(a)) return (a * agm(b / a)).with_precision(p);
  // The limit for im(w / z) from above is that for im(z / w) from below.
  if (!contains_zero(b)) return (b * conj(agm(conj(a / b)))).with_precision(p);
  return square_of_half_side(max(a.magnitude_upper(), b.magnitude_upper()), p);
}

}  // namespace polhode
