// A formula as one numerator over divisors: the zeros of a meromorphic function without its poles.
//
// By induction over the operations each node x is N/D, D a product of powers of divisors, wherever
// no divisor is 0; and a divisor is 0 exactly where an operation of x divides by 0:
//   a + b = (N_a (L/D_a) + N_b (L/D_b))/L for the least common multiple L of D_a and D_b,
//   a b = N_a N_b/(D_a D_b),   a/b = N_a D_b/(D_a N_b), with N_b as a further divisor,
//   a^n = N_a^n/D_a^n,   a^-n = D_a^n/N_a^n, with N_a as a further divisor,
//   tan a = sin a/cos a,   tanh a = sinh a/cosh a.
// The divisors of b stay divisors in a/b, of no power: 1/(1/x) is not defined at 0.

#include <algorithm>
#include <cstdlib>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "graph.hpp"

namespace polhode {
namespace fraction_impl {
namespace {

using detail::node;
using detail::node_id;
using detail::operation;

constexpr node_id most_nodes = 4000;
constexpr long greatest_power = 64;

class over_one_denominator {
 public:
  explicit over_one_denominator(detail::graph f)
      : g_(std::move(f)), size_(g_.root + 1), varies_(detail::varying(g_)) {}

  /// The numerator and the divisors, as nodes of graph(); none where they become long.
  std::optional<std::pair<node_id, std::vector<node_id>>> result() {
    std::vector<quotient> parts(size_);
    for (node_id i = 0; i < size_; ++i) {
      if (varies_[i] == 0) {
        parts[i] = {i, {}};
        continue;
      }
      const node n = g_[i];
      const std::optional<quotient> made = of(n, i, parts);
      if (!made || g_.size() > most_nodes) return std::nullopt;
      parts[i] = *made;
    }
    std::vector<node_id> divisors;
    for (const auto& [divisor, power] : parts[g_.root].below) divisors.push_back(divisor);
    return std::pair(parts[g_.root].above, std::move(divisors));
  }
  [[nodiscard]] const detail::graph& graph() const { return g_; }

 private:
  /// Divisors with their powers, which may be 0.
  using product = std::map<node_id, long>;
  struct quotient {
    node_id above;
    product below;
  };

  std::optional<quotient> of(const node& n, node_id i, const std::vector<quotient>& parts) {
    switch (n.what) {
      case operation::negate:
        return quotient{detail::negate(g_, parts[n.left].above), parts[n.left].below};
      case operation::add:
      case operation::subtract:
        return sum(parts[n.left], parts[n.right], n.what == operation::subtract);
      case operation::multiply:
        return times(parts[n.left], parts[n.right]);
      case operation::divide:
        return over(parts[n.left], parts[n.right], n.right);
      case operation::power_integer:
        return power(parts[n.left], n.number);
      case operation::tan:
        return quotient{g_.make(operation::sin, n.left), {{g_.make(operation::cos, n.left), 1}}};
      case operation::tanh:
        return quotient{g_.make(operation::sinh, n.left), {{g_.make(operation::cosh, n.left), 1}}};
      default:
        return quotient{i, {}};
    }
  }

  node_id raised(node_id x, long n) { return detail::power(g_, x, g_.number(n)); }

  /// `above` times what `more` has beyond `less`.
  node_id filled_up(node_id above, const product& more, const product& less) {
    for (const auto& [divisor, power] : more) {
      const auto known = less.find(divisor);
      const long missing = power - (known == less.end() ? 0 : known->second);
      if (missing > 0) above = detail::multiply(g_, above, raised(divisor, missing));
    }
    return above;
  }

  quotient sum(const quotient& a, const quotient& b, bool is_difference) {
    product least = a.below;
    for (const auto& [divisor, power] : b.below) {
      long& known = least[divisor];
      known = std::max(known, power);
    }
    const node_id x = filled_up(a.above, least, a.below);
    const node_id y = filled_up(b.above, least, b.below);
    return {is_difference ? detail::subtract(g_, x, y) : detail::add(g_, x, y), std::move(least)};
  }

  std::optional<quotient> times(const quotient& a, const quotient& b) {
    quotient r{detail::multiply(g_, a.above, b.above), a.below};
    for (const auto& [divisor, power] : b.below) {
      if ((r.below[divisor] += power) > greatest_power) return std::nullopt;
    }
    return r;
  }

  /// a/b, b a node of the formula.
  std::optional<quotient> over(const quotient& a, const quotient& b, node_id node_of_b) {
    if (varies_[node_of_b] == 0) return quotient{detail::divide(g_, a.above, b.above), a.below};
    const std::optional<quotient> inverse = power(b, -1);
    return inverse ? times(a, *inverse) : std::nullopt;
  }

  std::optional<quotient> power(const quotient& a, long n) {
    if (n > greatest_power || n < -greatest_power) return std::nullopt;
    quotient r = a;
    for (auto& [divisor, power] : r.below) power *= std::abs(n);
    for (const auto& [divisor, power] : r.below) {
      if (power > greatest_power) return std::nullopt;
    }
    if (n >= 0) {
      r.above = raised(a.above, n);
      return r;
    }
    r.above = filled_up(g_.number(1), r.below, {});
    for (auto& [divisor, power] : r.below) power = 0;
    if (!add_divisor(r.below, a.above, -n)) return std::nullopt;
    return r;
  }

  /// Adds the n-th power of a node to a product, by its factors and the bases of its whole powers;
  /// false where a power becomes great.
  bool add_divisor(product& below, node_id x, long n) {
    const node factor = g_[x];
    if (factor.what == operation::multiply) {
      return add_divisor(below, factor.left, n) && add_divisor(below, factor.right, n);
    }
    if (factor.what == operation::power_integer && 0 < factor.number &&
        factor.number <= greatest_power) {
      return add_divisor(below, factor.left, n * factor.number);
    }
    long& power = below[x];
    power += n;
    return n <= greatest_power && power <= greatest_power;
  }

  detail::graph g_;
  node_id size_;
  std::vector<char> varies_;
};

}  // namespace
}  // namespace fraction_impl

std::optional<expression::fraction> expression::as_fraction() const {
  try {
    fraction_impl::over_one_denominator f(*graph_);
    const auto parts = f.result();
    if (!parts) return std::nullopt;
    fraction r{with_root(f.graph(), parts->first), {}};
    for (const detail::node_id d : parts->second) r.divisors.push_back(with_root(f.graph(), d));
    return r;
  } catch (const detail::undefined_operation&) {
    return std::nullopt;
  }
}

}  // namespace polhode
