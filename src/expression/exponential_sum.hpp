#pragma once

// A formula as the real part of a sum of exponentials of polynomials:
//
//   f(x) = Re of the sum of (u + i v)(x) exp(E(x)),   E(x) = the sum of e_j x^j, j >= 1,
//
// with u and v real formulas in which the variable stands in no exponential, sine or cosine, and
// complex numbers e_j; where that is asked for, E(x) has a sum of l_j x^j log x beside these, for
// x > 0. Each step is an identity:
//   Re p Re q = Re (p q + p conj(q)) / 2,  cos w = Re exp(i w),  sin w = Re(-i exp(i w)),
//   exp(c + w) = exp(c) exp(w),  cosh w = (exp(w) + exp(-w)) / 2,  sinh w = (exp(w) - exp(-w)) / 2.

#include <map>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "graph.hpp"

namespace polhode::detail {

/// re + i im, as nodes of one graph.
struct complex_node {
  node_id re;
  node_id im;
  friend bool operator<(const complex_node& x, const complex_node& y) {
    return std::pair(x.re, x.im) < std::pair(y.re, y.im);
  }
};

/// Complex numbers and functions as pairs of nodes.
class complex_nodes {
 public:
  explicit complex_nodes(graph& g) : g_(g), zero_(g.number(0)) {}

  [[nodiscard]] complex_node real(node_id x) const { return {x, zero_}; }
  [[nodiscard]] complex_node number(const rational& q) { return real(g_.number(q)); }
  [[nodiscard]] bool is_zero(const complex_node& x) const { return x.re == zero_ && x.im == zero_; }
  [[nodiscard]] bool is_real(const complex_node& x) const { return x.im == zero_; }

  [[nodiscard]] complex_node add(const complex_node& x, const complex_node& y);
  [[nodiscard]] complex_node negate(const complex_node& x);
  [[nodiscard]] complex_node conjugate(const complex_node& x);
  [[nodiscard]] complex_node multiply(const complex_node& x, const complex_node& y);
  [[nodiscard]] complex_node divide(const complex_node& x, const complex_node& y);
  [[nodiscard]] complex_node power(const complex_node& x, long n);

  // Of reals, without what a zero or a one leaves as it is.
  [[nodiscard]] node_id sum(node_id x, node_id y);
  [[nodiscard]] node_id difference(node_id x, node_id y);
  [[nodiscard]] node_id product(node_id x, node_id y);
  [[nodiscard]] node_id minus(node_id x);
  [[nodiscard]] node_id call(const char* function, node_id x);

 private:
  graph& g_;
  node_id zero_;
};

/// E, by its coefficients; the last of each is not 0.
struct exponent {
  std::vector<complex_node> powers;       // e_1, e_2, ...
  std::vector<complex_node> logarithmic;  // l_0, l_1, ...

  [[nodiscard]] bool is_zero() const { return powers.empty() && logarithmic.empty(); }
  friend bool operator<(const exponent& x, const exponent& y) {
    return std::tie(x.powers, x.logarithmic) < std::tie(y.powers, y.logarithmic);
  }
};

/// u + i v by the exponents E; u and v are nodes of the graph that the sum was made in.
using exponential_terms = std::map<exponent, complex_node>;

/// The coefficients of 1, x, x^2, ... where the node is a polynomial in the variable with
/// coefficients without it, of a degree of at most 64; the last of them is not the number 0.
[[nodiscard]] std::optional<std::vector<node_id>> polynomial_in_variable(graph& g, node_id of);

/// x^lowest times the sum of the coefficients by the powers of x, wherever no divisor is 0.
struct laurent_nodes {
  long lowest = 0;
  std::vector<node_id> coefficients;
  /// Nodes without the variable.
  std::vector<node_id> divisors;
};
/// The same for a polynomial in x and 1/x.
[[nodiscard]] std::optional<laurent_nodes> laurent_polynomial_in_variable(graph& g, node_id of);

/// Whether there is a sine or cosine of what varies: cheaply, before a graph is copied for more.
[[nodiscard]] bool has_circular_functions(const graph& g);
/// Whether there is an operation of what varies that no entire sum of exponentials is made by.
[[nodiscard]] bool has_other_than_entire(const graph& g);

/// The sum that the root of g is; what it is made of joins g. Exponents have logarithms only where
/// these are allowed. None where it is no such sum, or one of more than 256 terms.
[[nodiscard]] std::optional<exponential_terms> exponential_terms_of(graph& g,
                                                                    bool allows_logarithms = false);

}  // namespace polhode::detail
