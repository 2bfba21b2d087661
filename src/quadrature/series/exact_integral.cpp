#include "quadrature/formula/integrand.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "polhode/expression/symbol.hpp"
#include "quadrature/formula/logarithmic_ends.hpp"
#include "quadrature/formula/symmetry.hpp"

namespace polhode {
namespace {

std::size_t bits_of(const rational& q) {
  return std::max(mpz_sizeinbase(mpq_numref(q.backend().data()), 2),
                  mpz_sizeinbase(mpq_denref(q.backend().data()), 2));
}

/// f(u/v) = (the sum of c_n u^n v^(N-n)) / (d v^N) for f with coefficients c_n / d: in integers,
/// with one quotient at the end.
rational value_at(const std::vector<integer>& c, const integer& d, const rational& x) {
  const integer u = numerator(x);
  const integer v = denominator(x);
  integer sum = 0;
  integer scale = 1;  // v^(N-n)
  for (std::size_t n = c.size(); n-- > 0;) {
    sum = sum * u + c[n] * scale;
    if (n > 0) scale *= v;
  }
  return rational(sum) / rational(integer(d * scale));
}

}  // namespace

std::optional<rational> exact_integral(const rational_polynomial& p, const rational& a,
                                       const rational& b) {
  constexpr std::size_t most_bits = 1U << 20;
  std::vector<rational> antiderivative(1, rational(0));
  std::size_t bits = 0;
  integer d = 1;
  for (const rational& c : p.coefficients()) {
    const auto n = static_cast<long>(antiderivative.size());
    antiderivative.push_back(c / n);
    bits += bits_of(antiderivative.back());
    if (bits > most_bits) return std::nullopt;
    d = lcm(d, denominator(antiderivative.back()));
    if (mpz_sizeinbase(d.backend().data(), 2) > most_bits / 8) return std::nullopt;
  }
  if ((bits_of(a) + bits_of(b)) * antiderivative.size() > most_bits) return std::nullopt;
  std::vector<integer> coefficients;
  coefficients.reserve(antiderivative.size());
  for (const rational& c : antiderivative) {
    coefficients.push_back(numerator(c) * integer(d / denominator(c)));
  }
  return value_at(coefficients, d, b) - value_at(coefficients, d, a);
}

namespace {

// ---------------------------------------------------------------------------------------------
// Rational functions

/// An end of a range; nothing for an infinity.
using maybe_end = std::optional<rational>;

/// A solution c of the equations sum over j of m[i][j] c_j = m[i].back(), by Gauss's elimination;
/// nothing where there is none, or more than one.
std::optional<std::vector<rational>> solution(std::vector<std::vector<rational>> m,
                                              std::size_t unknowns) {
  std::size_t row = 0;
  for (std::size_t column = 0; column < unknowns; ++column) {
    std::size_t pivot = row;
    while (pivot < m.size() && m[pivot][column] == 0) ++pivot;
    if (pivot == m.size()) return std::nullopt;
    std::swap(m[row], m[pivot]);
    for (std::size_t i = 0; i < m.size(); ++i) {
      if (i == row || m[i][column] == 0) continue;
      const rational factor = m[i][column] / m[row][column];
      for (std::size_t j = column; j <= unknowns; ++j) m[i][j] -= factor * m[row][j];
    }
    ++row;
  }
  std::vector<rational> c;
  for (std::size_t i = 0; i < m.size(); ++i) {
    if (i < unknowns) {
      c.push_back(m[i][unknowns] / m[i][i]);
    } else if (m[i][unknowns] != 0) {
      return std::nullopt;
    }
  }
  return c;
}

/// C with (C/D)' = P/Q, deg C < deg D = deg gcd(Q, Q'), for deg P < deg Q and P and Q coprime,
/// where there is one. With S = Q/D and W = D' S/D, a polynomial, the equation is P = C' S - C W
/// (M. V. Ostrogradsky, 1845): in general P/Q = (C/D)' + A/S, and the integral of A/S is a sum of
/// logarithms, a rational function only for A = 0.
std::optional<rational_polynomial> rational_part(const rational_polynomial& p,
                                                 const rational_polynomial& q,
                                                 const rational_polynomial& d) {
  const rational_polynomial s = divide(q, d).first;
  const rational_polynomial w = divide(d.derivative() * s, d).first;
  const auto equations = static_cast<std::size_t>(q.degree());
  const auto unknowns = static_cast<std::size_t>(d.degree());
  std::vector<std::vector<rational>> m(equations, std::vector<rational>(unknowns + 1, rational(0)));
  const auto put = [&](const rational_polynomial& f, std::size_t column) {
    for (std::size_t i = 0; i < f.coefficients().size(); ++i) m[i][column] = f.coefficients()[i];
  };
  for (std::size_t j = 0; j < unknowns; ++j) {
    std::vector<rational> power(j + 1, rational(0));
    power[j] = 1;
    const rational_polynomial c(std::move(power));
    put(c.derivative() * s - c * w, j);
  }
  put(p, unknowns);
  const auto c = solution(std::move(m), unknowns);
  return c ? std::optional(rational_polynomial(*c)) : std::nullopt;
}

bool has_root_in(const rational_polynomial& q, const maybe_end& a, const maybe_end& b) {
  const rational bound = root_bound(q);
  const rational lower = a ? *a : rational(-bound);
  const rational upper = b ? *b : bound;
  return lower <= upper && count_real_roots(q, lower, upper) > 0;
}

/// From a to b, a < b.
std::optional<rational> integral_of(const rational_quotient& f, const maybe_end& a,
                                    const maybe_end& b) {
  constexpr long greatest_degree = 64;
  rational_polynomial q({rational(1)});
  for (const repeated_factor& d : f.divisors) {
    for (long k = 0; k < d.multiplicity; ++k) {
      q = q * d.factor;
      if (q.degree() > greatest_degree) return std::nullopt;
    }
  }
  rational_polynomial p = f.numerator;
  if (p.is_zero()) return rational(0);
  const rational_polynomial common = gcd(p, q);
  p = divide(p, common).first;
  q = divide(q, common).first;
  if (q.degree() > 0 && has_root_in(q, a, b)) return std::nullopt;
  const auto [whole, rest] = divide(p, q);
  rational result = 0;
  if (!whole.is_zero()) {
    const auto part = a && b ? exact_integral(whole, *a, *b) : std::nullopt;
    if (!part) return std::nullopt;
    result = *part;
  }
  if (rest.is_zero()) return result;
  const rational_polynomial d = gcd(q, q.derivative());
  const auto c = d.degree() > 0 ? rational_part(rest, q, d) : std::nullopt;
  if (!c) return std::nullopt;
  if (b) result += (*c)(*b) / d(*b);  // at an infinity C/D is 0
  if (a) result -= (*c)(*a) / d(*a);
  return result;
}

// ---------------------------------------------------------------------------------------------
// Formulas

/// From a to b, a < b, of a formula without breaks.
std::optional<rational> smooth_integral(const expression& f, const maybe_end& a,
                                        const maybe_end& b) {
  if (const auto q = f.quotient()) return integral_of(*q, a, b);
  const auto in_u = f.by_root();
  if (!in_u) return std::nullopt;
  const auto q = in_u->formula.quotient();
  if (!q) return std::nullopt;
  // The u of a finite end; with false where it is no rational number, or not real.
  const auto u_of = [&](const maybe_end& x, int side) -> std::pair<bool, maybe_end> {
    if (!x) return {side * in_u->alpha > 0, std::nullopt};
    const rational form = in_u->alpha * *x + in_u->beta;
    if (form < 0) return {false, std::nullopt};
    const auto u = exact_root(form, static_cast<unsigned long>(in_u->q));
    return {u.has_value(), u};
  };
  const auto [has_a, u_a] = u_of(a, -1);
  const auto [has_b, u_b] = u_of(b, 1);
  if (!has_a || !has_b) return std::nullopt;
  if (in_u->alpha > 0) return integral_of(*q, u_a, u_b);
  const auto reversed = integral_of(*q, u_b, u_a);
  return reversed ? std::optional<rational>(-*reversed) : std::nullopt;
}

/// From a to b, a < b, by pieces where there are breaks.
std::optional<rational> integral_by_pieces(const expression& f, const maybe_end& a,
                                           const maybe_end& b) {
  constexpr std::size_t most_pieces = 1000;
  const auto pieces = f.pieces(a, b, most_pieces);
  if (!pieces) return smooth_integral(f, a, b);
  rational sum = 0;
  for (const expression::piece& piece : *pieces) {
    const auto part = smooth_integral(piece.formula, piece.lower, piece.upper);
    if (!part) return std::nullopt;
    sum += *part;
  }
  return sum;
}

/// From a to b, a < b, of a polynomial in x and in floors. With the period T and the degree n the
/// integral over the k-th period from a is a polynomial I(k) of degree at most n. So the sum of
/// I(k) over 0 <= k < K is the sum over j <= n of binomial(K, j + 1) times the j-th difference of I
/// at 0 (Newton).
std::optional<rational> integral_of_stairs(const expression& f, const rational& a,
                                           const rational& b) {
  const auto stairs = f.as_staircase();
  if (!stairs) return std::nullopt;
  const rational& period = stairs->period;
  const integer count = floor_of((b - a) / period);
  if (count <= stairs->degree + 1) return std::nullopt;
  std::vector<rational> differences;
  for (long k = 0; k <= stairs->degree; ++k) {
    const rational start = a + k * period;
    const auto part = integral_by_pieces(f, start, start + period);
    if (!part) return std::nullopt;
    differences.push_back(*part);
  }
  rational sum = 0;
  rational binomial = 1;
  for (std::size_t j = 0; j < differences.size(); ++j) {
    const auto step = static_cast<long>(j);
    binomial *= rational(integer(count - step)) / (step + 1);
    sum += binomial * differences[j];
    for (std::size_t i = differences.size(); i-- > j + 1;) differences[i] -= differences[i - 1];
  }
  const rational last = a + count * period;
  if (last == b) return sum;
  const auto rest = integral_by_pieces(f, last, b);
  return rest ? std::optional<rational>(sum + *rest) : std::nullopt;
}

/// By an antiderivative that is entire, or is so in log x, at ends that are given by formulas.
std::optional<rational> difference_at_ends(const expression& f, const end_point& a,
                                           const end_point& b) {
  const auto at_a = formula_of(a);
  const auto at_b = formula_of(b);
  const auto number = [](const expression& x) { return x.evaluate(std::span<const symbol>()); };
  if (at_a && at_b) {
    if (const auto antiderivative = f.entire_antiderivative()) {
      const auto at = [&](const expression& x) { return (*antiderivative)(number(x)); };
      return expression(at(*at_b) - at(*at_a), {}).rational_value();
    }
  }
  if (!detail::is_right_of_zero(a) || !detail::is_right_of_zero(b)) return std::nullopt;
  const bool is_known_at_a = at_a || a.is_infinite();
  const bool is_known_at_b = at_b || b.is_infinite();
  if (!is_known_at_a || !is_known_at_b) return std::nullopt;
  const auto found = f.antiderivative_in_logarithm();
  if (!found || !detail::reaches(*found, a) || !detail::reaches(*found, b)) return std::nullopt;
  const auto at = [&](const end_point& x, const std::optional<expression>& formula) {
    return detail::is_limit_of_logarithm(x) ? symbol(0) : found->of_s(-log(number(*formula)));
  };
  return expression(at(a, at_a) - at(b, at_b), {}).rational_value();
}

}  // namespace

namespace {

std::optional<rational> by_antiderivative(const expression& f, const end_point& a,
                                          const end_point& b) {
  const auto is_number = [](const end_point& x) { return x.at(64).is_bounded(); };
  const bool is_range = (a.is_infinite() || is_number(a)) && (b.is_infinite() || is_number(b)) &&
                        (!a.is_infinite() || a.infinite_sign() != b.infinite_sign());
  if (!is_range) return std::nullopt;
  if (f.is_zero_almost_everywhere()) return rational(0);
  const auto is_known = [](const end_point& x) { return x.exact() || x.infinite_sign() != 0; };
  if (!is_known(a) || !is_known(b)) return difference_at_ends(f, a, b);
  if (a.exact() && b.exact()) {
    if (*a.exact() == *b.exact()) return rational(0);
    if (const auto p = f.polynomial()) return exact_integral(*p, *a.exact(), *b.exact());
  }
  const bool is_reversed = a.infinite_sign() > 0 || b.infinite_sign() < 0 ||
                           (a.exact() && b.exact() && *b.exact() < *a.exact());
  if (is_reversed) {
    if (a.infinite_sign() == b.infinite_sign() && a.infinite_sign() != 0) return std::nullopt;
    const auto found = by_antiderivative(f, b, a);
    return found ? std::optional<rational>(-*found) : std::nullopt;
  }
  if (a.infinite_sign() == b.infinite_sign() && a.infinite_sign() != 0) return std::nullopt;
  const maybe_end& lower = a.exact();
  const maybe_end& upper = b.exact();
  if (!lower || !upper) {
    if (auto value = integral_by_pieces(f, lower, upper)) return value;
    return difference_at_ends(f, a, b);
  }
  if (auto sum = integral_of_stairs(f, *lower, *upper)) return sum;
  if (auto sum = integral_by_pieces(f, *lower, *upper)) return sum;
  return difference_at_ends(f, a, b);
}

/// (a + b)/2, and 0 for the whole line, where it is known to be q + r pi.
std::optional<pi_combination> middle_of(const end_point& a, const end_point& b) {
  if (a.is_infinite() && b.is_infinite() && a.infinite_sign() != b.infinite_sign()) {
    return pi_combination{};
  }
  if (a.form() && b.form()) return (*a.form() + *b.form()) * rational(1, 2);
  const auto lower = formula_of(a);
  const auto upper = formula_of(b);
  if (!lower || !upper) return std::nullopt;
  const std::span<const symbol> none;
  const auto sum =
      expression(lower->evaluate(none) + upper->evaluate(none), lower->names()).rational_value();
  if (!sum) return std::nullopt;
  return pi_combination{*sum / 2, 0};
}

/// Where f(a + b - x) = c - f(x), or f(-x) = -f(x) on the whole line, and the integral over a half
/// of the range is proved to be a number: then that over the other half is one, too, and their sum
/// is c (b - a)/2.
std::optional<rational> by_symmetry(const expression& f, const end_point& a, const end_point& b) {
  const std::optional<pi_combination> middle = middle_of(a, b);
  if (!middle) return std::nullopt;
  const prepared_integrand prepared(f);
  const auto sum = prepared.functions().under(symmetry::reflection(*middle)).sum_with_image();
  if (!sum || !sum->is_rational()) return std::nullopt;
  rational value = 0;
  if (!sum->is_zero()) {
    if (!a.form() || !b.form()) return std::nullopt;
    const pi_combination length = *b.form() - *a.form();
    if (!length.is_rational()) return std::nullopt;
    value = sum->q * length.q / 2;
  }
  integrate_options existence;
  existence.digits = 1;
  existence.most_evaluations = 20'000;
  const integral half = integrate(prepared, end_point(*middle), b, existence);
  if (half.verdict != status::certified) return std::nullopt;
  return value;
}

}  // namespace

std::optional<rational> exact_integral(const expression& f, const end_point& a,
                                       const end_point& b) {
  if (f.variables().size() != 1 || !f.has_defined_constants()) return std::nullopt;
  if (auto value = by_antiderivative(f, a, b)) return value;
  return by_symmetry(f, a, b);
}

}  // namespace polhode
