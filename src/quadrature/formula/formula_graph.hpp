#pragma once

// The operations of a formula, each once and after its operands, for those who walk them.
//
// They are the expression's own instructions (program.hpp). abs, min, max, floor and ceil are made
// of several analytic functions each. A formula is evaluated here with a branch of each of them, of
// which somebody proved that it holds on a piece of the range (breaks.hpp). The result is the
// analytic continuation of f from that piece.

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "polhode/arithmetic/generic_function.hpp"
#include "polhode/arithmetic/jet.hpp"
#include "polhode/arithmetic/region.hpp"
#include "polhode/expression/expression.hpp"
#include "quadrature/ends/end_series.hpp"

namespace polhode::detail {

using slope_jet = jet<ball, 1>;

struct formula_node {
  /// operation::variable for the argument, operation::number for a constant of whatever kind.
  operation what = operation::variable;
  /// The numbers of the first and of the last operand's node.
  std::size_t left = 0;
  std::size_t right = 0;
  /// The node whose value decides the branch: of abs, floor and ceil the operand, of min and max
  /// left - right.
  std::size_t decider = 0;
  /// As in an instruction; the place of a constant among the constants, of a call among the calls.
  long number = 0;
  /// A constant's value, where that is known to be rational.
  std::optional<rational> exact = std::nullopt;

  [[nodiscard]] bool is_argument() const { return what == operation::variable; }
  [[nodiscard]] bool is_constant() const { return what == operation::number; }
  [[nodiscard]] bool is_leaf() const { return is_argument() || is_constant(); }
  [[nodiscard]] bool is_call() const { return what == operation::further; }
  [[nodiscard]] bool is_exponential() const {
    return what == operation::exp || what == operation::sinh || what == operation::cosh ||
           what == operation::tanh;
  }
  [[nodiscard]] bool is_circular() const {
    return what == operation::sin || what == operation::cos || what == operation::tan ||
           what == operation::sinpi || what == operation::cospi;
  }
  [[nodiscard]] bool is_piecewise() const {
    return what == operation::abs || what == operation::min || what == operation::max ||
           what == operation::floor || what == operation::ceil;
  }
};

/// A formula of at most one variable. Several threads may use one.
class formula_graph {
 public:
  using constants = std::vector<possibly_exact_constant>;

  explicit formula_graph(expression f);

  [[nodiscard]] std::size_t size() const { return nodes_.size(); }
  /// The node of the formula's value.
  [[nodiscard]] std::size_t result() const { return result_; }
  [[nodiscard]] bool has_breaks() const { return has_breaks_; }
  /// The argument is node 0.
  [[nodiscard]] const formula_node& node(std::size_t i) const { return nodes_[i]; }
  /// The function and the operands of a call.
  struct call {
    const further_function* function;
    std::vector<std::size_t> operands;
  };
  [[nodiscard]] const call& call_at(const formula_node& node) const {
    return calls_[static_cast<std::size_t>(node.number)];
  }
  /// Calls f(k) for the number k of each operand of the node.
  template <class F>
  void for_each_operand(const formula_node& node, F&& f) const {
    if (node.is_leaf()) return;
    if (node.is_call()) {
      for (const std::size_t k : call_at(node).operands) f(k);
      return;
    }
    f(node.left);
    if (node.right != node.left) f(node.right);
  }
  /// With at least p bits.
  [[nodiscard]] std::shared_ptr<const constants> constants_at(precision p) const;

 private:
  [[nodiscard]] std::size_t added(const formula_node& node);
  [[nodiscard]] std::size_t added_choice(formula_node node);
  /// The node of x - y.
  [[nodiscard]] std::size_t difference(std::size_t x, std::size_t y);
  [[nodiscard]] bool is_zero(std::size_t i) const {
    return nodes_[i].exact && *nodes_[i].exact == 0;
  }

