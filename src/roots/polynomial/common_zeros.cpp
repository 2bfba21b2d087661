#include "common_zeros.hpp"

#include <algorithm>
#include <utility>

#include "elimination.hpp"
#include "polhode/arithmetic/boost_bridge.hpp"
#include "polhode/arithmetic/interval.hpp"
#include "polhode/expression/symbol.hpp"
#include "real_roots.hpp"

namespace polhode::detail {

real_algebraic::real_algebraic(const rational& q)
    : exact_(q), polynomial_({rational(-q), rational(1)}), bracket_{q, q} {}

real_algebraic::real_algebraic(const std::vector<integer>& p, exact_interval bracket)
    : polynomial_(std::vector<rational>(p.begin(), p.end())),
      coefficients_(p),
      bracket_(std::move(bracket)) {}

/// It is no end of the bracket, and not rational, where it is not exact.
std::optional<bool> real_algebraic::is_in(const exact_interval& x) {
  constexpr long most_bits = 1L << 14;
  for (long bits = 8; bits <= most_bits; bits *= 2) {
    if ((!x.lower || *bracket_.lower >= *x.lower) && (!x.upper || *bracket_.upper <= *x.upper)) {
      return true;
    }
    if (exact_) return false;
    if ((x.lower && *bracket_.upper <= *x.lower) || (x.upper && *bracket_.lower >= *x.upper)) {
      return false;
    }
    polynomial_values values(coefficients_);
    bracket_ = narrowed(values, bracket_, bits);
  }
  return std::nullopt;
}

ball real_algebraic::enclosure(precision p) {
  if (exact_) return {*exact_, p};
  polynomial_values values(coefficients_);
  bracket_ = narrowed(values, bracket_, p);
  return bracket_.to_ball(p + 32);
}

std::vector<ball> enclosure_of(algebraic_point& x, precision p) {
  std::vector<ball> result;
  for (real_algebraic& t : x) result.push_back(t.enclosure(p));
  return result;
}

namespace {

/// A lower bound of the size of every root but 0. Hypothesis: p is not 0.
rational least_root_but_zero(const rational_polynomial& p) {
  std::vector<rational> reversed(p.coefficients().rbegin(), p.coefficients().rend());
  while (reversed.back() == 0) reversed.pop_back();
  if (reversed.size() == 1) return 1;  // 0 is the only root
  return 1 / root_bound(rational_polynomial(reversed));
}

}  // namespace

std::optional<bool> is_zero_at(const expression& g, algebraic_point& x) {
  if (std::ranges::all_of(x, [](const real_algebraic& t) { return t.exact().has_value(); })) {
    std::vector<symbol> point;
    for (const real_algebraic& t : x) point.emplace_back(*t.exact());
    const expression value(g.evaluate(std::span<const symbol>(point)), g.names());
    const std::optional<rational> q = value.rational_value();
    return q ? std::optional(*q == 0) : std::nullopt;
  }
  std::optional<rational> least;
  constexpr precision most_bits = 1L << 16;
  for (precision p = 64; p <= most_bits; p *= 2) {
    const std::vector<ball> at = enclosure_of(x, p);
    const ball value = g.evaluator<ball>(p)(std::span<const ball>(at));
    if (!value.is_bounded()) return std::nullopt;
    if (!contains_zero(value)) return false;
    if (!least) {
      std::vector<rational_polynomial> of;
      for (const real_algebraic& t : x) of.push_back(t.polynomial());
      const auto values = eliminant_of_values(g, of);
      if (!values) return std::nullopt;
      least = least_root_but_zero(*values);
    }
    if (certainly_less(abs(value), ball(*least, 64))) return true;
  }
  return std::nullopt;
}

common_zeros::common_zeros(std::span<const expression> components)
    : components_(components.begin(), components.end()),
      jacobian_(jacobian_determinant(components)) {
  std::vector<std::vector<real_algebraic>> all;
  for (const auto& p : eliminants(components)) {
    constexpr long most_degree = 100;
    if (!p || !jacobian_ || p->degree() > most_degree) return;
    std::vector<real_algebraic>& roots = all.emplace_back();
    for (const repeated_factor& f : square_free_decomposition(*p)) {
      const auto found = separate_real_roots(f.factor, [] { return true; });
      for (const rational& q : found->exact) roots.emplace_back(q);
      for (const exact_interval& b : found->brackets) roots.emplace_back(found->rest, b);
    }
  }
  coordinates_ = std::move(all);
}

std::optional<std::vector<common_zeros::solution>> common_zeros::in(std::span<const ball> box) {
  if (coordinates_.empty()) return std::nullopt;
  std::vector<algebraic_point> points(1);
  for (std::size_t i = 0; i < box.size(); ++i) {
    const exact_interval side{lower_rational(box[i]), upper_rational(box[i])};
    std::vector<algebraic_point> longer;
    for (real_algebraic& t : coordinates_[i]) {
      const std::optional<bool> is_in = t.is_in(side);
      if (!is_in) return std::nullopt;
      if (!*is_in) continue;
      for (const algebraic_point& x : points) longer.emplace_back(x).push_back(t);
    }
    constexpr std::size_t most_points = 16;
    if (longer.size() > most_points) return std::nullopt;
    points = std::move(longer);
  }
  std::vector<solution> result;
  for (algebraic_point& x : points) {
    bool is_solution = true;
    for (std::size_t k = 0; k < components_.size() && is_solution; ++k) {
      const std::optional<bool> is_zero = is_zero_at(components_[k], x);
      if (!is_zero) return std::nullopt;
      is_solution = *is_zero;
    }
    if (!is_solution) continue;
    const std::optional<bool> is_singular = is_zero_at(*jacobian_, x);
    if (!is_singular) return std::nullopt;
    result.push_back({*is_singular ? root_verdict::multiple : root_verdict::unique, std::move(x)});
  }
  return result;
}

}  // namespace polhode::detail
