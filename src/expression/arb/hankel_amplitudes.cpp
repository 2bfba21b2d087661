#include "polhode/expression/hankel_amplitudes.hpp"

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

/// e^w K(w) of a real order, to p bits where that is possible.
complex_ball scaled_k(const rational& order, const complex_ball& w, precision p) {
  const arb_number z(w);
  arb_number r;
  const precision most = 8 * p + 1024;
  for (precision working = p + 32; working <= most; working *= 2) {
    const arb_number nu{complex_ball(ball(order, working))};
    arb().acb_hypgeom_bessel_k_scaled(r.get(), nu.get(), z.get(), working);
    if (r.accuracy() >= p || !w.is_exact()) break;
  }
  return r.to_complex_ball(p);
}

/// H1(z) = 2/(pi i) e^(-i nu pi/2) K(-i z) for -pi/2 <= ph z <= pi, and H2(z) = -2/(pi i) e^(i nu
/// pi/2) K(i z) for -pi <= ph z <= pi/2 (DLMF 10.27.8). With the factors e^(-iz), e^(iz) taken
/// out, they are -i turn S and i/turn T of the scaled S and T below, times 2/pi.
hankel_amplitudes<complex_ball> at_point(const rational& order, const complex_ball& z,
                                         precision p) {
  const ball angle = ball(order, p) * pi(p) / 2;
  const complex_ball turn(cos(angle), -sin(angle));
  const complex_ball back(cos(angle), sin(angle));
  const complex_ball first = turn * scaled_k(order, {z.im, -z.re}, p);   // i e^(-iz) H1 pi/2
  const complex_ball second = back * scaled_k(order, {-z.im, z.re}, p);  // -i e^(iz) H2 pi/2
  // P - i Q = -i first 2/pi and P + i Q = i second 2/pi.
  const complex_ball difference = second - first;
  const complex_ball sum = first + second;
  hankel_amplitudes<complex_ball> result{{-difference.im / pi(p), difference.re / pi(p)},
                                         sum / pi(p)};
  if (sign_of(z.im) == certain_sign::zero) {
    result.p.im = ball(0, p);
    result.q.im = ball(0, p);
  }
  return result;
}

}  // namespace
#endif

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
magnitude bound_of_hankel_amplitudes(const rational& order, const ball& least) {
  constexpr long most = 200;
  const rational nu = abs(order);
  const rational half(1, 2);
  if (!certainly_positive(least) || nu > most) return magnitude::infinity();
  const ball first(rational(nu + half), few_bits);
  ball bound = sqrt(2 / pi(few_bits)) * pow(ball(2, few_bits), first);
  if (nu < half) return (bound * sqrt(ball(rational(4, 3), few_bits))).magnitude_upper();
  long m = 0;
  while (nu > m + half) ++m;
  ball term(1, few_bits);
  ball sum = term;
  for (long k = 0; k < m; ++k) {
    term = term * (m - k) * (first + k) / ((k + 1) * least);
    sum = sum + term;
  }
  return (bound * sum).magnitude_upper();
}

// Over a set Z the mean value theorem of arb_functions.cpp, with Cauchy's estimate of the slope: P
// and Q are analytic on the disc of radius rho < Re z about each z of Z, and bounded there, where
// numbers are at least |z| - rho.
hankel_amplitudes<complex_ball> hankel_amplitudes_at(const rational& order, const complex_ball& z) {
  const precision p = z.precision();
  hankel_amplitudes<complex_ball> undefined{complex_ball::undefined(p), complex_ball::undefined(p)};
#ifdef POLHODE_WITH_ARB
  if (!z.is_bounded() || !certainly_positive(z.re)) return undefined;
  if (z.is_exact()) return at_point(order, z, p);
  const ball rho = number_of(z.re.magnitude_lower()) / 2;
  const ball least = number_of(z.magnitude_lower());
  const auto bound_beyond = [&](const ball& distance) {
    return ball(0, few_bits).enlarged(bound_of_hankel_amplitudes(order, distance)) / sqrt(distance);
  };
  const magnitude size = bound_beyond(least).magnitude_upper();
  const magnitude slope = (bound_beyond(least - rho) / rho).magnitude_upper();
  const magnitude error = multiply_up(add_up(z.re.radius(), z.im.radius()), slope);
  hankel_amplitudes<complex_ball> result = at_point(order, z.middle(), p);
  for (complex_ball* one : {&result.p, &result.q}) {
    const bool is_far = size <= error || !one->is_bounded();
    *one = is_far ? complex_ball(0, p).enlarged(size) : one->enlarged(error);
    if (sign_of(z.im) == certain_sign::zero) one->im = ball(0, p);
  }
  return result;
#else
  (void)order;
  return undefined;
#endif
}

hankel_amplitudes<region> hankel_amplitudes_at(const rational& order, const region& z) {
  const complex_ball set = z.to_complex_ball();
  if (!set.is_bounded() || !certainly_positive(set.re)) {
    const region blocked = region::blocked(obstacle::branch_cut, "a Bessel function");
    return {blocked, blocked};
  }
  const hankel_amplitudes<complex_ball> values = hankel_amplitudes_at(order, set);
  const auto as_region = [&](const complex_ball& w) {
    if (!w.is_bounded()) return region::blocked(obstacle::undefined, "a Bessel function");
    return z.is_in_hardware() ? region(w) : region::in_balls(w);
  };
  return {as_region(values.p), as_region(values.q)};
}

}  // namespace polhode::detail
