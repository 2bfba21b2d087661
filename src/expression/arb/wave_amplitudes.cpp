#include "polhode/expression/wave_amplitudes.hpp"

#include <algorithm>
#include <stdexcept>

#include "polhode/arithmetic/elementary.hpp"

#ifdef POLHODE_WITH_ARB
#include "arb_library.hpp"
#include "arb_numbers.hpp"
#endif

namespace polhode::detail {

namespace {

constexpr precision few_bits = 64;

}  // namespace

#ifdef POLHODE_WITH_ARB
namespace {

/// A magnitude as a number.
ball number_of(const magnitude& x) {
  return {upper_rational(ball(0, few_bits).enlarged(x)), few_bits};
}

/// e^w K(w), or e^w gamma(a, w) = U(1 - a, 1 - a, w) (DLMF 13.6.6), to p bits where that is
/// possible.
complex_ball scaled_value(const wave_function& f, const complex_ball& w, precision p) {
  const arb_number z(w);
  arb_number r;
  const precision most = 8 * p + 1024;
  for (precision working = p + 32; working <= most; working *= 2) {
    if (f.of == wave_function::family::bessel) {
      const arb_number nu{complex_ball(ball(f.order, working))};
      arb().acb_hypgeom_bessel_k_scaled(r.get(), nu.get(), z.get(), working);
    } else {
      const arb_number a{complex_ball(ball(rational(1 - f.order), working))};
      arb().acb_hypgeom_u(r.get(), a.get(), a.get(), z.get(), working);
    }
    if (r.accuracy() >= p || !w.is_exact()) break;
  }
  return r.to_complex_ball(p);
}

/// With S(w) for the scaled value, P - i Q = c S(-i z) and P + i Q = c' S(i z), c' the conjugate of
/// c.
///
/// H1(z) = 2/(pi i) e^(-i nu pi/2) K(-i z) for -pi/2 <= ph z <= pi, and H2(z) = -2/(pi i) e^(i nu
/// pi/2) K(i z) for -pi <= ph z <= pi/2 (DLMF 10.27.8): so c = 2/pi e^(-i (nu + 1) pi/2).
///
/// The integral of -i t^(a-1) e^(i t) over t > z is, with t = z + i s, e^(i z) times that of
/// (z + i s)^(a-1) e^-s over s > 0 (Jordan's lemma); and e^w gamma(a, w) is that of (w + s)^(a-1)
/// e^-s, where w + s = -i (z + i s) for w = -i z: so c = e^(-i (1 - a) pi/2).
wave_amplitudes<complex_ball> at_point(const wave_function& f, const complex_ball& z, precision p) {
  const bool is_bessel = f.of == wave_function::family::bessel;
  const rational turns = is_bessel ? rational(f.order + 1) : rational(1 - f.order);
  const ball angle = ball(turns, p) * pi(p) / 2;
  const ball size = is_bessel ? 2 / pi(p) : ball(1, p);
  const ball cosine = size * cos(angle);
  const ball sine = size * sin(angle);
  const complex_ball first = complex_ball(cosine, -sine) * scaled_value(f, {z.im, -z.re}, p);
  const complex_ball second = complex_ball(cosine, sine) * scaled_value(f, {-z.im, z.re}, p);
  const complex_ball sum = first + second;
  const complex_ball difference = second - first;  // 2 i Q
  wave_amplitudes<complex_ball> result{sum / 2, {difference.im / 2, -difference.re / 2}};
  if (sign_of(z.im) == certain_sign::zero) {
    result.p.im = ball(0, p);
    result.q.im = ball(0, p);
  }
  return result;
}

}  // namespace
#endif

namespace {

// For nu > -1/2 and |ph w| < pi (DLMF 10.32.8, with t = 1 + s/w and its path turned by phi, |phi| <
// pi/2, |phi - ph w| < pi: Cauchy's theorem),
//
//   sqrt(2 w/pi) e^w K(w) = 1/gamma(nu + 1/2) times the integral of e^-s s^(nu - 1/2)
//                           (1 + s/(2 w))^(nu - 1/2) over s = e^(i phi) x, x > 0.
//
// Let nu >= 0; K is even in it. Where |ph w| <= pi, phi can be chosen with |phi| <= pi/3 and
// |phi - ph w| <= 2 pi/3. Then |e^-s| <= e^(-x/2), and |1 + s/(2 w)| is at least sin(2 pi/3) > 3/4
// and at most 1 + x/(2 |w|). With x = 2 y the modulus is at most
//
//   2^(nu + 1/2)/gamma(nu + 1/2) times the integral of e^-y y^(nu - 1/2) f(y) over y > 0,
//
// where f is (3/4)^(-1/2) for nu < 1/2, and else (1 + y/|w|)^m with a whole m >= nu - 1/2: so it is
// 2^(nu + 1/2) times (4/3)^(1/2), or the sum of binomial(m, k) (nu + 1/2)_k |w|^-k over k <= m. P
// and Q are halves of sums of two such numbers times 2/pi sqrt(pi/(2 |z|)).
ball bound_of_hankel_amplitudes(const rational& order, const ball& least) {
  constexpr long most = 200;
  const rational nu = abs(order);
  const rational half(1, 2);
  if (!certainly_positive(least) || nu > most) return ball::undefined(few_bits);
  const ball first(rational(nu + half), few_bits);
  ball bound = sqrt(2 / pi(few_bits)) * pow(ball(2, few_bits), first);
  if (nu < half) return bound * sqrt(ball(rational(4, 3), few_bits));
  long m = 0;
  while (nu > m + half) ++m;
  ball term(1, few_bits);
  ball sum = term;
  for (long k = 0; k < m; ++k) {
    term = term * (m - k) * (first + k) / ((k + 1) * least);
    sum = sum + term;
  }
  return bound * sum;
}

// The integral of (w + s)^(a-1) e^-s over s > 0, a < 1 and |ph w| <= pi, turned in the same way: it
// is at most |w|^(a-1) (4/3)^(1-a) times that of e^(-x/2) over x > 0, which is 2. Less w^(a-1) it
// has (1 + s/w)^(a-1) - 1 in the place of a factor, which is at most (1 - a) |s/w| (4/3)^(2-a), as
// the points between 1 and 1 + s/w are at least 3/4 in size as well; and the integral of x e^(-x/2)
// is 4. Of c w^(a-1), which is z^(a-1), nothing is left in Q.
wave_amplitudes<amplitude_bound> bounds_of_integrals(const rational& a) {
  const ball share(rational(4, 3), few_bits);
  const rational e = 1 - a;
  const ball first = 2 * pow(share, ball(e, few_bits));
  const ball second = 4 * ball(e, few_bits) * pow(share, ball(rational(1 + e), few_bits));
  return {{first.magnitude_upper(), e}, {second.magnitude_upper(), rational(1 + e)}};
}

}  // namespace

ball amplitude_bound::beyond(const ball& least) const {
  return ball(0, few_bits).enlarged(factor) * pow(least, ball(rational(-exponent), few_bits));
}

wave_amplitudes<amplitude_bound> bounds_of_wave_amplitudes(const wave_function& f,
                                                           const ball& least) {
  if (f.of == wave_function::family::integral_of_power) return bounds_of_integrals(f.order);
  const ball most = bound_of_hankel_amplitudes(f.order, least);
  const amplitude_bound both{most.is_bounded() ? most.magnitude_upper() : magnitude::infinity(),
                             rational(1, 2)};
  return {both, both};
}

// Over a set Z the mean value theorem of arb_functions.cpp, with Cauchy's estimate of the slope: P
// and Q are analytic on the disc of radius rho < Re z about each z of Z, and bounded there, where
// numbers are at least |z| - rho.
wave_amplitudes<complex_ball> wave_amplitudes_at(const wave_function& f, const complex_ball& z) {
  const precision p = z.precision();
  wave_amplitudes<complex_ball> undefined{complex_ball::undefined(p), complex_ball::undefined(p)};
#ifdef POLHODE_WITH_ARB
  if (!z.is_bounded() || !certainly_positive(z.re)) return undefined;
  if (z.is_exact()) return at_point(f, z, p);
  const ball rho = number_of(z.re.magnitude_lower()) / 2;
  const ball least = number_of(z.magnitude_lower());
  const wave_amplitudes<amplitude_bound> near = bounds_of_wave_amplitudes(f, least - rho);
  const wave_amplitudes<amplitude_bound> bounds = bounds_of_wave_amplitudes(f, least);
  const magnitude radius = add_up(z.re.radius(), z.im.radius());
  const auto over = [&](const complex_ball& middle, const amplitude_bound& bound,
                        const amplitude_bound& beside) {
    const magnitude size = bound.beyond(least).magnitude_upper();
    const magnitude slope = (beside.beyond(least - rho) / rho).magnitude_upper();
    const magnitude error = multiply_up(radius, slope);
    const bool is_far = size <= error || !middle.is_bounded();
    complex_ball result = is_far ? complex_ball(0, p).enlarged(size) : middle.enlarged(error);
    if (sign_of(z.im) == certain_sign::zero) result.im = ball(0, p);
    return result;
  };
  const wave_amplitudes<complex_ball> middle = at_point(f, z.middle(), p);
  return {over(middle.p, bounds.p, near.p), over(middle.q, bounds.q, near.q)};
#else
  (void)f;
  return undefined;
#endif
}

wave_amplitudes<region> wave_amplitudes_at(const wave_function& f, const region& z) {
  const complex_ball set = z.to_complex_ball();
  const char* const name = "a function that oscillates";
  if (!set.is_bounded() || !certainly_positive(set.re)) {
    const region blocked = region::blocked(obstacle::branch_cut, name);
    return {blocked, blocked};
  }
  const wave_amplitudes<complex_ball> values = wave_amplitudes_at(f, set);
  const auto as_region = [&](const complex_ball& w) {
    if (!w.is_bounded()) return region::blocked(obstacle::undefined, name);
    return z.is_in_hardware() ? region(w) : region::in_balls(w);
  };
  return {as_region(values.p), as_region(values.q)};
}

}  // namespace polhode::detail
