#pragma once

// Carlson's integrals in the complex plane.
//
// DUPLICATION. On the plane cut along (-oo, 0], where Re sqrt > 0,
//   R_F(x,y,z) = R_F((x+L)/4, (y+L)/4, (z+L)/4),  L = sqrt x sqrt y + sqrt y sqrt z + sqrt z sqrt
//   x:
// the integral of R_F is analytic in the cut plane, and x + L = (sqrt x + sqrt y)(sqrt x + sqrt z)
// is in it as a product of two numbers with Re > 0. For R_J with positive real parts
//   R_J(x,y,z,p) = R_J((x+L)/4, ..., (p+L)/4)/4 + (6/d) R_C(1, 1+e),   1+e = 2b/d,
//   d = (sqrt p + sqrt x)(sqrt p + sqrt y)(sqrt p + sqrt z) = a + b,  b = sqrt p (p + L)
// (carlson_core.hpp). There the roots are within 45 degrees of the real line, so that Re L > 0 and
// real parts stay positive, and u = sqrt x/sqrt p, v, w alike have Re > 0. With a/b =
// (u+v+w+uvw)/(1+uv+vw+wu) multiplying out gives
//   (1 + a/b)/(1 - a/b) = (1+u)(1+v)(1+w)/((1-u)(1-v)(1-w)),
// and |(1+t)/(1-t)| > 1 says the same as Re t > 0: so Re a/b > 0, and 1 + e = 2/(1 + a/b) is within
// 1 of 1, where R_C is analytic. With x = 0 all this holds but for |(1+u)/(1-u)| = 1.
//
// SERIES. With A the mean (p taken twice), X_i = 1 - x_i/A, and |X_i| <= s < 1: R_F(1-X_1, ...) is
// the power series of carlson_core.hpp, whose proof of convergence and of the rest is by absolute
// values, and R_F(A t) = A^(-1/2) R_F(t) (R_J: A^(-3/2)) for all t_i with |t_i - 1| <= s, where the
// disc of radius s |A| around A stays off (-oo, 0]: that says |arg A| + asin s < pi, so that A may
// turn from |A| to where it is, with A t_i in the cut plane.

#include <array>
#include <optional>
#include <vector>

#include "plane.hpp"

namespace polhode::detail::in_plane {

/// The sum of factor T_N/(2N + factor), N < terms: 2N T_N = -sum over j >= 2 of d_j (2N - j)
/// T_(N-j).
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
/// Steps that bring numbers together as far as `wanted` says: x + L >= x/4 + sqrt(x y) more than
/// halves the logarithm of the ratio of the greatest to the next in as many steps as it has
/// quaternary digits. For more the sets are too wide.
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

/// R_F with the roots of its arguments given: for these the formulas that tell where they lie may
/// be better.
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

/// R_C(1, w) for w = 1 + e within 1 of 1: the sum of (-e)^k/(2k+1), what is left out after n terms
/// being at most
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

}  // namespace polhode::detail::in_plane
