#include "polhode/expression/symbol.hpp"

#include <functional>
#include <limits>
#include <map>
#include <string>
#include <unordered_map>

#include "calls.hpp"
#include "polhode/arithmetic/mpfr_cell.hpp"
#include "symbol_graph.hpp"

namespace polhode {

namespace {
std::shared_ptr<detail::symbol_node> new_node() { return std::make_shared<detail::symbol_node>(); }
}  // namespace

symbol symbol::of_number(const rational& q) {
  symbol result(new_node());
  result.node_->number = q;
  return result;
}

symbol symbol::variable(std::size_t i) {
  symbol result(new_node());
  result.node_->variable = i;
  return result;
}

symbol symbol::constant(std::string_view name) { return call(name, {}); }

symbol symbol::call(std::string_view function, std::vector<symbol> operands) {
  symbol result(new_node());
  result.node_->name = function;
  result.node_->operands = std::move(operands);
  return result;
}

void symbol::refuse_infinite() {
  throw input_error("a number in the function is infinite or a NaN; it must be finite");
}

template <std::floating_point R>
symbol machine_symbol<R>::exactly_of(R x) {
  if (!(x - x == 0)) refuse_infinite();
  detail::mpfr_cell exact(std::numeric_limits<R>::digits);
  rational q;
  mpfr_set_ld(exact.get(), static_cast<long double>(x), MPFR_RNDN);
  mpfr_get_q(q.backend().data(), exact.get());
  return q;
}
template class machine_symbol<double>;
template class machine_symbol<long double>;

namespace detail {

/// A chain of operations is as long as a loop made it: its nodes are let go one after the other, not each inside another.
symbol_node::~symbol_node() {
  std::vector<symbol> rest = std::move(operands);
  while (!rest.empty()) {
    const symbol last = std::move(rest.back());
    rest.pop_back();
    if (last.node_.use_count() != 1) continue;
    for (symbol& operand : last.node_->operands) rest.push_back(std::move(operand));
    last.node_->operands.clear();
  }
}

namespace {

using operands = std::vector<node_id>;
using maker = node_id (*)(graph&, const operands&);

/// Operators by their names; "-" is told by its operands.
maker operator_of(std::string_view name, std::size_t count) {
  static const std::map<std::string_view, maker> of_two{
      {"+", [](graph& g, const operands& x) { return add(g, x[0], x[1]); }},
      {"-", [](graph& g, const operands& x) { return subtract(g, x[0], x[1]); }},
      {"*", [](graph& g, const operands& x) { return multiply(g, x[0], x[1]); }},
      {"/", [](graph& g, const operands& x) { return divide(g, x[0], x[1]); }}};
  if (count == 1 && name == "-") return [](graph& g, const operands& x) { return negate(g, x[0]); };
  const auto found = of_two.find(name);
  return count == 2 && found != of_two.end() ? found->second : nullptr;
}

node_id made_of(graph& g, const symbol_node& s, const operands& x) {
  if (const maker make = operator_of(s.name, x.size())) return make(g, x);
  if (x.empty()) {
    if (const constant_row* constant = find_constant(s.name)) return constant->build(g);
  }
  if (const function_row* row = find_function(s.name);
      row != nullptr && row->arity == static_cast<int>(x.size())) {
    return row->build(g, x);
  }
  if (const further_function* f = find_further(g.further().get(), s.name, x.size())) {
    return call_further(g, *f, x);
  }
  throw input_error("there is no function " + std::string(s.name) + " of " +
                    std::to_string(x.size()) + " arguments");
}

node_id leaf_of(graph& g, const symbol_node& s, std::size_t variables) {
  if (!s.name.empty()) return made_of(g, s, {});
  if (s.variable == symbol_node::no_variable) return g.number(s.number);
  if (s.variable >= variables) {
    throw input_error("the function has a variable " + std::to_string(s.variable + 1) +
                      ", and only " + std::to_string(variables) + " have names");
  }
  return g.variable(static_cast<long>(s.variable));
}

}  // namespace

node_id node_of(graph& g, const symbol& formula, std::size_t variables) try {
  std::unordered_map<const symbol_node*, node_id> known;
  std::vector<const symbol_node*> waiting{&formula.node()};
  while (!waiting.empty()) {
    const symbol_node* s = waiting.back();
    if (known.contains(s)) {
      waiting.pop_back();
      continue;
    }
    operands x;
    const std::size_t before = waiting.size();
    for (const symbol& operand : s->operands) {
      const auto found = known.find(&operand.node());
      if (found == known.end()) {
        waiting.push_back(&operand.node());
      } else {
        x.push_back(found->second);
      }
    }
    if (waiting.size() > before) continue;  // operands first
    known[s] = x.empty() ? leaf_of(g, *s, variables) : made_of(g, *s, x);
    waiting.pop_back();
  }
  return known.at(&formula.node());
} catch (const undefined_operation& error) {
  throw input_error(std::string("in the function, ") + error.what());
}

}  // namespace detail

}  // namespace polhode
