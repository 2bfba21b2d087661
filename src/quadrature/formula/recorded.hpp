#pragma once

// Records a function's operations by calling it once.
//
// Call a generic function with a `recorded` number for its argument: each operation becomes a node,
// which knows how it is done over balls, jets of balls, regions and series. So abs, min, max, floor
// and ceil, the functions that are made of several analytic ones, can be told apart, and evaluated
// again with a branch of each that was proved to be the one that holds on a piece of the range
// (breaks.hpp in src/quadrature): the result is the analytic continuation of f from that piece.
//
// The same operation of the same nodes is one node; so |t|/t has one t. Exact numbers are kept
// exactly. A ball is one unknown number of its set each time that it is met: two nodes.

#include <memory>
#include <optional>
#include <vector>

#include "polhode/arithmetic/analytic_ball.hpp"
#include "polhode/arithmetic/jet.hpp"
#include "polhode/arithmetic/region.hpp"
#include "polhode/expression/functions.hpp"
#include "quadrature/ends/end_series.hpp"
#include "quadrature/ends/tail_series.hpp"

namespace polhode {

namespace detail {

using slope_jet = jet<ball, 1>;

/// What an operation is, for those who take a formula apart (hyperexponential.hpp, oscillation.hpp
/// and poles.hpp in src/quadrature).
enum class recorded_rule : std::uint8_t {
  other,
  negative,
  sum,
  difference,
  product,
  quotient,
  square,
  sqrt,
  root,   // the number-th
  power,  // left to the power right
  exp,
  sinh,
  cosh,
  tanh,
  sin,
  cos,
  tan,
  sinpi,
  cospi
};

/// One operation of at most two operands and an integer, in each arithmetic.
struct recorded_operation {
  ball (*on_balls)(const ball& x, const ball& y, long n) = nullptr;
  slope_jet (*on_jets)(const slope_jet& x, const slope_jet& y, long n) = nullptr;
  region (*on_regions)(const region& x, const region& y, long n) = nullptr;
  end_series (*on_series)(const end_series& x, const end_series& y, long n) = nullptr;
  tail_series (*on_tails)(const tail_series& x, const tail_series& y, long n) = nullptr;
  /// Where it is the function that on_regions is of; else null.
  analytic_ball (*on_complex)(const analytic_ball& x, const analytic_ball& y, long n) = nullptr;
  recorded_rule rule = recorded_rule::other;
  /// Not null: this function of the first operands, in place of those above.
  const further_function* further = nullptr;

  /// Of a generic function object without a state.
  template <class F>
  [[nodiscard]] static recorded_operation of(F) {
    return {[](const ball& x, const ball& y, long n) { return F{}(x, y, n); },
            [](const slope_jet& x, const slope_jet& y, long n) { return F{}(x, y, n); },
            [](const region& x, const region& y, long n) { return F{}(x, y, n); },
            [](const end_series& x, const end_series& y, long n) { return F{}(x, y, n); },
            [](const tail_series& x, const tail_series& y, long n) { return F{}(x, y, n); }};
  }
  /// Of one that analytic balls have too.
  template <class F>
  [[nodiscard]] static recorded_operation analytic(F f, recorded_rule rule = recorded_rule::other) {
    recorded_operation result = of(f);
    result.on_complex = [](const analytic_ball& x, const analytic_ball& y, long n) {
      return F{}(x, y, n);
    };
    result.rule = rule;
    return result;
  }
  bool operator==(const recorded_operation&) const = default;
};

struct recorded_node {
  enum class kind : std::uint8_t {
    argument,
    constant,  // `exact`, or else `enclosure`
    function,  // `operation` of left, right and number
    power,     // left to the power `exact`
    // Made of several analytic functions: which of them holds depends on the value of the node
    // `decider`.
    abs,
    min,
    max,
    floor,
    ceil
  };
  kind what = kind::argument;
  std::size_t left = 0;
  std::size_t right = 0;
  std::size_t decider = 0;  // of abs, floor and ceil the operand, of min and max left - right
  recorded_operation operation;
  long number = 0;
  std::optional<rational> exact;
  ball enclosure;

