#include "polhode/elliptic/complex.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "polhode/arithmetic/boost_bridge.hpp"
#include "polhode/arithmetic/exact.hpp"

// Each function is an analytic one, made of operations that are checked to be analytic where they are taken, and equal to
// the real function at real arguments: so it is the continuation. What is to be shown is that the identities used
// hold between analytic functions on a connected set that has real positive points; they are known there.
//
// DUPLICATION. On the plane cut along (-oo, 0], where Re sqrt > 0,
//   R_F(x,y,z) = R_F((x+L)/4, (y+L)/4, (z+L)/4),  L = sqrt x sqrt y + sqrt y sqrt z + sqrt z sqrt x:
// the integral of R_F is analytic in the cut plane, and x + L = (sqrt x + sqrt y)(sqrt x + sqrt z) is in it as a product of
// two numbers with Re > 0. For R_J with positive real parts
//   R_J(x,y,z,p) = R_J((x+L)/4, ..., (p+L)/4)/4 + (6/d) R_C(1, 1+e),   1+e = 2b/d,
//   d = (sqrt p + sqrt x)(sqrt p + sqrt y)(sqrt p + sqrt z) = a + b,  b = sqrt p (p + L)
// (carlson_core.hpp). There the roots are within 45 degrees of the real line, so that Re L > 0 and real parts stay
// positive, and u = sqrt x/sqrt p, v, w alike have Re > 0. With a/b = (u+v+w+uvw)/(1+uv+vw+wu) multiplying out gives
//   (1 + a/b)/(1 - a/b) = (1+u)(1+v)(1+w)/((1-u)(1-v)(1-w)),
// and |(1+t)/(1-t)| > 1 says the same as Re t > 0: so Re a/b > 0, and 1 + e = 2/(1 + a/b) is within 1 of 1, where R_C
// is analytic. With x = 0 all this holds but for |(1+u)/(1-u)| = 1.
//
// SERIES. With A the mean (p taken twice), X_i = 1 - x_i/A, and |X_i| <= s < 1: R_F(1-X_1, ...) is the
// power series of carlson_core.hpp, whose proof of convergence and of the rest is by absolute values, and
// R_F(A t) = A^(-1/2) R_F(t) (R_J: A^(-3/2)) for all t_i with |t_i - 1| <= s, where the disc of radius s |A| around A stays
// off (-oo, 0]: that says |arg A| + asin s < pi, so that A may turn from |A| to where it is, with A t_i in the cut plane.
//
// COMPLETE INTEGRALS. With r = sqrt(1-m), Re r > 0, k = (1-r)/(1+r), r' = 2 sqrt r/(1+r) = 2/(sqrt r + 1/sqrt r), Re r' > 0:
//   K(m) = 2 K(k^2)/(1+r),   D(m) = (K(k^2) + k D(k^2))/(1+r),   1 - k^2 = r'^2
// (J. Landen; DLMF 19.8.12-13; the second from K - E = m D). For |m| < 1, with a_n = (1/2)_n/n!,
//   K = (pi/2) sum of a_n^2 m^n,   D = (pi/2) sum over n >= 1 of a_n^2 2n/(2n-1) m^(n-1),
// with coefficients that are at most 1 and do not grow: what is left out from m^N on is at most 2 |m|^N/(1-|m|).
//
// The rest are formulas on those, named where they stand.