  expression f_;
  std::vector<formula_node> nodes_;
  std::vector<call> calls_;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> differences_;  // by their operands
  std::size_t result_ = 0;
  bool has_breaks_ = false;
  mutable std::mutex mutex_;
  mutable std::map<precision, std::shared_ptr<const constants>> constants_;
};

/// The node's operation of its operands (evaluation.hpp), compiled for those T that are declared
/// below.
template <class T>
[[nodiscard]] T value_of_operation(const formula_node& node, const T& x, const T& y);
template <class T>
[[nodiscard]] T value_of_call(const further_function& f, const std::vector<T>& operands);

#define POLHODE_DECLARED_FOR(T)                                                              \
  extern template T value_of_operation<T>(const formula_node& node, const T& x, const T& y); \
  extern template T value_of_call<T>(const further_function& f, const std::vector<T>& operands);
POLHODE_DECLARED_FOR(ball)
POLHODE_DECLARED_FOR(slope_jet)
POLHODE_DECLARED_FOR(region)
POLHODE_DECLARED_FOR(end_series)
#undef POLHODE_DECLARED_FOR

/// The value of an operation or a call; operand(k) is the value of node k.
template <class T, class Operand>
[[nodiscard]] T value_of_node(const formula_graph& f, const formula_node& node,
                              const Operand& operand) {
  if (!node.is_call()) return value_of_operation<T>(node, operand(node.left), operand(node.right));
  const formula_graph::call& call = f.call_at(node);
  std::vector<T> operands;
  operands.reserve(call.operands.size());
  for (const std::size_t k : call.operands) operands.push_back(operand(k));
  return value_of_call<T>(*call.function, operands);
}

/// A number beside x.
template <class T>
[[nodiscard]] T constant_beside(const T& x, const possibly_exact_constant& c) {
  if constexpr (std::same_as<T, end_series>) {
    if (x.is_blocked()) return x;
    return std::visit([&](const auto& n) { return x.constant_like(n); }, c);
  } else {
    if (const rational* q = std::get_if<rational>(&c)) return value_as<T>(*q, x);
    return value_as<T>(std::get<known_number>(c).enclosure(), x);
  }
}

/// Of each node the branch that is taken: of abs 1 where the operand is >= 0, else -1; of min and
/// max the sign of left - right; of floor and ceil the value. Nothing where the node is left as it
/// is.
using choices = std::vector<std::optional<long>>;

/// The values of the nodes at x, made one after the other.
template <class T>
class evaluation {
 public:
  evaluation(const formula_graph& f, precision p, T x)
      : f_(&f), constants_(f.constants_at(p)), x_(std::move(x)), values_(f.size()) {}
  /// The argument, where nodes were made that do not depend on it.
  void set_argument(const T& x) { x_ = x; }
  /// Node i; a piecewise one by its branch, where that is given.
  void step(std::size_t i, const std::optional<long>& branch) {
    const formula_node& node = f_->node(i);
    if (node.is_argument()) {
      values_[i] = x_;
    } else if (node.is_constant()) {
      values_[i] = constant_beside(x_, (*constants_)[static_cast<std::size_t>(node.number)]);
    } else if (branch && node.is_piecewise()) {
      values_[i] = on_branch(node, *branch);
    } else {
      values_[i] = value_of_node<T>(*f_, node, *this);
    }
  }
  [[nodiscard]] const T& operator()(std::size_t i) const { return values_[i]; }
  [[nodiscard]] const T& operator[](std::size_t i) const { return values_[i]; }
  [[nodiscard]] T& operator[](std::size_t i) { return values_[i]; }

 private:
  [[nodiscard]] T on_branch(const formula_node& node, long branch) const {
    const T& left = values_[node.left];
    const T& right = values_[node.right];
    switch (node.what) {
      case operation::abs:
        return branch > 0 ? left : -left;
      case operation::min:
        return branch > 0 ? right : left;
      case operation::max:
        return branch > 0 ? left : right;
      default:  // floor and ceil
        return constant_beside(x_, rational(branch));
    }
  }

  const formula_graph* f_;
  std::shared_ptr<const formula_graph::constants> constants_;
  T x_;
  std::vector<T> values_;
};

/// Nodes up to the last, with these branches and constants to p bits.
template <class T>
[[nodiscard]] evaluation<T> evaluate(const formula_graph& f, precision p, const T& x,
                                     const choices& chosen, std::size_t last) {
  evaluation<T> values(f, p, x);
  for (std::size_t i = 0; i <= last; ++i) values.step(i, chosen[i]);
  return values;
}

}  // namespace polhode::detail
