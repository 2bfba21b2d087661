#include "elliptic.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace polhode::checker {

// As p, A, g > 0 always |e| < 1: the Q at least halve, and what is left after Q_n is at most 2
// |Q_(n+1)| <= |Q_n|.
mean_and_sum bartky_sums(interval A, interval g) {
  const precision bits = A.bits();
  const long most_steps = 2 * bits;
  const integer close = 64;  // units, beyond which steps gain nothing
  interval p(rational(1), bits);
  interval Q = p;
  interval sum = p;
  for (long i = 0; i < most_steps; ++i) {
    const interval product = A * g;
    const interval p_squared = square(p);
    Q = (Q * ((p_squared - product) / (p_squared + product))) / 2;
    sum = sum + Q;
    p = (p_squared + product) / (p.scaled(1));
    const interval mean = (A + g) / 2;
    g = sqrt(product);
    A = mean;
    if ((A - g).magnitude() <= close + (A.high() - A.low()) + (g.high() - g.low()) &&
        Q.magnitude() <= close + (Q.high() - Q.low())) {
      break;
    }
  }
  // The mean lies between A and g at every step.
  return {hull(A, g), sum.widened(Q.magnitude())};
}

namespace {

interval number(const real& x, precision bits) { return x.at(bits); }

}  // namespace

// c_(n+1)^2 = (A_n - g_n)^2/4 = c_n^2 (A_n - g_n)/(4 (A_n + g_n)) in absolute value, for c_n^2 =
// A_n^2 - g_n^2: it is at most c_n^2/4. So the terms at least halve, and what is left is at most
// the last one taken. The mean lies between A and g at every step.
mean_and_sum agm_with_sum(const interval& A_0, const interval& g_0) {
  const precision bits = A_0.bits();
  const integer close = 64;
  interval A = A_0;
  interval g = g_0;
  interval sum(integer(0), integer(0), bits);
  for (long n = 1; n < 2 * bits; ++n) {
    const interval term = square((A - g) / 2).scaled(n - 1);
    sum = sum + term;
    // Beyond this distance a step gains nothing.
    if ((A - g).magnitude() <= close + (A.high() - A.low()) + (g.high() - g.low())) {
      return {hull(A, g), sum.widened(term.magnitude())};
    }
    const interval mean = (A + g) / 2;
    g = sqrt(A * g);
    A = mean;
  }
  throw undecided("the arithmetic-geometric mean does not settle at these bits");
}

// With v = (a + b u)/(a + b), m = 1 - u/v and r = b (1 + a)/(a + b),
//   -u sqrt(b (a+b) v) dG/du = B(m) + r (u/v) D(m),   D = (K - E)/m,  B = K - D
// (put y = sin s, tan s = sqrt(u) tan t in the paper's eq. (44): the integrand becomes cos^2 t
// (sigma^(-1/2) + r u sigma^(-3/2)) with sigma = v (1 - m sin^2 t), and the integral of cos^2
// t/Delta^3 is D(m), for d/dt (sin t cos t/Delta) = cos^2 t/Delta^3 - sin^2 t/Delta). K = pi/(2M),
// E = K (1 - sum over n >= 0 of 2^(n-1) c_n^2), with (A, g) = (1, sqrt(1-m)), c_0^2 = m (DLMF
// 19.8.5, 19.8.6): D = K (1/2 + sum/m).
interval half_phase_slope(const real& a, const real& b, const real& u, precision bits) {
  bits.work().rationals(20, bit_length(a) + bit_length(b) + bit_length(u));
  const precision w = bits + 32 + 6 * (bit_length(a) + bit_length(b) + bit_length(u));
  const real v((a + b * u) / (a + b));
  const real m(a * (1 - u) / (a + b * u));
  const real r(b * (1 + a) / (a + b));
  const mean_and_sum s = agm_with_sum(number(1, w), sqrt(number(u / v, w)));
  const interval K = pi(w) / s.mean.scaled(1);
  const interval half = number(rational(1, 2), w);
  // m = 0: K = pi/2, D = pi/4.
  const interval D = m == 0 ? K * half : K * (half + s.sum / number(m, w));
  const interval total = (K - D) + number(r * u / v, w) * D;
  const interval root = sqrt(number(b * (a + b) * v, w));
  return (-total / (number(u, w) * root)).with_bits(bits);
}