namespace polhode {
namespace {

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
  return sign_of(set.re) == sign::zero && sign_of(set.im) == sign::zero;
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
magnitude power_up(const magnitude& x, long n) {
  magnitude result = magnitude::power_of_two(0);
  for (long k = 0; k < n; ++k) result = multiply_up(result, x);
  return result;
}
/// x^n/(1-x), or infinity.
magnitude geometric_rest(const magnitude& x, long n) {
  const magnitude one = magnitude::power_of_two(0);
  if (one <= x) return magnitude::infinity();
  return divide_up(power_up(x, n), subtract_down(one, x));
}
/// The square root with Re > 0; of exactly 0 it is 0.
template <class Z>
Z root_in_plane(const Z& z) {
  return is_zero(z) ? z : plane<Z>::root(z);
}

/// Whether a series in numbers of that size is to be used: it is small, or it does not shrink further.
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

/// The sum of factor T_N/(2N + factor), N < terms: 2N T_N = -sum over j >= 2 of d_j (2N - j) T_(N-j).
template <class Z>
Z symmetric_series(const std::vector<Z>& d, long factor, long terms, const Z& like) {
  std::vector<Z> t{plane<Z>::number(1, like), plane<Z>::number(0, like)};
  Z sum = t[0];
  for (long n = 2; n < terms; ++n) {
    Z next = plane<Z>::number(0, like);
    for (long j = 2; j < static_cast<long>(d.size()) + 2 && j <= n; ++j) {
      next -= d[static_cast<std::size_t>(j - 2)] * (2 * n - j) * t[static_cast<std::size_t>(n - j)];
    }
    t.push_back(next / (2 * n));
    sum += t.back() * rational(factor, 2 * n + factor);
  }
  return sum;
}

/// The number of terms for q bits, and log2 of how small the argument must be for it.
struct plan {
  explicit plan(precision q)
      : terms(4 + static_cast<long>(std::sqrt(1.5 * static_cast<double>(q)))),
        wanted(-(q / terms) - 1) {}
  long terms;
  std::int64_t wanted;
};
/// Steps that bring numbers together as far as `wanted` says: x + L >= x/4 + sqrt(x y) more than halves the logarithm of the
/// ratio of the greatest to the next in as many steps as it has quaternary digits. For more the sets are too wide.
template <class Z>
int most_steps(const std::vector<Z>& x, std::int64_t wanted) {
  std::vector<std::int64_t> sizes;
  for (const Z& argument : x) {
    const magnitude m = size(argument);
    if (!m.is_zero() && !m.is_infinite()) sizes.push_back(m.log2_floor());
  }
  if (sizes.empty()) return 0;
  const auto [least, greatest] = std::minmax_element(sizes.begin(), sizes.end());
  constexpr std::int64_t most = 100'000;
  return static_cast<int>(std::min(16 + (*greatest - *least) - wanted, most));
}

/// R_F with the roots of its arguments given: for these the formulas that tell where they lie may be better.
template <class Z>
Z rf_with_roots(std::array<Z, 3> x, std::array<Z, 3> root) {
  const plan p(plane<Z>::bits(x[0]));
  shrinking spread(p.wanted);
  const int steps = most_steps<Z>({x[0], x[1], x[2]}, p.wanted);
  // (A - x_i) 4^n, which stays the same.
  Z from_x = (x[1] + x[2] - 2 * x[0]) / 3;
  Z from_y = (x[0] + x[2] - 2 * x[1]) / 3;
  Z from_z = (x[0] + x[1] - 2 * x[2]) / 3;
  for (int n = 0; n < steps; ++n) {
    const Z mean = (x[0] + x[1] + x[2]) / 3;
    if (!is_known(mean)) break;
    const Z dx = from_x / mean;
    const Z dy = from_y / mean;
    const Z dz = from_z / mean;
    const magnitude greatest = max(max(size(dx), size(dy)), size(dz));
    if (spread.is_done(greatest)) {
      const Z disc = plane<Z>::enlarged(mean, multiply_up(greatest, size(mean)));
      if (!is_known(plane<Z>::root(disc))) break;
      const Z series = symmetric_series<Z>({dx * dy - dz * dz, -(dx * dy * dz)}, 1, p.terms, mean);
      return plane<Z>::enlarged(series, geometric_rest(greatest, p.terms)) / plane<Z>::root(mean);
    }
    if (n > 0) {
      for (std::size_t i = 0; i < 3; ++i) root[i] = plane<Z>::root(x[i]);
    }
    const Z lambda = root[0] * (root[1] + root[2]) + root[1] * root[2];
    for (Z& argument : x) argument = (argument + lambda) / 4;
    for (Z* difference : {&from_x, &from_y, &from_z}) *difference = *difference / 4;
  }
  return plane<Z>::failed(x[0]);
}

template <class Z>
bool one_zero_at_most(const Z& x, const Z& y, const Z& z) {
  return (is_zero(x) ? 1 : 0) + (is_zero(y) ? 1 : 0) + (is_zero(z) ? 1 : 0) <= 1;
}

template <class Z>
Z rf(const Z& x, const Z& y, const Z& z) {
  if (!one_zero_at_most(x, y, z)) return plane<Z>::failed(x);
  const std::array<Z, 3> roots{root_in_plane(x), root_in_plane(y), root_in_plane(z)};
  for (const Z& root : roots) {
    if (!is_known(root)) return root;
  }
  return rf_with_roots<Z>({x, y, z}, roots);
}

/// R_C(1, w) for w = 1 + e within 1 of 1: the sum of (-e)^k/(2k+1), what is left out after n terms being at most
/// |e|^n/(1-|e|), or R_F(1, w, w).
template <class Z>
Z rc_of_one(const Z& w, const Z& e) {
  const Z rest = -e;
  const magnitude size_of_rest = size(rest);
  if (!(size_of_rest <= magnitude::power_of_two(-2))) return rf(plane<Z>::number(1, w), w, w);
  const std::int64_t bits =
      size_of_rest.is_zero() ? 1000 : std::max<std::int64_t>(-size_of_rest.log2_floor() - 1, 1);
  const long terms = static_cast<long>(plane<Z>::bits(w) / bits) + 2;
  Z sum = plane<Z>::number(0, w);
  for (long k = terms - 1; k >= 0; --k) sum = sum * rest + rational(1, 2 * k + 1);
  return plane<Z>::enlarged(sum, geometric_rest(size_of_rest, terms));
}

template <class Z>
Z rj(std::array<Z, 3> x, Z p) {
  if (!is_right_of(p, 0) || !one_zero_at_most(x[0], x[1], x[2])) {
    return plane<Z>::failed(p);
  }
  for (const Z& argument : x) {
    if (!is_right_of(argument, 0) && !is_zero(argument)) return plane<Z>::failed(p);
  }
  const plan q(plane<Z>::bits(p));
  shrinking spread(q.wanted);
  Z sum = plane<Z>::number(0, p);
  Z power = plane<Z>::number(1, p);  // 4^(-n)
  // (A - x_i) 4^n and (p-x)(p-y)(p-z) 64^n, which stay the same.
  std::array<Z, 4> from{x[1] + x[2] + 2 * p - 4 * x[0], x[0] + x[2] + 2 * p - 4 * x[1],
                        x[0] + x[1] + 2 * p - 4 * x[2], x[0] + x[1] + x[2] - 3 * p};
  for (Z& difference : from) difference = difference / 5;
  Z product = (p - x[0]) * (p - x[1]) * (p - x[2]);
  const int steps = most_steps<Z>({x[0], x[1], x[2], p}, q.wanted);
  for (int n = 0; n < steps; ++n) {
    const Z mean = (x[0] + x[1] + x[2] + 2 * p) / 5;
    if (!is_right_of(mean, 0)) break;
    const Z dx = from[0] / mean;
    const Z dy = from[1] / mean;
    const Z dz = from[2] / mean;
    const Z dp = from[3] / mean;
    const magnitude greatest = max(max(size(dx), size(dy)), max(size(dz), size(dp)));
    if (spread.is_done(greatest)) {
      const Z e2 = dx * dy + (dx + dy) * dz;
      const Z e3 = dx * dy * dz;
      const Z pp = dp * dp;
      const Z series = symmetric_series<Z>(
          {e2 - 3 * pp, 2 * pp * dp - 2 * dp * e2 - e3, 2 * dp * e3 + pp * e2, -(pp * e3)}, 3,
          q.terms, mean);
      // (n+1) s^n/(1-s)^2, n terms
      const magnitude one = magnitude::power_of_two(0);
      const magnitude rest = divide_up(
          multiply_up(geometric_rest(greatest, q.terms),
                      magnitude::from_integer_up(static_cast<std::uint64_t>(q.terms) + 1)),
          subtract_down(one, greatest));
      return 6 * sum + plane<Z>::enlarged(series, rest) * power / (mean * plane<Z>::root(mean));
    }
    std::array<Z, 3> root;
    for (std::size_t i = 0; i < 3; ++i) root[i] = root_in_plane(x[i]);
    const Z rp = plane<Z>::root(p);
    const Z lambda = root[0] * (root[1] + root[2]) + root[1] * root[2];
    const Z d = (rp + root[0]) * (rp + root[1]) * (rp + root[2]);
    const Z rc = rc_of_one<Z>(2 * rp * (p + lambda) / d, product / square(d));
    if (!is_known(rc)) break;
    sum += rc * power / d;
    for (Z& argument : x) argument = (argument + lambda) / 4;
    p = (p + lambda) / 4;
    power = power / 4;
    product = product / 64;
    for (Z& difference : from) difference = difference / 4;
  }
  return plane<Z>::failed(p);
}

/// 2 R_G = z R_F - (x-z)(y-z) R_D/3 + sqrt x sqrt y/sqrt z (DLMF 19.21.10), z not 0.
template <class Z>
Z rg(Z x, Z y, Z z) {
  if (is_zero(z)) std::swap(y, z);
  if (!is_right_of(z, 0)) return plane<Z>::failed(z);
  const Z last = is_zero(x) || is_zero(y)
                     ? plane<Z>::number(0, z)
                     : Z(plane<Z>::root(x) * plane<Z>::root(y) / plane<Z>::root(z));
  return (z * rf(x, y, z) - (x - z) * (y - z) * rj<Z>({x, y, z}, z) / 3 + last) / 2;
}

// ---------------------------------------------------------------------------------------------
// Legendre's integrals.

template <class Z>
struct kinds {
  Z k, d;  // of the first kind; (first - second)/m
};

/// For Re r > 0: K and D of m = 1 - r^2.
template <class Z>
std::optional<kinds<Z>> complete_kinds(const Z& r) {
  constexpr long terms = 8;
  std::vector<Z> k;  // of the steps
  std::vector<Z> one_more;
  Z at = r;
  Z m = (1 - r) * (1 + r);
  shrinking size_of_m(-(plane<Z>::bits(r) / terms) - 1);
  while (!size_of_m.is_done(size(m))) {
    if (k.size() == 100 || !is_known(at) || !is_right_of(at, 0)) return std::nullopt;
    one_more.push_back(1 + at);
    k.push_back((1 - at) / one_more.back());
    m = square(k.back());
    at = 2 * plane<Z>::root(at) / one_more.back();
  }
  Z first = plane<Z>::number(0, r);
  Z second = first;
  rational a = 1;  // a_n^2
  Z power = plane<Z>::number(1, r);
  for (long n = 0; n < terms; ++n) {  // a_n^2 m^n, and the term of D with a_(n+1)^2 m^n
    first += power * a;
    a *= rational((2 * n + 1) * (2 * n + 1), (2 * n + 2) * (2 * n + 2));
    second += power * rational(a * rational(2 * n + 2, 2 * n + 1));
    power *= m;
  }
  const magnitude rest = scale(geometric_rest(size(m), terms), 1);
  const ball right = scale(pi(plane<Z>::bits(r) + 34), -1);
  first = plane<Z>::enlarged(first * right, rest);
  second = plane<Z>::enlarged(second * right, rest);
  for (std::size_t n = k.size(); n-- > 0;) {
    second = (first + k[n] * second) / one_more[n];
    first = 2 * first / one_more[n];
  }
  return kinds<Z>{first, second};
}
template <class Z>
kinds<Z> complete(const Z& m) {
  const Z r = plane<Z>::root(1 - m);
  if (!is_known(r)) {
    return {r, r};
  }
  const auto result = complete_kinds(r);
  const Z none = plane<Z>::failed(m);
  return result ? *result : kinds<Z>{none, none};
}

/// Pi = R_F(0, 1-m, 1) + (n/3) R_J(0, 1-m, 1, 1-n) (DLMF 19.25.2).
template <class Z>
Z complete_third(const Z& n, const Z& m) {
  const Z zero = plane<Z>::number(0, m);
  const Z one = plane<Z>::number(1, m);
  return rf<Z>(zero, 1 - m, one) + n * rj<Z>({zero, 1 - m, one}, 1 - n) / 3;
}

/// phi = centre + rest: a multiple j pi/2 of pi/2 and what is left.
template <class Z>
struct quarter {
  long j = 0;
  Z rest;
};
/// j even where |Re phi - j pi/2| is at most about 1.2, else odd.
template <class Z>
std::optional<quarter<Z>> quarter_of(const Z& phi) {
  if (!is_known(phi)) return std::nullopt;
  const double middle = plane<Z>::middle(phi);
  constexpr double most = 1e6;
  if (!(std::abs(middle) < most)) return std::nullopt;
  const double turns = std::nearbyint(middle / half_turn);
  quarter<Z> result{2 * static_cast<long>(turns), phi};
  constexpr double before_quarter = 1.1;
  const double offset = middle - turns * half_turn;
  if (std::abs(offset) > before_quarter) result.j += offset > 0 ? 1 : -1;
  if (result.j != 0) {
    result.rest = phi - scale(pi(plane<Z>::bits(phi) + 64), -1) * result.j;
  }
  return result;
}

/// The integrals from 0 to phi with |Re phi| < pi/2 (F = s R_F(c^2, 1 - m s^2, 1) and so on, DLMF 19.25(i)), those of
/// the second and third kind where they are wanted. Hypothesis, checked: Re (factor sqrt(1 - m s^2)) > 0.
template <class Z>
struct parts {
  Z f, d, pi;
};
template <class Z>
std::optional<parts<Z>> to_amplitude(const Z& phi, const Z& m, bool d_wanted, const Z* n,
                                     const Z& factor) {
  const Z s = sin(phi);
  const Z c = cos(phi);
  if (!is_right_of(c, 0)) return std::nullopt;  // |Re phi| < pi/2, or that and whole turns:
  constexpr double quarter_turn = 1.6;
  if (!(std::abs(plane<Z>::middle(phi)) < quarter_turn)) return std::nullopt;
  const Z cc = square(c);
  const Z ss = square(s);
  const Z Y = 1 - m * ss;
  const Z root = plane<Z>::root(Y);
  if (!is_right_of<Z>(factor * root, 0)) return std::nullopt;
  const Z one = plane<Z>::number(1, m);
  parts<Z> result{s * rf_with_roots<Z>({cc, Y, one}, {c, root, one}), one, one};
  const Z cube = s * ss / 3;
  if (d_wanted) result.d = cube * rj<Z>({cc, Y, one}, one);
  if (n != nullptr) result.pi = result.f + *n * cube * rj<Z>({cc, Y, one}, 1 - *n * ss);
  return result;
}

enum class integral { f, e, d, pi };

/// Beyond, from the nearest multiple of pi by whole periods, or from the nearest odd multiple j pi/2: with t = j pi/2 + theta,
/// M = -m/(1-m) and N = -n/(1-n),
///   1 - m sin^2 t = (1-m)(1 - M sin^2 theta),  1 - n sin^2 t = (1-n)(1 - N sin^2 theta),  sin^2 t = 1 - sin^2 theta.
/// Both forms are the same function where they meet: on the real line, where 1 - m sin^2 t runs on the segment from 1 to
/// 1 - m, its root is that of 1 - m times the other; and from there as far as the product of these two has a positive
/// real part, as is required, so that the derivatives agree. Across a cut of one of the forms it has not.
template <class Z>
Z incomplete(integral which, const Z* n, const Z& phi, const Z& m) {
  if (!is_known(m)) return m;
  if (!is_known(phi)) return phi;
  const auto place = quarter_of(phi);
  if (!place) return plane<Z>::failed(phi);
  const bool odd = place->j % 2 != 0;
  const bool d_wanted = which == integral::e || which == integral::d;
  Z result = plane<Z>::number(0, m);
  std::optional<parts<Z>> part;
  if (odd) {
    const Z m1 = 1 - m;
    Z root = plane<Z>::root(m1);
    if (!is_known(root)) return root;
    std::optional<Z> N;
    if (n != nullptr) {
      if (!is_left_of(*n, 1)) return plane<Z>::failed(m);
      N = -*n / (1 - *n);
    }
    part = to_amplitude<Z>(place->rest, -m / m1, d_wanted, N ? &*N : nullptr, root);
    if (part) {
      part->f = part->f / root;
      part->d = part->f - part->d / root;
      if (n != nullptr) part->pi = part->pi / ((1 - *n) * root);
    }
  } else {
    part = to_amplitude<Z>(place->rest, m, d_wanted, n, plane<Z>::number(1, m));
  }
  if (!part) return plane<Z>::failed(phi);
  if (place->j != 0) {
    if (which == integral::pi) {
      part->pi += place->j * complete_third(*n, m);
    } else {
      const kinds<Z> whole = complete(m);
      part->f += place->j * whole.k;
      part->d += place->j * whole.d;
    }
  }
  switch (which) {
    case integral::f:
      result = part->f;
      break;
    case integral::d:
      result = part->d;
      break;
    case integral::e:
      result = part->f - m * part->d;
      break;
    case integral::pi:
      result = part->pi;
      break;
  }
  return result;
}

// ---------------------------------------------------------------------------------------------
// Theta functions, and Jacobi's through them.

/// The sum of the definition, DLMF 20.2(i): with l = 2n+1 (theta_1, theta_2) or 2n, the terms are in size at most
/// b_l = 2 |q|^(l^2/4) e^(l |Im z|), times l in the derivative. b_(l+2)/b_l = |q|^(l+1) e^(2 |Im z|) falls; where it is at
/// most 1/6, the terms from l >= 1 on have ratios of at most (l+2)/l/6 <= 1/2, and their sum is at most twice the first.
template <class Z>
Z theta_series(int j, bool derivative, const Z& z, const Z& q) {
  if (j < 1 || j > 4) {
    throw std::invalid_argument("theta functions are numbered 1 to 4, not " + std::to_string(j));
  }
  const bool half = j <= 2;
  const Z quarter_power = half ? plane<Z>::root(plane<Z>::root(q)) : plane<Z>::number(1, q);
  if (!is_known(z) || !is_known(quarter_power)) return plane<Z>::failed(q);
  const magnitude size_of_q = size(q);
  if (!(size_of_q <= scale(magnitude::from_integer_up(63), -6))) return plane<Z>::failed(q);
  const magnitude growth = exp(abs(plane<Z>::set(z).im).with_precision(64)).magnitude_upper();
  const magnitude growth_of_two = multiply_up(growth, growth);
  const Z qq = square(q);
  Z power = 2 * quarter_power;  // 2 q^(l^2/4)
  Z ratio = half ? qq : q;      // q^(l+1)
  Z sum = plane<Z>::number(half || derivative ? 0 : 1, q);
  magnitude bound = multiply_up(size(power), half ? growth : magnitude::power_of_two(0));  // b_l
  magnitude greatest = half ? bound : magnitude::power_of_two(0);
  if (!half) {  // the term of l = 0 is there already
    bound = multiply_up(multiply_up(bound, size(ratio)), growth_of_two);
    power *= ratio;
    ratio *= qq;
    greatest = max(greatest, bound);
  }
  constexpr long most_terms = 400;
  for (long l = half ? 1 : 2; l < most_terms; l += 2) {
    const magnitude next_ratio = multiply_up(size(ratio), growth_of_two);
    const magnitude factor =
        magnitude::from_integer_up(derivative ? static_cast<std::uint64_t>(l) : 1);
    const magnitude first = multiply_up(bound, factor);
    const bool falls =
        next_ratio <= divide_up(magnitude::power_of_two(0), magnitude::from_integer_up(7));
    if (falls && l > 2 && first <= scale(greatest, -plane<Z>::bits(q))) {
      return plane<Z>::enlarged(sum, scale(first, 1));
    }
    if (first.is_infinite()) break;
    const long n = l / 2;
    const bool negative = (j == 1 || j == 4) && n % 2 != 0;
    const Z angle = z * l;
    // d sin(lz) = l cos(lz), d cos(lz) = -l sin(lz)
    const Z wave = (j == 1) != derivative ? sin(angle) : cos(angle);
    Z term = power * wave;
    if (derivative) term = term * (j == 1 ? l : -l);
    sum += negative ? -term : term;
    bound = multiply_up(bound, next_ratio);
    greatest = max(greatest, bound);
    power *= ratio;
    ratio *= qq;
  }
  return plane<Z>::failed(q);
}

/// K(m) and the nome.
template <class Z>
struct period {
  Z k, q;
};
template <class Z>
period<Z> period_of(const Z& m) {
  const Z k = complete(m).k;
  return {k, exp(complete(Z(1 - m)).k / k * -pi(plane<Z>::bits(m) + 34))};
}

/// What sn, cn, dn and 1 are proportional to at u: with k = sqrt m and k' = sqrt(1-m), z = pi u/(2K),
///   theta_1(z)/sqrt k, theta_2(z) sqrt(k'/k), theta_3(z) sqrt k', theta_4(z)      (DLMF 22.2.4-6 with 22.2.2);
/// the one of the letter s, c, d or n. For Re m < 0 and Re m > 1 by 22.17(i) and C. G. J. Jacobi's real transformation:
///   sn(u|m) = sd(r u|M)/r, cn = cd, dn = nd, r^2 = 1 - m, M = -m/(1-m);   k sn(u|m) = sn(k u|1/m), cn = dn, dn = cn, k^2 = m.
template <class Z>
class jacobi_parts {
 public:
  jacobi_parts(const Z& u, const Z& m) : sine_(plane<Z>::number(1, m)) {
    if (is_left_of(m, 0)) {
      const Z r = plane<Z>::root(1 - m);
      sine_ = 1 / r;
      letters_ = "scnd";
      prepare(r * u, -m / (1 - m));
    } else if (is_right_of(m, 1)) {
      const Z k = plane<Z>::root(m);
      sine_ = 1 / k;
      letters_ = "sdcn";
      prepare(k * u, 1 / m);
    } else {
      prepare(u, m);
    }
  }
  [[nodiscard]] Z operator()(char letter) const {
    const std::string_view names = "scdn";
    switch (letters_[names.find(letter)]) {
      case 's':
        return sine_ * theta_series(1, false, z_, q_) / root_k_;
      case 'c':
        return theta_series(2, false, z_, q_) * root_k1_ / root_k_;
      case 'd':
        return theta_series(3, false, z_, q_) * root_k1_;
      default:
        return theta_series(4, false, z_, q_);
    }
  }

