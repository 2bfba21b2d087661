#pragma once

// Clenshaw and Curtis's rule and Fejer's first: integrate the polynomial that agrees with f at
// Chebyshev's points. The first has the ends among its nodes, and those of 2n among them those of
// n. What they leave out: clenshaw_curtis_error and fejer_error (error_bounds.hpp).
//
// THE WEIGHTS are sums of cosines, Fourier sums of rational numbers (J. Waldvogel, BIT 46 (2006),
// has them so). Let p = sum of A_k cos(k t) be that polynomial at x = cos t; its integral is the
// sum of 2 A_k/(1 - k^2) over even k.
//
// With the nodes cos(j pi/n), j = 0 ... n: A_k = (2/n) (the sum of f_j cos(j k pi/n) with the terms
// j = 0 and n halved), and A_0 and A_n half of that. So with c_j = 1 for j = 0 and n, else 2, and k
// = 2m,
//   w_j = (c_j/n) sum over 0 <= m <= n/2 of b_m/(1 - 4m^2) cos(2 pi m j/n),  b_m = 1 for m = 0 and
//   n/2, else 2,
//       = (c_j/n) sum over 0 <= m < n of e^(2 pi i m j/n)/(1 - 4 min(m, n-m)^2),
// the terms m and n - m of which are conjugate.
//
// With the nodes cos((2j+1) pi/(2n)), j = 0 ... n-1: A_k = (2/n) sum of f_j cos(k (2j+1) pi/(2n)),
// A_0 half of that:
//   w_j = (2/n) Re sum over 0 <= m < n/2 of b_m/(1 - 4m^2) e^(pi i m/n) e^(2 pi i m j/n),  b_0 = 1,
//   else 2.

#include <stdexcept>
#include <utility>
#include <vector>

#include "polhode/quadrature/periodic_trapezoid.hpp"
#include "polhode/quadrature/rule_sum.hpp"

