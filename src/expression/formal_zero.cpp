// Formulas that are 0 wherever they are defined, as their expansion shows; and the size of the
// terms of those that may be.

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "exact/rationals.hpp"
#include "graph.hpp"

namespace polhode {
namespace formal_zero_impl {
namespace {

using detail::node_id;
using detail::operation;

/// A product of powers of atoms: nodes that are no sums, products or whole powers. Atoms are told
/// apart by their nodes, of which equal subexpressions are one.
using monomial = std::vector<std::pair<node_id, long>>;
using terms = std::map<monomial, rational>;  // the coefficients that are not 0

constexpr std::size_t most_terms = 200;
constexpr long most_exponent = 64;
constexpr std::size_t most_bits = 4096;

monomial product(const monomial& x, const monomial& y) {
  std::map<node_id, long> powers(x.begin(), x.end());
  for (const auto& [atom, exponent] : y) powers[atom] += exponent;
  std::erase_if(powers, [](const auto& power) { return power.second == 0; });
  return {powers.begin(), powers.end()};
}

/// Nothing where the expansion is too long.
using maybe_terms = std::optional<terms>;

maybe_terms add(terms x, const terms& y, const rational& factor) {
  for (const auto& [m, c] : y) {
    rational& sum = x[m];
    sum += factor * c;
    if (sum == 0) {
      x.erase(m);
    } else if (detail::exact_parts::bits_of(sum) > most_bits) {
      return std::nullopt;
    }
  }
  if (x.size() > most_terms) return std::nullopt;
  return x;
}

maybe_terms multiply(const terms& x, const terms& y) {
  maybe_terms result = terms{};
  for (const auto& [m, c] : x) {
    terms row;
    for (const auto& [n, d] : y) row.emplace(product(m, n), c * d);
    result = add(std::move(*result), row, 1);
    if (!result) return result;
  }
  return result;
}

class expansion {
 public:
  explicit expansion(const detail::graph& g) : g_(g) {}

  maybe_terms of(node_id i) {
    const auto known = known_.find(i);
    if (known != known_.end()) return known->second;
    return known_[i] = made(i);
  }

 private:
  maybe_terms made(node_id i) {
    const detail::node& n = g_[i];
    if (const rational* q = g_.value(i)) return *q == 0 ? terms{} : terms{{{}, *q}};
    const auto of_two = [&](const auto& f) -> maybe_terms {
      const maybe_terms x = of(n.left);
      const maybe_terms y = of(n.right);
      return x && y ? f(*x, *y) : std::nullopt;
    };
    switch (n.what) {
      case operation::add:
        return of_two([](const terms& x, const terms& y) { return add(x, y, 1); });
      case operation::subtract:
        return of_two([](const terms& x, const terms& y) { return add(x, y, -1); });
      case operation::multiply:
        return of_two([](const terms& x, const terms& y) { return multiply(x, y); });
      case operation::negate: {
        const maybe_terms x = of(n.left);
        return x ? add({}, *x, -1) : std::nullopt;
      }
      case operation::divide: {  // the divisor is an unknown of its own
        const maybe_terms x = of(n.left);
        if (!x) return std::nullopt;
        if (const rational* q = g_.value(n.right); q != nullptr && *q != 0) {
          return add({}, *x, 1 / *q);
        }
        return multiply(*x, terms{{{{n.right, -1}}, rational(1)}});
      }
      case operation::power_integer: {
        const maybe_terms x = of(n.left);
        if (!x || n.number < 1 || n.number > most_exponent) break;
        maybe_terms result = x;
        for (long k = 1; k < n.number && result; ++k) result = multiply(*result, *x);
        return result;
      }
      default:
        break;
    }
    return terms{{{{i, 1}}, rational(1)}};
  }

  const detail::graph& g_;
  std::map<node_id, maybe_terms> known_;
};

/// Whether the operation is an entire function of its operand.
bool is_entire(operation what) {
  constexpr std::array all{operation::exp,  operation::expm1, operation::sin,   operation::cos,
                           operation::sinh, operation::cosh,  operation::sinpi, operation::cospi,
                           operation::erf,  operation::erfc};
  return std::ranges::find(all, what) != all.end();
}

}  // namespace
}  // namespace formal_zero_impl

bool expression::is_formally_zero() const {
  const auto found = formal_zero_impl::expansion(*graph_).of(graph_->root);
  return found && found->empty();
}

// A quotient of meromorphic functions is meromorphic unless the divisor is 0 everywhere, which one
// value other than 0 refutes; and where f is meromorphic, it is defined but for isolated points.
bool expression::is_zero_almost_everywhere() const {
  using detail::node_id;
  using detail::operation;
  if (variables_.size() != 1 || !is_formally_zero()) return false;
  const detail::graph& g = *graph_;
  const std::vector<char> used = detail::reachable(g);
  const std::vector<char> varies = detail::varying(g);
  const auto value = [&](node_id i) {
    constexpr precision p = 128;
    return with_root(g, i)(ball(rational(5, 7), p));
  };
  std::vector<char> has_poles(g.root + 1, 0);
  for (node_id i = 0; i <= g.root; ++i) {
    if (used[i] == 0) continue;
    if (varies[i] == 0) {
      if (!value(i).is_bounded()) return false;
      continue;
    }
    const detail::node& n = g[i];
    for (const node_id k : detail::operands_at(g, i))
      has_poles[i] = std::max(has_poles[i], has_poles[k]);
    const bool is_whole_power = n.what == operation::power_integer;
    if (n.what == operation::divide || (is_whole_power && n.number <= 0)) {
      const node_id divisor = is_whole_power ? n.left : n.right;
      if (contains_zero(value(divisor))) return false;
      has_poles[i] = std::max(has_poles[i], varies[divisor]);
    } else if (!is_whole_power && !detail::is_of_ring(n.what)) {
      if (!formal_zero_impl::is_entire(n.what) || has_poles[i] != 0) return false;
    }
  }
  return true;
}

expression expression::sum_of_sizes() const {
  using detail::operation;
  auto g = std::make_shared<detail::graph>(*graph_);
  std::vector<detail::node_id> open{g->root};
  std::vector<detail::node_id> terms;
  while (!open.empty()) {
    const detail::node n = (*g)[open.back()];
    const detail::node_id i = open.back();
    open.pop_back();
    if (n.what == operation::add || n.what == operation::subtract) {
      open.push_back(n.right);
      open.push_back(n.left);
    } else if (n.what == operation::negate) {
      open.push_back(n.left);
    } else {
      terms.push_back(i);
    }
  }
  detail::node_id sum = g->number(0);
  for (const detail::node_id term : terms) {
    sum = detail::add(*g, sum, detail::find_function("abs")->build(*g, {term}));
  }
  g->root = sum;
  expression result(*this);
  result.exact_.reset();
  result.take(std::move(g));
  return result;
}

}  // namespace polhode
