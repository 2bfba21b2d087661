// Numbers of exact_field shown to be rational where the terms of their sums do not cancel by
// themselves: cbrt(2 + sqrt 5) + cbrt(2 - sqrt 5) is 1. An enclosure of 512 bits suggests the
// rational number q; that x - q is 0 is shown in one of three ways, each of them a proof.

#include <algorithm>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "expression/exact_number.hpp"
#include "polhode/arithmetic/polynomial.hpp"

namespace polhode::detail {
namespace {

constexpr std::size_t most_bits_of_suggestion = 64;
constexpr int most_rounds = 8;  // in which reciprocals are cleared, or conjugates multiplied
constexpr std::size_t greatest_degree = 30;

/// A sum of powers of a number, and which: row = the sum of coefficients[k] x^k.
struct combination {
  exact_sum row;
  std::vector<rational> coefficients;
};

rational absolute(const rational& q) { return q < 0 ? rational(-q) : q; }

/// Whether all roots but 0 of the polynomial a_0 + a_1 t + ... + a_n t^n, a_n not 0, lie outside of
/// `around`, and 0 is a root. By Cauchy: with a_j the first coefficient that is not 0, |t| >=
/// |a_j|/(|a_j| + max |a_i|) for roots t other than 0, as 1/t is a root of a_j t^(n-j) + ... + a_n,
/// whose roots are at most 1 + max |a_i/a_j| (M. Marden, Geometry of Polynomials, 1966, th. 27.2).
bool has_no_root_but_zero_in(const std::vector<rational>& a, const ball& around) {
  std::size_t j = 0;
  while (a[j] == 0) ++j;
  if (j == 0) return false;
  rational greatest = 0;
  for (std::size_t i = j + 1; i < a.size(); ++i) greatest = std::max(greatest, absolute(a[i]));
  const rational least = absolute(a[j]);
  const ball bound(rational(least / (least + greatest)), around.precision());
  return certainly_positive(bound - around) && certainly_positive(bound + around);
}

}  // namespace

std::optional<rational> exact_field::rational_by_further_rules(const exact_sum& x) {
  if (shows_zero_) return std::nullopt;
  const ball around = enclosure(x);
  if (!around.is_bounded()) return std::nullopt;
  // The ends of an enclosure of e^(10^9), or of e^(-10^9), are rational numbers of as many bits.
  constexpr auto bits = static_cast<std::int64_t>(most_bits_of_suggestion);
  const bool is_near_zero = contains_zero(around);
  if (around.magnitude_upper() > magnitude::power_of_two(bits) ||
      (!is_near_zero && around.magnitude_upper() < magnitude::power_of_two(-bits))) {
    return std::nullopt;
  }
  constexpr int most_quotients = 64;
  const auto q = is_near_zero ? rational(0)
                              : simplest_between(lower_rational(around), upper_rational(around),
                                                 most_quotients);
  if (!q || mpz_sizeinbase(mpq_numref(q->backend().data()), 2) > most_bits_of_suggestion ||
      mpz_sizeinbase(mpq_denref(q->backend().data()), 2) > most_bits_of_suggestion) {
    return std::nullopt;
  }
  shows_zero_ = true;
  bool is_shown = false;
  try {
    is_shown = is_shown_to_be_zero(difference(x, exactly(*q)));
  } catch (const not_decided&) {
    is_shown = false;
  }
  shows_zero_ = false;
  return is_shown ? q : std::nullopt;
}

bool exact_field::is_shown_to_be_zero(const exact_sum& x) {
  const exact_sum y = without_reciprocals(x);
  if (y.empty()) return true;
  try {
    if (is_zero_by_conjugates(y)) return true;
  } catch (const not_decided&) {
    spend(1);
  }
  return is_zero_by_a_polynomial(y);
}

/// x times powers of generators of which it has reciprocals: none is 0, or it would have none. So
/// the result is 0 where x is.
exact_sum exact_field::without_reciprocals(exact_sum x) {
  for (int round = 0; round < most_rounds; ++round) {
    std::map<generator_id, rational> least;  // whole exponents
    for (const auto& [m, c] : x) {
      for (const auto& [g, exponent] : m) {
        if (exponent >= 0) continue;
        least[g] = std::min(least[g], rational(floor_of(exponent)));
      }
    }
    if (least.empty()) return x;
    exact_sum next;
    for (const auto& [m, c] : x) {
      monomial raised;
      auto place = least.begin();
      const auto raise_until = [&](generator_id end) {
        for (; place != least.end() && place->first < end; ++place) {
          raised.emplace_back(place->first, -place->second);
        }
      };
      for (const auto& [g, exponent] : m) {
        raise_until(g);
        const bool is_raised = place != least.end() && place->first == g;
        const rational e = is_raised ? rational(exponent - (place++)->second) : exponent;
        if (e != 0) raised.emplace_back(g, e);
      }
      raise_until(static_cast<generator_id>(generators_.size()));
      next = sum(next, scaled(expanded(raised), c));
    }
    x = std::move(next);
  }
  throw not_decided();
}

/// x = a + b s with a square root s is 0 where (a + b s)(a - b s) = a^2 - b^2 s^2 is, and a - b s
/// is not: the enclosure tells that. One root after the other, the outer ones first.
bool exact_field::is_zero_by_conjugates(exact_sum x) {
  for (int round = 0; round < most_rounds; ++round) {
    bool found = false;
    for (const generator_id g : square_roots_in(x)) {
      const auto parts = split(x, g);
      if (!parts) continue;
      const auto& [a, b] = *parts;
      const exact_sum conjugate = difference(a, product(b, generated(g, rational(1, 2))));
      if (contains_zero(enclosure(conjugate))) continue;
      x = without_reciprocals(
          difference(product(a, a), product(product(b, b), exact_sum(generators_[g].of))));
      found = true;
      break;
    }
    if (x.empty()) return true;
    if (!found) return false;
  }
  return false;
}

bool exact_field::is_algebraic(generator_id g) const {
  const generator& x = generators_[g];
  if (x.what == kind::cosine) return true;
  if (x.what != kind::base) return false;
  return std::all_of(x.of.begin(), x.of.end(), [this](const auto& term) {
    return std::all_of(term.first.begin(), term.first.end(),
                       [this](const auto& part) { return is_algebraic(part.first); });
  });
}

/// x = the sum of A_k M_k with different products M_k of generators that are not algebraic: each
/// A_k is shown to be 0. The powers 1, A, A^2, ... lie in a space over the rational numbers whose
/// dimension is the product of the degrees of A's roots at most, so that some combination of them
/// cancels term by term: a polynomial that A is a root of. Where 0 is a root of it too, and the
/// others are farther from 0 than A's enclosure reaches, A is 0.
bool exact_field::is_zero_by_a_polynomial(const exact_sum& x) {
  std::map<monomial, exact_sum> coefficients;
  for (const auto& [m, c] : x) {
    monomial algebraic;
    monomial others;
    for (const auto& part : m) {
      (is_algebraic(part.first) ? algebraic : others).push_back(part);
    }
    add_to(coefficients[others], algebraic, c);
  }
  for (const auto& [others, a] : coefficients) {
    std::vector<combination> rows;
    combination power{exactly(1), {1}};
    bool is_zero = false;
    for (std::size_t degree = 0; !is_zero; ++degree) {
      if (degree > greatest_degree) return false;
      combination next = power;
      for (const combination& known : rows) {
        const auto pivot = next.row.find(known.row.begin()->first);
        if (pivot == next.row.end()) continue;
        const rational factor = pivot->second / known.row.begin()->second;
        for (const auto& [m, c] : known.row) add_to(next.row, m, rational(-factor * c));
        for (std::size_t k = 0; k < known.coefficients.size(); ++k) {
          next.coefficients[k] -= factor * known.coefficients[k];
        }
      }
      if (next.row.empty()) {
        if (!has_no_root_but_zero_in(next.coefficients, enclosure(a))) return false;
        is_zero = true;
      } else {
        rows.push_back(std::move(next));
      }
      power.row = product(power.row, a);
      power.coefficients.assign(degree + 1, 0);
      power.coefficients.emplace_back(1);
    }
  }
  return true;
}

}  // namespace polhode::detail