 private:
  void prepare(const Z& u, const Z& m) {
    const period<Z> w = period_of(m);
    q_ = w.q;
    z_ = u / w.k * scale(pi(plane<Z>::bits(m) + 34), -1);
    root_k_ = plane<Z>::root(plane<Z>::root(m));
    root_k1_ = plane<Z>::root(plane<Z>::root(1 - m));
  }

  std::string_view letters_ = "scdn";  // of the transformed function
  Z sine_;                             // a factor of sn
  Z z_, q_, root_k_, root_k1_;
};

/// am u = z + 2 sum of q^n sin(2nz)/(n (1 + q^(2n))), z = pi u/(2K), for |q| e^(2 |Im z|) = x < 1 (DLMF 22.16.9): the terms
/// from n on are at most 2 x^n/(1 - |q|^2) together times 1/(1-x), as |sin 2nz| <= e^(2n |Im z|).
template <class Z>
Z amplitude(const Z& u, const Z& m) {
  if (!is_known(u)) return u;
  const auto [k, q] = period_of(m);
  if (!is_known(q)) return q;
  const Z z = u / k * scale(pi(plane<Z>::bits(m) + 34), -1);
  if (!is_known(z)) return plane<Z>::failed(m);
  const magnitude growth = exp(abs(plane<Z>::set(z).im).with_precision(64) * 2).magnitude_upper();
  const magnitude x = multiply_up(size(q), growth);
  const magnitude one = magnitude::power_of_two(0);
  if (!(x <= scale(magnitude::from_integer_up(31), -5))) return plane<Z>::failed(m);
  const magnitude all =
      divide_up(magnitude::power_of_two(1), subtract_down(one, multiply_up(size(q), size(q))));
  Z sum = z;
  Z power = q;
  const magnitude negligible = magnitude::power_of_two(-plane<Z>::bits(m));
  constexpr long most_terms = 2000;
  for (long n = 1; n < most_terms; ++n) {
    const magnitude rest = multiply_up(all, geometric_rest(x, n));
    if (rest <= negligible) return plane<Z>::enlarged(sum, rest);
    sum += 2 * power * sin(z * (2 * n)) / (n * (1 + square(power)));
    power *= q;
  }
  return plane<Z>::failed(m);
}

/// Where letters p and q stand in "scdn", as a place in a list of pairs.
std::size_t place_of(char p, char q) {
  const std::string_view letters = "scdn";
  const std::size_t first = letters.find(p);
  const std::size_t second = letters.find(q);
  if (first == std::string_view::npos || second == std::string_view::npos || p == q) {
    throw std::invalid_argument("Jacobi's functions have two of the letters s, c, d and n");
  }
  return 4 * first + second;
}
constexpr std::array<const char*, 16> names_of_jacobi = {
    "",         "jacobiSC", "jacobiSD", "jacobiSN", "jacobiCS", "",         "jacobiCD", "jacobiCN",
    "jacobiDS", "jacobiDC", "",         "jacobiDN", "jacobiNS", "jacobiNC", "jacobiND", ""};
constexpr std::array<const char*, 16> names_of_inverse = {
    "", "jacobiArcSC", "jacobiArcSD", "jacobiArcSN", "jacobiArcCS",
    "", "jacobiArcCD", "jacobiArcCN", "jacobiArcDS", "jacobiArcDC",
    "", "jacobiArcDN", "jacobiArcNS", "jacobiArcNC", "jacobiArcND",
    ""};

/// As in jacobi.cpp: R_F of three polynomials in x^2 times a square root, for Re x > 0 (the odd ones: anywhere), where the
/// roots of x^2 are x; 2K - u(-x) of cn, cs and cd for Re x < 0.
template <class Z>
Z inverse_function(char p, char q, const Z& x, const Z& m) {
  const bool odd = p == 's';
  const bool reflected = p == 'c';
  if (reflected && is_left_of(x, 0)) {
    return 2 * complete(m).k - inverse_function<Z>(p, q, -x, m);
  }
  if (!odd && !is_right_of(x, 0)) return plane<Z>::failed(x);
  const Z m1 = 1 - m;
  const Z xx = square(x);
  const Z one = plane<Z>::number(1, x);
  const auto below_one = [&] { return plane<Z>::root(1 - x) * plane<Z>::root(1 + x); };
  const auto above_one = [&] { return plane<Z>::root(x - 1) * plane<Z>::root(x + 1); };
  // Of the arguments of R_F two are m1 and m1 x^2, or m and m x^2. Where the product of x and the principal root of m1, or m,
  // is not the principal root of theirs, R_F is that of another branch, whose pq is -x.
  const auto has_root_beside = [&](const Z& parameter) {
    return is_right_of<Z>(x * plane<Z>::root(parameter), 0);
  };
  switch (place_of(p, q)) {
    case 1:  // sc
      return x * rf<Z>(one, 1 + m1 * xx, 1 + xx);
    case 2:  // sd
      return x * rf<Z>(1 - m1 * xx, one, 1 + m * xx);
    case 3:  // sn
      return x * rf<Z>(1 - xx, 1 - m * xx, one);
    case 4:  // cs
      return rf<Z>(xx, xx + m1, xx + 1);
    case 6:  // cd
      if (!has_root_beside(m1)) return plane<Z>::failed(x);
      return below_one() * rf<Z>(m1 * xx, m1, 1 - m * xx);
    case 7:  // cn
      return below_one() * rf<Z>(xx, m1 + m * xx, one);
    case 8:  // ds
      return rf<Z>(xx - m1, xx, xx + m);
    case 9:  // dc
      if (!has_root_beside(m1)) return plane<Z>::failed(x);
      return above_one() * rf<Z>(m1, m1 * xx, xx - m);
    case 11:  // dn
      if (!has_root_beside(m)) return plane<Z>::failed(x);
      return below_one() * rf<Z>(xx - m1, m * xx, m);
    case 12:  // ns
      return rf<Z>(xx - 1, xx - m, xx);
    case 13:  // nc
      return above_one() * rf<Z>(one, m + m1 * xx, xx);
    default:  // nd
      if (!has_root_beside(m)) return plane<Z>::failed(x);
      return above_one() * rf<Z>(1 - m1 * xx, m, m * xx);
  }
}

// ---------------------------------------------------------------------------------------------

/// f(x...), with its name on an obstacle. Over regions, where f is not available there but is at the middle, the set is too
/// wide, it or an enclosure made of it reaching a cut; smaller ones are of use.
template <class F>
complex_ball answered(const char*, const F& f, const std::same_as<complex_ball> auto&... x) {
  return f(x...);
}
template <class F>
region answered(const char* name, const F& f, const std::same_as<region> auto&... x) {
  region value = f(x...);
  if (value.is_analytic()) return value;
  for (const region* argument : {&x...}) {
    if (!argument->is_analytic()) return *argument;
  }
  const auto middle = [](const region& z) {
    return region(double_interval(z.re().midpoint()), double_interval(z.im().midpoint()));
  };
  const bool is_point = (... && (x.re().is_exact() && x.im().is_exact()));
  // A pole that sets of less than a double's last place do not get past is one of f's.
  const bool at_pole = value.why() == obstacle::pole && (... && !x.is_in_hardware());
  if (value.why() != obstacle::unknown && !at_pole) return region::blocked(value.why(), name);
  const bool smaller_would_do = !is_point && f(middle(x)...).is_analytic();
  return region::blocked(smaller_would_do ? obstacle::branch_cut : obstacle::unknown, name);
}

}  // namespace

#define POLHODE_COMPLEX_ELLIPTIC(Z)                                                              \
  Z carlson_rf(const Z& x, const Z& y, const Z& z) {                                             \
    return answered(                                                                             \
        "carlsonRF", [&](const Z& x_, const Z& y_, const Z& z_) -> Z { return rf(x_, y_, z_); }, \
        x, y, z);                                                                                \
  }                                                                                              \
  Z carlson_rc(const Z& x, const Z& y) {                                                         \
    return answered(                                                                             \
        "carlsonRC", [&](const Z& x_, const Z& y_) -> Z { return rf(x_, y_, y_); }, x, y);       \
  }                                                                                              \
  Z carlson_rj(const Z& x, const Z& y, const Z& z, const Z& p) {                                 \
    return answered(                                                                             \
        "carlsonRJ",                                                                             \
        [&](const Z& x_, const Z& y_, const Z& z_, const Z& p_) -> Z {                           \
          return rj<Z>({x_, y_, z_}, p_);                                                        \
        },                                                                                       \
        x, y, z, p);                                                                             \
  }                                                                                              \
  Z carlson_rd(const Z& x, const Z& y, const Z& z) {                                             \
    return answered(                                                                             \
        "carlsonRD",                                                                             \
        [&](const Z& x_, const Z& y_, const Z& z_) -> Z {                                        \
          return rj<Z>({x_, y_, z_}, z_);                                                        \
        },                                                                                       \
        x, y, z);                                                                                \
  }                                                                                              \
  Z carlson_rg(const Z& x, const Z& y, const Z& z) {                                             \
    return answered(                                                                             \
        "carlsonRG", [&](const Z& x_, const Z& y_, const Z& z_) -> Z { return rg(x_, y_, z_); }, \
        x, y, z);                                                                                \
  }                                                                                              \
  Z elliptic_k(const Z& m) {                                                                     \
    return answered(                                                                             \
        "ellipticK", [&](const Z& m_) -> Z { return complete(m_).k; }, m);                       \
  }                                                                                              \
  Z elliptic_d(const Z& m) {                                                                     \
    return answered(                                                                             \
        "ellipticD", [&](const Z& m_) -> Z { return complete(m_).d; }, m);                       \
  }                                                                                              \
  Z elliptic_e(const Z& m) {                                                                     \
    return answered(                                                                             \
        "ellipticE",                                                                             \
        [&](const Z& m_) -> Z {                                                                  \
          const kinds<Z> w = complete(m_);                                                       \
          return w.k - m_ * w.d;                                                                 \
        },                                                                                       \
        m);                                                                                      \
  }                                                                                              \
  Z elliptic_pi(const Z& n, const Z& m) {                                                        \
    return answered(                                                                             \
        "ellipticPi", [&](const Z& n_, const Z& m_) -> Z { return complete_third(n_, m_); }, n,  \
        m);                                                                                      \
  }                                                                                              \
  Z elliptic_f(const Z& phi, const Z& m) {                                                       \
    return answered(                                                                             \
        "ellipticF",                                                                             \
        [&](const Z& phi_, const Z& m_) -> Z {                                                   \
          return incomplete<Z>(integral::f, nullptr, phi_, m_);                                  \
        },                                                                                       \
        phi, m);                                                                                 \
  }                                                                                              \
  Z elliptic_e(const Z& phi, const Z& m) {                                                       \
    return answered(                                                                             \
        "ellipticE",                                                                             \
        [&](const Z& phi_, const Z& m_) -> Z {                                                   \
          return incomplete<Z>(integral::e, nullptr, phi_, m_);                                  \
        },                                                                                       \
        phi, m);                                                                                 \
  }                                                                                              \
  Z elliptic_d(const Z& phi, const Z& m) {                                                       \
    return answered(                                                                             \
        "ellipticD",                                                                             \
        [&](const Z& phi_, const Z& m_) -> Z {                                                   \
          return incomplete<Z>(integral::d, nullptr, phi_, m_);                                  \
        },                                                                                       \
        phi, m);                                                                                 \
  }                                                                                              \
  Z elliptic_pi(const Z& n, const Z& phi, const Z& m) {                                          \
    return answered(                                                                             \
        "ellipticPi",                                                                            \
        [&](const Z& n_, const Z& phi_, const Z& m_) -> Z {                                      \
          return incomplete<Z>(integral::pi, &n_, phi_, m_);                                     \
        },                                                                                       \
        n, phi, m);                                                                              \
  }                                                                                              \
  Z elliptic_nome(const Z& m) {                                                                  \
    return answered(                                                                             \
        "ellipticNome", [&](const Z& m_) -> Z { return period_of(m_).q; }, m);                   \
  }                                                                                              \
  Z theta_value(int j, const Z& z, const Z& q) {                                                 \
    return answered(                                                                             \
        "jacobiTheta",                                                                           \
        [&](const Z& z_, const Z& q_) -> Z { return theta_series(j, false, z_, q_); }, z, q);    \
  }                                                                                              \
  Z theta_derivative(int j, const Z& z, const Z& q) {                                            \
    return answered(                                                                             \
        "jacobiThetaPrime",                                                                      \
        [&](const Z& z_, const Z& q_) -> Z { return theta_series(j, true, z_, q_); }, z, q);     \
  }                                                                                              \
  Z jacobi_am(const Z& u, const Z& m) {                                                          \
    return answered(                                                                             \
        "jacobiAM", [&](const Z& u_, const Z& m_) -> Z { return amplitude(u_, m_); }, u, m);     \
  }                                                                                              \
  Z jacobi_quotient(char p, char q, const Z& u, const Z& m) {                                    \
    return answered(                                                                             \
        names_of_jacobi[place_of(p, q)],                                                         \
        [&](const Z& u_, const Z& m_) -> Z {                                                     \
          const jacobi_parts<Z> parts(u_, m_);                                                   \
          return parts(p) / parts(q);                                                            \
        },                                                                                       \
        u, m);                                                                                   \
  }                                                                                              \
  Z jacobi_inverse(char p, char q, const Z& x, const Z& m) {                                     \
    return answered(                                                                             \
        names_of_inverse[place_of(p, q)],                                                        \
        [&](const Z& x_, const Z& m_) -> Z { return inverse_function<Z>(p, q, x_, m_); }, x, m); \
  }
POLHODE_COMPLEX_ELLIPTIC(complex_ball)
POLHODE_COMPLEX_ELLIPTIC(region)
#undef POLHODE_COMPLEX_ELLIPTIC

}  // namespace polhode
