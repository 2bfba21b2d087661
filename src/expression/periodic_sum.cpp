// A formula as a sum of products of a periodic function, a power of x, a rational function, and
// powers of polynomials in x whose coefficients are periodic.
//
// Each step is an identity of real numbers wherever the operation of f is defined:
//   p q + r s is the sum of both products,  (p q)(r s) = (p r)(q s),  (p q)/(r s) = (p/r)(q/s),
//   (p q)^n = p^n q^n for a whole n,  |p q| = |p| |q|,
//   floor(w) = w - (w - floor(w)),  ceil(w) = w + (ceil(w) - w).
// A sum w of such products without such powers is x^l (c_0 + c_1 x + ...) with periodic c_i; its
// power w^a is x^(l a) (c_0 + c_1 x + ...)^a for x > 0, where w > 0, or a is a whole number.
// Periodic are: sin, cos and tan of a x + b, with 2 pi/|a|; sin(pi (a x + b)) and its cosine, with
// 2/|a|; the fractional parts of a x + b, with 1/|a|; and every function of periodic ones.

#include <algorithm>
#include <map>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "exponential_sum.hpp"
#include "graph.hpp"
#include "polhode/arithmetic/polynomial.hpp"
#include "polhode/expression/expression.hpp"

namespace polhode {
namespace periodic_sum_impl {
namespace {

using detail::node;
using detail::node_id;
using detail::operation;

constexpr std::size_t most_nodes = 300;  // of the formula
constexpr std::size_t most_terms = 32;
constexpr long most_power = 8;  // of a sum

/// The exponents of powers of sums, by the sums' nodes. Some may be 0: the power is defined only
/// where the sum is not 0.
using powers_of_sums = std::map<node_id, rational>;
struct product {
  node_id periodic;
  node_id steady;
  powers_of_sums powers = {};
};
using sum = std::vector<product>;

class splitting {
 public:
  explicit splitting(detail::graph f) : g_(std::move(f)), one_(g_.number(1)) {}

  /// Whether periodic functions are in it, and have a common period.
  bool prepare() {
    const std::vector<char> used = detail::reachable(g_);
    const node_id count = g_.root + 1;
    moves_.assign(count, 0);
    turns_.assign(count, 0);
    for (node_id i = 0; i < count; ++i) {
      if (used[i] != 0 && !mark(i)) return false;
    }
    return turns_[g_.root] != 0;
  }

  std::optional<sum> terms() { return split(g_.root); }
  /// The sum of which a product has a power.
  [[nodiscard]] const sum& base(node_id i) const { return bases_.at(i); }
  [[nodiscard]] const pi_combination& period() const { return *period_; }
  detail::graph& graph() { return g_; }

 private:
  static bool is_circular(operation what) {
    return what == operation::sin || what == operation::cos || what == operation::tan ||
           what == operation::sinpi || what == operation::cospi;
  }
  static bool is_step(operation what) {
    return what == operation::floor || what == operation::ceil;
  }

  /// The slope a of a node a x + b, not 0.
  std::optional<pi_combination> slope_of(node_id i) {
    const auto c = detail::polynomial_in_variable(g_, i);
    if (!c || c->size() != 2) return std::nullopt;
    auto slope = detail::known_value(g_, (*c)[1]);
    if (!slope || slope->is_zero() || (slope->q != 0 && slope->r != 0)) return std::nullopt;
    return slope;
  }
  bool add_period(const pi_combination& own) {
    period_ = period_ ? common_period(*period_, own) : own;
    return period_.has_value();
  }