// With v = (a + b u)/(a + b), Carlson's forms (DLMF 19.22.1, 19.22.9: R_F(0, A^2, g^2) = pi/(2M),
// R_J(0, A^2, g^2, 1) = 3 pi/(4M) sum of Q) and x = 1 - (1-u) s, s in (0, 1), in the integral give
//   G(u) = pi/(sqrt(b (a+b)) M) (1 - b + (b/2)(1 - u) sum),  M and sum of (sqrt(v), sqrt(u)).
// For u = 1: M = 1, G = pi (1-b)/sqrt(b (a+b)) = pi I.
interval half_phase(const real& a, const real& b, const real& u, precision bits) {
  bits.work().rationals(20, bit_length(a) + bit_length(b) + bit_length(u));
  const precision w = bits + 16 + 2 * (bit_length(a) + bit_length(b) + bit_length(u));
  const mean_and_sum s = bartky_sums(sqrt(number((a + b * u) / (a + b), w)), sqrt(number(u, w)));
  const interval bracket = number(1 - b, w) + number(b * (1 - u) / 2, w) * s.sum;
  return (pi(w) * bracket / (sqrt(number(b * (a + b), w)) * s.mean)).with_bits(bits);
}

// In the same way, with (sqrt(a/(a+b)), sqrt(c/(b+c))):  F(c,0) = pi/(sqrt((a+b)(b+c)) M) (1 - b +
// (b/2) sum).
interval rotating_phase(const real& a, const real& b, const real& c, precision bits) {
  bits.work().rationals(20, bit_length(a) + bit_length(b) + bit_length(c));
  const precision w = bits + 16 + 2 * (bit_length(a) + bit_length(b) + bit_length(c));
  const mean_and_sum s = bartky_sums(sqrt(number(a / (a + b), w)), sqrt(number(c / (b + c), w)));
  const interval bracket = number(1 - b, w) + number(b / 2, w) * s.sum;
  return (pi(w) * bracket / (sqrt(number((a + b) * (b + c), w)) * s.mean)).with_bits(bits);
}

// 2 artanh(sqrt(a) w)/sqrt(ab) - 2 arctan(sqrt(b) w) with w^2 = (1-u)/(a + b u): its derivative is
// the integrand with the sign minus (steps of the claim separatrix_twist), and it is 0 at u = 1. 2
// artanh(z) = log((1+z)^2/(1 - z^2)), 1 - a w^2 = (a+b) u/(a + b u).
interval separatrix_phase(const real& a, const real& b, const interval& sine_squared,
                          const interval& cosine_squared) {
  const precision w = sine_squared.bits();
  w.work().rationals(4, bit_length(a) + bit_length(b));
  const interval denominator = number(a, w) + number(b, w) * sine_squared;
  const interval square_of_w = cosine_squared / denominator;
  const interval z = sqrt(number(a, w) * square_of_w);
  const interval rest = number(a + b, w) * sine_squared / denominator;
  const interval logarithm = log(square(number(1, w) + z) / rest);
  return logarithm / sqrt(number(a * b, w)) - atan(sqrt(number(b, w) * square_of_w)).scaled(1);
}

// ---------------------------------------------------------------------------------------------
// The incomplete integral, by Taylor series
//
// On a tile [m - r, m + r], with f(m + h) = c_0 + c_1 h + ... + c_(d-1) h^(d-1) + C h^d, d even,
// where C is a value of the coefficient of degree d at some point of the tile (Lagrange), the
// integral is 2 sum over even k < d of c_k r^(k+1)/(k+1) + 2 C' r^(d+1)/(d+1), C' in the range of
// the coefficient: h^d has one sign. Series are computed by recurrence, c_k at m and the range of C
// over the whole tile.

