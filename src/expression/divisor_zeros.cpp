// Zeros of a formula's divisors and of what stands under its roots and logarithms, and the poles of
// its tangents: found by inverting one operation after the other.

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "graph.hpp"

namespace polhode {
namespace divisor_zeros_impl {
namespace {

using detail::node_id;
using detail::operation;

constexpr std::size_t most_found = 64;
constexpr int most_steps = 64;      // from an operation to the variable
constexpr long most_exponent = 64;  // of a power that is inverted
constexpr double most_turns = 24;   // of an angle, each with zeros of its own

/// The values of a node over the range in question.
using values_of_node = std::function<double_interval(const detail::graph& g, node_id i)>;

class search {
 public:
  search(const detail::graph& f, values_of_node values)
      : g_(f),
        used_(detail::reachable(f)),
        varies_(detail::varying(f)),
        size_(f.size()),
        values_(std::move(values)) {}

  [[nodiscard]] std::vector<node_id> found() {
    for (node_id i = 0; i < size_; ++i) {
      if (used_[i] == 0 || varies_[i] == 0) continue;
      const detail::node n = g_[i];
      switch (n.what) {
        case operation::divide:
          vanish(n.right);
          break;
        case operation::power_integer:
          if (n.number < 0) vanish(n.left);
          break;
        case operation::power:
        case operation::root:
        case operation::sqrt:
        case operation::log:
          vanish(n.left);
          break;
        case operation::tan:
          solve_angle(n.left, divide(g_, g_.make(operation::pi), g_.number(2)), 1, most_steps);
          break;
        default:
          break;
      }
    }
    return std::move(found_);
  }
  [[nodiscard]] const detail::graph& graph() const { return g_; }

 private:
  void vanish(node_id i) { solve(i, g_.number(0), most_steps); }

  node_id of(const char* function, node_id x) {
    return detail::find_function(function)->build(g_, {x});
  }
  [[nodiscard]] bool is_zero(node_id i) const {
    const rational* q = g_.value(i);
    return q != nullptr && *q == 0;
  }
  /// Whether a node is of the formula, and of its variable.
  [[nodiscard]] bool varies(node_id i) const { return i < size_ && varies_[i] != 0; }

  /// Adds numbers at which node i may have the value of a node without variables; what cannot be
  /// inverted is left out.
  void solve(node_id i, node_id value, int steps) {
    if (!varies(i) || steps == 0 || found_.size() >= most_found) return;
    try {
      invert(g_[i], value, steps - 1);
    } catch (const detail::undefined_operation&) {
      return;  // no number has this value: the logarithm of a negative one, say
    }
  }
  /// Node i may be the angle, or that and a multiple of so many half turns.
  void solve_angle(node_id i, node_id angle, long half_turns, int steps) {
    const double_interval first = values_(g_, angle);
    if (!first.is_bounded()) return;
    solve(i, angle, steps);
    const double_interval over = values_(g_, i);
    if (!over.is_bounded()) return;
    constexpr double half_turn = 3.14159265358979;
    const double turn = half_turn * static_cast<double>(half_turns);
    constexpr double margin = 1e-6;  // in turns
    const double least = std::ceil((over.lower() - first.upper()) / turn - margin);
    const double most = std::floor((over.upper() - first.lower()) / turn + margin);
    if (!(most - least <= most_turns) || !(std::abs(least) < 0x1p40)) return;
    for (auto k = static_cast<long>(least); k <= static_cast<long>(most); ++k) {
      if (k == 0) continue;
      const node_id turns = multiply(g_, g_.number(k * half_turns), g_.make(operation::pi));
      solve(i, add(g_, angle, turns), steps);
    }
  }
  /// A copy of the node: the graph grows.
  void invert(const detail::node n, node_id value, int steps) {
    const bool of_left = varies(n.left);
    const bool of_right = varies(n.right);
    switch (n.what) {
      case operation::variable:
        if (std::find(found_.begin(), found_.end(), value) == found_.end()) {
          found_.push_back(value);
        }
        return;
      case operation::negate:
        return solve(n.left, negate(g_, value), steps);
      case operation::add:
        if (of_left && !of_right) return solve(n.left, subtract(g_, value, n.right), steps);
        if (of_right && !of_left) return solve(n.right, subtract(g_, value, n.left), steps);
        return solve_trinomial(n, value);
      case operation::subtract:
        if (of_left && !of_right) return solve(n.left, add(g_, value, n.right), steps);
        if (of_right && !of_left) return solve(n.right, subtract(g_, n.left, value), steps);
        return solve_trinomial(n, value);
      case operation::multiply:
        if (of_left && of_right) {
          if (!is_zero(value)) return;
          solve(n.left, value, steps);
          return solve(n.right, value, steps);
        }
        return of_left ? solve(n.left, divide(g_, value, n.right), steps)
                       : solve(n.right, divide(g_, value, n.left), steps);
      case operation::divide:
        if (is_zero(value)) return solve(n.left, value, steps);
        if (of_left && !of_right) return solve(n.left, multiply(g_, value, n.right), steps);
        if (of_right && !of_left) return solve(n.right, divide(g_, n.left, value), steps);
        return;
      case operation::power_integer:
        return invert_power(n, value, steps);
      case operation::abs:
        solve(n.left, value, steps);
        if (!is_zero(value)) solve(n.left, negate(g_, value), steps);
        return;
      case operation::root:
        return solve(n.left, power(g_, value, g_.number(n.number)), steps);
      case operation::sqrt:
        return solve(n.left, power(g_, value, g_.number(2)), steps);
      case operation::exp:
        return solve(n.left, of("log", value), steps);
      case operation::expm1:
        return solve(n.left, of("log1p", value), steps);
      case operation::log:
        return solve(n.left, of("exp", value), steps);
      case operation::log1p:
        return solve(n.left, of("expm1", value), steps);
      case operation::sin: {
        const node_id angle = of("asin", value);
        solve_angle(n.left, angle, 2, steps);
        return solve_angle(n.left, subtract(g_, g_.make(operation::pi), angle), 2, steps);
      }
      case operation::cos: {
        const node_id angle = of("acos", value);
        solve_angle(n.left, angle, 2, steps);
        return solve_angle(n.left, negate(g_, angle), 2, steps);
      }
      case operation::tan:
        return solve_angle(n.left, of("atan", value), 1, steps);
      case operation::sinh:
        return solve(n.left, of("asinh", value), steps);
      case operation::cosh: {
        const node_id x = of("acosh", value);
        solve(n.left, x, steps);
        return solve(n.left, negate(g_, x), steps);
      }
      case operation::tanh:
        return solve(n.left, of("atanh", value), steps);
      default:
        return;
    }
  }
  void invert_power(const detail::node& n, node_id value, int steps) {
    const long exponent = n.number < 0 ? -n.number : n.number;
    if (exponent == 0 || exponent > most_exponent) return;
    if (n.number < 0) value = divide(g_, g_.number(1), value);
    const node_id x = exponent == 1 ? value
                      : exponent == 2
                          ? of("sqrt", value)
                          : detail::find_function("root")->build(g_, {value, g_.number(exponent)});
    solve(n.left, x, steps);
    if (exponent % 2 == 0) solve(n.left, negate(g_, x), steps);
  }