  [[nodiscard]] bool is_piecewise() const { return what >= kind::abs; }
};

/// The nodes, each after its operands; the first is the argument.
using recorded_nodes = std::vector<recorded_node>;

}  // namespace detail

class recorded {
 public:
  /// Operators and functions take integers and rationals beside it; inexact_operand.hpp refuses the
  /// rest.
  static constexpr bool takes_exact_numbers = true;
  /// No number: to be assigned to.
  recorded() = default;
  /// The argument of a new recording.
  [[nodiscard]] static recorded argument();

  [[nodiscard]] const detail::recorded_nodes& nodes() const { return *nodes_; }
  /// The number of its node.
  [[nodiscard]] std::size_t node() const { return node_; }

  template <exact_number N>
  [[nodiscard]] recorded constant_like(const N& n) const {
    return constant(rational(n));
  }
  [[nodiscard]] recorded constant_like(const ball& x) const;
  /// op of this, y and n.
  [[nodiscard]] recorded applied(const detail::recorded_operation& op, const recorded& y,
                                 long n = 0) const;

  friend recorded operator+(const recorded& x) { return x; }
  friend recorded operator-(const recorded& x);
  friend recorded operator+(const recorded& x, const recorded& y);
  friend recorded operator-(const recorded& x, const recorded& y);
  friend recorded operator*(const recorded& x, const recorded& y);
  friend recorded operator/(const recorded& x, const recorded& y);
  recorded& operator+=(const recorded& y) { return *this = *this + y; }
  recorded& operator-=(const recorded& y) { return *this = *this - y; }
  recorded& operator*=(const recorded& y) { return *this = *this * y; }
  recorded& operator/=(const recorded& y) { return *this = *this / y; }

  friend recorded square(const recorded& x);
  friend recorded sqrt(const recorded& x);
  friend recorded pow(const recorded& x, long n);
  friend recorded pow(const recorded& x, const rational& e);
  friend recorded pow(const recorded& x, const recorded& y);
  friend recorded exp(const recorded& x);
  friend recorded log(const recorded& x);
  friend recorded sin(const recorded& x);
  friend recorded cos(const recorded& x);
  friend recorded tan(const recorded& x);
  friend recorded asin(const recorded& x);
  friend recorded acos(const recorded& x);
  friend recorded atan(const recorded& x);
  friend recorded sinh(const recorded& x);
  friend recorded cosh(const recorded& x);
  friend recorded tanh(const recorded& x);
  friend recorded asinh(const recorded& x);
  friend recorded acosh(const recorded& x);
  friend recorded atanh(const recorded& x);
  friend recorded abs(const recorded& x);
  friend recorded min(const recorded& x, const recorded& y);
  friend recorded max(const recorded& x, const recorded& y);
  friend recorded floor(const recorded& x);
  friend recorded ceil(const recorded& x);

 private:
  using kind = detail::recorded_node::kind;
  recorded(std::shared_ptr<detail::recorded_nodes> nodes, std::size_t node)
      : nodes_(std::move(nodes)), node_(node) {}
  [[nodiscard]] recorded constant(const rational& q) const;
  [[nodiscard]] recorded piecewise(kind what, const recorded& y, const recorded& decider) const;
  /// The node, or the one that is the same.
  [[nodiscard]] recorded added(detail::recorded_node node) const;

  std::shared_ptr<detail::recorded_nodes> nodes_;
  std::size_t node_ = 0;
};

template <detail::series_constant N>
[[nodiscard]] recorded operator+(const recorded& x, const N& n) {
  return x + x.constant_like(n);
}
template <detail::series_constant N>
[[nodiscard]] recorded operator+(const N& n, const recorded& x) {
  return x.constant_like(n) + x;
}
template <detail::series_constant N>
[[nodiscard]] recorded operator-(const recorded& x, const N& n) {
  return x - x.constant_like(n);
}
template <detail::series_constant N>
[[nodiscard]] recorded operator-(const N& n, const recorded& x) {
  return x.constant_like(n) - x;
}
template <detail::series_constant N>
[[nodiscard]] recorded operator*(const recorded& x, const N& n) {
  return x * x.constant_like(n);
}
template <detail::series_constant N>
[[nodiscard]] recorded operator*(const N& n, const recorded& x) {
  return x.constant_like(n) * x;
}
template <detail::series_constant N>
[[nodiscard]] recorded operator/(const recorded& x, const N& n) {
  return x / x.constant_like(n);
}
template <detail::series_constant N>
[[nodiscard]] recorded operator/(const N& n, const recorded& x) {
  return x.constant_like(n) / x;
}

}  // namespace polhode
