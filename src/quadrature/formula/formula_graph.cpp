#include "quadrature/formula/formula_graph.hpp"

#include <utility>

#include "polhode/expression/evaluation.hpp"

namespace polhode::detail {

namespace {
constexpr precision least_bits = 192;
}  // namespace

formula_graph::formula_graph(expression f) : f_(std::move(f)) {
  const program& instructions = f_.instructions();
  const tape& body = instructions.body;
  nodes_.emplace_back();  // the argument
  const std::shared_ptr<const constants> known = constants_at(least_bits);
  for (std::size_t k = 0; k < known->size(); ++k) {
    formula_node constant{operation::number};
    constant.number = static_cast<long>(k);
    if (const rational* q = std::get_if<rational>(&(*known)[k])) constant.exact = *q;
    nodes_.push_back(std::move(constant));
  }
  std::vector<std::size_t> slots(body.slots);  // the nodes that are in them
  const auto node_of = [&](std::uint32_t operand) -> std::size_t {
    if (operand >= body.inputs) return slots[operand - body.inputs];
    return operand + (1 - instructions.variables);
  };
  for (const instruction& i : body.code) {
    formula_node node{i.what};
    node.number = i.number;
    if (node.is_call()) {
      const call_of_further& called = body.calls[static_cast<std::size_t>(i.number)];
      call own{called.function, {}};
      for (const std::uint32_t o : called.operands) own.operands.push_back(node_of(o));
      node.left = own.operands.front();
      node.right = own.operands.back();
      node.number = static_cast<long>(calls_.size());
      calls_.push_back(std::move(own));
    } else {
      node.left = node_of(i.left);
      node.right = operands_of(i.what) == 2 ? node_of(i.right) : node.left;
    }
    if (node.is_piecewise()) {
      slots[i.result] = added_choice(node);
    } else if (node.what == operation::subtract) {
      slots[i.result] = difference(node.left, node.right);
    } else {
      slots[i.result] = added(node);
    }
  }
  result_ = node_of(body.outputs.front());
}

std::size_t formula_graph::added(const formula_node& node) {
  nodes_.push_back(node);
  return nodes_.size() - 1;
}

std::size_t formula_graph::added_choice(formula_node node) {
  has_breaks_ = true;
  node.decider = node.left;
  if (node.what == operation::min || node.what == operation::max) {
    // The operands stand in an order that depends on the pair alone, a 0 behind the other: so
    // min(x, y), max(y, x) and, for y = 0, |x| change at the zeros of one and the same node.
    const bool swap = is_zero(node.left) || (!is_zero(node.right) && node.right < node.left);
    if (swap) std::swap(node.left, node.right);
    node.decider = is_zero(node.right) ? node.left : difference(node.left, node.right);
  }
  return added(node);
}

std::size_t formula_graph::difference(std::size_t x, std::size_t y) {
  const auto [place, is_new] = differences_.emplace(std::pair(x, y), nodes_.size());
  return is_new ? added({operation::subtract, x, y}) : place->second;
}

std::shared_ptr<const formula_graph::constants> formula_graph::constants_at(precision p) const {
  precision bits = least_bits;
  while (bits < p) bits *= 2;
  const std::lock_guard lock(mutex_);
  std::shared_ptr<const constants>& made = constants_[bits];
  if (!made) {
    made = std::make_shared<const constants>(possibly_exact_constants_of(f_.instructions(), bits));
  }
  return made;
}

}  // namespace polhode::detail
