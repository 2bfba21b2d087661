#pragma once

// A recording, evaluated.

#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "polhode/arithmetic/analytic_ball.hpp"
#include "polhode/arithmetic/generic_function.hpp"
#include "polhode/quadrature/contour.hpp"
#include "quadrature/formula/recorded.hpp"

namespace polhode::detail {

/// Of each node the branch that is taken: of abs 1 where the operand is >= 0, else -1; of min and
/// max the sign of left - right; of floor and ceil the value. Nothing where the node is left as it
/// is.
using choices = std::vector<std::optional<long>>;

/// f of x, or of x and y.
[[nodiscard]] ball of_further(const further_function& f, const ball& x, const ball& y);
[[nodiscard]] slope_jet of_further(const further_function& f, const slope_jet& x,
                                   const slope_jet& y);
[[nodiscard]] region of_further(const further_function& f, const region& x, const region& y);
[[nodiscard]] end_series of_further(const further_function& f, const end_series& x,
                                    const end_series& y);
[[nodiscard]] tail_series of_further(const further_function& f, const tail_series& x,
                                     const tail_series& y);

inline ball operate(const recorded_operation& op, const ball& x, const ball& y, long n) {
  return op.further != nullptr ? of_further(*op.further, x, y) : op.on_balls(x, y, n);
}
inline slope_jet operate(const recorded_operation& op, const slope_jet& x, const slope_jet& y,
                         long n) {
  return op.further != nullptr ? of_further(*op.further, x, y) : op.on_jets(x, y, n);
}
inline region operate(const recorded_operation& op, const region& x, const region& y, long n) {
  return op.further != nullptr ? of_further(*op.further, x, y) : op.on_regions(x, y, n);
}
inline end_series operate(const recorded_operation& op, const end_series& x, const end_series& y,
                          long n) {
  return op.further != nullptr ? of_further(*op.further, x, y) : op.on_series(x, y, n);
}
inline tail_series operate(const recorded_operation& op, const tail_series& x, const tail_series& y,
                           long n) {
  return op.further != nullptr ? of_further(*op.further, x, y) : op.on_tails(x, y, n);
}

/// Undefined where it has none.
inline analytic_ball operate(const recorded_operation& op, const analytic_ball& x,
                             const analytic_ball& y, long n) {
  if (op.on_complex == nullptr) return analytic_ball(complex_ball::undefined(x.precision()));
  return op.on_complex(x, y, n);
}

/// A number beside x.
template <class T, class N>
T constant_beside(const T& x, const N& n) {
  return value_as<T>(n, x);
}
template <class N>
end_series constant_beside(const end_series& x, const N& n) {
  return x.is_blocked() ? x : x.constant_like(n);
}
template <class N>
analytic_ball constant_beside(const analytic_ball& x, const N& n) {
  return analytic_ball(complex_ball(value_as<ball>(n, ball(0, x.precision()))));
}

inline ball power_of(const ball& x, const rational& e) { return pow(x, e); }
inline slope_jet power_of(const slope_jet& x, const rational& e) {
  return pow(x, ball(e, x[0].precision()));
}
inline region power_of(const region& x, const rational& e) { return pow(x, e); }
inline end_series power_of(const end_series& x, const rational& e) { return pow(x, e); }
inline tail_series power_of(const tail_series& x, const rational& e) { return pow(x, e); }
inline analytic_ball power_of(const analytic_ball& x, const rational& e) { return pow(x, e); }
template <class T>
T power(const T& x, const rational& e) {
  if (denominator(e) == 1 && abs(numerator(e)) < 1L << 40) {
    return pow(x, static_cast<long>(numerator(e)));
  }
  return power_of(x, e);
}

/// The values of the nodes at x, made one after the other.
template <class T>
class evaluation {
 public:
  evaluation(const recorded_nodes& nodes, T x) : nodes_(nodes), x_(std::move(x)) {
    values_.resize(nodes.size());
  }
  /// The argument, where nodes were made that do not depend on it.
  void set_argument(const T& x) { x_ = x; }
  /// Node i; a piecewise one by its branch, where that is given.
  void step(std::size_t i, const std::optional<long>& branch) {
    const recorded_node& node = nodes_[i];
    if (node.is_piecewise()) {
      if constexpr (std::same_as<T, analytic_ball>) {
        values_[i] = T(complex_ball::undefined(x_.precision()));  // it has none of these
      } else {
        step_piecewise(node, branch, values_[i]);
      }
      return;
    }
    const T& left = values_[node.left];
    const T& right = values_[node.right];
    T& value = values_[i];
    switch (node.what) {
      case recorded_node::kind::argument:
        value = x_;
        return;
      case recorded_node::kind::constant:
        value = node.exact ? constant_beside(x_, *node.exact) : constant_beside(x_, node.enclosure);
        return;
      case recorded_node::kind::function:
        value = operate(node.operation, left, right, node.number);
        return;
      case recorded_node::kind::power:
        value = power(left, *node.exact);
        return;
      default:
        return;
    }
  }
  [[nodiscard]] const T& operator[](std::size_t i) const { return values_[i]; }
  [[nodiscard]] T& operator[](std::size_t i) { return values_[i]; }

