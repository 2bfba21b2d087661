// A formula with divisors that grow exponentially for x -> inf, written by exponentials that decay:
// 1/sinh(x) as 2 exp(-x)/(1 - exp(-2 x)). Over sets of large x exp(x) is any number of its size, 0
// among them, and exp(-x) is near 0.
//
// The reciprocal of what grows is followed through the formula: with v = 1/u,
//
//   1/(u w) = v/w,   1/(u/w) = v/(1/w),   1/u^n = v^n,   1/(u + w) = v/(1 + w v):
//
// these have values only where the left sides have. Where w grows, too, w v is v/(1/w) with the
// reciprocal that is followed, u being what seems to grow faster.

#include <cstdlib>
#include <optional>
#include <utility>
#include <vector>

#include "exact_value.hpp"
#include "graph.hpp"
#include "polhode/expression/expression.hpp"

namespace polhode {
namespace decaying_exponentials_impl {
namespace {

using detail::node;
using detail::node_id;
using detail::operation;

constexpr node_id most_nodes = 300;

class rewriting {
 public:
  explicit rewriting(detail::graph f)
      : g_(std::move(f)), size_(g_.root + 1), varies_(detail::varying(g_)) {}

  /// Nothing where no divisor grows.
  std::optional<node_id> result() {
    values_.resize(size_);
    inverses_.resize(size_);
    for (node_id i = 0; i < size_; ++i) {
      values_[i] = i;
      if (varies_[i] != 0 && g_[i].what != operation::variable) rewrite(i);
    }
    return has_changed_ ? std::optional(values_[g_.root]) : std::nullopt;
  }
  [[nodiscard]] const detail::graph& graph() const { return g_; }

 private:
  node_id exp_of(node_id x) { return detail::find_function("exp")->build(g_, {x}); }
  node_id one() { return g_.number(1); }
  /// 1 or -1 where u seems to tend to infinity or minus infinity.
  int direction(node_id u) {
    constexpr long far = 32;
    const ball value = detail::value_far_out(g_, u);
    return certainly_less(ball(far, 64), value)    ? 1
           : certainly_less(value, ball(-far, 64)) ? -1
                                                   : 0;
  }
  /// 1/x, where x does not grow.
  node_id plain_inverse(node_id i) { return divide(g_, one(), values_[i]); }
  std::optional<node_id> with_change(node_id x) {
    has_changed_ = true;
    return x;
  }

  void rewrite(node_id i) {
    const node n = g_[i];  // a copy: the graph grows
    static const std::optional<node_id> none;
    const bool is_call = n.what == operation::further;
    const std::optional<node_id>& x = is_call ? none : inverses_[n.left];
    const std::optional<node_id>& y =
        is_call || operands_of(n.what) < 2 ? none : inverses_[n.right];
    std::optional<node_id> value;
    switch (n.what) {
      case operation::exp:
      case operation::sinh:
      case operation::cosh:
        inverses_[i] = inverse_of_exponential(n);
        break;
      case operation::negate:
        if (x) inverses_[i] = negate(g_, *x);
        break;
      case operation::multiply:
        if (x || y) {
          inverses_[i] =
              multiply(g_, x ? *x : plain_inverse(n.left), y ? *y : plain_inverse(n.right));
        }
        break;
      case operation::divide:
        if (y) {
          value = with_change(multiply(g_, values_[n.left], *y));
        } else if (x) {
          // Not v w, which has a value where w = 0 and u/w has none.
          inverses_[i] = divide(g_, *x, plain_inverse(n.right));
        }
        break;
      case operation::power_integer: {
        if (!x || n.number == 0) break;
        const node_id power_of_inverse = power(g_, *x, g_.number(std::abs(n.number)));
        if (n.number < 0) {
          value = with_change(power_of_inverse);
        } else {
          inverses_[i] = power_of_inverse;
        }
        break;
      }
      case operation::power:
        inverses_[i] = inverse_of_power(n);
        break;
      case operation::add:
      case operation::subtract:
        inverses_[i] = inverse_of_sum(n, x, y);
        break;
      default:
        break;
    }
    values_[i] =
        value ? *value : detail::with_operands(g_, g_, i, [&](node_id k) { return values_[k]; });
  }
  /// exp(u) for a growing u; sinh(u) and cosh(u) for a growing or falling one.
  std::optional<node_id> inverse_of_exponential(const node& n) {
    const int s = direction(n.left);
    if (s == 0 || (s < 0 && n.what == operation::exp)) return std::nullopt;
    const node_id u = s > 0 ? values_[n.left] : negate(g_, values_[n.left]);
    const node_id small = exp_of(negate(g_, u));
    if (n.what == operation::exp) return small;
    const node_id square = multiply(g_, small, small);
    const node_id twice = multiply(g_, g_.number(2), small);
    if (n.what == operation::cosh) return divide(g_, twice, add(g_, one(), square));
    return divide(g_, s > 0 ? twice : negate(g_, twice), subtract(g_, one(), square));
  }
  /// c^u for a constant c, which is positive where u log c has a value.
  std::optional<node_id> inverse_of_power(const node& n) {
    if (varies_[n.left] != 0 || varies_[n.right] == 0) return std::nullopt;
    const node_id u = multiply(g_, detail::find_function("log")->build(g_, {n.left}), n.right);
    if (direction(u) <= 0) return std::nullopt;
    return power(g_, values_[n.left], negate(g_, values_[n.right]));
  }
  /// Of a sum or difference of the operands, of which x and y are the reciprocals where they grow.
  std::optional<node_id> inverse_of_sum(const node& n, const std::optional<node_id>& x,
                                        const std::optional<node_id>& y) {
    if (!x && !y) return std::nullopt;
    const bool is_difference = n.what == operation::subtract;
    // u/w as (1/w)/(1/u).
    const auto is_faster = [&](node_id v, node_id w) { return direction(divide(g_, w, v)) != 0; };
    const bool is_left = x && (!y || is_faster(*x, *y));
    if (x && y && !is_left && !is_faster(*y, *x)) return std::nullopt;
    const node_id v = is_left ? *x : *y;
    const std::optional<node_id>& inverse_of_other = is_left ? y : x;
    const node_id other = values_[is_left ? n.right : n.left];
    const node_id ratio =
        inverse_of_other ? divide(g_, v, *inverse_of_other) : multiply(g_, other, v);
    const node_id sum = is_difference ? subtract(g_, one(), ratio) : add(g_, one(), ratio);
    const node_id result = divide(g_, v, sum);
    return is_difference && !is_left ? negate(g_, result) : result;
  }

  detail::graph g_;
  node_id size_;
  std::vector<char> varies_;
  std::vector<node_id> values_;
  std::vector<std::optional<node_id>> inverses_;
  bool has_changed_ = false;
};

}  // namespace
}  // namespace decaying_exponentials_impl

std::optional<expression> expression::with_decaying_exponentials() const {
  if (variables_.size() != 1 || graph_->root >= decaying_exponentials_impl::most_nodes) {
    return std::nullopt;
  }
  try {
    decaying_exponentials_impl::rewriting f(*graph_);
    const auto found = f.result();
    return found ? std::optional(with_root(f.graph(), *found)) : std::nullopt;
  } catch (const detail::undefined_operation&) {
    return std::nullopt;  // an operation has no value anywhere
  }
}

}  // namespace polhode
