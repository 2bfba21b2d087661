#include "polhode/expression/expression.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "exact_value.hpp"
#include "graph.hpp"
#include "polhode/expression/evaluation.hpp"
#include "symbol_graph.hpp"

namespace polhode {

using detail::node_id;
using detail::operation;

bool is_identifier(std::string_view text) {
  const auto letter = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
  };
  const auto digit = [](char c) { return c >= '0' && c <= '9'; };
  return !text.empty() && letter(text.front()) &&
         std::all_of(text.begin(), text.end(), [&](char c) { return letter(c) || digit(c); });
}

namespace {

using name_table = std::map<std::string, node_id, std::less<>>;

/// A name in quotes, without the end of a long one.
std::string quoted(const std::string& name) {
  constexpr std::size_t most = 40;
  return '"' + (name.size() <= most ? name : name.substr(0, most) + "...") + '"';
}

void check_name(const std::string& name, const name_table& variables, const name_table& known,
                const further_functions* further) {
  if (!is_identifier(name)) {
    throw input_error(quoted(name) +
                      " cannot be a name: it must be a letter or _, then letters, digits and _");
  }
  if (is_infinity(name)) {
    throw input_error(quoted(name) + " is infinity, a limit; it cannot have another meaning");
  }
  const char* taken = nullptr;
  if (detail::find_function(name) != nullptr || detail::has_further(further, name)) {
    taken = "function";
  }
  if (detail::find_constant(name) != nullptr) taken = "constant";
  if (taken != nullptr) {
    throw input_error(quoted(name) + " is the name of a " + taken +
                      "; it cannot have another meaning");
  }
  if (variables.count(name) != 0 || known.count(name) != 0) {
    throw input_error("the name " + quoted(name) + " is given twice");
  }
}

}  // namespace

expression::expression(std::string_view text, const expression_names& names)
    : variables_(names.variables) {
  const auto g = std::make_shared<detail::graph>(names.further);
  name_table variables;
  name_table definitions;
  for (const std::string& name : variables_) {
    check_name(name, variables, definitions, names.further.get());
    const node_id id = g->variable(static_cast<long>(variables.size()));
    variables[name] = id;
  }
  for (const auto& [name, value] : names.definitions) {
    check_name(name, variables, definitions, names.further.get());
    try {
      definitions[name] = detail::read_expression(*g, value, definitions);
    } catch (const expression_error& error) {
      throw expression_error(name, error);
    }
  }
  definitions.merge(variables);
  g->root = detail::read_expression(*g, text, definitions);
  take(g);
}

expression::expression(const symbol& formula, const expression_names& names)
    : variables_(names.variables) {
  take(std::make_shared<const detail::graph>(detail::graph_of(formula, names)));
}

symbol expression::operator()(const symbol& x) const { return detail::symbol_of(*graph_, {&x, 1}); }

symbol expression::evaluate(std::span<const symbol> values) const {
  return detail::symbol_of(*graph_, values);
}

/// The graph and what is made of it.
void expression::take(std::shared_ptr<const detail::graph> g) {
  if (const rational* q = g->value(g->root)) exact_ = *q;
  program_ = std::make_shared<const detail::program>(detail::compile(*g, variables_.size()));
  graph_ = std::move(g);
}

expression expression::with_root(detail::graph g, node_id root) const {
  g.root = root;
  expression result(*this);
  result.exact_.reset();
  result.take(std::make_shared<const detail::graph>(std::move(g)));
  return result;
}

std::vector<expression> expression::constants(std::size_t most) const {
  const std::vector<char> used = detail::reachable(*graph_);
  const std::vector<char> varies = detail::varying(*graph_);
  std::vector<expression> result;
  for (node_id i = 0; i < graph_->size() && result.size() < most; ++i) {
    if (used[i] == 0 || varies[i] != 0 || graph_->value(i) != nullptr) continue;
    result.push_back(with_root(*graph_, i));
  }
  return result;
}

expression expression::with_sets(std::span<const ball> of_others) const {
  if (of_others.size() + 1 != variables_.size()) {
    throw std::invalid_argument("an expression needs a set for each variable but the first one");
  }
  std::vector<symbol> values{symbol::variable(0)};
  values.insert(values.end(), of_others.begin(), of_others.end());
  return expression(evaluate(std::span<const symbol>(values)),
                    {{variables_.front()}, {}, graph_->further()});
}

expression expression::with_rational_constants() const {
  const std::vector<char> used = detail::reachable(*graph_);
  const std::vector<char> varies = detail::varying(*graph_);
  detail::graph g = *graph_;
  std::vector<node_id> places(graph_->root + 1, 0);
  for (node_id i = 0; i <= graph_->root; ++i) {
    places[i] = i;
    const int operands = detail::operands_of(g[i].what);
    const bool is_leaf = operands == 0 && g[i].what != detail::operation::further;
    if (used[i] == 0 || g.value(i) != nullptr || (is_leaf && varies[i] != 0)) continue;
    const auto value = varies[i] == 0 ? with_root(*graph_, i).rational_value() : std::nullopt;
    if (value) {
      places[i] = g.number(*value);
    } else if (!is_leaf) {
      places[i] = detail::with_operands(g, *graph_, i, [&](node_id k) { return places[k]; });
    }
  }
  const node_id root = places[graph_->root];
  return with_root(std::move(g), root);
}

