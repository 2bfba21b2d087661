// A formula in u = tan(x) in place of x, where sines or cosines stand over tan(x): the oscillations
// of sin(tan(x)), which are ever faster towards pi/2, are those of sin(u).
//
// For |x - k pi| < pi/2, x = atan(u) + k pi, dx = du/(1 + u^2), and sin(x) and cos(x) are (-1)^k
// times u/sqrt(1 + u^2) and 1/sqrt(1 + u^2).

#include <optional>
#include <vector>

#include "graph.hpp"
#include "polhode/expression/expression.hpp"

namespace polhode {

namespace {

/// f(atan(u) + k pi)/(1 + u^2) in the graph of f, if a sine or cosine stands over tan(x). Throws
/// detail::undefined_operation where an operation has no value anywhere.
std::optional<detail::node_id> in_tangent(detail::graph& g, const integer& k_pi) {
  using detail::node_id;
  using detail::operation;
  const node_id size = g.root + 1;
  const std::vector<char> varies = detail::varying(g);
  const node_id u = g.variable(0);
  const auto is_of_x = [&](node_id i, operation what) {
    return g[i].what == what && g[i].left == u;
  };
  std::vector<char> has_tangent(size, 0);
  bool turns = false;
  for (node_id i = 0; i < size; ++i) {
    for (const node_id k : detail::operands_at(g, i)) has_tangent[i] |= has_tangent[k];
    const bool is_wave = g[i].what == operation::sin || g[i].what == operation::cos;
    turns = turns || (is_wave && has_tangent[i] != 0);
    if (is_of_x(i, operation::tan)) has_tangent[i] = 1;
  }
  if (!turns) return std::nullopt;
  const node_id weight = add(g, g.number(1), detail::power(g, u, g.number(2)));
  const auto call = [&](const char* function, node_id x) {
    return detail::find_function(function)->build(g, {x});
  };
  const node_id root = call("sqrt", weight);
  const node_id x = add(g, call("atan", u), multiply(g, g.number(k_pi), g.make(operation::pi)));
  const node_id sign = g.number(mpz_even_p(k_pi.backend().data()) != 0 ? 1 : -1);
  std::vector<node_id> places(size);
  for (node_id i = 0; i < size; ++i) {
    if (varies[i] == 0) {
      places[i] = i;
    } else if (i == u) {
      places[i] = x;
    } else if (is_of_x(i, operation::tan)) {
      places[i] = u;
    } else if (is_of_x(i, operation::sin)) {
      places[i] = divide(g, multiply(g, sign, u), root);
    } else if (is_of_x(i, operation::cos)) {
      places[i] = divide(g, sign, root);
    } else {
      places[i] = detail::with_operands(g, g, i, [&](node_id k) { return places[k]; });
    }
  }
  return divide(g, places[g.root], weight);
}

}  // namespace

std::optional<expression> expression::by_tangent(const integer& k) const {
  constexpr detail::node_id most_nodes = 500;
  if (variables_.size() != 1 || graph_->root >= most_nodes) return std::nullopt;
  bool has_tangent = false;
  for (detail::node_id i = 0; i <= graph_->root; ++i) {
    has_tangent = has_tangent || (*graph_)[i].what == detail::operation::tan;
  }
  if (!has_tangent) return std::nullopt;
  detail::graph g = *graph_;
  try {
    const auto found = in_tangent(g, k);
    return found ? std::optional(with_root(std::move(g), *found)) : std::nullopt;
  } catch (const detail::undefined_operation&) {
    return std::nullopt;
  }
}

}  // namespace polhode
