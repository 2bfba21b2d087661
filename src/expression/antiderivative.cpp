// An antiderivative of what is a sum of products of powers of x, exponentials, sines and cosines:
//
//   the integral of x^n exp(l x) = exp(l x) (the sum over k = 0 ... n of
//                                            (-1)^k n!/(n-k)! x^(n-k) / l^(k+1)),  l != 0,
//
// by n integrations by parts. What is found is entire, so that its difference at two numbers is the
// integral between them. Where l is 0, but not shown to be, the quotients have no value.
//
// With x = e^-s the integral of f(x) from a to b, 0 < a < b, is that of f(e^-s) e^-s from -log b to
// -log a, and this is such a sum for products of powers of x and of log x. s^n exp(l s) tends to 0
// for s -> inf and l < 0, and for s -> -inf and l > 0, and is integrable up to there.

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
      if (e.powers.size() > 1) return std::nullopt;
      const auto u = detail::polynomial_in_variable(g_, amplitude.re);
      const auto v = detail::polynomial_in_variable(g_, amplitude.im);
      if (!u || !v) return std::nullopt;
      powers += std::max(u->size(), v->size());
      if (powers > most_powers) return std::nullopt;
      std::vector<complex_node> c(std::max(u->size(), v->size()), nodes_.number(0));
      for (std::size_t n = 0; n < u->size(); ++n) c[n].re = (*u)[n];
      for (std::size_t n = 0; n < v->size(); ++n) c[n].im = (*v)[n];
      sum = nodes_.sum(sum, e.is_zero() ? of_polynomial(c) : of_exponential(c, e.powers.front()));
      rates_.push_back(e.is_zero() ? g_.number(0) : e.powers.front().re);
    }
    return sum;
  }
  /// The real parts of the exponents k of the terms.
  [[nodiscard]] const std::vector<node_id>& rates() const { return rates_; }

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
  std::vector<node_id> rates_;
};

/// Without these the other ways are as good.
bool has_logarithm_or_root(const detail::graph& g) {
  using detail::operation;
  for (node_id i = 0; i <= g.root; ++i) {
    const operation what = g[i].what;
    if (what == operation::log || what == operation::sqrt || what == operation::root ||
        what == operation::power) {
      return true;
    }
  }
  return false;
}

/// Marks the nodes that are positive, or analytic, for every x > 0: the variable, positive
/// constants, their products, quotients, powers and roots; and of these logarithms.
class right_of_zero {
 public:
  /// is_positive(i) says it of the node i, a constant.
  template <class IsPositive>
  right_of_zero(const detail::graph& g, const IsPositive& is_positive)
      : varies_(detail::varying(g)), positive_(g.root + 1), has_(g.root + 1) {
    using detail::operation;
    const std::vector<char> reached = detail::reachable(g);
    for (node_id i = 0; i <= g.root; ++i) {
      if (reached[i] == 0) continue;
      const detail::node& n = g[i];
      if (varies_[i] == 0) {
        positive_[i] = is_positive(i) ? 1 : 0;
        has_[i] = 1;
        continue;
      }
      const auto both = [&](const std::vector<char>& marks) {
        return marks[n.left] != 0 && marks[n.right] != 0 ? char{1} : char{0};
      };
      switch (n.what) {
        case operation::variable:
          positive_[i] = has_[i] = 1;
          break;
        case operation::add:
        case operation::subtract:
          has_[i] = both(has_);
          break;
        case operation::multiply:
          positive_[i] = both(positive_);
          has_[i] = both(has_);
          break;
        case operation::divide:
          positive_[i] = both(positive_);
          has_[i] = positive_[n.right] != 0 || varies_[n.right] == 0 ? has_[n.left] : char{0};
          break;
        case operation::negate:
          has_[i] = has_[n.left];
          break;
        case operation::power_integer:
          positive_[i] = positive_[n.left];
          has_[i] = n.number >= 0 ? has_[n.left] : positive_[n.left];
          break;
        case operation::root:
        case operation::sqrt:
          positive_[i] = has_[i] = positive_[n.left];
          break;
        case operation::power:
          positive_[i] = has_[i] =
              positive_[n.left] != 0 && varies_[n.right] == 0 ? char{1} : char{0};
          break;
        case operation::log:
          has_[i] = positive_[n.left];
          break;
        default:
          break;
      }
    }
  }
  [[nodiscard]] bool holds(node_id i) const { return has_[i] != 0; }

 private:
  std::vector<char> varies_;
  std::vector<char> positive_;
  std::vector<char> has_;
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

std::optional<expression::logarithmic_antiderivative> expression::antiderivative_in_logarithm()
    const {
  namespace impl = antiderivative_impl;
  if (variables_.size() != 1 || graph_->size() > impl::most_nodes ||
      !impl::has_logarithm_or_root(*graph_)) {
    return std::nullopt;
  }
  constexpr precision few = 64;
  const auto value_in = [&](const detail::graph& g, detail::node_id i) {
    return with_root(g, i).value(few);
  };
  try {
    // Most formulas are not of this kind whatever their constants are.
    const detail::node_id top = graph_->root;
    if (!impl::right_of_zero(*graph_, [](detail::node_id) { return true; }).holds(top)) {
      return std::nullopt;
    }
    const auto is_positive = [&](detail::node_id i) {
      return certainly_positive(value_in(*graph_, i));
    };
    if (!impl::right_of_zero(*graph_, is_positive).holds(top)) return std::nullopt;
    const expression zero("0", {.variables = {}, .definitions = {}});
    const std::optional<expression> in_s = in_exponential(&zero, 1);
    if (!in_s || detail::has_other_than_entire(*in_s->graph_)) return std::nullopt;
    detail::graph g = *in_s->graph_;
    impl::antiderivative found(g);
    const auto root = found.root();
    if (!root) return std::nullopt;
    logarithmic_antiderivative result{in_s->with_root(g, *root), true, true};
    for (const detail::node_id rate : found.rates()) {
      const ball k = value_in(g, rate);
      result.vanishes_at_zero = result.vanishes_at_zero && certainly_negative(k);
      result.vanishes_at_infinity = result.vanishes_at_infinity && certainly_positive(k);
    }
    return result;
  } catch (const detail::undefined_operation&) {
    return std::nullopt;  // an operation has no value anywhere
  }
}

}  // namespace polhode
