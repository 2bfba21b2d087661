// Let f(x) = P(x) g(x) for x >= X - v, with P of period T = 2 v, integrable over a period, and
//
//   g(x) = x^-s (a_0 + a_1/x + a_2/x^2 + ...),  |a_k| <= M rho^k,  s > 1,  rho > 0.
//
// (For 0 < s <= 1 see the end.)
//
// With Y_n = X + n T, u in [-v, v] and theta = (rho + v)/X < 1,
//
//   the integral of f from X - v to infinity = that of P(X + u) S(u) from -v to v,
//   S(u) = the sum over n >= 0 of g(Y_n + u)
//        = the sum over k, i >= 0 of a_k binomial(-(s+k), i) u^i Z(s+k+i),  Z(c) = sum of Y_n^-c,
//
// by (Y_n + u)^-c = the sum over i of binomial(-c, i) u^i Y_n^(-c-i), all of it absolutely
// convergent: |binomial(-(s+k), i)| = binomial(s+k+i-1, i), so that the terms with k + i = j add up
// to at most
//
//   M Z(s+j) sum over i <= j of binomial(s+j-1, i) rho^(j-i) v^i <= M Z(s+j) (rho + v)^(j+e)/rho^e
//
// with e = ceil(s) - 1, as binomial(r, i) <= binomial(ceil r, i) for r >= i >= 0, and by the
// binomial theorem with the exponent j + e. And Z(c) <= X^-c (1 + X/(T (c-1))), the sum by the
// integral. So what is left out for k + i >= K is at most
//
//   M ((rho + v)/rho)^e X^-s (1 + X/(T (s+K-1))) theta^K/(1 - theta).
//
// Z(c) is found by the formula of Euler and Maclaurin for h(t) = (X + t T)^-c from N on,
//
//   Z(c) = sum over n < N of Y_n^-c + Y_N^(1-c)/(T (c-1)) + Y_N^-c/2
//          + sum over 1 <= m <= L of B_2m/(2m)! T^(2m-1) c (c+1) ... (c+2m-2) Y_N^(-c-2m+1) + R,
//
// R = the integral over t >= N of (B_2L+2 - B_2L+2({t}))/(2L+2)! h^(2L+2)(t) (DLMF 2.10.1). There
// |B_2m({t})| <= |B_2m| (DLMF 24.9, from the cosine series DLMF 24.8.1) and h^(2L+2) > 0: |R| is at
// most twice the term with m = L + 1. Of B_2m/(2m)! it is used that it is
// (-1)^(m+1) 2 zeta(2m)/(2 pi)^(2m) (DLMF 25.6.2).
//
// For g = x^e N(x)/D(x), N and D of degrees n < d and with D = the sum of d_i x^i: s = d - n - e,
// the a_k are the Taylor coefficients of (z^n N(1/z))/(z^d D(1/z)) at 0, and where
// the sum of |d_i| rho^(i-d) over i < d is at most |d_d|/2, the divisor is at least |d_d|/2 for
// |z| <= 1/rho, so that |a_k| <= M rho^k with M = 2 (the sum of |n_i| rho^(i-n))/|d_d| (Cauchy).
//
// A further factor of g may be (c_m x^m + ... + c_0)^alpha with c_i of period T: g then depends on
// u, too, and all of the above holds for each u with an M and a rho that hold for all. With w_i =
// c_(m-i)/c_m, it is x^(m alpha) c_m^alpha times the series of (1 + w_1 z + ... + w_m z^m)^alpha at
// z = 1/x. Where the sum of |w_i| rho^-i is at most 1/2, for |z| <= 1/rho the power is analytic and
// at most 2^|alpha| in size, and the polynomial is not 0; it has the sign of c_m for x >= rho. The
// product b of such series with Q = the product of the D_j = 1 + w_1 z + ..., to the alpha_j, has
//
//   Q b' = R b,   R = the sum over j of alpha_j D_j' (the product of the other D_i),
//
// and so k b_k = the sum over i >= 1 of (r_(i-1) - (k - i) q_i) b_(k-i).
//
// For 0 < s <= 1 let a_0 P have the integral 0 over a period. Over N periods the
// integral of P g is then that of P(X + u) times the sum over n < N of g(Y_n + u) - a_0 Y_n^-s,
// whose terms are O(Y_n^(-s-1)) for |u| <= v, and over a part of a period it tends to 0 as g does.
// So the integral converges, and all of the above holds with S less its term with k = i = 0: of the
// others s + k + i >= s + 1 > 1. For the bound, e = 0, and binomial(s+j-1, j), the product of
// (s+m-1)/m over 1 <= m <= j, is at most 1 = binomial(j, j). Of a sum of such P g it is enough that
// for each s the sum of its a_0 P has the integral 0, as all that is left out is a multiple of it.
//
// Where f is a sum of P g with any g for which |g(x)| <= C (c/x)^b for x >= B and a b > 1, as by a
// growth_bound where g decays exponentially, S is the sum over n < N of g(Y_n + u), but for at most
// C (c/B)^b (1 + B/(T (b-1))) with B = Y_N - v: the sum by the integral.

