#pragma once

// The nodes and weights of a quadrature rule, and what the sums of the rules have in common.

#include <concepts>
#include <type_traits>
#include <vector>

#include "polhode/arithmetic/complex_ball.hpp"
#include "polhode/arithmetic/scalar.hpp"

namespace polhode {

/// The n nodes and weights of a rule on [-1, 1] that is symmetric about 0: the nodes >= 0,
/// increasing, and the weights that belong to them. The others are their negatives, with the same
/// weights. Where n is odd, nodes[0] is 0, exactly, and counts once. Each ball holds the true node
/// or weight and has `bits` bits.
struct symmetric_nodes {
  long n = 0;
  precision bits = 0;
  std::vector<ball> nodes;
  std::vector<ball> weights;
};

/// A function of a scalar that answers with a scalar of the same type. (A lambda that returns what
/// an operator of mpfr_float returns, an expression of references to its argument, is none: let it
/// say `-> T`.)
template <class F, class T>
concept function_on = scalar<T> && requires(const F& f, const T& x) {
  { f(x) } -> std::same_as<T>;
};

namespace detail {

/// sum += weight * value, rounded once.
inline void accumulate(ball& sum, const ball& weight, const ball& value) {
  fma(sum, weight, value, sum);
}
inline void accumulate(complex_ball& sum, const ball& weight, const complex_ball& value) {
  fma(sum.re, weight, value.re, sum.re);
  fma(sum.im, weight, value.im, sum.im);
}
inline void accumulate(mpfr_float& sum, const mpfr_float& weight, const mpfr_float& value) {
  mpfr_fma(sum.backend().data(), weight.backend().data(), value.backend().data(),
           sum.backend().data(), MPFR_RNDN);
}

/// The set as a scalar: itself, or the number in its middle.
template <scalar T>
[[nodiscard]] decltype(auto) scalar_of(const ball& x) {
  if constexpr (std::same_as<T, ball>) {
    return (x);
  } else {
    return midpoint(x);
  }
}

/// [-1, 1] on the line: x -> centre + half_length x.
template <scalar T>
struct interval_map {
  const T& centre;
  const T& half_length;
  void offset(T& result, const T& node) const { result = half_length * node; }
};

/// sum += the sum of w_k (f(centre + h x_k) + f(centre - h x_k)) over k = first ... last-1, where
/// x_0 = 0 counts once. `at` has the centre, a T, and offset(h x, x). T: ball, or mpfr_float for
/// the uncertified sum; Value: what f answers with.
template <class F, class Map, class Value>
void add_nodes(const F& f, const symmetric_nodes& rule, const Map& at, long first, long last,
               Value& sum) {
  using T = std::remove_cvref_t<decltype(at.centre)>;
  T offset = at.centre;
  for (long k = first; k < last; ++k) {
    const auto i = static_cast<std::size_t>(k);
    at.offset(offset, scalar_of<T>(rule.nodes[i]));
    Value value = f(T(at.centre + offset));
    const bool is_middle = k == 0 && rule.n % 2 != 0;
    if (!is_middle) value += f(T(at.centre - offset));
    accumulate(sum, scalar_of<T>(rule.weights[i]), value);
  }
}

}  // namespace detail

/// half_length times the sum of w_k f(centre + half_length x_k): about the integral of f from
/// centre - half_length to centre + half_length. With T = ball an enclosure of that sum, whatever
/// member of its set each node and weight is, and so of the true rule's; what the rule leaves out
/// is not in it. With T = mpfr_float the uncertified value, from the midpoints of nodes and
/// weights. It calls f rule.n times. `integrate` sums by the same terms (add_nodes).
template <scalar T, class F>
requires function_on<F, T>
[[nodiscard]] T rule_sum(const F& f, const symmetric_nodes& rule, const T& centre,
                         const T& half_length) {
  T sum = scalar_from<T>(0, rule.bits);
  detail::add_nodes(f, rule, detail::interval_map<T>{centre, half_length}, 0,
                    static_cast<long>(rule.nodes.size()), sum);
  return T(half_length * sum);
}

}  // namespace polhode
