#pragma once

// Legendre's integrals in the complex plane.
//
// COMPLETE INTEGRALS. With r = sqrt(1-m), Re r > 0, k = (1-r)/(1+r), r' = 2 sqrt r/(1+r) = 2/(sqrt
// r + 1/sqrt r), Re r' > 0:
//   K(m) = 2 K(k^2)/(1+r),   D(m) = (K(k^2) + k D(k^2))/(1+r),   1 - k^2 = r'^2
// (J. Landen; DLMF 19.8.12-13; the second from K - E = m D). For |m| < 1, with a_n = (1/2)_n/n!,
//   K = (pi/2) sum of a_n^2 m^n,   D = (pi/2) sum over n >= 1 of a_n^2 2n/(2n-1) m^(n-1),
// with coefficients that are at most 1 and do not grow: what is left out from m^N on is at most 2
// |m|^N/(1-|m|).

#include <array>
#include <optional>

#include "carlson.hpp"

namespace polhode::detail::in_plane {

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

/// The integrals from 0 to phi with |Re phi| < pi/2 (F = s R_F(c^2, 1 - m s^2, 1) and so on, DLMF
/// 19.25(i)), those of the second and third kind where they are wanted. Hypothesis, checked: Re
/// (factor sqrt(1 - m s^2)) > 0.
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

/// Beyond, from the nearest multiple of pi by whole periods, or from the nearest odd multiple j
/// pi/2: with t = j pi/2 + theta, M = -m/(1-m) and N = -n/(1-n),
///   1 - m sin^2 t = (1-m)(1 - M sin^2 theta),  1 - n sin^2 t = (1-n)(1 - N sin^2 theta),  sin^2 t
///   = 1 - sin^2 theta.
/// Both forms are the same function where they meet: on the real line, where 1 - m sin^2 t runs on
/// the segment from 1 to 1 - m, its root is that of 1 - m times the other; and from there as far as
/// the product of these two has a positive real part, as is required, so that the derivatives
/// agree. Across a cut of one of the forms it has not.
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

}  // namespace polhode::detail::in_plane
