// Cosines of rational multiples of pi as sums of roots of unity, by which polynomials in them are
// shown to be rational: cos(2 pi/7) + cos(4 pi/7) + cos(6 pi/7) is -1/2.

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "expression/exact/rationals.hpp"
#include "expression/exact/terms.hpp"
#include "expression/exact_number.hpp"

namespace polhode::detail {
using namespace exact_parts;

namespace {

/// A polynomial's coefficients, from the constant one.
using coefficients = std::vector<rational>;

/// Leaves the remainder of division by a polynomial whose leading coefficient is 1, and returns the
/// quotient.
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

/// The cyclotomic polynomial Phi_n, whose roots are the primitive n-th roots of unity: Phi_1 = x -
/// 1, and for a prime p Phi_pm(x) = Phi_m(x^p) where p divides m, else Phi_m(x^p)/Phi_m(x).
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

/// An N for which x is a sum of products of cosines of multiples of pi/N; none where it is no such
/// sum, or N or the products are great.
std::optional<long> exact_field::common_order_of_cosines(const exact_sum& x) const {
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
  return as_long(common);
}

/// Of a sum of products of cosines: with z = e^(i pi/N), cos(pi k/N) = (z^k + z^-k)/2, so that the
/// sum is a polynomial in z, of which z^(2N) = 1 and the cyclotomic polynomial's value 0 leave the
/// remainder.
std::optional<rational> exact_field::rational_by_roots_of_unity(const exact_sum& x) {
  const auto common = common_order_of_cosines(x);
  if (!common) return std::nullopt;
  const auto n = static_cast<std::size_t>(2 * *common);
  coefficients total(n);
  for (const auto& [m, c] : x) {
    coefficients term(n);
    term[0] = c;
    for (const auto& [g, exponent] : m) {
      const rational angle(*plain_number(generators_[g].of) * *common);
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

}  // namespace polhode::detail
