// A graph as text that is read back to the same graph.

#include <variant>

#include "graph.hpp"

namespace polhode::detail {
const char* name_of(operation what) {
  switch (what) {
    case operation::pi:
      return "pi";
    case operation::euler_gamma:
      return "euler_gamma";
    case operation::catalan:
      return "catalan";
    case operation::zeta:
      return "zeta";
    case operation::root:
      return "root";
#define POLHODE_NAME(f, ...) \
  case operation::f:         \
    return #f;
      POLHODE_FUNCTION_TABLE(POLHODE_NAME, POLHODE_NAME, POLHODE_NAME, POLHODE_NO_ROW)
#undef POLHODE_NAME
    default:
      return "";
  }
}

namespace {

// How tightly a text holds together; an operand is put in parentheses where it holds less than its
// place asks for.
enum binding { of_sum = 1, of_product, of_sign, of_power, of_operand };

binding binding_of_number(const rational& q) {
  if (denominator(q) != 1) return of_product;
  return q < 0 ? of_sign : of_operand;
}

binding binding_of(const graph& g, node_id i) {
  switch (g[i].what) {
    case operation::number:
      return binding_of_number(*g.value(i));
    case operation::add:
    case operation::subtract:
      return of_sum;
    case operation::multiply:
    case operation::divide:
      return of_product;
    case operation::negate:
      return of_sign;
    case operation::power:
    case operation::power_integer:
      return of_power;
    default:
      return of_operand;
  }
}

/// What is still to be written: a text, or a node in a place that asks for so much binding.
struct operand_place {
  node_id id;
  binding least;
};
using piece = std::variant<std::string, operand_place>;

std::string exponent_text(long n) {
  return n < 0 ? "(" + std::to_string(n) + ")" : std::to_string(n);
}

std::vector<piece> pieces_of(const graph& g, node_id i, const std::vector<std::string>& variables) {
  const node& n = g[i];
  const auto at = [](node_id id, binding least) { return piece(operand_place{id, least}); };
  switch (n.what) {
    case operation::number:
      return {polhode::to_text(*g.value(i))};
    case operation::variable:
      return {variables[static_cast<std::size_t>(n.number)]};
    case operation::add:
      return {at(n.left, of_sum), " + ", at(n.right, of_product)};
    case operation::subtract:
      return {at(n.left, of_sum), " - ", at(n.right, of_product)};
    case operation::multiply:
      return {at(n.left, of_product), "*", at(n.right, of_sign)};
    case operation::divide:
      return {at(n.left, of_product), "/", at(n.right, of_sign)};
    case operation::negate:
      return {"-", at(n.left, of_power)};
    case operation::power_integer:
      return {at(n.left, of_operand), "^" + exponent_text(n.number)};
    case operation::power:
      return {at(n.left, of_operand), "^", at(n.right, of_operand)};
    default:
      break;
  }
  if (n.what == operation::further) {
    const further_call& call = g.call_at(i);
    std::vector<piece> result{call.function->what.name};
    for (std::size_t k = 0; k < call.operands.size(); ++k) {
      result.emplace_back(std::string(k == 0 ? "(" : ", "));
      result.push_back(at(call.operands[k], of_sum));
    }
    result.emplace_back(std::string(")"));
    return result;
  }
  const std::string name = name_of(n.what);
  if (n.what == operation::zeta) return {"zeta(" + std::to_string(n.number) + ")"};
  if (n.what == operation::root) {
    return {"root(", at(n.left, of_sum), ", " + std::to_string(n.number) + ")"};
  }
  switch (operands_of(n.what)) {
    case 0:
      return {name};
    case 1:
      return {name + "(", at(n.left, of_sum), ")"};
    default:
      return {name + "(", at(n.left, of_sum), ", ", at(n.right, of_sum), ")"};
  }
}

}  // namespace

/// With a stack of its own: a sum of thousands of terms is as deep as it is long.
std::string to_text(const graph& g, const std::vector<std::string>& variables) {
  std::string result;
  std::vector<piece> rest{operand_place{g.root, of_sum}};
  while (!rest.empty()) {
    const piece next = std::move(rest.back());
    rest.pop_back();
    if (const auto* text = std::get_if<std::string>(&next)) {
      result += *text;
      if (result.size() > longest_expression) {
        throw std::length_error("the expression has no text of at most " +
                                std::to_string(longest_expression) + " characters");
      }
      continue;
    }
    const auto [id, least] = std::get<operand_place>(next);
    std::vector<piece> pieces = pieces_of(g, id, variables);
    const bool in_parentheses = binding_of(g, id) < least;
    if (in_parentheses) rest.emplace_back(std::string(")"));
    rest.insert(rest.end(), std::make_move_iterator(pieces.rbegin()),
                std::make_move_iterator(pieces.rend()));
    if (in_parentheses) rest.emplace_back(std::string("("));
  }
  return result;
}

}  // namespace polhode::detail
