#pragma once

// What the nodes of a formula are, as functions of a variable y that takes the place of x.

#include <functional>
#include <optional>
#include <vector>

#include "hyperexponential_algebra.hpp"
#include "quadrature/formula/formula_graph.hpp"

namespace polhode::detail {

/// What the functions of x that a variable stands for are in it. Nothing for the others.
struct substitution {
  rational inside;
  /// Of node i, whose operand is an affine function of x, the form in y.
  std::function<maybe_sum(std::size_t i)> leaf;
};

/// Which nodes a node is made of, itself among them.
[[nodiscard]] std::vector<bool> parts_of_node(const formula_graph& f, std::size_t node);

/// The forms of nodes, each where it has one.
class forms {
 public:
  /// Of what the node `last` is made of.
  forms(const formula_graph& f, std::size_t last, const substitution& by)
      : f_(f), apart_(by.inside) {
    found_.resize(f.size());
    is_constant_.resize(f.size());
    const std::vector<bool> is_part = parts_of_node(f, last);
    for (std::size_t i = 0; i <= last; ++i) {
      if (!is_part[i]) continue;
      const formula_node& node = f.node(i);
      bool is_constant = !node.is_argument();
      f.for_each_operand(node,
                         [&](std::size_t k) { is_constant = is_constant && is_constant_[k]; });
      is_constant_[i] = is_constant;
      found_[i] = form_of(i, by);
      if (!found_[i] && is_constant_[i]) found_[i] = constant(i);
    }
  }
  [[nodiscard]] const maybe_sum& operator[](std::size_t i) const { return found_[i]; }

 private:
  /// Node i, a number that is not known to be rational.
  [[nodiscard]] maybe_sum constant(std::size_t i) const {
    constexpr precision p = 192;
    const choices none(f_.size());
    const ball value = evaluate(f_, p, ball(0, p), none, i)[i];
    if (!value.is_bounded() || contains_zero(value)) return std::nullopt;
    hyperexponential result = number(certainly_positive(value) ? 1 : -1);
    constant_power c;
    c.what = constant_power::kind::node;
    c.node = i;
    result.constants.push_back(c);
    return hyperexponential_sum{result};
  }

  [[nodiscard]] maybe_sum form_of(std::size_t i, const substitution& by) const {
    const formula_node& node = f_.node(i);
    if (node.is_constant()) {
      if (!node.exact) return std::nullopt;
      return hyperexponential_sum{number(*node.exact)};
    }
    if (node.is_piecewise()) return std::nullopt;
    if (!is_constant_[i]) {
      if (maybe_sum found = by.leaf(i)) return found;
    }
    if (node.is_argument()) return std::nullopt;
    const maybe_sum& x = found_[node.left];
    if (!x) return std::nullopt;
    const maybe_sum& y = found_[node.right];
    switch (node.what) {
      case operation::negate:
        return apart_.multiplied(*x, {number(-1)});
      case operation::add:
        return y ? apart_.added(*x, *y) : std::nullopt;
      case operation::subtract: {
        if (!y) return std::nullopt;
        const maybe_sum negative = apart_.multiplied(*y, {number(-1)});
        return negative ? apart_.added(*x, *negative) : std::nullopt;
      }
      case operation::multiply:
        return y ? apart_.multiplied(*x, *y) : std::nullopt;
      case operation::divide: {
        if (!y) return std::nullopt;
        const maybe_sum inverse = apart_.raised(*y, -1);
        return inverse ? apart_.multiplied(*x, *inverse) : std::nullopt;
      }
      case operation::power_integer:
        return raised(i, *x, node.number);
      case operation::sqrt:
        return raised(i, *x, rational(1, 2));
      case operation::root:
        return raised(i, *x, rational(1, node.number));
      case operation::power: {
        if (!y || !is_constant_[node.right]) return std::nullopt;
        const auto e = taking_apart::as_polynomial(*y);
        return e ? raised(i, *x, e->is_zero() ? rational(0) : e->leading()) : std::nullopt;
      }
      default:
        return std::nullopt;
    }
  }
  /// A root of a number is a number of its own, but where it is rational for other reasons.
  [[nodiscard]] maybe_sum raised(std::size_t i, const hyperexponential_sum& x,
                                 const rational& e) const {
    if (is_constant_[i] && !is_integer(e)) return std::nullopt;
    return apart_.raised(x, e);
  }

  const formula_graph& f_;
  taking_apart apart_;
  std::vector<maybe_sum> found_;
  std::vector<bool> is_constant_;
};

/// slope x + offset, of pi where the function has it.
struct affine {
  rational slope;
  rational offset;
};

/// Returns nullopt where the form is not affine in x.
[[nodiscard]] std::optional<affine> affine_of(const maybe_sum& form);

/// A rational number between x < y, as far as is known; nullopt where it would be a long one.
[[nodiscard]] std::optional<rational> between(const ball& x, const ball& y);
/// The same for a range without an end.
[[nodiscard]] std::optional<rational> beyond(const ball& x);

/// x = sign y, sign = 1 or -1. `plain` are the forms in x of what exponential and circular
/// functions are taken of.
[[nodiscard]] substitution argument_itself(const formula_graph& f, int sign, const rational& inside,
                                           const forms* plain);

}  // namespace polhode::detail