namespace {

constexpr std::size_t degree = 16;
using series = std::vector<interval>;  // degree + 1 coefficients

series operator*(const series& x, const series& y) {
  series result;
  result.reserve(x.size());
  for (std::size_t k = 0; k < x.size(); ++k) {
    interval sum = x[0] * y[k];
    for (std::size_t j = 1; j <= k; ++j) sum = sum + x[j] * y[k - j];
    result.push_back(sum);
  }
  return result;
}

series operator/(const series& x, const series& y) {
  series result;
  result.reserve(x.size());
  for (std::size_t k = 0; k < x.size(); ++k) {
    interval rest = x[k];
    for (std::size_t j = 1; j <= k; ++j) rest = rest - y[j] * result[k - j];
    result.push_back(rest / y[0]);
  }
  return result;
}

series root(const series& x) {
  series result{sqrt(x[0])};
  result.reserve(x.size());
  for (std::size_t k = 1; k < x.size(); ++k) {
    interval rest = x[k];
    for (std::size_t j = 1; j < k; ++j) rest = rest - result[j] * result[k - j];
    result.push_back(rest / result[0].scaled(1));
  }
  return result;
}

/// constant + factor * x.
series linear(const interval& constant, const interval& factor, series x) {
  for (interval& c : x) c = c * factor;
  x[0] = x[0] + constant;
  return x;
}

/// 1 - w sin^2 t = 1 - w/2 + (w/2) cos 2t around the t in [m - r, m + r].
series one_minus_sine_squared(const interval& w, const interval& m, const interval& r) {
  const sine_and_cosine at = sin_cos(m.scaled(1));
  // |cos 2t - cos 2m| <= 2r, and so for the sine.
  const integer spread = r.scaled(1).magnitude();
  const interval sine = at.sine.widened(spread);
  const interval cosine = at.cosine.widened(spread);
  const std::array<interval, 4> derivatives{cosine, -sine, -cosine, sine};
  series result;
  result.reserve(degree + 1);
  interval power = w / 2;  // (w/2) 2^k/k!
  for (std::size_t k = 0; k <= degree; ++k) {
    if (k > 0) power = power.scaled(1) / static_cast<long>(k);
    result.push_back(power * derivatives[k % 4]);
  }
  result[0] = result[0] + interval(rational(1), m.bits()) - w / 2;
  return result;
}

using integrand = std::function<series(const interval& m, const interval& r)>;

interval integral_on(const integrand& f, const interval& from, const interval& to, int depth) {
  constexpr int most_depth = 12;
  constexpr long wanted_bits = 56;
  const precision bits = from.bits();
  const interval m = (from + to) / 2;
  const interval r = (to - from) / 2;
  const interval zero(integer(0), integer(0), bits);
  try {
    const series remainder = f(m, r);
    interval power = r;
    for (std::size_t k = 0; k < degree; ++k) power = power * r;
    const interval rest = (remainder[degree] * power).scaled(1) / static_cast<long>(degree + 1);
    if (rest.high() - rest.low() <= integer(1) << static_cast<unsigned>(bits - wanted_bits)) {
      const series at = f(m, zero);
      interval sum = rest;
      interval odd_power = r;
      for (std::size_t k = 0; k < degree; k += 2) {
        sum = sum + (at[k] * odd_power).scaled(1) / static_cast<long>(k + 1);
        odd_power = odd_power * square(r);
      }
      return sum;
    }
  } catch (const undecided&) {
    if (depth >= most_depth) throw;  // else a shorter tile may do
  }
  if (depth >= most_depth) throw undecided("an integral needs more tiles than the checker takes");
  return integral_on(f, from, m, depth + 1) + integral_on(f, m, to, depth + 1);
}

}  // namespace

