// Where a formula is continuous, by its operations: each is continuous on an open set of arguments,
// which the signs of its operands describe.

#include <algorithm>
#include <functional>
#include <vector>

#include "graph.hpp"
#include "polhode/expression/expression.hpp"

namespace polhode {

namespace {

using detail::node;
using detail::operation;

/// Whether the operation is defined and continuous at all real arguments.
bool is_continuous_everywhere(const node& n) {
  switch (n.what) {
    case operation::variable:
    case operation::negate:
    case operation::add:
    case operation::subtract:
    case operation::multiply:
    case operation::exp:
    case operation::expm1:
    case operation::sin:
    case operation::cos:
    case operation::sinpi:
    case operation::cospi:
    case operation::atan:
    case operation::sinh:
    case operation::cosh:
    case operation::tanh:
    case operation::asinh:
    case operation::abs:
    case operation::min:
    case operation::max:
    case operation::hypot:
    case operation::erf:
    case operation::erfc:
      return true;
    case operation::power_integer:
      return n.number >= 0;
    case operation::root:
      return n.number % 2 != 0;
    default:
      return false;
  }
}

}  // namespace

bool expression::is_continuous(const std::function<int(const expression&)>& sign_of) const {
  constexpr detail::node_id most_nodes = 1000;
  const detail::graph& g = *graph_;
  if (g.root >= most_nodes || !has_defined_constants()) return false;
  const std::vector<char> used = detail::reachable(g);
  const std::vector<char> varies = detail::varying(g);
  const auto sign_at = [&](detail::node_id i) { return sign_of(with_root(g, i)); };
  const auto is_positive = [&](detail::node_id i) { return sign_at(i) > 0; };
  for (detail::node_id i = 0; i <= g.root; ++i) {
    const node& n = g[i];
    if (used[i] == 0 || varies[i] == 0 || is_continuous_everywhere(n)) continue;
    switch (n.what) {
      case operation::divide:
        if (sign_at(n.right) == 0) return false;
        break;
      case operation::power_integer:
        if (sign_at(n.left) == 0) return false;
        break;
      case operation::sqrt:
      case operation::root:
      case operation::power:
      case operation::log:
      case operation::log1p:
      case operation::gamma:
      case operation::log_gamma:
        if (!is_positive(n.left)) return false;
        break;
      default:
        return false;
    }
  }
  return true;
}

}  // namespace polhode
