// A formula with a factor that tends to 1 or -1 exponentially for x -> inf, as that limit times the
// rest and what is left: f = T A = s A + (T - s) A for either sign s, whatever the limit is.

#include <optional>
#include <utility>

#include "exact_value.hpp"
#include "graph.hpp"
#include "polhode/expression/expression.hpp"

namespace polhode {
namespace steady_factor_impl {
namespace {

using detail::node;
using detail::node_id;
using detail::operation;

constexpr node_id most_nodes = 300;

class splitting {
 public:
  explicit splitting(detail::graph f)
      : g_(std::move(f)), size_(g_.root + 1), varies_(detail::varying(g_)) {}

  /// s A and (T - s) A.
  std::optional<std::pair<node_id, node_id>> result() {
    if (!turns()) return std::nullopt;
    return split(g_.root);
  }
  [[nodiscard]] const detail::graph& graph() const { return g_; }

 private:
  /// It has a sine or cosine of what varies: nothing decays, or the whole is known otherwise.
  [[nodiscard]] bool turns() const {
    for (node_id i = 0; i < size_; ++i) {
      if ((g_[i].what == operation::sin || g_[i].what == operation::cos) && varies(i)) return true;
    }
    return false;
  }
  [[nodiscard]] bool varies(node_id i) const { return i < size_ && varies_[i] != 0; }
  node_id of(const char* function, node_id x) {
    return detail::find_function(function)->build(g_, {x});
  }
  /// 1 or -1, as u seems to tend to infinity or minus infinity.
  [[nodiscard]] int direction(node_id u) {
    const ball value = detail::value_far_out(g_, u);
    return certainly_positive(value) ? 1 : certainly_negative(value) ? -1 : 0;
  }

  /// Of the node, a product or quotient with such a factor.
  std::optional<std::pair<node_id, node_id>> split(node_id i) {
    if (!varies(i)) return std::nullopt;
    const node n = g_[i];
    switch (n.what) {
      case operation::tanh:
      case operation::erf: {
        const int s = direction(n.left);
        if (s == 0) return std::nullopt;
        const node_id u = s > 0 ? n.left : negate(g_, n.left);
        const node_id less =
            n.what == operation::erf
                ? of("erfc", u)
                : divide(g_, g_.number(2), add(g_, of("exp", add(g_, u, u)), g_.number(1)));
        return std::pair(g_.number(s), s > 0 ? negate(g_, less) : less);
      }
      case operation::negate: {
        const auto x = split(n.left);
        if (!x) return std::nullopt;
        return std::pair(negate(g_, x->first), negate(g_, x->second));
      }
      case operation::multiply: {
        if (const auto x = split(n.left)) {
          return std::pair(multiply(g_, x->first, n.right), multiply(g_, x->second, n.right));
        }
        const auto y = split(n.right);
        if (!y) return std::nullopt;
        return std::pair(multiply(g_, n.left, y->first), multiply(g_, n.left, y->second));
      }
      case operation::divide: {
        if (const auto x = split(n.left)) {
          return std::pair(divide(g_, x->first, n.right), divide(g_, x->second, n.right));
        }
        const auto y = split_reciprocal(n.right);
        if (!y) return std::nullopt;
        return std::pair(multiply(g_, n.left, y->first), multiply(g_, n.left, y->second));
      }
      default:
        return std::nullopt;
    }
  }
  /// Of 1 over the node, tanh(u) or a product with 1 + e^v: 1/tanh(u) = 1 + 2/(e^(2 u) - 1), and
  /// 1/(1 + e^v) = 1 - 1/(1 + e^-v).
  std::optional<std::pair<node_id, node_id>> split_reciprocal(node_id i) {
    if (!varies(i)) return std::nullopt;
    const node n = g_[i];
    const node_id one = g_.number(1);
    if (n.what == operation::multiply) {
      if (const auto x = split_reciprocal(n.left)) {
        return std::pair(divide(g_, x->first, n.right), divide(g_, x->second, n.right));
      }
      const auto y = split_reciprocal(n.right);
      if (!y) return std::nullopt;
      return std::pair(divide(g_, y->first, n.left), divide(g_, y->second, n.left));
    }
    if (n.what == operation::tanh) {
      const int s = direction(n.left);
      if (s == 0) return std::nullopt;
      const node_id u = s > 0 ? n.left : negate(g_, n.left);
      const node_id more = divide(g_, g_.number(2), subtract(g_, of("exp", add(g_, u, u)), one));
      return std::pair(g_.number(s), s > 0 ? more : negate(g_, more));
    }
    if (n.what != operation::add) return std::nullopt;
    const bool is_left = g_[n.left].what == operation::exp;
    const node_id power = is_left ? n.left : n.right;
    const node_id other = is_left ? n.right : n.left;
    if (g_[power].what != operation::exp || other != one) return std::nullopt;
    const node_id v = g_[power].left;
    if (!varies(v) || direction(v) >= 0) return std::nullopt;
    return std::pair(one, negate(g_, divide(g_, one, add(g_, of("exp", negate(g_, v)), one))));
  }

  detail::graph g_;
  node_id size_;
  std::vector<char> varies_;
};

}  // namespace
}  // namespace steady_factor_impl

std::optional<expression::steady_factor> expression::by_steady_factor() const {
  if (variables_.size() != 1 || graph_->root >= steady_factor_impl::most_nodes) return std::nullopt;
  try {
    steady_factor_impl::splitting s(*graph_);
    const auto found = s.result();
    if (!found) return std::nullopt;
    return steady_factor{with_root(s.graph(), found->first), with_root(s.graph(), found->second)};
  } catch (const detail::undefined_operation&) {
    return std::nullopt;  // an operation has no value anywhere
  }
}

}  // namespace polhode