interval partial_phase(const real& a, const real& b, const real& c, const interval& psi) {
  const precision bits = psi.bits();
  const interval one = number(1, bits);
  const auto one_minus_bx = [&](const series& x) { return linear(one, number(-b, bits), x); };
  const auto a_plus_bx = [&](const series& x) {
    return linear(number(a, bits), number(b, bits), x);
  };
  const interval zero(integer(0), integer(0), bits);
  if (c > 0) {
    // x = cos^2 t: F = 2 integral from 0 to psi of (1 - b x)/sqrt((a + b x)(c + b x)) dt.
    const integrand f = [&](const interval& m, const interval& r) {
      const series x = one_minus_sine_squared(one, m, r);
      return one_minus_bx(x) / root(a_plus_bx(x) * linear(number(c, bits), number(b, bits), x));
    };
    return integral_on(f, zero, psi, 0).scaled(1);
  }
  // With sin t = sqrt(w) sin s, w = 1 + c/b, x = 1 - w sin^2 s: c + b x = b w cos^2 s and dt =
  // sqrt(w) cos s/sqrt(x) ds, so that F = (2/sqrt(b)) integral from 0 to sigma of (1 - b x)/sqrt(x
  // (a + b x)) ds, sin psi = sqrt(w) sin sigma.
  const interval w = number(1 + c / b, bits);
  const interval sine_squared = square(sin_cos(psi).sine) / w;
  const interval sigma = atan(sqrt(sine_squared / (one - sine_squared)));
  const integrand f = [&](const interval& m, const interval& r) {
    const series x = one_minus_sine_squared(w, m, r);
    return one_minus_bx(x) / root(x * a_plus_bx(x));
  };
  return (integral_on(f, zero, sigma, 0) / sqrt(number(b, bits))).scaled(1);
}

// ---------------------------------------------------------------------------------------------
// The trapezoidal rule
//
// |rule - integral| <= 2 pi M/(e^(2 n H) - 1) on the half circle: half of the bound 4 pi M/(e^(H N)
// - 1) for the N = 2n nodes of the circle (Trefethen and Weideman, SIAM Review 56 (2014), theorem
// 3.2), of which those on the other half give the same values.

periodic_integral periodic_trapezoid(const std::function<interval(const interval& cosine)>& g,
                                     long n, const rational& half_width, const rational& supremum,
                                     precision bits) {
  const interval step = pi(bits) / (2 * n);
  interval sum(integer(0), integer(0), bits);
  // The angles (2k+1) step with k = i block + j are sums of 2 i block step and (2j+1) step.
  const auto block = static_cast<long>(floor_root(integer(n))) + 1;
  std::vector<sine_and_cosine> fine;
  fine.reserve(static_cast<std::size_t>(block));
  for (long j = 0; j < block; ++j) fine.push_back(sin_cos(step * (2 * j + 1)));
  for (long k = 0; k < n; k += block) {
    const sine_and_cosine coarse = sin_cos(step * (2 * k));
    for (long j = 0; j < block && k + j < n; ++j) {
      const sine_and_cosine& f = fine[static_cast<std::size_t>(j)];
      sum = sum + g(coarse.cosine * f.cosine - coarse.sine * f.sine);
    }
  }
  const interval growth = exp(number(rational(2 * n * half_width), bits));
  const interval error = (pi(bits) * number(supremum, bits)).scaled(1) / (growth - number(1, bits));
  return {(sum * step.scaled(1)).widened(error.magnitude()), error};
}

strip_range range_on_strip(const rational& u, const rational& half_width, precision bits) {
  const interval e = exp(number(rational(half_width / 2), bits));
  const interval sinh = (e - number(1, bits) / e) / 2;
  const interval spread = number(rational(1 - u), bits) * square(sinh);
  return {number(u, bits) - spread, number(1, bits) + spread};
}

}  // namespace polhode::checker
