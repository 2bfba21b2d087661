#pragma once

// Gauss and Chebyshev's rules, for integrals over [-1, 1] with the weight 1/sqrt(1 - x^2) (the
// first kind) or sqrt(1 - x^2) (the second). Nodes and weights are cosines, in closed form. What
// they leave out: gauss_chebyshev_error and gauss_chebyshev_second_error (error_bounds.hpp).

#include <stdexcept>

#include "polhode/quadrature/periodic_trapezoid.hpp"
#include "polhode/quadrature/rule_sum.hpp"

namespace polhode {

namespace detail {

/// f as an integrand of periodic_trapezoid.hpp.
template <class F>
struct function_of_cosine {
  const F& f;
  template <scalar T>
  [[nodiscard]] auto evaluator(precision) const {
    return [&g = f](const T& x) -> T { return g(x); };
  }
};

}  // namespace detail

/// (pi/n) times the sum of f(cos((2j+1) pi/(2n))), j = 0 ... n-1, with p bits: about the integral
/// of f(x)/sqrt(1 - x^2) over [-1, 1], and exactly so for polynomials of degree below 2n. With T =
/// ball an enclosure of the rule's value, with T = mpfr_float the uncertified value. It calls f n
/// times. Throws std::invalid_argument for n < 1.
template <scalar T, class F>
requires function_on<F, T>
[[nodiscard]] T gauss_chebyshev_sum(const F& f, long n, precision p) {
  if (n < 1) throw std::invalid_argument("gauss_chebyshev_sum: at least 1 node is needed");
  // With x = cos t the integral is that of f(cos t) over (0, pi), and the rule the trapezoidal one.
  return periodic_trapezoid_sum<T>(detail::function_of_cosine<F>{f}, n, p);
}

/// pi/(n+1) times the sum of sin(j pi/(n+1))^2 f(cos(j pi/(n+1))), j = 1 ... n, with p bits: about
/// the integral of f(x) sqrt(1 - x^2) over [-1, 1], and exactly so for polynomials of degree below
/// 2n. Otherwise as above.
template <scalar T, class F>
requires function_on<F, T>
[[nodiscard]] T gauss_chebyshev_second_sum(const F& f, long n, precision p) {
  if (n < 1) throw std::invalid_argument("gauss_chebyshev_second_sum: at least 1 node is needed");
  const T step(scalar_pi<T>(p) / (n + 1));
  const auto [sine, cosine] = sin_cos(step);
  const long pairs = n / 2;  // j and n + 1 - j; for odd n the node 0 is left
  const detail::circle_powers<T> at(cosine, sine, pairs + 1, p);
  T sum = n % 2 == 0 ? scalar_from<T>(0, p) : f(scalar_from<T>(0, p));
  for (long k = 1; k <= pairs; ++k) {
    const auto j = static_cast<std::size_t>(k);
    const T& node = at.cosines[j];
    T value = f(node);
    value += f(T(-node));
    detail::accumulate(sum, T(at.sines[j] * at.sines[j]), value);
  }
  return T(sum * step);
}

}  // namespace polhode