expression_names expression::names() const { return {variables_, {}, graph_->further()}; }

ball expression::value(precision p) const {
  if (!used_variables().empty()) {
    throw std::invalid_argument("the value of an expression in " + used_variables().front() +
                                ": it has none of its own");
  }
  const std::vector<ball> any(variables_.size(), ball(0, p));
  const auto f = evaluator<ball>(p);
  return any.empty() ? f(ball(0, p)) : f(any);
}

known_number expression::known_value(precision p) const {
  if (!used_variables().empty()) return known_number(value(p));
  const detail::tape& body = program_->body;
  const std::uint32_t i = body.outputs.front();
  // What has no variable is an output of the constants, which come after the variables.
  if (i < variables_.size() || i >= body.inputs) return known_number(value(p));
  const auto c = detail::possibly_exact_constants_of(*program_, p)[i - variables_.size()];
  if (const rational* q = std::get_if<rational>(&c)) return known_number(*q, p);
  return std::get<known_number>(c);
}

std::optional<expression_function> expression::undefined_function(precision p) const {
  const auto i = detail::first_undefined(*program_, p);
  if (!i) return std::nullopt;
  if (i->what == operation::further) {
    return program_->constants.calls[static_cast<std::size_t>(i->number)].function->what;
  }
  const detail::function_row* row = detail::find_function(detail::name_of(i->what));
  return row == nullptr ? std::nullopt : std::optional(row->what);
}

bool expression::has_defined_constants() const {
  constexpr std::array<precision, 3> attempts{64, 1024, 8192};
  return std::ranges::any_of(attempts,
                             [&](precision p) { return !detail::first_undefined(*program_, p); });
}

std::vector<std::string> expression::used_variables() const {
  const std::vector<char> used = detail::reachable(*graph_);
  std::vector<std::string> result;
  for (std::size_t i = 0; i < variables_.size(); ++i) {  // the first nodes, in their order
    if (i < used.size() && used[i] != 0) result.push_back(variables_[i]);
  }
  return result;
}

std::optional<rational> expression::rational_value() const {
  return detail::rational_value(*graph_, *program_);
}

std::optional<std::pair<rational, long>> expression::exact_power() const {
  const detail::node& root = (*graph_)[graph_->root];
  if (root.what != operation::power_integer) return std::nullopt;
  const rational* base = graph_->value(root.left);
  if (base == nullptr) return std::nullopt;
  return std::pair(*base, root.number);
}

namespace {
/// That of a named function; nothing for the other operations.
std::optional<detail::function_kind> kind_of(operation what) {
  switch (what) {
    // NOLINTBEGIN(bugprone-branch-clone): neighbours in the table are often of one kind
#define POLHODE_KIND(f, arguments, description, domain, kind, reader) \
  case operation::f:                                                  \
    return detail::function_kind::kind;
    POLHODE_FUNCTION_TABLE(POLHODE_KIND, POLHODE_KIND, POLHODE_KIND, POLHODE_NO_ROW)
#undef POLHODE_KIND
    // NOLINTEND(bugprone-branch-clone)
    default:
      return std::nullopt;
  }
}
}  // namespace

std::optional<std::string_view> expression::function_not_analytic() const {
  for (const detail::instruction& i : program_->body.code) {
    if (kind_of(i.what) == detail::function_kind::piecewise) return detail::name_of(i.what);
  }
  return std::nullopt;
}

std::size_t expression::operation_count() const {
  return program_->constants.code.size() + program_->body.code.size();
}

std::size_t expression::live_numbers() const {
  const detail::program& f = *program_;
  return f.numbers.size() + f.constants.slots + f.constants.outputs.size() + f.body.slots +
         f.variables;
}

namespace {
expression_cost cost_of(detail::function_kind kind) {
  switch (kind) {
    case detail::function_kind::special:
      return expression_cost::special;
    case detail::function_kind::elementary:
      return expression_cost::elementary;
    default:
      return expression_cost::algebraic;
  }
}

expression_cost cost_of(operation what) {
  if (const auto kind = kind_of(what)) return cost_of(*kind);
  switch (what) {
    case operation::zeta:
    case operation::euler_gamma:
    case operation::catalan:
      return expression_cost::special;
    case operation::negate:
    case operation::power_integer:
    case operation::root:
    case operation::add:
    case operation::subtract:
    case operation::multiply:
    case operation::divide:
      return expression_cost::algebraic;
    case operation::further:
      return expression_cost::further;
    default:
      return expression_cost::elementary;
  }
}
}  // namespace

expression_cost expression::cost() const {
  expression_cost most = expression_cost::algebraic;
  for (const auto* code : {&program_->constants.code, &program_->body.code}) {
    for (const detail::instruction& i : *code) most = std::max(most, cost_of(i.what));
  }
  return most;
}

std::string expression::to_text() const { return detail::to_text(*graph_, variables_); }

known_number settled(const known_number& x) {
  if (x.exact() || !x.has_formula()) return x;
  // Where it may be undefined, a difference of the same number is no 0.
  if (!x.enclosure().is_bounded() || !contains_zero(x.enclosure())) return x;
  try {
    if (expression(symbol_of(*x.formula()), {}).rational_value() == rational(0)) return x.like(0);
  } catch (const input_error&) {
    // An operation on exact numbers that is not defined.
  }
  return known_number(x.enclosure());
}

}  // namespace polhode