 private:
  void step_piecewise(const recorded_node& node, const std::optional<long>& branch, T& value) {
    const T& left = values_[node.left];
    const T& right = values_[node.right];
    switch (node.what) {
      case recorded_node::kind::abs:
        value = branch ? (*branch > 0 ? left : -left) : abs(left);
        return;
      case recorded_node::kind::min:
        value = branch ? (*branch > 0 ? right : left) : min(left, right);
        return;
      case recorded_node::kind::max:
        value = branch ? (*branch > 0 ? left : right) : max(left, right);
        return;
      case recorded_node::kind::floor:
        value = branch ? constant_beside(x_, rational(*branch)) : floor(left);
        return;
      case recorded_node::kind::ceil:
        value = branch ? constant_beside(x_, rational(*branch)) : ceil(left);
        return;
      default:
        return;
    }
  }

  const recorded_nodes& nodes_;
  T x_;
  std::vector<T> values_;
};

/// f's recording, with its constants to as many bits as are asked for; safe to be used by several
/// threads.
class formula {
 public:
  explicit formula(std::function<recorded(const recorded& x, precision p)> record)
      : record_(std::move(record)), first_(record_(recorded::argument(), least_bits)) {
    const recorded_nodes& nodes = first_.nodes();
    needed_.resize(nodes.size());
    needed_[first_.node()] = true;
    for (std::size_t i = nodes.size(); i-- > 0;) {
      const recorded_node& node = nodes[i];
      if (!needed_[i] || node.what == recorded_node::kind::argument ||
          node.what == recorded_node::kind::constant)
        continue;
      needed_[node.left] = needed_[node.right] = true;
      if (node.is_piecewise()) needed_[node.decider] = true;
      if (node.is_piecewise()) has_breaks_ = true;
    }
  }

  [[nodiscard]] std::size_t size() const { return needed_.size(); }
  [[nodiscard]] std::size_t result() const { return first_.node(); }
  /// The result is made of it.
  [[nodiscard]] bool needs(std::size_t i) const { return needed_[i]; }
  [[nodiscard]] bool has_breaks() const { return has_breaks_; }
  [[nodiscard]] const recorded_node& node(std::size_t i) const { return first_.nodes()[i]; }

  [[nodiscard]] const recorded_nodes& at(precision p) const {
    if (p <= least_bits) return first_.nodes();
    precision bits = 2 * least_bits;
    while (bits < p) bits *= 2;
    const std::lock_guard lock(mutex_);
    const auto found = precise_.find(bits);
    if (found != precise_.end()) return found->second.nodes();
    const recorded again = record_(recorded::argument(), bits);
    // What is said of a node by its number is said of the same node.
    bool same = again.nodes().size() == size() && again.node() == result();
    for (std::size_t i = 0; same && i < size(); ++i) {
      const recorded_node& x = node(i);
      const recorded_node& y = again.nodes()[i];
      same = x.what == y.what && x.left == y.left && x.right == y.right && x.decider == y.decider &&
             x.operation == y.operation && x.number == y.number;
    }
    return precise_.emplace(bits, same ? again : first_).first->second.nodes();
  }

 private:
  static constexpr precision least_bits = 192;
  std::function<recorded(const recorded& x, precision p)> record_;
  recorded first_;
  std::vector<bool> needed_;
  bool has_breaks_ = false;
  mutable std::mutex mutex_;
  mutable std::map<precision, recorded> precise_;
};

/// Nodes up to the last, with these branches.
template <class T>
evaluation<T> evaluate(const formula& f, precision p, const T& x, const choices& chosen,
                       std::size_t last) {
  evaluation<T> values(f.at(p), x);
  for (std::size_t i = 0; i <= last; ++i) {
    if (f.needs(i)) values.step(i, chosen[i]);
  }
  return values;
}

}  // namespace polhode::detail
