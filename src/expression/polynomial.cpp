// A formula that is a polynomial with rational coefficients, or a quotient of two.

#include <algorithm>
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

/// A polynomial over a product of powers of divisors, which are known by their numbers.
struct fraction {
  terms above;
  std::map<std::size_t, long> below;
  /// The base and the exponent, where the whole was written as a power of a polynomial.
  std::optional<std::pair<terms, long>> as_power;
};
using maybe_fraction = std::optional<fraction>;

class expansion {
 public:
  /// With quotients, a formula may be divided by others than numbers.
  expansion(const detail::graph& g, bool with_quotients)
      : g_(g), with_quotients_(with_quotients), known_(g.size()) {}

  maybe_fraction root() {
    const std::vector<char> used = detail::reachable(g_);
    count_uses(used);
    for (node_id i = 0; i <= g_.root; ++i) {
      if (used[i] == 0) continue;
      known_[i] = of(i);
      if (!known_[i]) return std::nullopt;
    }
    return known_[g_.root];
  }
  /// All that the formula divides by, each with leading coefficient 1.
  [[nodiscard]] const std::vector<terms>& divisors() const { return divisors_; }

 private:
  /// How often the operations that are expanded take each node.
  void count_uses(const std::vector<char>& used) {
    uses_.assign(g_.size(), 0);
    ++uses_[g_.root];
    for (node_id i = 0; i <= g_.root; ++i) {
      if (used[i] == 0) continue;
      const operation what = g_[i].what;
      const bool is_binary = what == operation::add || what == operation::subtract ||
                             what == operation::multiply || what == operation::divide;
      if (is_binary || what == operation::negate || what == operation::power_integer) {
        ++uses_[g_[i].left];
      }
      if (is_binary) ++uses_[g_[i].right];
    }
  }
  /// The node's fraction, which is not kept where nothing else needs it: a long sum would be copied
  /// for each of its terms.
  fraction taken(node_id i) {
    if (uses_[i] > 1) return *known_[i];
    return std::move(*known_[i]);
  }

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

