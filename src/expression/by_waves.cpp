// Functions that are waves for large arguments, as Bessel's J: by further_function::near_infinity
// f(u) = main(u) + theta rest(u) with |theta| <= 1 for |u| >= 4. There f, main and rest, which is
// positive or 0, are continuous, and so is theta (0, say, where rest is 0).

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "exponential_sum.hpp"
#include "graph.hpp"
#include "polhode/expression/expression.hpp"

namespace polhode {

namespace {

using detail::graph;
using detail::node_id;
using detail::operation;

/// The nodes of a formula that may be waves: calls of functions that are known for large arguments.
std::vector<node_id> calls_with_leading_terms(const graph& g) {
  const std::vector<char> used = detail::reachable(g);
  const std::vector<char> varies = detail::varying(g);
  std::vector<node_id> result;
  for (node_id i = 0; i <= g.root; ++i) {
    if (used[i] == 0 || varies[i] == 0 || g[i].what != operation::further) continue;
    const detail::further_call& call = g.call_at(i);
    const auto is_steady = [&](node_id k) { return varies[k] == 0; };
    if (call.function->near_infinity != nullptr &&
        std::all_of(call.operands.begin(), call.operands.end() - 1, is_steady)) {
      result.push_back(i);
    }
  }
  return result;
}

}  // namespace

std::optional<expression> expression::by_waves(
    const std::function<int(const expression&)>& sign_of) const {
  constexpr node_id most_nodes = 500;
  if (variables_.size() != 1 || graph_->root >= most_nodes) return std::nullopt;
  const std::vector<node_id> calls = calls_with_leading_terms(*graph_);
  if (calls.empty()) return std::nullopt;
  expression of_all(*this);
  graph to(graph_->further());
  (void)to.variable(0);  // variables are the first nodes, in their order
  for (std::size_t k = 1; k <= calls.size(); ++k) {
    of_all.variables_.push_back(fmt::format("{}_wave{}", variables_.front(), k));
    (void)to.variable(static_cast<long>(k));
  }
  const auto sign_at = [&](node_id i) { return sign_of(of_all.with_root(to, i)); };
  // main + theta rest, theta the k-th variable; none where the call is not known to be a wave.
  const auto wave = [&](const detail::further_call& call, long k) -> std::optional<node_id> {
    constexpr long far = 4;
    constexpr precision p = 128;
    const node_id u = call.operands.back();
    const int sign = sign_at(u);
    const node_id size = sign < 0 ? negate(to, u) : u;
    if (sign == 0 || sign_at(subtract(to, size, to.number(far))) <= 0) return std::nullopt;
    std::vector<ball> orders;
    std::map<std::string, node_id, std::less<>> values;
    const std::vector<std::string> names = argument_names(call.function->what);
    for (std::size_t n = 0; n < names.size(); ++n) {
      values.emplace(names[n], call.operands[n]);
      if (n + 1 < names.size()) orders.push_back(of_all.with_root(to, call.operands[n]).value(p));
    }
    const auto known = call.function->near_infinity(orders, sign);
    if (!known) return std::nullopt;
    const expression main(known->main, {names, {}, graph_->further()});
    if (!detail::has_circular_functions(*main.graph_)) return std::nullopt;
    const node_id rest = read_expression(to, known->rest, values);
    return add(to, read_expression(to, known->main, values), multiply(to, to.variable(k), rest));
  };
  const std::vector<char> used = detail::reachable(*graph_);
  std::vector<node_id> places(graph_->root + 1, 0);
  const auto place_of = [&](node_id k) { return places[k]; };
  bool has_waves = false;
  for (node_id i = 0; i <= graph_->root; ++i) {
    if (used[i] == 0) continue;
    if (const rational* number = graph_->value(i)) {
      places[i] = to.number(*number);
      continue;
    }
    places[i] = detail::with_operands(to, *graph_, i, place_of);
    const auto known = std::ranges::find(calls, i);
    if (known == calls.end()) continue;
    const detail::further_call call = to.call_at(places[i]);
    if (const auto made = wave(call, 1 + static_cast<long>(known - calls.begin()))) {
      places[i] = *made;
      has_waves = true;
    }
  }
  if (!has_waves) return std::nullopt;
  const node_id root = places[graph_->root];
  return of_all.with_root(std::move(to), root);
}

}  // namespace polhode
