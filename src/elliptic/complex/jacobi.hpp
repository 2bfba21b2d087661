#pragma once

// Jacobi's elliptic functions of complex arguments, by theta functions, and their inverses, by
// Carlson's R_F.

#include <array>
#include <optional>
#include <string_view>

#include "carlson.hpp"
#include "legendre.hpp"
#include "theta.hpp"

namespace polhode::detail::in_plane {

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

/// What sn, cn, dn and 1 are proportional to at u: with k = sqrt m and k' = sqrt(1-m), z = pi
/// u/(2K),
///   theta_1(z)/sqrt k, theta_2(z) sqrt(k'/k), theta_3(z) sqrt k', theta_4(z)
///     (DLMF 22.2.4-6 with 22.2.2);
/// the one of the letter s, c, d or n. For Re m < 0 and Re m > 1 by 22.17(i) and C. G. J. Jacobi's
/// real transformation:
///   sn(u|m) = sd(r u|M)/r, cn = cd, dn = nd, r^2 = 1 - m, M = -m/(1-m);
///     k sn(u|m) = sn(k u|1/m), cn = dn, dn = cn, k^2 = m.
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

/// am u = z + 2 sum of q^n sin(2nz)/(n (1 + q^(2n))), z = pi u/(2K), for |q| e^(2 |Im z|) = x < 1
/// (DLMF 22.16.9): the terms from n on are at most 2 x^n/(1 - |q|^2) together times 1/(1-x), as
/// |sin 2nz| <= e^(2n |Im z|).
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
inline std::size_t place_of(char p, char q) {
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

/// As in jacobi.cpp: R_F of three polynomials in x^2 times a square root, for Re x > 0 (the odd
/// ones: anywhere), where the roots of x^2 are x; 2K - u(-x) of cn, cs and cd for Re x < 0.
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
  // Of the arguments of R_F two are m1 and m1 x^2, or m and m x^2. Where the product of x and the
  // principal root of m1, or m, is not the principal root of theirs, R_F is that of another branch,
  // whose pq is -x.
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

}  // namespace polhode::detail::in_plane
