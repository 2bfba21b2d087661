// An antiderivative of what is a sum of products of powers of x, exponentials, sines and cosines:
//
//   the integral of x^n exp(l x) = exp(l x) (the sum over k = 0 ... n of
//                                            (-1)^k n!/(n-k)! x^(n-k) / l^(k+1)),  l != 0,
//
// by n integrations by parts. What is found is entire, so that its difference at two numbers is the
// integral between them. Where l is 0, but not shown to be, the quotients have no value.

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "exponential_sum.hpp"

namespace polhode {
namespace antiderivative_impl {
namespace {

using detail::complex_node;
using detail::complex_nodes;
using detail::node_id;

constexpr std::size_t most_nodes = 300;  // of the formula
constexpr std::size_t most_powers = 200;

class antiderivative {
 public:
  explicit antiderivative(detail::graph& g) : g_(g), nodes_(g), x_(g.variable(0)) {}

  std::optional<node_id> root() {
    const auto terms = detail::exponential_terms_of(g_);
    if (!terms) return std::nullopt;
    node_id sum = g_.number(0);
    std::size_t powers = 0;
    for (const auto& [e, amplitude] : *terms) {
      if (e.size() > 1) return std::nullopt;
      const auto u = detail::polynomial_in_variable(g_, amplitude.re);
      const auto v = detail::polynomial_in_variable(g_, amplitude.im);
      if (!u || !v) return std::nullopt;
      powers += std::max(u->size(), v->size());
      if (powers > most_powers) return std::nullopt;
      std::vector<complex_node> c(std::max(u->size(), v->size()), nodes_.number(0));
      for (std::size_t n = 0; n < u->size(); ++n) c[n].re = (*u)[n];
      for (std::size_t n = 0; n < v->size(); ++n) c[n].im = (*v)[n];
      sum = nodes_.sum(sum, e.empty() ? of_polynomial(c) : of_exponential(c, e.front()));
    }
    return sum;
  }

 private:
  node_id of_polynomial(const std::vector<complex_node>& c) {
    std::vector<complex_node> result{nodes_.number(0)};
    for (std::size_t n = 0; n < c.size(); ++n) {
      const auto over = static_cast<long>(n + 1);
      result.push_back(nodes_.multiply(nodes_.real(c[n].re), nodes_.number(rational(1, over))));
    }
    return at_x(result).re;
  }
  /// Re of exp(l x) q(x) for q' + l q = the polynomial p: q_n = (p_n - (n + 1) q_(n+1)) / l.
  node_id of_exponential(const std::vector<complex_node>& p, const complex_node& l) {
    std::vector<complex_node> q(p.size() + 1, nodes_.number(0));
    for (std::size_t n = p.size(); n-- > 0;) {
      const auto factor = -static_cast<long>(n + 1);
      const complex_node rest = nodes_.multiply(q[n + 1], nodes_.number(factor));
      q[n] = nodes_.divide(nodes_.add(p[n], rest), l);
    }
    const complex_node amplitude = at_x(q);
    const node_id turn = nodes_.product(l.im, x_);
    complex_node value = amplitude;
    if (!nodes_.is_real(l)) {
      value = nodes_.multiply(amplitude, {nodes_.call("cos", turn), nodes_.call("sin", turn)});
    }
    const node_id growth = nodes_.product(l.re, x_);
    if (growth == g_.number(0)) return value.re;
    return nodes_.product(nodes_.call("exp", growth), value.re);
  }
  /// By Horner's rule.
  complex_node at_x(const std::vector<complex_node>& c) {
    complex_node result = nodes_.number(0);
    for (std::size_t n = c.size(); n-- > 0;) {
      result = nodes_.add(nodes_.multiply(result, nodes_.real(x_)), c[n]);
    }
    return result;
  }

  detail::graph& g_;
  complex_nodes nodes_;
  node_id x_;
};

}  // namespace
}  // namespace antiderivative_impl

std::optional<expression> expression::entire_antiderivative() const {
  if (variables_.size() != 1 || graph_->size() > antiderivative_impl::most_nodes ||
      detail::has_other_than_entire(*graph_)) {
    return std::nullopt;
  }
  try {
    detail::graph g = *graph_;
    const auto root = antiderivative_impl::antiderivative(g).root();
    if (!root) return std::nullopt;
    return with_root(std::move(g), *root);
  } catch (const detail::undefined_operation&) {
    return std::nullopt;  // an operation has no value anywhere
  }
}

}  // namespace polhode
