// A formula in u = 1/x in place of x, where abs, min, max, floor or ceil stand over powers of 1/x,
// or a sine or cosine over these beside a logarithm: what these do ever faster towards x = 0, as in
// floor(1/x) and |sin(1/x)|, they do at one pace in u, and cos(log(x)/x) is cos(u log(u)), whose
// oscillations are known towards infinity (turned_rays.cpp).

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "exponential_sum.hpp"
#include "graph.hpp"
#include "polhode/expression/expression.hpp"

namespace polhode {
namespace by_reciprocal_impl {
namespace {

using detail::node;
using detail::node_id;
using detail::operation;

constexpr node_id most_nodes = 500;
constexpr long greatest_exponent = 64;

/// c x^exponent, c without x.
struct monomial {
  node_id c;
  long exponent;
};

bool has(const detail::graph& g, const auto& property) {
  for (node_id i = 0; i <= g.root; ++i) {
    if (property(g[i].what)) return true;
  }
  return false;
}
bool may_be_wanted(const detail::graph& g) {
  return has(g, detail::is_piecewise) ||
         (has(g, [](operation what) { return what == operation::log; }) &&
          detail::has_circular_functions(g));
}

class substitution {
 public:
  explicit substitution(detail::graph f)
      : g_(std::move(f)), size_(g_.root + 1), varies_(detail::varying(g_)) {}

  /// f(1/u)/u^2. Throws detail::undefined_operation where an operation has no value anywhere.
  std::optional<node_id> result() {
    std::vector<std::optional<monomial>> monomials(size_);
    std::vector<char> has_reciprocal(size_, 0);
    std::vector<char> has_factor(size_, 0);  // a reciprocal beside logarithms, not inside one
    std::vector<char> has_logarithm(size_, 0);
    bool is_wanted = false;
    for (node_id i = 0; i < size_; ++i) {
      const operation what = g_[i].what;
      monomials[i] = monomial_at(i, monomials);
      has_reciprocal[i] = monomials[i] && monomials[i]->exponent < 0 ? 1 : 0;
      const bool divides = what == operation::divide && monomials[g_[i].right] &&
                           monomials[g_[i].right]->exponent > 0;
      has_factor[i] = has_reciprocal[i] != 0 || divides ? 1 : 0;
      has_logarithm[i] = what == operation::log && varies_[i] != 0 ? 1 : 0;
      for (const node_id k : detail::operands_at(g_, i)) {
        has_reciprocal[i] |= has_reciprocal[k];
        has_logarithm[i] |= has_logarithm[k];
        if (what != operation::log) has_factor[i] |= has_factor[k];
      }
      const bool is_circular = what == operation::sin || what == operation::cos;
      is_wanted |= (detail::is_piecewise(what) && has_reciprocal[i] != 0) ||
                   (is_circular && has_factor[i] != 0 && has_logarithm[i] != 0);
    }
    if (!is_wanted) return std::nullopt;
    const node_id u = g_.variable(0);
    std::vector<node_id> places(size_);
    for (node_id i = 0; i < size_; ++i) {
      if (varies_[i] == 0) {
        places[i] = i;
      } else if (monomials[i]) {
        places[i] =
            multiply(g_, monomials[i]->c, detail::power(g_, u, g_.number(-monomials[i]->exponent)));
      } else if (g_[i].what == operation::divide && monomials[g_[i].right]) {
        const monomial& divisor = *monomials[g_[i].right];
        places[i] = multiply(g_, divide(g_, places[g_[i].left], divisor.c),
                             detail::power(g_, u, g_.number(divisor.exponent)));
      } else {
        places[i] = detail::with_operands(g_, g_, i, [&](node_id k) { return places[k]; });
      }
    }
    return divide(g_, places[g_.root], detail::power(g_, u, g_.number(2)));
  }
  [[nodiscard]] const detail::graph& graph() const { return g_; }

 private:
  std::optional<monomial> monomial_at(node_id i,
                                      const std::vector<std::optional<monomial>>& known) {
    const node n = g_[i];
    if (varies_[i] == 0) return monomial{i, 0};
    if (n.what == operation::variable) return monomial{g_.number(1), 1};
    const auto of = [&](node_id k) { return k < size_ ? known[k] : std::nullopt; };
    std::optional<monomial> result;
    switch (n.what) {
      case operation::negate:
        if (const auto x = of(n.left)) result = {negate(g_, x->c), x->exponent};
        break;
      case operation::multiply: {
        const auto x = of(n.left);
        const auto y = of(n.right);
        if (x && y) result = {multiply(g_, x->c, y->c), x->exponent + y->exponent};
        break;
      }
      case operation::divide: {
        const auto x = of(n.left);
        const auto y = of(n.right);
        if (x && y) result = {divide(g_, x->c, y->c), x->exponent - y->exponent};
        break;
      }
      case operation::power_integer:
        if (const auto x = of(n.left); x && std::abs(n.number) <= greatest_exponent) {
          result = {detail::power(g_, x->c, g_.number(n.number)), x->exponent * n.number};
        }
        break;
      default:
        break;
    }
    return result && std::abs(result->exponent) <= greatest_exponent ? result : std::nullopt;
  }

  detail::graph g_;
  node_id size_;
  std::vector<char> varies_;
};

}  // namespace
}  // namespace by_reciprocal_impl

std::optional<expression> expression::by_reciprocal() const {
  if (variables_.size() != 1 || graph_->root >= by_reciprocal_impl::most_nodes ||
      !by_reciprocal_impl::may_be_wanted(*graph_)) {
    return std::nullopt;
  }
  try {
    by_reciprocal_impl::substitution s(*graph_);
    const auto found = s.result();
    return found ? std::optional(with_root(s.graph(), *found)) : std::nullopt;
  } catch (const detail::undefined_operation&) {
    return std::nullopt;
  }
}

}  // namespace polhode