  /// Whether x stands outside periodic functions, and whether there are any, below a node. Returns
  /// false where there is no common period.
  bool mark(node_id i) {
    const node n = g_[i];
    if (n.what == operation::variable) {
      moves_[i] = 1;
      return true;
    }
    for (const node_id x : detail::operands_at(g_, i)) {
      moves_[i] = static_cast<char>(moves_[i] | moves_[x]);
      turns_[i] = static_cast<char>(turns_[i] | turns_[x]);
    }
    const bool of_x_alone = moves_[i] != 0 && turns_[i] == 0;
    if (of_x_alone && is_circular(n.what)) return mark_circular(i, n);
    if (of_x_alone && is_step(n.what)) {
      turns_[i] = 1;  // it moves by whole steps
      const auto slope = slope_of(n.left);
      return slope && slope->is_rational() && add_period({abs(1 / slope->q), 0});
    }
    // A fractional part.
    if (n.what == operation::subtract && is_step(g_[n.right].what) && g_[n.right].left == n.left &&
        turns_[n.left] == 0) {
      moves_[i] = 0;
    }
    return true;
  }
  bool mark_circular(node_id i, const node& n) {
    moves_[i] = 0;
    turns_[i] = 1;
    const auto slope = slope_of(n.left);
    if (!slope) return false;
    const bool in_half_turns = n.what == operation::sinpi || n.what == operation::cospi;
    if (in_half_turns) return slope->is_rational() && add_period({abs(2 / slope->q), 0});
    return add_period(slope->is_rational() ? pi_combination{0, abs(2 / slope->q)}
                                           : pi_combination{abs(2 / slope->r), 0});
  }

  std::optional<sum> split(node_id i) {
    if (turns_[i] == 0) return sum{{one_, i}};
    if (moves_[i] == 0) return sum{{i, one_}};
    const node n = g_[i];
    switch (n.what) {
      case operation::negate: {
        auto x = split(n.left);
        if (x) negate(*x);
        return x;
      }
      case operation::add:
      case operation::subtract: {
        auto x = split(n.left);
        auto y = split(n.right);
        if (!x || !y) return std::nullopt;
        if (n.what == operation::subtract) negate(*y);
        x->insert(x->end(), y->begin(), y->end());
        return few(std::move(x));
      }
      case operation::multiply:
        return multiplied(split(n.left), split(n.right));
      case operation::divide:
        return multiplied(split(n.left), power(n.right, -1));
      case operation::power_integer:
        return power(n.left, n.number);
      case operation::sqrt:
      case operation::root:
      case operation::power: {
        const auto e = detail::fractional_exponent_at(g_, i);
        auto x = e ? split(n.left) : std::nullopt;
        if (!x || x->size() == 1) return std::nullopt;
        return power_of_sum(n.left, std::move(*x), *e);
      }
      case operation::abs: {
        auto x = split(n.left);
        if (!x || x->size() != 1 || !x->front().powers.empty()) return std::nullopt;
        return sum{{g_.make(operation::abs, x->front().periodic),
                    g_.make(operation::abs, x->front().steady)}};
      }
      case operation::floor:
        return sum{{one_, n.left}, {g_.make(operation::negate, fraction(n.left, i)), one_}};
      case operation::ceil:
        return sum{{one_, n.left}, {g_.make(operation::subtract, i, n.left), one_}};
      default:
        return std::nullopt;
    }
  }
  node_id fraction(node_id of, node_id floor) { return g_.make(operation::subtract, of, floor); }
  static std::optional<sum> few(std::optional<sum> x) {
    return x && x->size() <= most_terms ? std::move(x) : std::nullopt;
  }
  void negate(sum& x) {
    for (product& p : x) p.steady = detail::negate(g_, p.steady);
  }
  std::optional<sum> multiplied(const std::optional<sum>& x, const std::optional<sum>& y) {
    if (!x || !y || x->size() * y->size() > most_terms) return std::nullopt;
    sum result;
    for (const product& p : *x) {
      for (const product& q : *y) {
        result.push_back(
            {multiply(g_, p.periodic, q.periodic), multiply(g_, p.steady, q.steady), p.powers});
        for (const auto& [of, e] : q.powers) result.back().powers[of] += e;
      }
    }
    return result;
  }
  std::optional<sum> power(node_id of, long n) {
    if (const node m = g_[of]; n < 0 && m.what == operation::multiply) {
      return multiplied(power(m.left, n), power(m.right, n));  // each may be a sum
    }
    auto x = split(of);
    if (!x) return std::nullopt;
    if (x->size() == 1) {
      product result{detail::power(g_, x->front().periodic, g_.number(n)),
                     detail::power(g_, x->front().steady, g_.number(n)), x->front().powers};
      for (auto& [base, e] : result.powers) e *= n;
      return sum{std::move(result)};
    }
    if (n < 0) return power_of_sum(of, std::move(*x), n);
    if (n < 1 || n > most_power) return std::nullopt;
    std::optional<sum> result = x;
    for (long k = 1; k < n && result; ++k) result = multiplied(result, x);
    return result;
  }
  /// Of a node that is this sum.
  std::optional<sum> power_of_sum(node_id of, sum x, const rational& e) {
    if (std::ranges::any_of(x, [](const product& p) { return !p.powers.empty(); })) {
      return std::nullopt;
    }
    bases_.emplace(of, std::move(x));
    return sum{{one_, one_, {{of, e}}}};
  }

