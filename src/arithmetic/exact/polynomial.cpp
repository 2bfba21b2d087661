#include "polhode/arithmetic/polynomial.hpp"

#include <algorithm>
#include <cstdlib>
#include <limits>

namespace polhode {

rational_polynomial::rational_polynomial(std::vector<rational> coefficients)
    : coefficients_(std::move(coefficients)) {
  trim();
}

void rational_polynomial::trim() {
  while (!coefficients_.empty() && coefficients_.back() == 0) coefficients_.pop_back();
}

std::size_t rational_polynomial::height() const {
  std::size_t bits = 0;
  for (const rational& c : coefficients_) {
    const mpq_srcptr q = c.backend().data();
    bits = std::max({bits, mpz_sizeinbase(mpq_numref(q), 2), mpz_sizeinbase(mpq_denref(q), 2)});
  }
  return bits;
}

rational_polynomial operator+(const rational_polynomial& p, const rational_polynomial& q) {
  const rational_polynomial& longer = p.degree() >= q.degree() ? p : q;
  const rational_polynomial& shorter = p.degree() >= q.degree() ? q : p;
  rational_polynomial sum = longer;
  for (std::size_t k = 0; k < shorter.coefficients_.size(); ++k) {
    sum.coefficients_[k] += shorter.coefficients_[k];
  }
  sum.trim();
  return sum;
}

rational_polynomial operator-(const rational_polynomial& p, const rational_polynomial& q) {
  rational_polynomial negative = q;
  for (rational& c : negative.coefficients_) c = -c;
  return p + negative;
}

rational_polynomial operator*(const rational_polynomial& p, const rational_polynomial& q) {
  if (p.is_zero() || q.is_zero()) return {};
  std::vector<rational> product(p.coefficients_.size() + q.coefficients_.size() - 1);
  for (std::size_t i = 0; i < p.coefficients_.size(); ++i) {
    if (p.coefficients_[i] == 0) continue;
    for (std::size_t j = 0; j < q.coefficients_.size(); ++j) {
      product[i + j] += p.coefficients_[i] * q.coefficients_[j];
    }
  }
  return rational_polynomial(std::move(product));
}

rational rational_polynomial::operator()(const rational& x) const {
  rational value = 0;
  for (std::size_t k = coefficients_.size(); k-- > 0;) value = value * x + coefficients_[k];
  return value;
}

ball rational_polynomial::operator()(const ball& x) const {
  ball value(0, x.precision());
  for (std::size_t k = coefficients_.size(); k-- > 0;) value = value * x + coefficients_[k];
  return value;
}

rational_polynomial rational_polynomial::derivative() const {
  std::vector<rational> result;
  for (std::size_t k = 1; k < coefficients_.size(); ++k) {
    result.push_back(coefficients_[k] * static_cast<long>(k));
  }
  return rational_polynomial(std::move(result));
}

jet<ball, dynamic_order> rational_polynomial::series(const ball& x, int n) const {
  // Horner's scheme: after the j-th pass row[j] is f^(j)(x)/j!, and what is above it are the
  // coefficients of the quotient by (t - x)^(j+1).
  std::vector<ball> row;
  row.reserve(coefficients_.size());
  for (const rational& c : coefficients_) row.emplace_back(c, x.precision());
  jet<ball, dynamic_order> result(n);
  for (int j = 0; j <= n; ++j) {
    const auto first = static_cast<std::size_t>(j);
    if (first >= row.size()) {
      result[j] = ball(0, x.precision());
      continue;
    }
    for (std::size_t k = row.size() - 1; k-- > first;) row[k] += row[k + 1] * x;
    result[j] = row[first];
  }
  return result;
}

rational_polynomial denominator_of(const rational_quotient& q) {
  rational_polynomial product({rational(1)});
  for (const repeated_factor& f : q.divisors) {
    for (long k = 0; k < f.multiplicity; ++k) product = product * f.factor;
  }
  return product;
}

std::pair<rational_polynomial, rational_polynomial> divide(const rational_polynomial& p,
                                                           const rational_polynomial& d) {
  std::vector<rational> rest = p.coefficients();
  const std::vector<rational>& by = d.coefficients();
  if (rest.size() < by.size()) return {rational_polynomial(), p};
  std::vector<rational> quotient(rest.size() - by.size() + 1);
  for (std::size_t k = quotient.size(); k-- > 0;) {
    quotient[k] = rest[k + by.size() - 1] / by.back();
    if (quotient[k] == 0) continue;
    for (std::size_t j = 0; j < by.size(); ++j) rest[k + j] -= quotient[k] * by[j];
  }
  return {rational_polynomial(std::move(quotient)), rational_polynomial(std::move(rest))};
}

namespace {

rational_polynomial scaled(const rational_polynomial& p, const rational& factor) {
  return p * rational_polynomial({factor});
}

}  // namespace

std::vector<repeated_factor> square_free_decomposition(const rational_polynomial& p) {
  std::vector<repeated_factor> result;
  if (p.degree() < 1) return result;
  const rational_polynomial slope = p.derivative();
  const rational_polynomial common = gcd(p, slope);
  rational_polynomial b = divide(p, common).first;
  rational_polynomial d = divide(slope, common).first - b.derivative();
  for (long multiplicity = 1; b.degree() > 0; ++multiplicity) {
    rational_polynomial factor = gcd(b, d);
    b = divide(b, factor).first;
    d = divide(d, factor).first - b.derivative();
    if (factor.degree() > 0) result.push_back({std::move(factor), multiplicity});
  }
  return result;
}

// Let M >= |c_(n-k) / c_n|^(1/k) for k = 1, ..., n. If |x| > 2 M, then the sum of |c_(n-k) x^(n-k)|
// over k is at most |c_n x^n| times the sum of (M/|x|)^k < 2^-k, which is below 1: x is no root.
rational root_bound(const rational_polynomial& p) {
  const std::vector<rational>& c = p.coefficients();
  std::optional<long> exponent;  // M = 2^exponent; none for M = 0
  for (std::size_t k = 1; k < c.size(); ++k) {
    const rational& one = c[c.size() - 1 - k];
    if (one == 0) continue;
    const rational quotient = one / p.leading();
    const mpq_srcptr q = quotient.backend().data();
    // |q| < 2^bits.
    const long bits = static_cast<long>(mpz_sizeinbase(mpq_numref(q), 2)) -
                      static_cast<long>(mpz_sizeinbase(mpq_denref(q), 2)) + 1;
    const auto step = static_cast<long>(k);
    const long root_bits = bits > 0 ? (bits + step - 1) / step : -(-bits / step);  // upward
    exponent = std::max(exponent.value_or(root_bits), root_bits);
  }
  if (!exponent) return 0;
  const long bound = *exponent + 1;
  const integer power = integer(1) << static_cast<unsigned long>(std::abs(bound));
  return bound >= 0 ? rational(power) : rational(1, power);
}

namespace {

int sign_at(const rational_polynomial& p, const rational& x) {
  const rational value = p(x);
  return value > 0 ? 1 : (value < 0 ? -1 : 0);
}

long sign_changes(const std::vector<rational_polynomial>& chain, const rational& x) {
  long changes = 0;
  int last = 0;
  for (const rational_polynomial& p : chain) {
    const int s = sign_at(p, x);
    if (s != 0 && last != 0 && s != last) ++changes;
    if (s != 0) last = s;
  }
  return changes;
}

}  // namespace

long count_real_roots(const rational_polynomial& p, const rational& lower, const rational& upper) {
  // Without multiple roots, so that no end is a zero of the whole chain.
  const rational_polynomial once = divide(p, gcd(p, p.derivative())).first;
  std::vector<rational_polynomial> chain{once, once.derivative()};
  while (!chain.back().is_zero()) {
    const rational_polynomial rest = divide(chain[chain.size() - 2], chain.back()).second;
    // A positive factor keeps the signs.
    chain.push_back(rest.is_zero() ? rest : scaled(rest, -1 / abs(rest.leading())));
  }
  chain.pop_back();
  // Sturm's theorem counts the different roots in (lower, upper].
  return sign_changes(chain, lower) - sign_changes(chain, upper) + (once(lower) == 0 ? 1 : 0);
}

}  // namespace polhode
