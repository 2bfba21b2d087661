#pragma once

// A formula as a graph in which equal subexpressions are one node, and the operations that make it:
// those on rational numbers are done exactly, and those that are not defined are refused.

#include <deque>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

#include "polhode/expression/expression.hpp"
#include "polhode/expression/functions.hpp"
#include "polhode/expression/program.hpp"

namespace polhode::detail {

/// Operands come before what is made of them.
using node_id = std::uint32_t;

struct node {
  operation what;
  node_id left;   // the first operand, 0 where there is none
  node_id right;  // the second one, 0 where there is none
  long number;    // n; of operation::number and operation::variable an index
  friend bool operator<(const node& x, const node& y) {
    return std::tie(x.what, x.left, x.right, x.number) <
           std::tie(y.what, y.left, y.right, y.number);
  }
};

/// An operation on numbers is not defined; what() says which, without a column.
class undefined_operation : public std::domain_error {
 public:
  using std::domain_error::domain_error;
};

/// A call of a function that is not this room's.
struct further_call {
  const further_function* function;
  std::vector<node_id> operands;
  friend bool operator<(const further_call& x, const further_call& y) {
    return std::tie(x.function, x.operands) < std::tie(y.function, y.operands);
  }
};

class graph {
 public:
  explicit graph(std::shared_ptr<const further_functions> further = nullptr)
      : further_(std::move(further)) {}

  [[nodiscard]] node_id number(const rational& q);
  [[nodiscard]] node_id variable(long index) { return plain({operation::variable, 0, 0, index}); }
  /// The node of the operation as it stands; the functions below fold and simplify first.
  [[nodiscard]] node_id make(operation what, node_id left = 0, node_id right = 0, long number = 0) {
    return plain({what, left, right, number});
  }

  [[nodiscard]] node_id call(const further_call& c);

  [[nodiscard]] const std::shared_ptr<const further_functions>& further() const { return further_; }
  [[nodiscard]] const further_call& call_at(node_id i) const {
    return calls_[static_cast<std::size_t>(nodes_[i].number)];
  }
  [[nodiscard]] const node& operator[](node_id i) const { return nodes_[i]; }
  [[nodiscard]] node_id size() const { return static_cast<node_id>(nodes_.size()); }
  [[nodiscard]] const rational& number_at(long index) const {
    return numbers_[static_cast<std::size_t>(index)];
  }
  /// The number that a node is, or nullptr.
  [[nodiscard]] const rational* value(node_id i) const {
    return nodes_[i].what == operation::number ? &number_at(nodes_[i].number) : nullptr;
  }

  node_id root = 0;

 private:
  /// Any order will do; by size it would cost products of long numbers.
  struct by_parts {
    bool operator()(const rational& x, const rational& y) const {
      const mpq_srcptr a = x.backend().data();
      const mpq_srcptr b = y.backend().data();
      const int below = mpz_cmp(mpq_denref(a), mpq_denref(b));
      return below < 0 || (below == 0 && mpz_cmp(mpq_numref(a), mpq_numref(b)) < 0);
    }
  };
  [[nodiscard]] node_id plain(const node& n);

  std::shared_ptr<const further_functions> further_;
  std::vector<node> nodes_;
  std::vector<further_call> calls_;
  std::map<further_call, node_id> known_calls_;
  std::deque<rational> numbers_;  // whose elements stay where they are
  std::map<node, node_id> known_;
  std::map<rational, node_id, by_parts> known_numbers_;
};

// The operators.
[[nodiscard]] node_id add(graph& g, node_id x, node_id y);
[[nodiscard]] node_id subtract(graph& g, node_id x, node_id y);
[[nodiscard]] node_id multiply(graph& g, node_id x, node_id y);
[[nodiscard]] node_id divide(graph& g, node_id x, node_id y);
[[nodiscard]] node_id negate(graph& g, node_id x);
/// x^n for an integer y = n, for every x, with x^0 = 1; x^y for x > 0, and 0 for x = 0 < y, else.
[[nodiscard]] node_id power(graph& g, node_id x, node_id y);
/// Of a number that is an integer >= 0.
[[nodiscard]] node_id factorial(graph& g, node_id x);
/// x!! = x (x-2) (x-4) ..., the product down to 1 or 2.
node_id double_factorial(graph& g, node_id x);

/// Made of several analytic functions: abs, min, max, floor and ceil.
[[nodiscard]] bool is_piecewise(operation what);
/// Of a ring of functions: the variable, its negatives, sums, differences and products.
[[nodiscard]] bool is_of_ring(operation what);
/// The operands of a node, each once.
[[nodiscard]] std::vector<node_id> operands_at(const graph& g, node_id i);
/// The nodes that the root depends on, as a mark for each.
[[nodiscard]] std::vector<char> reachable(const graph& g);
/// Those of them that depend on a variable.
[[nodiscard]] std::vector<char> varying(const graph& g);

/// The exponent of the root, or of the power with an exponent that is no whole number, at a node.
[[nodiscard]] std::optional<rational> fractional_exponent_at(const graph& g, node_id i);

/// The operation at a node of `from` as it stands, of the operands in `to` that `operand` names; no
/// number and no variable.
[[nodiscard]] node_id with_operands(graph& to, const graph& from, node_id i,
                                    const std::function<node_id(node_id)>& operand);

/// Copies what the root of `from` is made of into `to`, as it stands. Returns where each node of
/// `from` is in `to`. Throws std::invalid_argument where there is a variable.
[[nodiscard]] std::vector<node_id> copied_into(graph& to, const graph& from);

/// The graph's root in instructions.
[[nodiscard]] program compile(const graph& g, std::size_t variables);
[[nodiscard]] std::string to_text(const graph& g, const std::vector<std::string>& variables);

/// A number for a message: whole where short.
[[nodiscard]] std::string brief(const rational& q);

/// The row of a function in the table, as the reader needs it.
struct function_row {
  expression_function what;
  int arity;
  /// Throws undefined_operation.
  node_id (*build)(graph&, const std::vector<node_id>&);
};
[[nodiscard]] const std::vector<function_row>& function_rows();
struct constant_row {
  expression_constant what;
  node_id (*build)(graph&);
};
[[nodiscard]] const std::vector<constant_row>& constant_rows();
/// nullptr where there is none of that name.
[[nodiscard]] const function_row* find_function(std::string_view name);
[[nodiscard]] const constant_row* find_constant(std::string_view name);
/// Whether a further function has the name; the one of so many arguments, or nullptr.
[[nodiscard]] bool has_further(const further_functions* further, std::string_view name);
[[nodiscard]] const further_function* find_further(const further_functions* further,
                                                   std::string_view name, std::size_t arity);

/// q + r pi where a node is a short sum of numbers and multiples of pi.
[[nodiscard]] std::optional<pi_combination> known_value(const graph& g, node_id i);

/// Reads a text into the graph; names are those of variables and definitions.
[[nodiscard]] node_id read_expression(graph& g, std::string_view text,
                                      const std::map<std::string, node_id, std::less<>>& names);

}  // namespace polhode::detail