  detail::graph g_;
  node_id one_;
  std::map<node_id, sum> bases_;
  std::vector<char> moves_;
  std::vector<char> turns_;
  std::optional<pi_combination> period_;
};

/// x^exponent times the rest, for x > 0.
struct power_of_x {
  rational exponent = 0;
  node_id rest;
};

class powers {
 public:
  explicit powers(detail::graph& g) : g_(g), one_(g.number(1)) {}

  power_of_x of(node_id i) {
    const node n = g_[i];
    switch (n.what) {
      case operation::variable:
        return {1, one_};
      case operation::multiply: {
        const power_of_x x = of(n.left);
        const power_of_x y = of(n.right);
        return {x.exponent + y.exponent, multiply(g_, x.rest, y.rest)};
      }
      case operation::divide: {
        const power_of_x x = of(n.left);
        const power_of_x y = of(n.right);
        if (g_.value(y.rest) != nullptr && *g_.value(y.rest) == 0) return {0, i};
        return {x.exponent - y.exponent, divide(g_, x.rest, y.rest)};
      }
      case operation::negate: {
        const power_of_x x = of(n.left);
        return {x.exponent, detail::negate(g_, x.rest)};
      }
      case operation::power_integer: {
        const power_of_x x = of(n.left);
        if (x.exponent == 0) return {0, i};
        return {x.exponent * n.number, detail::power(g_, x.rest, g_.number(n.number))};
      }
      default:
        break;
    }
    const std::optional<rational> e = detail::fractional_exponent_at(g_, i);
    // (c x^k)^e = c^e x^(k e) for c, x > 0.
    if (e && is_monomial(n.left)) {
      const power_of_x x = of(n.left);
      return {x.exponent * *e, detail::power(g_, x.rest, g_.number(*e))};
    }
    // |x| = x for x > 0; others are left to quotient(), which refuses them.
    if (n.what == operation::abs && is_monomial(n.left)) return of(n.left);
    return {0, i};
  }

 private:
  /// Of products, quotients and powers of x and positive numbers.
  bool is_monomial(node_id i) {
    const node n = g_[i];
    if (const rational* q = g_.value(i)) return *q > 0;
    switch (n.what) {
      case operation::variable:
        return true;
      case operation::multiply:
      case operation::divide:
        return is_monomial(n.left) && is_monomial(n.right);
      case operation::power_integer:
        return is_monomial(n.left);
      default:
        return detail::fractional_exponent_at(g_, i) && is_monomial(n.left);
    }
  }