  /// The coefficients of a polynomial in the variable, by their exponents; false for other
  /// formulas.
  using coefficients = std::map<long, node_id>;
  bool add_terms(node_id i, node_id factor, coefficients& terms) {
    constexpr std::size_t most_terms = 8;
    const detail::node n = g_[i];
    const auto add_term = [&](long exponent) {
      const auto [place, is_new] = terms.emplace(exponent, factor);
      if (!is_new) place->second = add(g_, place->second, factor);
      return terms.size() <= most_terms;
    };
    if (!varies(i)) {
      factor = multiply(g_, factor, i);
      return add_term(0);
    }
    const bool is_power = n.what == operation::power_integer && n.number > 0;
    if (n.what == operation::variable) return add_term(1);
    if (is_power && g_[n.left].what == operation::variable) return add_term(n.number);
    if (n.what == operation::negate) return add_terms(n.left, negate(g_, factor), terms);
    if (n.what == operation::add || n.what == operation::subtract) {
      return add_terms(n.left, factor, terms) &&
             add_terms(n.right, n.what == operation::add ? factor : negate(g_, factor), terms);
    }
    if (n.what == operation::multiply && !varies(n.left)) {
      return add_terms(n.right, multiply(g_, factor, n.left), terms);
    }
    if (n.what == operation::multiply && !varies(n.right)) {
      return add_terms(n.left, multiply(g_, factor, n.right), terms);
    }
    return false;
  }
  /// Adds the double zeros of a x^(2 d) + b x^d + c - value for d = 1 or 2, where x^d is -b/(2 a).
  void solve_trinomial(const detail::node& n, node_id value) {
    coefficients terms;
    const node_id one = g_.number(1);
    const node_id sign = n.what == operation::add ? one : g_.number(-1);
    if (!add_terms(n.left, one, terms) || !add_terms(n.right, sign, terms)) return;
    const long d = terms.rbegin()->first / 2;
    const bool is_known = std::ranges::all_of(
        terms, [&](const auto& t) { return t.first == 0 || t.first == d || t.first == 2 * d; });
    if (!is_known || d < 1 || d > 2 || !terms.contains(d)) return;
    const node_id a = terms.at(2 * d);
    const node_id b = terms.at(d);
    const node_id c = terms.contains(0) ? subtract(g_, terms.at(0), value) : negate(g_, value);
    const node_id discriminant =
        subtract(g_, multiply(g_, b, b), multiply(g_, g_.number(4), multiply(g_, a, c)));
    const double_interval size = values_(g_, discriminant);
    if (size.is_undefined() || certainly_positive(size) || certainly_negative(size)) return;
    const node_id x = negate(g_, divide(g_, b, multiply(g_, g_.number(2), a)));
    if (d == 1) {
      found_.push_back(x);
    } else {
      found_.push_back(of("sqrt", x));
      found_.push_back(negate(g_, found_.back()));
    }
  }

  detail::graph g_;
  std::vector<char> used_;
  std::vector<char> varies_;
  node_id size_;
  values_of_node values_;
  std::vector<node_id> found_;
};

}  // namespace
}  // namespace divisor_zeros_impl

std::vector<expression> expression::divisor_zeros(const double_interval& range) const {
  const auto part = [this](const detail::graph& f, detail::node_id root, bool is_number) {
    auto g = std::make_shared<detail::graph>(f);
    g->root = root;
    expression x(*this);
    if (is_number) x.variables_.clear();
    x.exact_.reset();
    x.take(std::move(g));
    return x;
  };
  constexpr precision p = 64;
  divisor_zeros_impl::search all(*graph_, [&](const detail::graph& g, detail::node_id i) {
    return part(g, i, false).evaluator<double_interval>(p)(range);
  });
  std::vector<expression> result;
  for (const detail::node_id root : all.found()) {
    result.push_back(part(all.graph(), root, true));
  }
  return result;
}

}  // namespace polhode