namespace polhode {

namespace detail {

template <scalar T>
struct complex_scalar {
  T re;
  T im;
};

/// The sums of v_m e^(2 pi i m j/n), j = 0 ... n-1, for n = v.size() >= 1. roots holds e^(2 pi i
/// j/n). In n (q_1 + q_2 + ...) multiplications, n = q_1 q_2 ... with primes q: by the sums over
/// each residue of m modulo a q.
template <scalar T>
[[nodiscard]] std::vector<complex_scalar<T>> fourier_sums(const std::vector<complex_scalar<T>>& v,
                                                          const circle_powers<T>& roots) {
  const std::size_t n = v.size();
  if (n == 1) return v;
  std::size_t q = 2;
  while (n % q != 0) q = q * q > n ? n : q + 1;
  const std::size_t part = n / q;
  const std::size_t stride = roots.cosines.size() / n;
  std::vector<std::vector<complex_scalar<T>>> sums;
  for (std::size_t r = 0; r < q; ++r) {
    std::vector<complex_scalar<T>> every;
    every.reserve(part);
    for (std::size_t m = r; m < n; m += q) every.push_back(v[m]);
    sums.push_back(fourier_sums(every, roots));
  }
  // With m = q m' + r the sum is that of e^(2 pi i r j/n) times the r-th part's sum at j.
  std::vector<complex_scalar<T>> result;
  result.reserve(n);
  for (std::size_t j = 0; j < n; ++j) {
    complex_scalar<T> sum = sums[0][j % part];
    for (std::size_t r = 1; r < q; ++r) {
      const complex_scalar<T>& s = sums[r][j % part];
      const T& c = roots.cosines[r * j % n * stride];
      const T& d = roots.sines[r * j % n * stride];
      accumulate(sum.re, c, s.re);
      accumulate(sum.re, T(-d), s.im);
      accumulate(sum.im, c, s.im);
      accumulate(sum.im, d, s.re);
    }
    result.push_back(std::move(sum));
  }
  return result;
}

/// {e^(i a j), j = 0 ... count-1} for a = pi/divisor.
template <scalar T>
[[nodiscard]] circle_powers<T> powers_of_angle(long divisor, long count, precision p) {
  const auto [sine, cosine] = sin_cos(T(scalar_pi<T>(p) / divisor));
  return {cosine, sine, count, p};
}

}  // namespace detail

/// A rule on [-1, 1] with the nodes from 1 downwards, with p bits.
template <scalar T>
struct chebyshev_points_rule {
  std::vector<T> nodes;
  std::vector<T> weights;
};

/// Clenshaw and Curtis's rule with the n + 1 nodes cos(j pi/n). Fast where n has small prime
/// factors. Throws std::invalid_argument for n < 1.
template <scalar T>
[[nodiscard]] chebyshev_points_rule<T> clenshaw_curtis_rule(long n, precision p) {
  if (n < 1) throw std::invalid_argument("clenshaw_curtis_rule: at least n = 1 is needed");
  const auto all = detail::powers_of_angle<T>(n, 2 * n, p);
  detail::circle_powers<T> roots(all.cosines[0], all.sines[0], 0, p);
  std::vector<detail::complex_scalar<T>> v;
  for (long m = 0; m < n; ++m) {
    const auto j = static_cast<std::size_t>(m);
    roots.cosines.push_back(all.cosines[2 * j]);
    roots.sines.push_back(all.sines[2 * j]);
    const long k = std::min(m, n - m);
    v.push_back({scalar_from<T>(rational(1, 1 - 4 * k * k), p), scalar_from<T>(0, p)});
  }
  const auto sums = detail::fourier_sums(v, roots);
  chebyshev_points_rule<T> rule;
  for (long k = 0; k <= n; ++k) {
    const auto j = static_cast<std::size_t>(k);
    rule.nodes.push_back(k == n ? scalar_from<T>(-1, p) : all.cosines[j]);
    const T& sum = sums[j % static_cast<std::size_t>(n)].re;
    rule.weights.push_back(T(k == 0 || k == n ? T(sum / n) : T(2 * sum / n)));
  }
  if (n % 2 == 0) rule.nodes[static_cast<std::size_t>(n / 2)] = scalar_from<T>(0, p);
  return rule;
}

/// Fejer's first rule, with the n nodes cos((2j+1) pi/(2n)). Otherwise as above.
template <scalar T>
[[nodiscard]] chebyshev_points_rule<T> fejer_rule(long n, precision p) {
  if (n < 1) throw std::invalid_argument("fejer_rule: at least 1 node is needed");
  const auto all = detail::powers_of_angle<T>(2 * n, 4 * n, p);
  detail::circle_powers<T> roots(all.cosines[0], all.sines[0], 0, p);
  std::vector<detail::complex_scalar<T>> v;
  for (long m = 0; m < n; ++m) {
    const auto j = static_cast<std::size_t>(m);
    roots.cosines.push_back(all.cosines[4 * j]);
    roots.sines.push_back(all.sines[4 * j]);
    const rational u = 2 * m < n ? rational(m == 0 ? 1 : 2, 1 - 4 * m * m) : rational(0);
    const T factor = scalar_from<T>(u, p);
    v.push_back({T(factor * all.cosines[2 * j]), T(factor * all.sines[2 * j])});
  }
  const auto sums = detail::fourier_sums(v, roots);
  chebyshev_points_rule<T> rule;
  for (long k = 0; k < n; ++k) {
    const auto j = static_cast<std::size_t>(k);
    rule.nodes.push_back(2 * k + 1 == n ? scalar_from<T>(0, p) : all.cosines[2 * j + 1]);
    rule.weights.push_back(T(2 * sums[j].re / n));
  }
  return rule;
}

/// The nodes >= 0 of one of these rules, with p bits.
[[nodiscard]] inline symmetric_nodes symmetric_half(chebyshev_points_rule<ball> rule, precision p) {
  symmetric_nodes half;
  half.n = static_cast<long>(rule.nodes.size());
  half.bits = p;
  for (std::size_t k = (rule.nodes.size() + 1) / 2; k-- > 0;) {
    half.nodes.push_back(std::move(rule.nodes[k]));
    half.weights.push_back(std::move(rule.weights[k]));
  }
  return half;
}

/// The sum of w_j f(x_j): with T = ball an enclosure of the rule's value, with T = mpfr_float the
/// uncertified value. It calls f once a node.
template <scalar T, class F>
requires function_on<F, T>
[[nodiscard]] T chebyshev_points_sum(const F& f, const chebyshev_points_rule<T>& rule) {
  T sum(rule.weights[0] * f(rule.nodes[0]));
  for (std::size_t j = 1; j < rule.nodes.size(); ++j) {
    detail::accumulate(sum, rule.weights[j], f(rule.nodes[j]));
  }
  return sum;
}

}  // namespace polhode
