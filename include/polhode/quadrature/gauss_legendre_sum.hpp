#pragma once

// The Gauss and Legendre rule itself, over an interval of any place and length.

#include "polhode/quadrature/gauss_legendre.hpp"
#include "polhode/quadrature/rule_sum.hpp"

namespace polhode {

/// half_length times the sum of w_k f(centre + half_length x_k): about the integral of f from centre - half_length
/// to centre + half_length, and exactly so for polynomials of degree below 2n. With T = ball an enclosure of that
/// sum, whatever member of its set each node and weight is, and so of the true rule's; what the rule leaves out is
/// half_length times gauss_legendre_error (error_bounds.hpp), of which nothing is in the result. With
/// T = mpfr_float the uncertified value, from the midpoints of nodes and weights. It calls f rule.n times.
template <scalar T, class F>
requires function_on<F, T>
[[nodiscard]] T gauss_legendre_sum(const F& f, const gauss_legendre_rule& rule, const T& centre,
                                   const T& half_length) {
  T sum = scalar_from<T>(0, rule.bits);
  for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
    const T offset(half_length * detail::scalar_of<T>(rule.nodes[k]));
    T value = f(T(centre + offset));
    const bool is_middle = k == 0 && rule.n % 2 != 0;  // counts once
    if (!is_middle) value += f(T(centre - offset));
    detail::accumulate(sum, detail::scalar_of<T>(rule.weights[k]), value);
  }
  return T(half_length * sum);
}

}  // namespace polhode
