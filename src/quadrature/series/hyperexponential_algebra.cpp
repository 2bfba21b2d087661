#include "hyperexponential_algebra.hpp"

#include <algorithm>

namespace polhode::detail {

bool is_integer(const rational& q) { return denominator(q) == 1; }

namespace {

constexpr std::size_t most_factors = 32;

/// gcd of the numerators over the least common denominator, so that p over it has coprime integer
/// coefficients.
rational content(const rational_polynomial& p) {
  integer above = 0;
  integer below = 1;
  for (const rational& c : p.coefficients()) {
    above = gcd(above, numerator(c));
    below = lcm(below, denominator(c));
  }
  return {above, below};
}

}  // namespace

hyperexponential number(const rational& q) {
  hyperexponential result;
  result.coefficient = q;
  return result;
}

/// |x|^e joins the constants of f.
void multiply_by(hyperexponential& f, const constant_power& c) {
  for (auto i = f.constants.begin(); i != f.constants.end(); ++i) {
    if (i->what != c.what || i->node != c.node || i->value != c.value) continue;
    i->exponent += c.exponent;
    if (i->exponent == 0) f.constants.erase(i);
    return;
  }
  f.constants.push_back(c);
}

void multiply_by(hyperexponential& f, const polynomial_power& p) {
  if (p.exponent == 0 && !p.must_be_positive) return;
  for (auto i = f.powers.begin(); i != f.powers.end(); ++i) {
    if (i->base != p.base) continue;
    i->exponent += p.exponent;
    i->must_be_positive = i->must_be_positive || p.must_be_positive;
    if (i->exponent == 0 && !i->must_be_positive) f.powers.erase(i);
    return;
  }
  f.powers.push_back(p);
}

hyperexponential product(hyperexponential f, const hyperexponential& g) {
  f.coefficient *= g.coefficient;
  for (const constant_power& c : g.constants) multiply_by(f, c);
  for (const polynomial_power& p : g.powers) multiply_by(f, p);
  if (!g.exponent.is_zero()) f.exponent = f.exponent + g.exponent;
  if (!g.phase.is_zero()) {  // f has none
    f.phase = g.phase;
    f.is_sine = g.is_sine;
  }
  return f;
}

/// f times the cosine or sine of t, where f has none of its own.
hyperexponential with_phase(hyperexponential f, const rational_polynomial& t, bool is_sine) {
  const bool is_negative = !t.is_zero() && t.leading() < 0;
  f.phase = is_negative ? t * rational_polynomial({rational(-1)}) : t;
  f.is_sine = is_sine && !t.is_zero();
  if (is_sine && t.is_zero()) f.coefficient = 0;
  if (is_sine && is_negative) f.coefficient = -f.coefficient;
  return f;
}

/// The sum of these alone: what an initializer list holds is copied.
template <class... F>
hyperexponential_sum sum_of(F&&... f) {
  hyperexponential_sum result;
  result.reserve(sizeof...(f));
  (result.push_back(std::forward<F>(f)), ...);
  return result;
}

/// f g, a sum where both have a phase.
hyperexponential_sum products(const hyperexponential& f, const hyperexponential& g) {
  if (f.phase.is_zero() || g.phase.is_zero()) return sum_of(product(f, g));
  hyperexponential x = f;
  hyperexponential y = g;
  x.phase = y.phase = {};
  x.is_sine = y.is_sine = false;
  hyperexponential both = product(x, y);
  both.coefficient /= 2;
  hyperexponential negative = both;
  negative.coefficient = -negative.coefficient;
  const rational_polynomial difference = f.phase - g.phase;
  const rational_polynomial total = f.phase + g.phase;
  // 2 cos a cos b = cos(a-b) + cos(a+b), 2 sin a sin b = cos(a-b) - cos(a+b),
  // 2 sin a cos b = sin(a-b) + sin(a+b), 2 cos a sin b = -sin(a-b) + sin(a+b).
  const bool is_sine = f.is_sine != g.is_sine;
  return sum_of(with_phase(is_sine && g.is_sine ? negative : both, difference, is_sine),
                with_phase(f.is_sine && g.is_sine ? negative : both, total, is_sine));
}

/// The exponent of a base; 0 where f does not have it.
rational exponent_of(const hyperexponential& f, const rational_polynomial& base) {
  for (const polynomial_power& p : f.powers) {
    if (p.base == base) return p.exponent;
  }
  return 0;
}

bool have_same_constants(const hyperexponential& f, const hyperexponential& g) {
  return f.constants.size() == g.constants.size() &&
         std::all_of(f.constants.begin(), f.constants.end(), [&](const constant_power& c) {
           return std::find(g.constants.begin(), g.constants.end(), c) != g.constants.end();
         });
}

hyperexponential power_of_variable(const rational& e) {
  hyperexponential result;
  if (e != 0) result.powers.push_back({rational_polynomial::variable(), e, false});
  return result;
}
/// (1 - y)^e.
hyperexponential power_of_complement(const rational& e) {
  hyperexponential result;
  result.powers.push_back({rational_polynomial({rational(1), rational(-1)}), e, false});
  return result;
}

hyperexponential taking_apart::of_polynomial(const rational_polynomial& p) const {
  if (p.degree() < 1) return number(p.is_zero() ? rational(0) : p.leading());
  hyperexponential result;
  result.coefficient = content(p);
  if (p(inside_) < 0) result.coefficient = -result.coefficient;
  std::vector<rational> c = p.coefficients();
  if (result.coefficient != 1) {
    for (rational& x : c) x /= result.coefficient;
  }
  result.powers.push_back({rational_polynomial(std::move(c)), rational(1), false});
  return result;
}

maybe_sum taking_apart::added(const hyperexponential_sum& f, const hyperexponential_sum& g) const {
  hyperexponential_sum result = f;
  for (const hyperexponential& term : g) {
    if (!add(result, term)) return std::nullopt;
  }
  if (result.empty() || result.size() > most_terms) return std::nullopt;
  return result;
}

maybe_sum taking_apart::multiplied(const hyperexponential_sum& f,
                                   const hyperexponential_sum& g) const {
  if (f.size() * g.size() > most_terms) return std::nullopt;
  hyperexponential_sum result;
  for (const hyperexponential& x : f) {
    for (const hyperexponential& y : g) {
      for (hyperexponential& term : products(x, y)) {
        if (term.powers.size() > most_factors || !add(result, std::move(term))) return std::nullopt;
      }
    }
  }
  if (result.empty() || result.size() > most_terms) return std::nullopt;
  return result;
}

maybe_sum taking_apart::raised(const hyperexponential_sum& f, const rational& e) const {
  if (f.size() > 1 || !f.front().phase.is_zero()) {
    if (!is_integer(e) || e < 1 || e > 8) return std::nullopt;
    maybe_sum result = f;
    for (long k = 1; result && k < e; ++k) result = multiplied(*result, f);
    return result;
  }
  hyperexponential result = f.front();
  if (result.coefficient == 0) return std::nullopt;
  for (constant_power& c : result.constants) c.exponent *= e;
  for (polynomial_power& p : result.powers) p.exponent *= e;
  const auto is_long = [](const auto& power) {
    constexpr long greatest = 1L << 20;
    return abs(numerator(power.exponent)) > greatest || denominator(power.exponent) > greatest;
  };
  if (std::any_of(result.constants.begin(), result.constants.end(), is_long) ||
      std::any_of(result.powers.begin(), result.powers.end(), is_long)) {
    return std::nullopt;
  }
  result.exponent = result.exponent * rational_polynomial({e});
  if (is_integer(e)) {
    constexpr long greatest_exponent = 1L << 20;
    constexpr double most_bits = 10'000;
    if (abs(numerator(e)) > greatest_exponent) return std::nullopt;
    const auto n = static_cast<long>(numerator(e));
    const auto bits = static_cast<double>(rational_polynomial({result.coefficient}).height());
    const bool is_unit = abs(result.coefficient) == 1;
    if (!is_unit && bits * static_cast<double>(std::abs(n)) > most_bits) return std::nullopt;
    const rational base = n < 0 ? rational(1 / result.coefficient) : result.coefficient;
    rational power = 1;
    for (long k = 0; k < (is_unit ? std::abs(n) % 2 : std::abs(n)); ++k) power *= base;
    result.coefficient = power;
    std::erase_if(result.powers,
                  [](const polynomial_power& p) { return p.exponent == 0 && !p.must_be_positive; });
    return sum_of(std::move(result));
  }
  // Positive where its polynomials are.
  if (result.coefficient < 0) return std::nullopt;
  const rational coefficient = result.coefficient;
  result.coefficient = 1;
  if (coefficient != 1) {
    constant_power c;
    c.value = coefficient;
    c.exponent = e;
    multiply_by(result, c);
  }
  for (polynomial_power& p : result.powers) p.must_be_positive = true;
  return sum_of(std::move(result));
}

std::optional<rational_polynomial> taking_apart::as_polynomial(const hyperexponential_sum& f) {
  if (f.size() != 1) return std::nullopt;
  const hyperexponential& x = f.front();
  const bool has_conditions =
      std::any_of(x.powers.begin(), x.powers.end(),
                  [](const polynomial_power& p) { return p.must_be_positive; });
  if (has_conditions || !x.constants.empty() || !x.exponent.is_zero() || !x.phase.is_zero()) {
    return std::nullopt;
  }
  return polynomial_of(x.coefficient, x.powers);
}

std::optional<rational_polynomial> taking_apart::polynomial_of(
    const rational& coefficient, const std::vector<polynomial_power>& powers) {
  rational_polynomial result({coefficient});
  for (const polynomial_power& p : powers) {
    if (!is_integer(p.exponent) || p.exponent < 0 ||
        p.exponent * p.base.degree() + result.degree() > greatest_degree) {
      return std::nullopt;
    }
    for (long k = 0; k < p.exponent; ++k) result = result * p.base;
  }
  return result;
}

bool taking_apart::add(hyperexponential_sum& f, hyperexponential g) const {
  for (auto i = f.begin(); i != f.end(); ++i) {
    const bool is_alike = i->exponent == g.exponent && i->phase == g.phase &&
                          i->is_sine == g.is_sine && have_same_constants(*i, g);
    if (!is_alike) continue;
    hyperexponential common;
    common.constants = i->constants;
    common.exponent = i->exponent;
    common.phase = i->phase;
    common.is_sine = i->is_sine;
    std::vector<polynomial_power> left;
    std::vector<polynomial_power> right;
    bool is_possible = true;
    bool must_be_positive = false;
    const auto share = [&](const polynomial_power& p) {
      const rational mine = exponent_of(*i, p.base);
      const rational other = exponent_of(g, p.base);
      if (!is_integer(mine - other)) {
        is_possible = false;
        return;
      }
      const rational least = std::min(mine, other);
      must_be_positive = must_be_positive || p.must_be_positive;
      multiply_by(common, polynomial_power{p.base, least, p.must_be_positive});
      if (mine != least) left.push_back({p.base, rational(mine - least), false});
      if (other != least) right.push_back({p.base, rational(other - least), false});
    };
    for (const polynomial_power& p : i->powers) share(p);
    for (const polynomial_power& p : g.powers) {
      const auto has = [&](const polynomial_power& q) { return q.base == p.base; };
      const auto mine = std::find_if(i->powers.begin(), i->powers.end(), has);
      if (mine == i->powers.end()) {
        share(p);
      } else if (p.must_be_positive) {
        must_be_positive = true;
        multiply_by(common, polynomial_power{p.base, 0, true});
      }
    }
    if (!is_possible) continue;
    const auto x = polynomial_of(i->coefficient, left);
    const auto y = polynomial_of(g.coefficient, right);
    if (!x || !y) continue;
    const rational_polynomial both = *x + *y;
    if (both.is_zero()) {
      if (must_be_positive) return false;
      f.erase(i);
      return true;
    }
    *i = product(std::move(common), of_polynomial(both));
    return true;
  }
  f.push_back(std::move(g));
  return true;
}

}  // namespace polhode::detail