  detail::graph& g_;
  node_id one_;
};

/// x^lowest (c_0 + c_1 x + ...), the c_i periodic nodes.
struct moving_polynomial {
  rational lowest;
  std::vector<node_id> coefficients;
};

/// Of a sum whose other factors are powers of x and polynomials; the powers of all differ by whole
/// ones.
std::optional<moving_polynomial> polynomial_of(detail::graph& g, const sum& x) {
  constexpr long most_degree = 32;
  std::map<rational, node_id> coefficients;
  for (const product& p : x) {
    const power_of_x split = powers(g).of(p.steady);
    const auto c = detail::polynomial_in_variable(g, split.rest);
    if (!c) return std::nullopt;
    for (std::size_t k = 0; k < c->size(); ++k) {
      if ((*c)[k] == g.number(0)) continue;
      const node_id term = multiply(g, p.periodic, (*c)[k]);
      const auto [place, is_new] =
          coefficients.emplace(split.exponent + static_cast<long>(k), term);
      if (!is_new) place->second = add(g, place->second, term);
    }
  }
  if (coefficients.empty()) return std::nullopt;
  moving_polynomial result{coefficients.begin()->first, {}};
  if (coefficients.rbegin()->first - result.lowest > most_degree) return std::nullopt;
  for (const auto& [e, c] : coefficients) {
    const rational step = e - result.lowest;
    if (denominator(step) != 1) return std::nullopt;
    result.coefficients.resize(static_cast<std::size_t>(numerator(step)), g.number(0));
    result.coefficients.push_back(c);
  }
  return result;
}

}  // namespace
}  // namespace periodic_sum_impl

std::optional<expression::periodic_sum> expression::as_periodic_sum() const {
  namespace impl = periodic_sum_impl;
  if (variables_.size() != 1 || graph_->size() > impl::most_nodes) return std::nullopt;
  try {
    impl::splitting splitting(*graph_);
    if (!splitting.prepare()) return std::nullopt;
    const auto terms = splitting.terms();
    if (!terms) return std::nullopt;
    detail::graph& g = splitting.graph();
    std::map<detail::node_id, impl::moving_polynomial> bases;
    for (const impl::product& p : *terms) {
      for (const auto& [of, e] : p.powers) {
        auto found = impl::polynomial_of(g, splitting.base(of));
        if (!found) return std::nullopt;
        bases.emplace(of, std::move(*found));
      }
    }
    // Of the same periodic functions, the steady parts whose powers of x differ by whole ones
    // together: they may cancel.
    std::map<std::tuple<detail::node_id, impl::powers_of_sums, rational>,
             std::vector<impl::power_of_x>>
        steady;
    for (const impl::product& p : *terms) {
      impl::power_of_x split = impl::powers(g).of(p.steady);
      for (const auto& [of, e] : p.powers) split.exponent += e * bases.at(of).lowest;
      steady[{p.periodic, p.powers, split.exponent - floor_of(split.exponent)}].push_back(split);
    }
    periodic_sum result{splitting.period(), {}};
    for (const auto& [key, parts] : steady) {
      const rational e = std::ranges::min(parts, {}, &impl::power_of_x::exponent).exponent;
      detail::node_id sum = g.number(0);
      for (const impl::power_of_x& part : parts) {
        const auto more = g.number(part.exponent - e);
        sum = detail::add(g, sum,
                          detail::multiply(g, detail::power(g, g.variable(0), more), part.rest));
      }
      const auto quotient = with_root(g, sum).quotient();
      if (!quotient) return std::nullopt;
      const auto& [periodic, powers, fraction] = key;
      periodic_sum::term term{
          with_root(g, periodic), e, quotient->numerator, denominator_of(*quotient), {}};
      for (const auto& [of, power] : powers) {
        term.powers.push_back({{}, power});
        for (const detail::node_id c : bases.at(of).coefficients) {
          term.powers.back().coefficients.push_back(with_root(g, c));
        }
      }
      result.terms.push_back(std::move(term));
    }
    return result;
  } catch (const detail::undefined_operation&) {
    return std::nullopt;
  }
}

std::optional<expression::periodic_products> expression::as_periodic_products() const {
  namespace impl = periodic_sum_impl;
  if (variables_.size() != 1 || graph_->size() > impl::most_nodes) return std::nullopt;
  try {
    impl::splitting splitting(*graph_);
    if (!splitting.prepare()) return std::nullopt;
    const auto terms = splitting.terms();
    const auto has_powers = [](const impl::product& p) { return !p.powers.empty(); };
    if (!terms || std::ranges::any_of(*terms, has_powers)) return std::nullopt;
    periodic_products result{splitting.period(), {}};
    for (const impl::product& p : *terms) {
      const detail::graph& g = splitting.graph();
      result.terms.push_back({with_root(g, p.periodic), with_root(g, p.steady)});
    }
    return result;
  } catch (const detail::undefined_operation&) {
    return std::nullopt;
  }
}

}  // namespace polhode
