// A formula in u = exp(c x) in place of x, where circular functions stand over exponentials of x:
// the oscillations of sin(exp(x)), which are ever faster, are those of sin(u).
//
// With x = log(u)/c and dx = du/(c u), each step is an identity of real functions of u > 0:
//   exp(k c x + v) = e^v u^k for a whole number k,   b^w = exp(w log b) for b > 0,
//   sinh w = (exp(w) - exp(-w))/2,   cosh w = (exp(w) + exp(-w))/2,   expm1(w) = exp(w) - 1.

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "exact_value.hpp"
#include "exponential_sum.hpp"

namespace polhode {
namespace by_exponential_impl {
namespace {

using detail::node;
using detail::node_id;
using detail::operation;

constexpr node_id most_nodes = 500;
constexpr long greatest_power = 64;
constexpr precision bits = 128;

class substitution {
 public:
  explicit substitution(detail::graph f)
      : g_(std::move(f)), size_(g_.root + 1), varies_(detail::varying(g_)) {}

  /// The slope c and the formula, as nodes of graph(). Throws detail::undefined_operation where an
  /// operation has no value anywhere.
  std::optional<std::pair<node_id, node_id>> result() {
    if (!find_exponents() || !find_slope()) return std::nullopt;
    const node_id u = g_.variable(0);
    const node_id x = divide(g_, call("log", u), slope_);
    std::vector<node_id> places(size_);
    for (node_id i = 0; i < size_; ++i) {
      if (varies_[i] == 0) {
        places[i] = i;
      } else if (i == u) {
        places[i] = x;
      } else {
        const auto known =
            std::ranges::find(exponentials_, i, [](const exponential& e) { return e.of; });
        places[i] = known != exponentials_.end()
                        ? in_u(*known)
                        : detail::with_operands(g_, g_, i, [&](node_id k) { return places[k]; });
      }
    }
    return std::pair(slope_, divide(g_, places[g_.root], multiply(g_, slope_, u)));
  }
  [[nodiscard]] const detail::graph& graph() const { return g_; }

 private:
  /// Of exp(slope x + rest), or of a function made of it.
  struct exponential {
    node_id of;
    bool turns;  // under a sine or cosine
    node_id slope;
    node_id rest;
    long power = 0;  // of u
  };

  /// Whether every exponential is that of a linear form, and circular functions stand over one.
  bool find_exponents() {
    std::vector<char> turns(size_, 0);  // whether a node stands under a circular function
    for (node_id i = size_; i-- > 0;) {
      if (turns[i] == 0 && g_[i].what != operation::sin && g_[i].what != operation::cos) continue;
      for (const node_id k : detail::operands_at(g_, i)) turns[k] = varies_[i];
    }
    for (node_id i = 0; i < size_; ++i) {
      if (varies_[i] == 0) continue;
      const node n = g_[i];
      std::optional<node_id> exponent;
      switch (n.what) {
        case operation::exp:
        case operation::expm1:
        case operation::sinh:
        case operation::cosh:
          exponent = n.left;
          break;
        case operation::power:
          if (varies_[n.right] == 0) break;
          if (varies_[n.left] != 0 || !is_positive(n.left)) return false;
          exponent = multiply(g_, n.right, call("log", n.left));
          break;
        default:
          break;
      }
      if (!exponent) continue;
      const auto form = detail::polynomial_in_variable(g_, *exponent);
      if (!form || form->size() != 2) return false;
      exponentials_.push_back({i, turns[i] != 0, (*form)[1], (*form)[0]});
    }
    return std::ranges::any_of(exponentials_, &exponential::turns);
  }

  /// c: the slopes are whole multiples of it, and a positive one is that of the exponential under a
  /// sine or cosine that has the greatest slope in size.
  bool find_slope() {
    const node_id first = exponentials_.front().slope;
    std::vector<rational> ratios;
    rational greatest = 0;
    for (const exponential& e : exponentials_) {
      const auto ratio = detail::rational_value_at(g_, divide(g_, e.slope, first));
      if (!ratio || *ratio == 0) return false;
      ratios.push_back(*ratio);
      if (e.turns && abs(*ratio) > abs(greatest)) greatest = *ratio;
    }
    integer common = 1;
    for (const rational& q : ratios) common = lcm(common, denominator(q));
    integer steps = 0;
    for (const rational& q : ratios) steps = gcd(steps, numerator(rational(q * common)));
    if (greatest < 0) steps = -steps;
    for (std::size_t i = 0; i < ratios.size(); ++i) {
      const rational power = ratios[i] * common / steps;
      if (abs(power) > greatest_power) return false;
      exponentials_[i].power = static_cast<long>(numerator(power));
    }
    slope_ = multiply(g_, first, g_.number(rational(steps, common)));
    return true;
  }

  node_id in_u(const exponential& e) {
    const node_id power = detail::power(g_, g_.variable(0), g_.number(e.power));
    const node_id grown = multiply(g_, call("exp", e.rest), power);
    const auto half_of = [&](node_id w) { return multiply(g_, g_.number(rational(1, 2)), w); };
    switch (g_[e.of].what) {
      case operation::expm1:
        return subtract(g_, grown, g_.number(1));
      case operation::sinh:
        return half_of(subtract(g_, grown, divide(g_, g_.number(1), grown)));
      case operation::cosh:
        return half_of(add(g_, grown, divide(g_, g_.number(1), grown)));
      default:
        return grown;
    }
  }

  node_id call(const char* function, node_id x) {
    return detail::find_function(function)->build(g_, {x});
  }
  bool is_positive(node_id c) { return certainly_positive(detail::value_at(g_, c, bits)); }

  detail::graph g_;
  node_id size_;
  std::vector<char> varies_;
  std::vector<exponential> exponentials_;
  node_id slope_ = 0;
};

}  // namespace
}  // namespace by_exponential_impl

std::optional<expression::of_exponential> expression::by_exponential() const {
  if (variables_.size() != 1 || graph_->root >= by_exponential_impl::most_nodes ||
      !detail::has_circular_functions(*graph_)) {
    return std::nullopt;
  }
  try {
    by_exponential_impl::substitution s(*graph_);
    const auto found = s.result();
    if (!found) return std::nullopt;
    expression slope = with_root(s.graph(), found->first);
    slope.variables_.clear();
    return of_exponential{std::move(slope), with_root(s.graph(), found->second)};
  } catch (const detail::undefined_operation&) {
    return std::nullopt;
  }
}

}  // namespace polhode
