#include "polhode/quadrature/polynomial_integral.hpp"

#include <algorithm>
#include <vector>

namespace polhode {
namespace {

std::size_t bits_of(const rational& q) {
  return std::max(mpz_sizeinbase(mpq_numref(q.backend().data()), 2),
                  mpz_sizeinbase(mpq_denref(q.backend().data()), 2));
}

/// f(u/v) = (the sum of c_n u^n v^(N-n)) / (d v^N) for f with coefficients c_n / d: in integers, with one quotient at the
/// end.
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

}  // namespace polhode
