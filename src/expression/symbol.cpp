#include "polhode/expression/symbol.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <unordered_map>
#include <unordered_set>

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

symbol symbol::in_ball(const ball& x) {
  constexpr long most_exponent = 4096;  // of a number that the ball is, to be one of the formula's
  if (x.is_exact() && x.magnitude_upper() <= magnitude::power_of_two(most_exponent) &&
      (x.magnitude_upper().is_zero() ||
       x.magnitude_lower() >= magnitude::power_of_two(-most_exponent))) {
    return of_number(lower_rational(x));
  }
  symbol result(new_node());
  result.node_->enclosure = x;
  return result;
}

symbol symbol::in_complex_ball(const complex_ball& z) {
  if (sign_of(z.im) == certain_sign::zero) return z.re;
  return symbol(z.re) + times_i(symbol(z.im));
}

symbol symbol::imaginary_unit() { return variable(detail::symbol_node::imaginary_unit); }

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

namespace {

symbol symbol_of_part(const exact_formula& x,
                      std::unordered_map<const exact_formula*, symbol>& made) {
  if (const auto known = made.find(&x); known != made.end()) return known->second;
  symbol result;
  if (x.function.empty()) {
    result = x.number.q;
    if (!x.number.is_rational()) result += symbol(x.number.r) * symbol::constant("pi");
  } else {
    std::vector<symbol> operands;
    operands.reserve(x.operands.size());
    for (const auto& operand : x.operands) operands.push_back(symbol_of_part(*operand, made));
    result = symbol::call(x.function, std::move(operands));
  }
  made.emplace(&x, result);
  return result;
}

}  // namespace

symbol symbol_of(const exact_formula& x) {
  std::unordered_map<const exact_formula*, symbol> made;
  return symbol_of_part(x, made);
}

namespace detail {

/// A chain of operations is as long as a loop made it: its nodes are let go one after the other,
/// not each inside another.
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

/// Of the functions that stand for numbers in balls: no identifier, so that no function of a
/// program's own that texts can call has it.
constexpr std::string_view name_of_enclosed = "(a number in a ball)";
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

node_id variable_of(graph& g, std::size_t i, const std::vector<std::string>& variables) {
  if (i == symbol_node::imaginary_unit) {
    const auto unit = std::find(variables.begin(), variables.end(), "i");
    if (unit == variables.end()) {
      throw input_error("the function has complex numbers in it, and real ones are wanted here");
    }
    i = static_cast<std::size_t>(unit - variables.begin());
  }
  if (i >= variables.size()) {
    throw input_error("the function has a variable " + std::to_string(i + 1) + ", and only " +
                      std::to_string(variables.size()) + " have names");
  }
  return g.variable(static_cast<long>(i));
}

/// Calls each(s) for every node, operands before what is made of them, each node once.
template <class Each>
void for_each_node(const symbol& formula, const Each& each) {
  std::unordered_set<const symbol_node*> done;
  std::vector<const symbol_node*> waiting{&formula.node()};
  while (!waiting.empty()) {
    const symbol_node* s = waiting.back();
    const std::size_t before = waiting.size();
    if (!done.contains(s)) {
      for (const symbol& operand : s->operands) {
        if (!done.contains(&operand.node())) waiting.push_back(&operand.node());
      }
      if (waiting.size() > before) continue;  // operands first
      each(*s);
      done.insert(s);
    }
    waiting.pop_back();
  }
}

}  // namespace