  maybe_terms sum(terms p, const terms& q, int sign) {
    for (const auto& [n, c] : q) {
      if (!add_to(p, n, c * sign)) return std::nullopt;
    }
    return p;
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

  /// p times the powers of divisors that `wanted` has more of than `given`.
  maybe_terms times_missing(terms p, const std::map<std::size_t, long>& wanted,
                            const std::map<std::size_t, long>& given) {
    maybe_terms result = std::move(p);
    for (const auto& [divisor, n] : wanted) {
      const auto has = given.find(divisor);
      const long missing = n - (has == given.end() ? 0 : has->second);
      if (missing <= 0) continue;
      const maybe_terms factor = power(divisors_[divisor], missing);
      if (!factor) return std::nullopt;
      result = product(*result, *factor);
      if (!result) return std::nullopt;
    }
    return result;
  }

  static maybe_fraction over(maybe_terms above, std::map<std::size_t, long> below) {
    if (!above) return std::nullopt;
    return fraction{std::move(*above), std::move(below), std::nullopt};
  }

  maybe_fraction sum(fraction x, const fraction& y, int sign) {
    if (x.below == y.below) return over(sum(std::move(x.above), y.above, sign), std::move(x.below));
    std::map<std::size_t, long> below = x.below;
    for (const auto& [divisor, n] : y.below) below[divisor] = std::max(below[divisor], n);
    const maybe_terms left = times_missing(x.above, below, x.below);
    const maybe_terms right = times_missing(y.above, below, y.below);
    if (!left || !right) return std::nullopt;
    return over(sum(*left, *right, sign), std::move(below));
  }

  maybe_fraction product(const fraction& x, const fraction& y) {
    std::map<std::size_t, long> below = x.below;
    for (const auto& [divisor, n] : y.below) below[divisor] += n;
    return over(product(x.above, y.above), std::move(below));
  }

  /// x / y^n for n > 0: with y = u/v it is x v^n / u^n.
  maybe_fraction quotient(const fraction& x, const fraction& y, long n) {
    if (y.above.empty()) return std::nullopt;
    const terms& base = y.as_power ? y.as_power->first : y.above;  // of u
    const long exponent = n * (y.as_power ? y.as_power->second : 1);
    const bool is_number = base.size() == 1 && base.begin()->first == 0;
    if (exponent > greatest_degree || (!is_number && !with_quotients_)) return std::nullopt;
    std::map<std::size_t, long> below = x.below;
    std::map<std::size_t, long> more;  // of v^n, what x has not below
    for (const auto& [divisor, m] : y.below) {
      long& has = below[divisor];
      const long common = std::min(has, m * n);
      has -= common;
      more[divisor] = m * n - common;
    }
    const rational inverse = 1 / base.rbegin()->second;
    maybe_terms above = times_missing(x.above, more, {});
    const maybe_terms scale = power({{0, inverse}}, exponent);
    if (!above || !scale) return std::nullopt;
    above = product(*above, *scale);
    if (!is_number) {
      const maybe_terms monic = product(base, {{0, inverse}});
      if (!monic) return std::nullopt;
      below[number_of(*monic)] += exponent;
    }
    return over(std::move(above), std::move(below));
  }

  std::size_t number_of(const terms& divisor) {
    const auto place = std::find(divisors_.begin(), divisors_.end(), divisor);
    if (place != divisors_.end()) return static_cast<std::size_t>(place - divisors_.begin());
    divisors_.push_back(divisor);
    return divisors_.size() - 1;
  }

  maybe_fraction power(const fraction& x, long n) {
    if (n < 0) {
      if (n < -greatest_degree) return std::nullopt;
      return quotient({{{0, 1}}, {}, std::nullopt}, x, -n);
    }
    if (n > greatest_degree) return std::nullopt;
    std::map<std::size_t, long> below = x.below;
    for (auto& [divisor, m] : below) m *= n;
    maybe_fraction result = over(power(x.above, n), std::move(below));
    if (result && x.below.empty() && n > 1) {
      result->as_power = std::pair(x.above, n);
    }
    return result;
  }

  maybe_fraction of(node_id i) {
    const detail::node& n = g_[i];
    const auto left = [&]() -> const fraction& { return *known_[n.left]; };
    const auto right = [&]() -> const fraction& { return *known_[n.right]; };
    switch (n.what) {
      case operation::number: {
        terms result;
        if (!add_to(result, 0, *g_.value(i))) return std::nullopt;
        return over(std::move(result), {});
      }
      case operation::variable:
        return over(terms{{1, 1}}, {});
      case operation::negate:
        return sum({}, left(), -1);
      case operation::add:
        return sum(taken(n.left), right(), 1);
      case operation::subtract:
        return sum(taken(n.left), right(), -1);
      case operation::multiply:
        return product(left(), right());
      case operation::divide:
        return quotient(left(), right(), 1);
      case operation::power_integer:
        return power(left(), n.number);
      default:
        return std::nullopt;
    }
  }

  const detail::graph& g_;
  bool with_quotients_;
  std::vector<maybe_fraction> known_;
  std::vector<long> uses_;
  std::vector<terms> divisors_;
  std::size_t steps_ = 0;
};

rational_polynomial as_polynomial(const terms& p) {
  std::vector<rational> coefficients;
  if (!p.empty()) coefficients.resize(static_cast<std::size_t>(p.rbegin()->first) + 1);
  for (const auto& [n, c] : p) coefficients[static_cast<std::size_t>(n)] = c;
  return rational_polynomial(std::move(coefficients));
}

}  // namespace

std::optional<rational_polynomial> expression::polynomial() const {
  if (variables_.size() > 1) return std::nullopt;
  const maybe_fraction p = expansion(*graph_, false).root();
  if (!p) return std::nullopt;
  return as_polynomial(p->above);
}

std::optional<rational_quotient> expression::quotient() const {
  if (variables_.size() > 1) return std::nullopt;
  expansion all(*graph_, true);
  const maybe_fraction q = all.root();
  if (!q) return std::nullopt;
  rational_quotient result;
  result.numerator = as_polynomial(q->above);
  for (std::size_t k = 0; k < all.divisors().size(); ++k) {
    const auto place = q->below.find(k);
    result.divisors.push_back(
        {as_polynomial(all.divisors()[k]), place == q->below.end() ? 0 : place->second});
  }
  return result;
}

}  // namespace polhode
