// A formula that is a polynomial with rational coefficients.

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "exact/rationals.hpp"
#include "graph.hpp"
#include "polhode/arithmetic/polynomial.hpp"

namespace polhode {
namespace {

using detail::node_id;
using detail::operation;

// Beyond these a formula is not taken for a polynomial.
constexpr long greatest_degree = 10'000;
constexpr std::size_t most_steps = 1U << 20;  // products of coefficients
constexpr std::size_t most_bits = 1U << 14;   // of a coefficient

using terms = std::map<long, rational>;  // the coefficients that are not 0, by degree
using maybe_terms = std::optional<terms>;

class expansion {
 public:
  explicit expansion(const detail::graph& g) : g_(g), known_(g.size()) {}

  maybe_terms root() {
    const std::vector<char> used = detail::reachable(g_);
    for (node_id i = 0; i <= g_.root; ++i) {
      if (used[i] == 0) continue;
      known_[i] = of(i);
      if (!known_[i]) return std::nullopt;
    }
    return known_[g_.root];
  }

 private:
  /// c x^n joins p; false where that is too long.
  bool add_to(terms& p, long n, const rational& c) {
    if (++steps_ > most_steps || n > greatest_degree) return false;
    if (c == 0) return true;
    const auto [place, is_new] = p.emplace(n, c);
    if (!is_new) place->second += c;
    const std::size_t bits = detail::exact_parts::bits_of(place->second);
    steps_ += bits / 1024;  // long numbers take longer
    if (bits > most_bits) return false;
    if (place->second == 0) p.erase(place);
    return true;
  }

  maybe_terms sum(const terms& p, const terms& q, int sign) {
    terms result = p;
    for (const auto& [n, c] : q) {
      if (!add_to(result, n, c * sign)) return std::nullopt;
    }
    return result;
  }

  maybe_terms product(const terms& p, const terms& q) {
    terms result;
    for (const auto& [m, c] : p) {
      for (const auto& [n, d] : q) {
        if (!add_to(result, m + n, c * d)) return std::nullopt;
      }
    }
    return result;
  }

  maybe_terms power(const terms& p, long n) {
    if (n < 0 || n > greatest_degree) return std::nullopt;
    maybe_terms result = terms{{0, 1}};
    maybe_terms square = p;
    while (n > 0) {
      if (n % 2 == 1) result = product(*result, *square);
      n /= 2;
      if (n > 0) square = product(*square, *square);
      if (!result || !square) return std::nullopt;
    }
    return result;
  }

  maybe_terms of(node_id i) {
    const detail::node& n = g_[i];
    const auto left = [&]() -> const terms& { return *known_[n.left]; };
    const auto right = [&]() -> const terms& { return *known_[n.right]; };
    switch (n.what) {
      case operation::number: {
        terms result;
        if (!add_to(result, 0, *g_.value(i))) return std::nullopt;
        return result;
      }
      case operation::variable:
        return terms{{1, 1}};
      case operation::negate:
        return sum({}, left(), -1);
      case operation::add:
        return sum(left(), right(), 1);
      case operation::subtract:
        return sum(left(), right(), -1);
      case operation::multiply:
        return product(left(), right());
      case operation::divide:
        if (right().size() != 1 || right().begin()->first != 0) return std::nullopt;
        return product(left(), {{0, 1 / right().begin()->second}});
      case operation::power_integer:
        return power(left(), n.number);
      default:
        return std::nullopt;
    }
  }

  const detail::graph& g_;
  std::vector<maybe_terms> known_;
  std::size_t steps_ = 0;
};

}  // namespace

std::optional<rational_polynomial> expression::polynomial() const {
  if (variables_.size() > 1) return std::nullopt;
  const maybe_terms p = expansion(*graph_).root();
  if (!p) return std::nullopt;
  std::vector<rational> coefficients;
  if (!p->empty()) coefficients.resize(static_cast<std::size_t>(p->rbegin()->first) + 1);
  for (const auto& [n, c] : *p) coefficients[static_cast<std::size_t>(n)] = c;
  return rational_polynomial(std::move(coefficients));
}

}  // namespace polhode
