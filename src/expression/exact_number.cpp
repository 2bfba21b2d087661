#include "exact_number.hpp"

#include <algorithm>
#include <utility>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/polynomial.hpp"

namespace polhode::detail {
namespace {

// Beyond these a number is left to its enclosures.
constexpr std::size_t most_terms = 64;
constexpr std::size_t most_generators = 96;
constexpr std::size_t most_steps = 20'000;
constexpr std::size_t most_further_steps = 100'000;
constexpr std::size_t most_bits = 1U << 14;  // of a coefficient
constexpr long most_factors_at_once = 64;    // of a power of a sum
constexpr int deepest_root = 3;              // roots taken to find a root
constexpr long greatest_denominator = 120;   // of an angle that is looked for

const rational half(1, 2);

std::size_t bits_of(const rational& q) {
  return std::max(mpz_sizeinbase(mpq_numref(q.backend().data()), 2),
                  mpz_sizeinbase(mpq_denref(q.backend().data()), 2));
}
bool is_integer(const rational& q) { return denominator(q) == 1; }
/// In steps, of which one takes about a microsecond.
std::size_t cost_of_factors(const rational& c) { return 100 + bits_of(c) / 4; }

integer floor_of(const rational& q) {
  integer n;
  mpz_fdiv_q(n.backend().data(), mpq_numref(q.backend().data()), mpq_denref(q.backend().data()));
  return n;
}

long as_long(const integer& n) {
  if (mpz_fits_slong_p(n.backend().data()) == 0) throw not_decided();
  return mpz_get_si(n.backend().data());
}

/// c^n for c != 0, if it is short.
rational integer_power_of(const rational& c, const integer& n) {
  if (c == 1 || n == 0) return 1;
  if (c == -1) return mpz_even_p(n.backend().data()) != 0 ? 1 : -1;
  const long exponent = as_long(n);
  const unsigned long size = exponent < 0 ? 0UL - static_cast<unsigned long>(exponent)
                                          : static_cast<unsigned long>(exponent);
  if (size > most_bits / bits_of(c)) throw not_decided();
  integer above = numerator(c);
  integer below = denominator(c);
  mpz_pow_ui(above.backend().data(), above.backend().data(), size);
  mpz_pow_ui(below.backend().data(), below.backend().data(), size);
  return exponent < 0 ? rational(rational(below) / rational(above))
                      : rational(rational(above) / rational(below));
}

// ---------------------------------------------------------------------------------------------
// Factors of natural numbers

constexpr unsigned long all_primes_below = 1UL << 16;

const std::vector<unsigned long>& small_primes() {
  static const std::vector<unsigned long> primes = [] {
    std::vector<char> composite(all_primes_below, 0);
    std::vector<unsigned long> result;
    for (unsigned long p = 2; p < all_primes_below; ++p) {
      if (composite[p] != 0) continue;
      result.push_back(p);
      for (unsigned long k = p * p; k < all_primes_below; k += p) composite[k] = 1;
    }
    return result;
  }();
  return primes;
}

struct factor {
  integer base;
  long multiplicity;
  bool is_prime;  // as far as is known
};

/// n > 0 as a product of powers: of small primes, and of what is left of n, which is no power itself.
std::vector<factor> factors_of(integer n) {
  constexpr std::size_t short_bits = 128;
  constexpr unsigned long fewer_primes_below = 1000;
  std::vector<factor> result;
  unsigned long below = all_primes_below;
  for (const unsigned long p : small_primes()) {
    if (n == 1) return result;
    if (p > fewer_primes_below && mpz_sizeinbase(n.backend().data(), 2) > short_bits) {
      below = fewer_primes_below;
      break;
    }
    if (mpz_cmp_ui(n.backend().data(), p * p) < 0) break;  // n is prime
    if (mpz_divisible_ui_p(n.backend().data(), p) == 0) continue;
    const integer prime = p;
    const auto k = static_cast<long>(
        mpz_remove(n.backend().data(), n.backend().data(), prime.backend().data()));
    result.push_back({prime, k, true});
  }
  if (n == 1) return result;
  // No prime below the bound divides n, but where n was found to be prime.
  long multiplicity = 1;
  for (unsigned long k = 2; k < mpz_sizeinbase(n.backend().data(), 2);) {
    integer r;
    if (mpz_root(r.backend().data(), n.backend().data(), k) != 0) {
      n = r;
      multiplicity *= static_cast<long>(k);
    } else {
      ++k;
    }
    constexpr unsigned long greatest_order = 64;
    if (k > greatest_order) break;
  }
  result.push_back({n, multiplicity, n < integer(below) * below});
  return result;
}

// ---------------------------------------------------------------------------------------------
// Sums

/// The greatest rational number c > 0 with x / c of coprime integer coefficients. Hypothesis: x is not 0.
rational content(const exact_number& x) {
  integer above = 0;
  integer below = 1;
  for (const auto& [m, c] : x) {
    above = gcd(above, numerator(c));
    below = lcm(below, denominator(c));
  }
  return rational(above) / rational(below);
}

monomial merged(const monomial& x, const monomial& y) {
  monomial result;
  result.reserve(x.size() + y.size());
  auto i = x.begin();
  auto j = y.begin();
  while (i != x.end() || j != y.end()) {
    if (j == y.end() || (i != x.end() && i->first < j->first)) {
      result.push_back(*i++);
    } else if (i == x.end() || j->first < i->first) {
      result.push_back(*j++);
    } else {
      const rational exponent = i->second + j->second;
      if (exponent != 0) result.emplace_back(i->first, exponent);
      ++i;
      ++j;
    }
  }
  return result;
}

std::optional<rational> plain_number(const exact_number& x) {
  if (x.empty()) return rational(0);
  if (x.size() == 1 && x.begin()->first.empty()) return x.begin()->second;
  return std::nullopt;
}

rational exponent_in(const monomial& m, generator_id g) {
  for (const auto& [id, exponent] : m) {
    if (id == g) return exponent;
  }
  return 0;
}

monomial without(monomial m, generator_id g) {
  std::erase_if(m, [g](const auto& part) { return part.first == g; });
  return m;
}

}  // namespace

exact_number exactly(const rational& q) {
  exact_number result;
  if (q != 0) result[{}] = q;
  return result;
}

// ---------------------------------------------------------------------------------------------
// Bounds

void exact_field::spend(std::size_t steps) {
  spent_ += steps;
  if (spent_ > (further_ ? most_further_steps : most_steps)) throw not_decided();
}

void exact_field::check_size(const exact_number& x) const {
  if (x.size() > most_terms) throw not_decided();
}

void exact_field::add_to(exact_number& x, const monomial& m, const rational& c) {
  spend(1);
  if (c == 0) return;
  if (bits_of(c) > most_bits) throw not_decided();
  const auto [place, is_new] = x.emplace(m, c);
  if (is_new) return check_size(x);
  place->second += c;
  if (place->second == 0) x.erase(place);
}

// ---------------------------------------------------------------------------------------------
// Generators

std::optional<generator_id> exact_field::find(kind what, const exact_number& of) const {
  for (generator_id i = 0; i < generators_.size(); ++i) {
    if (generators_[i].what == what && generators_[i].of == of) return i;
  }
  return std::nullopt;
}

generator_id exact_field::make(kind what, const exact_number& of, const ball& enclosure) {
  spend(1);
  if (const auto known = find(what, of)) return *known;
  if (generators_.size() == most_generators) throw not_decided();
  generators_.push_back({what, of, enclosure});
  return static_cast<generator_id>(generators_.size() - 1);
}

exact_number exact_field::generated(generator_id g, const rational& exponent) {
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

ball exact_field::enclosure(const exact_number& x) {
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

// ---------------------------------------------------------------------------------------------
// Sums and products

exact_number exact_field::sum(const exact_number& x, const exact_number& y) {
  exact_number result = x;
  for (const auto& [m, c] : y) add_to(result, m, c);
  return result;
}

exact_number exact_field::scaled(const exact_number& x, const rational& q) {
  exact_number result;
  for (const auto& [m, c] : x) add_to(result, m, rational(c * q));
  return result;
}

exact_number exact_field::difference(const exact_number& x, const exact_number& y) {
  return sum(x, scaled(y, -1));
}

/// The product of powers m, in which g^q = g^floor(q) g^(q - floor(q)) is done for those g that are a natural number or
/// a sum.
exact_number exact_field::expanded(const monomial& m) {
  if (has_waves_to_reduce(m)) return with_waves_reduced(m);
  monomial kept;
  rational coefficient = 1;
  exact_number whole = exactly(1);
  for (const auto& [g, exponent] : m) {
    const generator& x = generators_[g];
    const bool is_base = x.what == kind::base;
    const std::optional<rational> number = is_base ? plain_number(x.of) : std::nullopt;
    if (!is_base || (exponent < 1 && (exponent >= 0 || !number))) {
      kept.emplace_back(g, exponent);
      continue;
    }
    const integer n = floor_of(exponent);
    if (const rational rest = exponent - rational(n); rest != 0) kept.emplace_back(g, rest);
    if (number) {
      coefficient *= integer_power_of(*number, n);
    } else {
      whole = product(whole, integer_power(exact_number(x.of), as_long(n)));
    }
  }
  const exact_number rest = {{kept, coefficient}};
  return whole == exactly(1) ? rest : product(whole, rest);
}

exact_number exact_field::product(const exact_number& x, const exact_number& y) {
  exact_number result;
  for (const auto& [m, c] : x) {
    for (const auto& [n, d] : y) {
      spend(1);
      const monomial both = merged(m, n);
      const bool is_plain = !has_waves_to_reduce(both) &&
                            std::none_of(both.begin(), both.end(), [this](const auto& part) {
                              const generator& g = generators_[part.first];
                              return g.what == kind::base &&
                                     (part.second >= 1 || (part.second < 0 && plain_number(g.of)));
                            });
      if (is_plain) {
        add_to(result, both, rational(c * d));
      } else {
        for (const auto& [e, f] : expanded(both)) add_to(result, e, rational(c * d * f));
      }
    }
  }
  return result;
}

exact_number exact_field::integer_power(const exact_number& x, long n) {
  if (n == 0) return exactly(1);
  if (n < 0) {
    if (n < -(1L << 62)) throw not_decided();
    return integer_power(reciprocal(x), -n);
  }
  if (x.empty()) return x;
  if (x.size() == 1) {
    monomial m = x.begin()->first;
    for (auto& part : m) part.second *= n;
    return scaled(expanded(m), integer_power_of(x.begin()->second, n));
  }
  if (n > most_factors_at_once) throw not_decided();
  exact_number result = exactly(1);
  exact_number square = x;
  for (;; n /= 2) {
    if (n % 2 == 1) result = product(result, square);
    if (n == 1) return result;
    square = product(square, square);
  }
}

// ---------------------------------------------------------------------------------------------
// Quotients

std::vector<generator_id> exact_field::square_roots_in(const exact_number& x) const {
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

std::optional<std::pair<exact_number, exact_number>> exact_field::split(const exact_number& x,
                                                                        generator_id g) {
  exact_number a;
  exact_number b;
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

/// 1/x by x (a - b s) = a^2 - b^2 s^2 for x = a + b s and a square root s, until one term is left: x times the
/// factors is then that term, and as the term is not 0, neither is x.
exact_number exact_field::rationalised_reciprocal(exact_number x) {
  exact_number factors = exactly(1);
  while (x.size() > 1) {
    bool found = false;
    for (const generator_id g : square_roots_in(x)) {
      const auto parts = split(x, g);
      if (!parts) continue;
      const exact_number conjugate =
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

exact_number exact_field::reciprocal(const exact_number& x) {
  if (x.empty()) throw not_decided();
  if (x.size() == 1) {
    const auto& [m, c] = *x.begin();
    exact_number result = exactly(rational(1 / c));
    for (const auto& [g, exponent] : monomial(m)) {
      if (!is_not_zero(g)) throw not_decided();
      const bool is_base = generators_[g].what == kind::base;
      result = product(result, is_base ? base_power(exact_number(generators_[g].of), -exponent)
                                       : generated(g, -exponent));
    }
    return result;
  }
  const int s = sign(x);
  if (s == 0) throw not_decided();
  const rational c = content(x) * s;
  return scaled(base_power(scaled(x, 1 / c), -1), 1 / c);
}

exact_number exact_field::quotient(const exact_number& x, const exact_number& y) {
  if (y.size() > 1 && x.size() == y.size()) {
    // x = t y for t a quotient of two of their terms: where y is not 0, x / y is t.
    for (const auto& [m, c] : y) {
      try {
        exact_number t = product({*x.begin()}, reciprocal({{m, c}}));
        if (product(t, y) == x && sign(y) != 0) return t;
      } catch (const not_decided&) {
        break;
      }
    }
  }
  return product(x, reciprocal(y));
}

// ---------------------------------------------------------------------------------------------
// Powers and roots

exact_number exact_field::number_power(const rational& c, const rational& q) {
  if (c == 1) return exactly(1);
  spend(cost_of_factors(c));
  exact_number result = exactly(1);
  for (const bool above : {true, false}) {
    for (const factor& f : factors_of(above ? numerator(c) : denominator(c))) {
      const rational exponent = (above ? q : rational(-q)) * f.multiplicity;
      result = product(result, base_power(exactly(rational(f.base)), exponent));
    }
  }
  return result;
}

/// v^q for a natural number v > 1 that is no power, or a sum v > 0 with coprime integer coefficients.
exact_number exact_field::base_power(const exact_number& v, const rational& q) {
  const integer n = floor_of(q);
  const rational rest = q - rational(n);
  const std::optional<rational> number = plain_number(v);
  if (number && *number == 1) return v;
  exact_number whole = exactly(1);
  if (number) {
    whole = exactly(integer_power_of(*number, n));
  } else if (n > 0) {
    whole = integer_power(v, as_long(n));
  } else if (n < 0) {
    try {
      whole = integer_power(rationalised_reciprocal(v), as_long(integer(-n)));
    } catch (const not_decided&) {
      return generated(make(kind::base, v, enclosure(v)), q);
    }
  }
  if (rest == 0) return whole;
  if (!number && rest == half && !find(kind::base, v)) {
    // sqrt(v) = s/sqrt(u) for a root sqrt(u) that is known and s = sqrt(u v).
    for (generator_id g = 0; g < generators_.size(); ++g) {
      const exact_number u = generators_[g].of;
      if (generators_[g].what != kind::base || plain_number(u)) continue;
      try {
        const auto s = plain_root(product(u, v), deepest_root);
        if (!s) continue;
        const exact_number root =
            product(product(*s, rationalised_reciprocal(u)), generated(g, half));
        return product(whole, root);
      } catch (const not_decided&) {
        spend(1);
      }
    }
  }
  return product(whole, generated(make(kind::base, v, enclosure(v)), rest));
}

/// The root of a term or a sum, without a root of a sum that is not one already.
std::optional<exact_number> exact_field::plain_root(const exact_number& x, int depth) {
  if (x.empty()) return x;
  if (x.size() > 1) return denested_root(x, depth);
  if (x.begin()->second < 0 || !is_positive(x.begin()->first)) return std::nullopt;
  return power(x, half);
}

/// sqrt(x) of a sum x = a + b g^(1/2) > 0 as sqrt((a + r)/2) + sqrt((a - r)/2), or the difference, with
/// r = sqrt(a^2 - b^2 g). However it was found, s is the root where s^2 = x and s > 0; both are checked.
std::optional<exact_number> exact_field::denested_root(const exact_number& x, int depth) {
  if (depth == 0 || x.size() < 2) return std::nullopt;
  for (const generator_id g : square_roots_in(x)) {
    try {
      const auto parts = split(x, g);
      if (!parts) continue;
      const auto& [a, b] = *parts;
      const exact_number square =
          difference(product(a, a), product(product(b, b), exact_number(generators_[g].of)));
      const auto r = plain_root(square, depth - 1);
      if (!r) continue;
      const auto first = plain_root(scaled(sum(a, *r), half), depth - 1);
      if (!first) continue;
      const auto second = plain_root(scaled(difference(a, *r), half), depth - 1);
      if (!second) continue;
      for (const int s : {1, -1}) {
        const exact_number root = sum(*first, scaled(*second, s));
        if (product(root, root) == x) return scaled(root, sign(root));
      }
    } catch (const not_decided&) {
      spend(1);
    }
  }
  return std::nullopt;
}

exact_number exact_field::power(const exact_number& x, const rational& q) {
  if (is_integer(q)) return integer_power(x, as_long(numerator(q)));
  if (x.empty()) {
    if (q < 0) throw not_decided();
    return x;
  }
  if (x.size() == 1 && x.begin()->second > 0 && is_positive(x.begin()->first)) {
    const auto [m, c] = *x.begin();
    exact_number result = number_power(c, q);
    for (const auto& [g, exponent] : m) {
      const bool is_base = generators_[g].what == kind::base;
      const rational e = exponent * q;
      result = product(result,
                       is_base ? base_power(exact_number(generators_[g].of), e) : generated(g, e));
    }
    return result;
  }
  if (sign(x) != 1) throw not_decided();
  if (denominator(q) == 2) {
    if (const auto root = denested_root(x, deepest_root)) {
      return integer_power(*root, as_long(numerator(q)));
    }
  }
  const rational c = content(x);
  return product(number_power(c, q), base_power(scaled(x, 1 / c), q));
}

exact_number exact_field::root(const exact_number& x, long n) {
  if (n % 2 == 0 || x.empty()) return power(x, rational(1, n));
  const int s = sign(x);
  return scaled(power(scaled(x, s), rational(1, n)), s);
}

// ---------------------------------------------------------------------------------------------
// What is decided by enclosures

int exact_field::sign(const exact_number& x) {
  if (x.empty()) return 0;
  if (x.size() == 1 && is_positive(x.begin()->first)) return x.begin()->second > 0 ? 1 : -1;
  switch (sign_of(enclosure(x))) {
    case polhode::sign::positive:
      return 1;
    case polhode::sign::negative:
      return -1;
    case polhode::sign::zero:
      return 0;
    default:
      break;
  }
  const auto q = as_rational(x);
  if (!q) throw not_decided();
  return q->sign();
}

exact_number exact_field::abs(const exact_number& x) { return scaled(x, sign(x)); }

exact_number exact_field::floor(const exact_number& x) {
  if (const auto q = as_rational(x)) return exactly(rational(floor_of(*q)));
  const ball around = enclosure(x);
  if (!around.is_bounded()) throw not_decided();
  const integer n = floor_of(lower_rational(around));
  if (n != floor_of(upper_rational(around))) throw not_decided();
  return exactly(rational(n));
}

namespace {

/// A polynomial's coefficients, from the constant one.
using coefficients = std::vector<rational>;

/// Leaves the remainder of division by a polynomial whose leading coefficient is 1, and returns the quotient.
coefficients divide(coefficients& x, const coefficients& y) {
  if (x.size() < y.size()) return {};
  coefficients quotient(x.size() - y.size() + 1);
  for (std::size_t i = quotient.size(); i-- > 0;) {
    quotient[i] = x[i + y.size() - 1];
    if (quotient[i] == 0) continue;
    for (std::size_t k = 0; k < y.size(); ++k) x[i + k] -= quotient[i] * y[k];
  }
  x.resize(y.size() - 1);
  return quotient;
}

coefficients at_power(const coefficients& x, std::size_t p) {
  coefficients result(p * (x.size() - 1) + 1);
  for (std::size_t k = 0; k < x.size(); ++k) result[p * k] = x[k];
  return result;
}

/// The cyclotomic polynomial Phi_n, whose roots are the primitive n-th roots of unity: Phi_1 = x - 1, and for a prime p
/// Phi_pm(x) = Phi_m(x^p) where p divides m, else Phi_m(x^p)/Phi_m(x).
coefficients cyclotomic(std::size_t n) {
  coefficients result{-1, 1};
  std::size_t done = 1;
  for (std::size_t prime = 2; done < n; ++prime) {
    while (n / done % prime == 0) {
      coefficients next = at_power(result, prime);
      result = done % prime == 0 ? std::move(next) : divide(next, result);
      done *= prime;
    }
  }
  return result;
}

}  // namespace

/// Of a sum of products of cosines: with z = e^(i pi/N), cos(pi k/N) = (z^k + z^-k)/2, so that the sum is a polynomial in z, of which
/// z^(2N) = 1 and the cyclotomic polynomial's value 0 leave the remainder.
std::optional<rational> exact_field::rational_by_roots_of_unity(const exact_number& x) {
  constexpr long greatest_order = 120;
  constexpr long most_factors = 30;
  integer common = 1;
  for (const auto& [m, c] : x) {
    long factors = 0;
    for (const auto& [g, exponent] : m) {
      const bool is_cosine = generators_[g].what == kind::cosine;
      if (!is_cosine || !is_integer(exponent) || exponent < 0 || exponent > most_factors) {
        return std::nullopt;
      }
      factors += as_long(numerator(exponent));
      const integer below = denominator(*plain_number(generators_[g].of));
      common = lcm(common, below);
      if (factors > most_factors || common > greatest_order) return std::nullopt;
    }
  }
  const auto n = static_cast<std::size_t>(2 * as_long(common));
  coefficients total(n);
  for (const auto& [m, c] : x) {
    coefficients term(n);
    term[0] = c;
    for (const auto& [g, exponent] : m) {
      const rational angle(*plain_number(generators_[g].of) * common);
      const auto k = static_cast<std::size_t>(as_long(numerator(angle)));  // 0 < k < n/4
      for (long i = as_long(numerator(exponent)); i > 0; --i) {
        spend(n);
        coefficients next(n);
        for (std::size_t j = 0; j < n; ++j) {
          if (term[j] == 0) continue;
          next[(j + k) % n] += term[j] * half;
          next[(j + n - k) % n] += term[j] * half;
        }
        term = std::move(next);
      }
    }
    for (std::size_t j = 0; j < n; ++j) total[j] += term[j];
  }
  spend(n * n / 4);
  (void)divide(total, cyclotomic(n));
  if (std::any_of(total.begin() + 1, total.end(), [](const rational& c) { return c != 0; })) {
    return std::nullopt;
  }
  return total[0];
}

/// The sum itself where one number is left, or where it is one of cosines that are roots of unity; else, where it has the reciprocals of sums v_i, N = q D is looked for with D
/// the product of their powers and N = x D.
std::optional<rational> exact_field::as_rational(const exact_number& x) {
  if (auto q = plain_number(x)) return q;
  if (auto q = rational_by_roots_of_unity(x)) return q;
  std::map<generator_id, rational> reciprocals;  // the least exponents
  for (const auto& [m, c] : x) {
    for (const auto& [g, exponent] : m) {
      if (generators_[g].what != kind::base || exponent >= 0) continue;
      rational& least = reciprocals[g];
      least = std::min(least, rational(floor_of(exponent)));
    }
  }
  if (further_) return rational_by_further_rules(x);
  if (reciprocals.empty()) return std::nullopt;
  try {
    monomial powers;
    exact_number below = exactly(1);
    for (const auto& [g, exponent] : reciprocals) {
      powers.emplace_back(g, -exponent);
      below = product(below, integer_power(exact_number(generators_[g].of),
                                           as_long(numerator(rational(-exponent)))));
    }
    exact_number above;
    for (const auto& [m, c] : x) above = sum(above, scaled(expanded(merged(m, powers)), c));
    if (above.empty()) return rational(0);
    if (above.size() != below.size() || above.begin()->first != below.begin()->first) {
      return std::nullopt;
    }
    const rational q = above.begin()->second / below.begin()->second;
    if (scaled(below, q) == above) return q;
  } catch (const not_decided&) {
    return std::nullopt;
  }
  return std::nullopt;
}

// ---------------------------------------------------------------------------------------------
// Exponentials and logarithms

exact_number exact_field::pi() { return generated(make(kind::pi, {}, polhode::pi(bits))); }

exact_number exact_field::opaque(std::uint32_t key, const ball& around) {
  return generated(make(kind::opaque, exactly(key), around));
}

/// exp(c log v) = v^c, and exp(c m) = exp(m)^c.
exact_number exact_field::exp(const exact_number& x) {
  exact_number result = exactly(1);
  for (const auto& [m, c] : x) {
    if (m.size() == 1 && m.front().second == 1 && generators_[m.front().first].what == kind::log) {
      result = product(result, power(exact_number(generators_[m.front().first].of), c));
      continue;
    }
    const exact_number argument = {{m, rational(1)}};
    const generator_id g = make(kind::exp, argument, polhode::exp(enclosure(argument)));
    result = product(result, generated(g, c));
  }
  return result;
}

exact_number exact_field::log_of_number(const rational& c) {
  spend(cost_of_factors(c));
  exact_number result;
  for (const bool above : {true, false}) {
    for (const factor& f : factors_of(above ? numerator(c) : denominator(c))) {
      const exact_number base = exactly(rational(f.base));
      const generator_id g = make(kind::log, base, polhode::log(ball(f.base, bits)));
      add_to(result, monomial{{g, rational(1)}}, above ? f.multiplicity : -f.multiplicity);
    }
  }
  return result;
}

/// log v of a positive sum with coprime integer coefficients: -log(1/v) where v < 1 and 1/v is such a sum, 2 log sqrt(v)
/// where the root has a form without nested roots.
exact_number exact_field::log_of_sum(const exact_number& v) {
  if (const auto q = plain_number(v)) return log_of_number(*q);
  if (sign(difference(exactly(1), v)) > 0) {
    std::optional<exact_number> inverse;
    try {
      inverse = rationalised_reciprocal(v);
    } catch (const not_decided&) {
      spend(1);
    }
    if (inverse) return scaled(log(*inverse), -1);
  }
  if (const auto root = denested_root(v, deepest_root)) return scaled(log(*root), 2);
  return generated(make(kind::log, v, polhode::log(enclosure(v))));
}

exact_number exact_field::log(const exact_number& x) {
  if (sign(x) != 1) throw not_decided();
  const auto [first, c] = *x.begin();
  if (x.size() > 1) {
    const rational whole = content(x);
    return sum(log_of_number(whole), log_of_sum(scaled(x, 1 / whole)));
  }
  if (c < 0 || !is_positive(first)) {
    return generated(make(kind::log, x, polhode::log(enclosure(x))));
  }
  exact_number result = log_of_number(c);
  for (const auto& [g, exponent] : first) {
    const exact_number of = generators_[g].of;
    exact_number part;
    if (generators_[g].what == kind::base) {
      part = log_of_sum(of);
    } else if (generators_[g].what == kind::exp) {
      part = of;
    } else {
      part = generated(make(kind::log, generated(g), polhode::log(ball(generators_[g].enclosure))));
    }
    result = sum(result, scaled(part, exponent));
  }
  return result;
}

// ---------------------------------------------------------------------------------------------
// Angles

/// cos(pi q): by its period and symmetries from 0 <= q <= 1/2; there cos(pi/3) = 1/2, cos(pi/4) = sqrt(2)/2,
/// cos(pi/6) = sqrt(3)/2, cos(pi/5) = (1 + sqrt 5)/4, cos(2 pi/5) = (sqrt 5 - 1)/4, cos(pi/12) = (sqrt 6 + sqrt 2)/4,
/// cos(5 pi/12) = (sqrt 6 - sqrt 2)/4, and cos(x/2) = sqrt((1 + cos x)/2) for others whose denominator is one of these
/// and some factors 2 more.
exact_number exact_field::cospi(const rational& q) {
  if (bits_of(q) > most_bits) throw not_decided();
  spend(4);
  rational angle = q - 2 * rational(floor_of(q * half));
  if (angle > 1) angle = 2 - angle;
  if (angle > half) return scaled(cospi(1 - angle), -1);
  const auto root = [this](long n) { return number_power(n, half); };
  const auto is = [&](long above, long below) { return angle == rational(above, below); };
  if (angle == 0) return exactly(1);
  if (is(1, 2)) return {};
  if (is(1, 3)) return exactly(half);
  if (is(1, 4)) return scaled(root(2), half);
  if (is(1, 6)) return scaled(root(3), half);
  const rational quarter(1, 4);
  if (is(1, 5)) return scaled(sum(root(5), exactly(1)), quarter);
  if (is(2, 5)) return scaled(difference(root(5), exactly(1)), quarter);
  if (is(1, 12)) return scaled(sum(root(6), root(2)), quarter);
  if (is(5, 12)) return scaled(difference(root(6), root(2)), quarter);
  constexpr long most_halves = 64;
  integer odd = denominator(angle);
  mpz_tdiv_q_2exp(odd.backend().data(), odd.backend().data(), mpz_scan1(odd.backend().data(), 0));
  if (denominator(angle) <= most_halves && (odd == 1 || odd == 3 || odd == 5)) {
    return sqrt(scaled(sum(exactly(1), cospi(2 * angle)), half));
  }
  return generated(make(kind::cosine, exactly(angle), polhode::cos(polhode::pi(bits) * angle)));
}

/// From cos(atan t) = 1/sqrt(1 + t^2) and sin(atan t) = t cos(atan t) by the sums of angles. What is left is an angle of which cosine and
/// sine are generators, or nothing is known.
std::pair<exact_number, exact_number> exact_field::cos_and_sin(const exact_number& x) {
  constexpr long most_arcs = 16;
  rational turns = 0;
  exact_number left;
  exact_number cosine = exactly(1);
  exact_number sine;
  long arcs = 0;
  for (const auto& [m, c] : x) {
    const bool is_multiple = m.size() == 1 && m.front().second == 1;
    if (is_multiple && generators_[m.front().first].what == kind::pi) {
      turns = c;
      continue;
    }
    if (!is_multiple || generators_[m.front().first].what != kind::arctan) {
      add_to(left, m, c);
      continue;
    }
    const generator g = generators_[m.front().first];
    const integer whole = floor_of(c);
    add_to(left, m, rational(c - rational(whole)));
    const long n = as_long(whole);
    if (n > most_arcs || n < -most_arcs || (arcs += std::abs(n)) > most_arcs) throw not_decided();
    const exact_number of_arc = reciprocal(sqrt(sum(exactly(1), product(g.of, g.of))));
    const exact_number sine_of_arc = scaled(product(g.of, of_arc), n < 0 ? -1 : 1);
    for (long k = 0; k < std::abs(n); ++k) {
      const exact_number next = difference(product(cosine, of_arc), product(sine, sine_of_arc));
      sine = sum(product(sine, of_arc), product(cosine, sine_of_arc));
      cosine = next;
    }
  }
  if (!left.empty()) {
    const auto [c, s] = generated_cos_and_sin(left);
    const exact_number next = difference(product(cosine, c), product(sine, s));
    sine = sum(product(sine, c), product(cosine, s));
    cosine = next;
  }
  const exact_number c = cospi(turns);
  const exact_number s = sinpi(turns);
  return {difference(product(cosine, c), product(sine, s)),
          sum(product(sine, c), product(cosine, s))};
}

namespace {

/// The fraction of few digits in an enclosure of an angle over pi: a candidate, which is no more than near.
std::optional<rational> near_fraction(const ball& angle) {
  if (!angle.is_bounded()) return std::nullopt;
  const ball turns = angle / polhode::pi(angle.precision());
  if (!turns.is_bounded()) return std::nullopt;
  constexpr int most_quotients = 64;
  auto q = simplest_between(lower_rational(turns), upper_rational(turns), most_quotients);
  if (!q || denominator(*q) > greatest_denominator) return std::nullopt;
  return q;
}

}  // namespace

/// pi q for the q in [-1/2, 1/2] with sin(pi q) = x, where it is found; else atan(x/sqrt(1 - x^2)).
exact_number exact_field::asin(const exact_number& x) {
  for (const int s : {-1, 0, 1}) {
    if (x == exactly(s)) return scaled(pi(), rational(s, 2));
  }
  const auto q = near_fraction(polhode::asin(enclosure(x)));
  if (q && *q >= -half && *q <= half && sinpi(*q) == x) return scaled(pi(), *q);
  return atan(quotient(x, sqrt(difference(exactly(1), product(x, x)))));
}

exact_number exact_field::acos(const exact_number& x) {
  return difference(scaled(pi(), half), asin(x));
}

/// atan t of t = n/d > 0 by the factors of d + i n in Z[i] (C. F. Gauss; J. Todd, A problem on arc tangent relations,
/// 1949): d + i n = i^k (1 + i)^f times powers of a + i b or a - i b, one of the two for each prime p = a^2 + b^2 that
/// divides d^2 + n^2, as d and n are coprime. So atan t = k pi/2 + f pi/4 + the sum of their +-e atan(b/a), and an
/// enclosure tells k.
exact_number exact_field::arctan_of_rational(const rational& t) {
  const integer n = numerator(t);
  const integer d = denominator(t);
  constexpr std::size_t short_bits = 64;
  const ball around = polhode::atan(ball(t, bits));
  const auto as_it_is = [&] {
    if (t < 1) return generated(make(kind::arctan, exactly(t), around));
    const generator_id g =
        make(kind::arctan, exactly(1 / t), polhode::atan(ball(rational(1 / t), bits)));
    return difference(scaled(pi(), half), generated(g));
  };
  if (bits_of(t) > short_bits) return as_it_is();
  spend(100);
  exact_number result;
  for (const factor& p : factors_of(integer(n * n + d * d))) {
    if (p.base == 2) {
      result = sum(result, scaled(pi(), rational(p.multiplicity, 4)));
      continue;
    }
    constexpr long greatest_prime = 1L << 32;
    if (!p.is_prime || p.base > greatest_prime) return as_it_is();
    integer a;
    integer b = 0;
    spend(1000);
    do {
      ++b;
      a = p.base - b * b;
    } while (mpz_perfect_square_p(a.backend().data()) == 0);
    mpz_sqrt(a.backend().data(), a.backend().data());
    if (a < b) std::swap(a, b);
    const bool divides = (d * a + n * b) % p.base == 0 && (n * a - d * b) % p.base == 0;
    const rational slope = rational(b) / rational(a);
    const generator_id g = make(kind::arctan, exactly(slope), polhode::atan(ball(slope, bits)));
    result = sum(result, scaled(generated(g), divides ? p.multiplicity : -p.multiplicity));
  }
  const ball quarters = (around - enclosure(result)) * 2 / polhode::pi(bits);
  const integer k = floor_of(upper_rational(quarters));
  if (rational(k) < lower_rational(quarters) || rational(k - 1) >= lower_rational(quarters)) {
    throw not_decided();
  }
  return sum(result, scaled(pi(), rational(k) / 2));
}

/// pi q for the q in (-1/2, 1/2) with sin(pi q) = x cos(pi q), where it is found.
exact_number exact_field::atan(const exact_number& x) {
  const int s = sign(x);
  if (s == 0) return {};
  if (s < 0) return scaled(atan(scaled(x, -1)), -1);
  const auto q = near_fraction(polhode::atan(enclosure(x)));
  if (q && *q > 0 && *q < half && product(x, cospi(*q)) == sinpi(*q)) return scaled(pi(), *q);
  if (const auto number = plain_number(x)) return arctan_of_rational(*number);
  if (sign(difference(x, exactly(1))) > 0) {
    return difference(scaled(pi(), half), atan(reciprocal(x)));
  }
  return generated(make(kind::arctan, x, polhode::atan(enclosure(x))));
}

}  // namespace polhode::detail