symbol symbol_of(const graph& g, std::span<const symbol> variables) {
  const std::vector<char> used = reachable(g);
  std::vector<symbol> made(g.size(), symbol(0));
  const auto call = [&](std::string_view name, const std::vector<node_id>& of) {
    std::vector<symbol> operands;
    operands.reserve(of.size());
    for (const node_id i : of) operands.push_back(made[i]);
    return symbol::call(name, std::move(operands));
  };
  for (node_id i = 0; i <= g.root; ++i) {
    if (used[i] == 0) continue;
    const node& n = g[i];
    switch (n.what) {
      case operation::number:
        made[i] = g.number_at(n.number);
        break;
      case operation::variable:
        if (static_cast<std::size_t>(n.number) >= variables.size()) {
          throw std::invalid_argument("an expression needs a value for each variable");
        }
        made[i] = variables[static_cast<std::size_t>(n.number)];
        break;
      case operation::zeta:
        made[i] = symbol::call("zeta", {symbol(n.number)});
        break;
      case operation::negate:
        made[i] = -made[n.left];
        break;
      case operation::power_integer:
        made[i] = symbol::call("pow", {made[n.left], symbol(n.number)});
        break;
      case operation::root:
        made[i] = symbol::call("root", {made[n.left], symbol(n.number)});
        break;
      case operation::add:
        made[i] = call("+", {n.left, n.right});
        break;
      case operation::subtract:
        made[i] = call("-", {n.left, n.right});
        break;
      case operation::multiply:
        made[i] = call("*", {n.left, n.right});
        break;
      case operation::divide:
        made[i] = call("/", {n.left, n.right});
        break;
      case operation::power:
        made[i] = call("pow", {n.left, n.right});
        break;
      case operation::further: {
        const further_call& of = g.call_at(i);
        const std::string& name = of.function->what.name;
        made[i] =
            name == name_of_enclosed ? symbol(of.function->value({})) : call(name, of.operands);
        break;
      }
      default:
        made[i] = call(name_of(n.what), operands_of(n.what) == 2   ? std::vector{n.left, n.right}
                                        : operands_of(n.what) == 1 ? std::vector{n.left}
                                                                   : std::vector<node_id>{});
    }
  }
  return made[g.root];
}

bool has_imaginary_unit(const symbol& formula) {
  bool found = false;
  for_each_node(formula, [&](const symbol_node& s) {
    found = found || s.variable == symbol_node::imaginary_unit;
  });
  return found;
}

graph graph_of(const symbol& formula, const expression_names& names) try {
  std::vector<const symbol_node*> enclosed;
  for_each_node(formula, [&](const symbol_node& s) {
    if (s.enclosure) enclosed.push_back(&s);
  });
  // Each enclosed number is a function of its own, of a number that it does not depend on.
  std::shared_ptr<const further_functions> functions = names.further;
  std::unordered_map<const symbol_node*, std::size_t> place;
  if (!enclosed.empty()) {
    further_functions all = functions != nullptr ? *functions : further_functions();
    for (const symbol_node* s : enclosed) {
      place[s] = all.size();
      all.push_back({.what = {std::string(name_of_enclosed), "x", "a number in a ball", "all x"},
                     .value = [x = *s->enclosure](std::span<const ball>) { return x; }});
    }
    functions = std::make_shared<const further_functions>(std::move(all));
  }
  graph g(functions);
  for (std::size_t i = 0; i < names.variables.size(); ++i) {
    static_cast<void>(g.variable(static_cast<long>(i)));  // the first nodes, in their order
  }
  std::unordered_map<const symbol_node*, node_id> known;
  for_each_node(formula, [&](const symbol_node& s) {
    operands x;
    x.reserve(s.operands.size());
    for (const symbol& operand : s.operands) x.push_back(known.at(&operand.node()));
    node_id& made = known[&s];
    if (s.enclosure) {
      made = g.call({&g.further()->at(place.at(&s)), {g.number(0)}});
    } else if (!s.name.empty()) {
      made = made_of(g, s, x);
    } else if (s.variable != symbol_node::no_variable) {
      made = variable_of(g, s.variable, names.variables);
    } else {
      made = g.number(s.number);
    }
  });
  g.root = known.at(&formula.node());
  return g;
} catch (const undefined_operation& error) {
  throw input_error(std::string("in the function, ") + error.what());
}

}  // namespace detail

}  // namespace polhode
