// Quotients in exact_field. What is divided by is shown not to be 0; of a sum with square roots the
// denominator is made rational where that can be done, else the sum's reciprocal becomes a
// generator.

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "expression/exact/rationals.hpp"
#include "expression/exact/terms.hpp"
#include "expression/exact_number.hpp"

namespace polhode::detail {

using namespace exact_parts;

std::vector<generator_id> exact_field::square_roots_in(const exact_sum& x) const {
  std::vector<generator_id> result;
  for (const auto& [m, c] : x) {
    for (const auto& [g, exponent] : m) {
      if (generators_[g].what != kind::base || denominator(exponent) != 2) continue;
      if (std::find(result.begin(), result.end(), g) == result.end()) result.push_back(g);
    }
  }
  std::sort(result.rbegin(), result.rend());  // a root comes after what is under it
  return result;
}

std::optional<std::pair<exact_sum, exact_sum>> exact_field::split(const exact_sum& x,
                                                                  generator_id g) {
  exact_sum a;
  exact_sum b;
  for (const auto& [m, c] : x) {
    const rational exponent = exponent_in(m, g);
    if (exponent == 0) {
      add_to(a, m, c);
    } else if (exponent == half) {
      add_to(b, without(m, g), c);
    } else {
      return std::nullopt;
    }
  }
  return std::pair(a, b);
}

/// 1/x by x (a - b s) = a^2 - b^2 s^2 for x = a + b s and a square root s, until one term is left:
/// x times the factors is then that term, and as the term is not 0, neither is x.
exact_sum exact_field::rationalised_reciprocal(exact_sum x) {
  exact_sum factors = exactly(1);
  while (x.size() > 1) {
    bool found = false;
    for (const generator_id g : square_roots_in(x)) {
      const auto parts = split(x, g);
      if (!parts) continue;
      const exact_sum conjugate =
          difference(parts->first, product(parts->second, generated(g, half)));
      factors = product(factors, conjugate);
      x = product(x, conjugate);
      found = true;
      break;
    }
    if (!found) throw not_decided();
  }
  if (x.empty()) throw not_decided();
  return product(factors, reciprocal(x));
}

exact_sum exact_field::reciprocal(const exact_sum& x) {
  if (x.empty()) throw not_decided();
  if (x.size() == 1) {
    const auto& [m, c] = *x.begin();
    exact_sum result = exactly(rational(1 / c));
    for (const auto& [g, exponent] : monomial(m)) {
      if (!is_not_zero(g)) throw not_decided();
      const bool is_base = generators_[g].what == kind::base;
      result = product(result, is_base ? base_power(exact_sum(generators_[g].of), -exponent)
                                       : generated(g, -exponent));
    }
    return result;
  }
  const int s = sign(x);
  if (s == 0) throw not_decided();
  const rational c = content(x) * s;
  return scaled(base_power(scaled(x, 1 / c), -1), 1 / c);
}

exact_sum exact_field::quotient(const exact_sum& x, const exact_sum& y) {
  if (y.size() > 1 && x.size() == y.size()) {
    // x = t y for t a quotient of two of their terms: where y is not 0, x / y is t.
    for (const auto& [m, c] : y) {
      try {
        exact_sum t = product({*x.begin()}, reciprocal({{m, c}}));
        if (product(t, y) == x && sign(y) != 0) return t;
      } catch (const not_decided&) {
        break;
      }
    }
  }
  return product(x, reciprocal(y));
}

}  // namespace polhode::detail