#include "periodic_tail.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "polhode/arithmetic/elementary.hpp"
#include "polhode/arithmetic/special_functions.hpp"
#include "polhode/expression/symbol.hpp"
#include "polhode/quadrature/integrate.hpp"
#include "quadrature/ends/growth_bound.hpp"
#include "quadrature/formula/arithmetics.hpp"

namespace polhode::detail {

namespace {

/// A term's other factors as x^-s (a_0 + a_1/x + ...).
struct decay {
  rational s;
  std::vector<rational> numerator;    // of a's quotient, the coefficients of 1, z, z^2, ...
  std::vector<rational> denominator;  // of which the first is not 0
  /// Bounds of |w_1|, |w_2|, ... over a period, for each power of a polynomial.
  std::vector<std::vector<rational>> ratios = {};
  /// A bound of the product of the |c_m|^alpha 2^|alpha|: |b_k| is at most that times rho^k.
  rational size = 1;
};

std::vector<rational> from_the_leading(const rational_polynomial& p) {
  std::vector<rational> c = p.coefficients();
  std::ranges::reverse(c);
  return c;
}

/// The sum of |c_i| rho^-i over i >= first.
rational size_at(const std::vector<rational>& c, std::size_t first, const rational& rho) {
  rational sum = 0;
  for (std::size_t i = c.size(); i-- > first;) sum = sum / rho + abs(c[i]);
  for (std::size_t i = 0; i < first; ++i) sum /= rho;
  return sum;
}

/// The least power of 2 that is a rho for these, and at least `least` > 0. None where it is long.
std::optional<rational> common_rho(const std::vector<decay>& all, const rational& least) {
  rational rho = 1;
  while (rho / 2 >= least) rho /= 2;
  constexpr int most_doublings = 60;
  const auto is_for_ratios = [&](const std::vector<rational>& w) {
    return 2 * size_at(w, 0, rho) <= rho;
  };
  for (int k = 0; k < most_doublings; ++k, rho *= 2) {
    if (rho >= least && std::ranges::all_of(all, [&](const decay& g) {
          return 2 * size_at(g.denominator, 1, rho) <= abs(g.denominator.front()) &&
                 std::ranges::all_of(g.ratios, is_for_ratios);
        })) {
      return rho;
    }
  }
  return std::nullopt;
}

/// a_0, ..., a_(count-1).
std::vector<ball> coefficients_of(const decay& g, std::size_t count, precision p) {
  std::vector<ball> a;
  a.reserve(count);
  for (std::size_t k = 0; k < count; ++k) {
    ball sum = k < g.numerator.size() ? ball(g.numerator[k], p) : ball(0, p);
    for (std::size_t i = 1; i < g.denominator.size() && i <= k; ++i) {
      sum -= a[k - i] * g.denominator[i];
    }
    a.push_back(sum / g.denominator.front());
  }
  return a;
}

/// A bound of |P| over [X - v, X + v]. None where none is found.
std::optional<magnitude> bound_over_period(const expression& factor, const rational& x,
                                           const rational& v) {
  constexpr int most_halvings = 10;
  constexpr precision bits = 64;
  const auto at = factor.evaluator<ball>(bits);
  magnitude most;
  struct piece {
    rational lower;
    rational upper;
    int depth;
  };
  std::vector<piece> rest;
  constexpr long first_pieces = 16;
  for (long k = 0; k < first_pieces; ++k) {
    const rational width = 2 * v / first_pieces;
    rest.push_back({x - v + k * width, x - v + (k + 1) * width, 0});
  }
  while (!rest.empty()) {
    const piece now = rest.back();
    rest.pop_back();
    const ball value = at(hull(ball(now.lower, bits), ball(now.upper, bits)));
    if (value.is_bounded()) {
      most = std::max(most, value.magnitude_upper());
      continue;
    }
    if (now.depth == most_halvings) return std::nullopt;
    const rational middle = (now.lower + now.upper) / 2;
    rest.push_back({now.lower, middle, now.depth + 1});
    rest.push_back({middle, now.upper, now.depth + 1});
  }
  return most;
}

/// A bound of |f| over [0, 2 v], which holds a period of f. None where none is found.
std::optional<rational> bound_over_period(const symbol& f, const expression_names& names,
                                          const rational& v) {
  const auto most = bound_over_period(expression(f, names), v, v);
  return most ? std::optional(upper_rational(ball(0, 64).enlarged(*most))) : std::nullopt;
}

/// The term's decay. None where a power of a polynomial has no bounds over a period, which [0, 2 v]
/// holds.
std::optional<decay> decay_of(const expression::periodic_sum::term& t, const rational& v) {
  decay result{t.denominator.degree() - t.numerator.degree() - t.exponent,
               from_the_leading(t.numerator), from_the_leading(t.denominator)};
  const symbol x = symbol::variable(0);
  const expression_names& names = t.factor.names();
  for (const auto& [c, power] : t.powers) {
    constexpr long greatest_power = 32;
    if (abs(power) > greatest_power) return std::nullopt;
    result.s -= power * static_cast<long>(c.size() - 1);
    const symbol leading = c.back()(x);
    const auto size = bound_over_period(pow(leading, symbol(power)), names, v);
    if (!size) return std::nullopt;
    // f is defined only where the polynomial is not 0, also where the power is 0.
    if (power == 0 && !bound_over_period(1 / leading, names, v)) return std::nullopt;
    result.size *= *size;
    for (rational step = 0; step < abs(power); ++step) result.size *= 2;
    std::vector<rational> ratios;
    for (std::size_t i = c.size() - 1; i-- > 0;) {
      const auto ratio = bound_over_period(c[i](x) / leading, names, v);
      if (!ratio) return std::nullopt;
      ratios.push_back(*ratio);
    }
    result.ratios.push_back(std::move(ratios));
  }
  return result;
}

// Polynomials in z, by their coefficients that are not 0.
using polynomial_in_z = std::map<std::size_t, symbol>;

void add_to(polynomial_in_z& sum, std::size_t k, const symbol& c) {
  const auto [place, is_new] = sum.emplace(k, c);
  if (!is_new) place->second = place->second + c;
}

polynomial_in_z operator*(const polynomial_in_z& p, const polynomial_in_z& q) {
  polynomial_in_z result;
  for (const auto& [i, c] : p) {
    for (const auto& [k, d] : q) add_to(result, i + k, c * d);
  }
  return result;
}

/// b_0, ..., b_(count-1) at this x of the period.
std::vector<symbol> coefficients_of(const std::vector<expression::periodic_sum::moving_power>& all,
                                    const symbol& x, std::size_t count) {
  symbol first = 1;
  polynomial_in_z q{{0, 1}};
  polynomial_in_z r;
  for (const auto& [c, power] : all) {
    if (power == 0) continue;
    const symbol leading = c.back()(x);
    first = first * pow(leading, symbol(power));
    polynomial_in_z d{{0, 1}};
    polynomial_in_z slope;  // alpha D'
    for (std::size_t i = 1; i < c.size(); ++i) {
      const expression& own = c[c.size() - 1 - i];
      const auto number = own.rational_value();
      if (number && *number == 0) continue;
      const symbol w = own(x) / leading;
      d.emplace(i, w);
      slope.emplace(i - 1, w * (power * static_cast<long>(i)));
    }
    const polynomial_in_z more = q * slope;
    r = r * d;
    for (const auto& [k, w] : more) add_to(r, k, w);
    q = q * d;
  }
  std::vector<symbol> b{first};
  const std::size_t longest = std::max(q.rbegin()->first, r.empty() ? 0 : r.rbegin()->first + 1);
  for (std::size_t k = 1; k < count; ++k) {
    symbol sum = 0;
    for (std::size_t i = 1; i <= std::min(k, longest); ++i) {
      symbol factor = 0;
      if (const auto c = r.find(i - 1); c != r.end()) factor = factor + c->second;
      const rational rest(static_cast<long>(k - i));
      if (const auto c = q.find(i); c != q.end()) factor = factor - c->second * rest;
      if (r.contains(i - 1) || q.contains(i)) sum = sum + factor * b[k - i];
    }
    b.push_back(sum * rational(1, static_cast<long>(k)));
  }
  return b;
}

/// A bound of the integral of |P| over a period around X. None where none is found.
std::optional<magnitude> size_over_period(const expression& factor, const pi_combination& period,
                                          const rational& x, const rational& v) {
  if (const auto most = bound_over_period(factor, x, v)) {
    return multiply_up(*most, ball(rational(2 * v), 64).magnitude_upper());
  }
  const symbol size = symbol::call("abs", {factor(symbol::variable(0))});
  const pi_combination middle{x, 0};
  const pi_combination half = period * rational(1, 2);
  integrate_options few;
  few.digits = 1;
  few.most_evaluations = 20'000;
  const integral found = integrate(expression(size, factor.names()), end_point(middle - half),
                                   end_point(middle + half), few);
  if (found.verdict != status::certified) return std::nullopt;
  return found.enclosure.magnitude_upper();
}

bool has_moderate_size(const rational& q) {
  static const rational most = rational(integer(1) << 1000);
  return q < most && q * most > 1;
}

/// A number above q > 0 with few bits.
rational rounded_up(const rational& q) {
  rational unit = 1;
  while (unit * 64 > q) unit /= 2;
  while (unit * 128 < q) unit *= 2;
  return rational(floor_of(q / unit) + 1) * unit;
}

/// The numbers of the proof above, and how precisely all is done.
struct setting {
  ball period;
  rational v;
  rational rho;
  rational x;
  std::size_t count;  // K
  precision goal;
  precision bits;
};

/// Whether the sum of a_0 P over the terms of each s <= 1 is shown to have the integral 0 over a
/// period; false where an s is not positive.
bool slow_terms_have_mean_zero(const expression::periodic_sum& sum,
                               const std::vector<decay>& decays) {
  const symbol x = symbol::variable(0);
  std::map<rational, symbol> sums;
  auto g = decays.begin();
  for (const auto& term : sum.terms) {
    if (term.numerator.is_zero()) continue;
    if (g->s <= 1) {
      const rational first = g->numerator.front() / g->denominator.front();
      symbol slow = term.factor(x) * first;
      for (const auto& [c, power] : term.powers) slow = slow * pow(c.back()(x), symbol(power));
      sums[g->s] += slow;
    }
    ++g;
  }
  return std::ranges::all_of(sums, [&](const auto& slow) {
    const expression of_period(slow.second, sum.terms.front().factor.names());
    // Odd functions are known to be so about the middle of a range.
    const pi_combination quarter = sum.period * rational(1, 4);
    const auto has_mean_zero_from = [&](const pi_combination& start) {
      const auto found = exact_integral(of_period, end_point(start), end_point(start + sum.period));
      return found && *found == 0;
    };
    return slow.first > 0 && (has_mean_zero_from({}) || has_mean_zero_from(quarter));
  });
}

/// The x^-s (a_0 + ...) of the terms that are not 0. None where one is not for this rule.
std::optional<std::vector<decay>> decays_of(const expression::periodic_sum& sum,
                                            const rational& v) {
  constexpr long greatest_exponent = 200;
  std::vector<decay> decays;
  for (const auto& term : sum.terms) {
    if (term.numerator.is_zero()) {
      if (!term.powers.empty()) return std::nullopt;
      continue;
    }
    auto one = decay_of(term, v);
    if (!one || one->s > greatest_exponent) return std::nullopt;
    decays.push_back(std::move(*one));
  }
  if (decays.empty() || !slow_terms_have_mean_zero(sum, decays)) return std::nullopt;
  return decays;
}

/// v, a little more than T/2. None where that is no moderate number.
std::optional<rational> half_of(const pi_combination& period) {
  const rational half = upper_rational(ball(period.at(64) / 2));
  return has_moderate_size(half) ? std::optional(rounded_up(half)) : std::nullopt;
}

std::optional<setting> setting_for(const std::vector<decay>& decays, const pi_combination& period,
                                   const rational& v, const rational& from, precision goal) {
  // S has more than two thousand terms then, or a thousand that are formulas.
  const bool has_powers =
      std::ranges::any_of(decays, [](const decay& g) { return !g.ratios.empty(); });
  const precision most_bits = has_powers ? 4000 : 8000;
  if (goal > most_bits || (from != 0 && !has_moderate_size(abs(from)))) return std::nullopt;
  const precision bits = goal + 64;  // for what rounding adds
  const ball length = period.at(bits + 32);
  const auto rho = common_rho(decays, v / 4);
  if (!rho) return std::nullopt;
  const rational x = std::max(rounded_up(8 * (*rho + v)), rational(from + rounded_up(2 * v)));
  // Up to there f is integrated as it is.
  constexpr long most_periods = 500;
  if (x - from > v * 2 * most_periods) return std::nullopt;
  // left_out is about 2^-goal beside X^-s; its power with the exponent e takes further terms.
  const auto log2_of = [](const rational& q) { return std::log2(static_cast<double>(q)); };
  const auto s = static_cast<double>(std::ranges::max(decays, {}, &decay::s).s);
  const double factors = static_cast<double>(goal) + s * log2_of(rational((*rho + v) / *rho));
  const auto count = static_cast<std::size_t>(factors / -log2_of(rational((*rho + v) / x))) + 2;
  return setting{length, v, *rho, x, count, goal, bits};
}

/// S as far as k + i < K: the sum of b_k times polynomials in u with rational coefficients, and
/// what it may be off at |u| <= v. b is 1 where g has no powers of polynomials.
struct folded_factor {
  std::vector<std::vector<rational>> coefficients;
  magnitude error;
};

folded_factor fold(const decay& g, const setting& at) {
  const std::size_t used =
      g.denominator.size() == 1 ? std::min(g.numerator.size(), at.count) : at.count;
  const std::vector<ball> a = coefficients_of(g, used, at.bits);
  // At Y_N each order has 7 bits: c + 2 L times T/(2 pi Y_N) is below 1/12.
  const long order = static_cast<long>(at.goal) / 7 + 3;
  const long shifts =
      2 * (static_cast<long>(at.count) + static_cast<long>(floor_of(g.s)) + 2 * order);
  // Z(s) is left out where s <= 1.
  const bool is_slow = g.s <= 1;
  std::vector<ball> z =
      is_slow ? sums_of_powers(g.s + 1, at.x, at.period, at.count - 1, shifts, order, at.bits)
              : sums_of_powers(g.s, at.x, at.period, at.count, shifts, order, at.bits);
  if (is_slow) z.insert(z.begin(), ball(0, at.bits));
  const std::size_t of_b = g.ratios.empty() ? 1 : at.count;
  std::vector<std::vector<ball>> c;
  for (std::size_t k = 0; k < of_b; ++k) c.emplace_back(at.count - k, ball(0, at.bits));
  std::vector<ball> row(at.count, ball(0, at.bits));
  for (std::size_t j = 0; j < at.count; ++j) {  // of a_l b_k with l + k = j
    ball term(1, at.bits);
    for (std::size_t i = 0; i + j < at.count; ++i) {
      row[i] = term * z[j + i];
      const auto step = static_cast<long>(i);
      term = term * rational(-(g.s + static_cast<long>(j) + step) / (step + 1));
    }
    for (std::size_t k = j - std::min(j, used - 1); k <= std::min(j, of_b - 1); ++k) {
      for (std::size_t i = 0; i + j < at.count; ++i) c[k][i] += a[j - k] * row[i];
    }
  }
  folded_factor result;
  ball error(0, 64);
  ball of_power(g.size, 64);  // a bound of |b_k|
  for (const std::vector<ball>& of_k : c) {
    result.coefficients.emplace_back();
    ball power = of_power;
    for (const ball& one : of_k) {
      const rational lower = lower_rational(one);
      result.coefficients.back().push_back(lower);
      error += power * ball(rational(upper_rational(one) - lower), 64);
      power = power * ball(at.v, 64);
    }
    of_power = of_power * ball(at.rho, 64);
  }
  result.error = error.magnitude_upper();
  return result;
}

/// The bound of what is left out for k + i >= K.
magnitude left_out(const decay& g, const setting& at) {
  constexpr precision bits = 64;
  const auto k = static_cast<long>(at.count);
  const rational size = 2 * g.size * size_at(g.numerator, 0, at.rho) / abs(g.denominator.front());
  const ball theta(rational((at.rho + at.v) / at.x), bits);
  const auto e = static_cast<long>(-floor_of(-g.s)) - 1;
  const ball bound = ball(size, bits) * pow(ball(rational((at.rho + at.v) / at.rho), bits), e) *
                     pow(ball(at.x, bits), ball(-g.s, bits)) *
                     (1 + at.x / (at.period * (g.s + (k - 1)))) * pow(theta, k) / (1 - theta);
  return bound.magnitude_upper();
}

/// The polynomial with these coefficients at u.
symbol polynomial_at(const symbol& u, const std::vector<rational>& coefficients) {
  symbol sum = 0;
  for (std::size_t i = coefficients.size(); i-- > 0;) sum = sum * u + coefficients[i];
  return sum;
}

}  // namespace

std::vector<ball> sums_of_powers(const rational& s, const rational& x, const ball& period,
                                 std::size_t count, long shifts, long order, precision p) {
  std::vector<ball> sums(count, ball(0, p));
  const auto add_powers = [&](const ball& y, const ball& factor) {
    const ball inverse = 1 / y;
    ball power = pow(y, ball(-s, p)) * factor;
    for (ball& sum : sums) {
      sum += power;
      power = power * inverse;
    }
  };
  for (long n = 0; n < shifts; ++n) add_powers(x + period * n, ball(1, p));
  const ball y = x + period * shifts;
  add_powers(y, ball(rational(1, 2), p));
  // (B_2m/(2m)!) (T/Y_N)^(2m-1)
  std::vector<ball> weights;
  const ball ratio = period / y;
  const ball step = square(ratio / (2 * pi(p)));
  ball power = step / ratio;
  for (long m = 1; m <= order + 1; ++m) {
    const ball weight = 2 * zeta(static_cast<unsigned long>(2 * m), p) * power;
    weights.push_back(m % 2 != 0 ? weight : -weight);
    power = power * step;
  }
  const ball inverse = 1 / y;
  ball at_end = pow(y, ball(-s, p));
  for (std::size_t j = 0; j < count; ++j) {
    const rational c = s + static_cast<long>(j);
    sums[j] += at_end * y / (period * (c - 1));
    ball rising(c, p);
    for (long m = 1; m <= order + 1; ++m) {
      const ball term = weights[static_cast<std::size_t>(m - 1)] * rising * at_end;
      if (m <= order) {
        sums[j] += term;
      } else {
        sums[j] = sums[j].enlarged((2 * term).magnitude_upper());
      }
      rising = rising * (c + (2 * m - 1)) * (c + 2 * m);
    }
    at_end = at_end * inverse;
  }
  return sums;
}

namespace {

symbol symbol_of(const pi_combination& x) {
  return symbol(x.q) + symbol(x.r) * symbol::constant("pi");
}

/// A bound of the sum of |g(B + m T)| over m >= 0. Infinite where none is known.
magnitude sum_beyond(const expression& g, const rational& b, const ball& period) {
  constexpr double r = 0.25;  // c/B
  const growth_bound x =
      growth_bound::argument(known_number(rational(0)), known_number(rational(b / 4)), -1, r);
  const growth_bound bound = g.evaluator<growth_bound>(192)(x);
  if (bound.is_blocked() || bound.exponent() <= 1) return magnitude::infinity();
  const ball first = ball(0, 64).enlarged(bound.factor()) *
                     pow(ball(rational(1, 4), 64), ball(bound.exponent(), 64));
  return (first * (1 + b / (period * (bound.exponent() - 1)))).magnitude_upper();
}

/// The number of terms after which that is less than about 2^-goal beside g(x), and the bound.
std::optional<std::pair<long, magnitude>> terms_of_sum(const expression& g, const rational& x,
                                                       const rational& v, const ball& period,
                                                       precision goal) {
  constexpr long most_terms = 512;
  const magnitude size = g.evaluator<ball>(64)(ball(x, 64)).magnitude_upper();
  for (long n = 4; n <= most_terms; n *= 2) {
    const magnitude rest = sum_beyond(g, lower_rational(x + period * n) - v, period);
    if (rest < scale(size, -static_cast<long>(goal))) return std::pair(n, rest);
  }
  return std::nullopt;
}

std::optional<periodic_tail> tail_by_sums(const expression& f, const rational& from, precision p) {
  const auto sum = f.as_periodic_products();
  const auto v = sum ? half_of(sum->period) : std::nullopt;
  if (!v || (from != 0 && !has_moderate_size(abs(from)))) return std::nullopt;
  const rational x = std::max<rational>(from, 0) + rounded_up(2 * *v);
  const ball period = sum->period.at(p + 64);
  const symbol u = symbol::variable(0);
  const symbol step = symbol_of(sum->period);
  symbol folded = 0;
  magnitude rest;
  for (const auto& [factor, steady] : sum->terms) {
    const auto size = size_over_period(factor, sum->period, x, *v);
    const auto terms = size ? terms_of_sum(steady, x, *v, period, p) : std::nullopt;
    if (!terms) return std::nullopt;
    symbol s = 0;
    for (long n = terms->first; n-- > 0;) s = s + steady(x + u + step * n);
    folded = folded + factor(x + u) * s;
    rest = add_up(rest, multiply_up(*size, terms->second));
  }
  expression_names names = f.names();
  names.variables = {"u"};
  const pi_combination half = sum->period * rational(1, 2);
  return periodic_tail{end_point(pi_combination{x, 0} - half), expression(folded, names), half,
                       rest};
}

std::optional<periodic_tail> tail_by_series(const expression& f, const rational& from,
                                            precision p) {
  const auto sum = f.as_periodic_sum();
  if (!sum) return std::nullopt;
  const auto v = half_of(sum->period);
  const auto decays = v ? decays_of(*sum, *v) : std::nullopt;
  if (!decays) return std::nullopt;
  const auto at = setting_for(*decays, sum->period, *v, from, p);
  if (!at) return std::nullopt;

  symbol folded = 0;
  const symbol u = symbol::variable(0);
  magnitude rest;
  auto g = decays->begin();
  for (const auto& term : sum->terms) {
    // f is defined only where the factor is, also where the factor's term is 0.
    const auto size = size_over_period(term.factor, sum->period, at->x, at->v);
    if (!size) return std::nullopt;
    if (term.numerator.is_zero()) continue;
    const folded_factor own = fold(*g, *at);
    const magnitude error = add_up(own.error, left_out(*g, *at));
    rest = add_up(rest, multiply_up(*size, error));
    const std::vector<symbol> b = coefficients_of(term.powers, at->x + u, own.coefficients.size());
    symbol s = 0;
    for (std::size_t k = b.size(); k-- > 0;) {
      s = s + b[k] * polynomial_at(u, own.coefficients[k]);
    }
    folded = folded + term.factor(at->x + u) * s;
    ++g;
  }
  expression_names names = f.names();
  names.variables = {"u"};
  const pi_combination half = sum->period * rational(1, 2);
  return periodic_tail{end_point(pi_combination{at->x, 0} - half), expression(folded, names), half,
                       rest};
}

}  // namespace

std::optional<periodic_tail> periodic_tail_of(const expression& f, const rational& from,
                                              precision p) {
  if (auto tail = tail_by_series(f, from, p)) return tail;
  return tail_by_sums(f, from, p);
}

}  // namespace polhode::detail
