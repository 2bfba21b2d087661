// The generators of exact_field, and the bounds of its work: of terms, generators, bits and steps
// in all. What is known of a sum without a rule is its enclosure, made of those of its generators.

#include <algorithm>
#include <cstddef>
#include <optional>

#include "expression/exact/rationals.hpp"
#include "expression/exact_number.hpp"
#include "polhode/arithmetic/elementary.hpp"

namespace polhode::detail {

using namespace exact_parts;

namespace {

// Beyond these a number is left to its enclosures.
constexpr std::size_t most_terms = 64;
constexpr std::size_t most_generators = 96;
constexpr std::size_t most_steps = 20'000;
constexpr std::size_t most_further_steps = 100'000;

}  // namespace

exact_sum exactly(const rational& q) {
  exact_sum result;
  if (q != 0) result[{}] = q;
  return result;
}

void exact_field::spend(std::size_t steps) {
  spent_ += steps;
  if (spent_ > (further_ ? most_further_steps : most_steps)) throw not_decided();
}

void exact_field::check_size(const exact_sum& x) const {
  if (x.size() > most_terms) throw not_decided();
}

void exact_field::add_to(exact_sum& x, const monomial& m, const rational& c) {
  spend(1);
  if (c == 0) return;
  if (bits_of(c) > most_bits) throw not_decided();
  const auto [place, is_new] = x.emplace(m, c);
  if (is_new) return check_size(x);
  place->second += c;
  if (place->second == 0) x.erase(place);
}

std::optional<generator_id> exact_field::find(kind what, const exact_sum& of) const {
  for (generator_id i = 0; i < generators_.size(); ++i) {
    if (generators_[i].what == what && generators_[i].of == of) return i;
  }
  return std::nullopt;
}

generator_id exact_field::make(kind what, const exact_sum& of, const ball& enclosure) {
  spend(1);
  if (const auto known = find(what, of)) return *known;
  if (generators_.size() == most_generators) throw not_decided();
  generators_.push_back({what, of, enclosure});
  return static_cast<generator_id>(generators_.size() - 1);
}

exact_sum exact_field::generated(generator_id g, const rational& exponent) {
  if (exponent == 0) return exactly(1);
  if (bits_of(exponent) > most_bits) throw not_decided();
  return {{monomial{{g, exponent}}, rational(1)}};
}

bool exact_field::is_positive(generator_id g) const {
  const generator& x = generators_[g];
  if (x.what != kind::log && x.what != kind::opaque && x.what != kind::angle_cosine &&
      x.what != kind::angle_sine) {
    return true;
  }
  return certainly_positive(x.enclosure);
}

bool exact_field::is_not_zero(generator_id g) const {
  return is_positive(g) || certainly_negative(generators_[g].enclosure);
}

bool exact_field::is_positive(const monomial& m) const {
  return std::all_of(m.begin(), m.end(),
                     [this](const auto& part) { return is_positive(part.first); });
}

ball exact_field::enclosure(const exact_sum& x) {
  ball result(0, bits);
  for (const auto& [m, c] : x) {
    ball term(c, bits);
    for (const auto& [g, exponent] : m) {
      spend(4);
      const ball& base = generators_[g].enclosure;
      const integer n = numerator(exponent);
      if (is_integer(exponent)) {
        term = term * polhode::pow(base, as_long(n));
      } else if (exponent == half) {
        term = term * polhode::sqrt(base);
      } else {
        term = term * polhode::pow(base, exponent);
      }
    }
    result = result + term;
  }
  return result;
}

exact_sum exact_field::pi() { return generated(make(kind::pi, {}, polhode::pi(bits))); }

exact_sum exact_field::opaque(std::uint32_t key, const ball& around) {
  return generated(make(kind::opaque, exactly(key), around));
}

}  // namespace polhode::detail
