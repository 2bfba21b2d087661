// The greatest common divisor of polynomials with rational coefficients, by images modulo primes
// (W. S. Brown, On Euclid's algorithm and the computation of polynomial greatest common divisors,
// 1971; J. von zur Gathen, J. Gerhard, Modern Computer Algebra, algorithm 6.38).
//
// Let p and q have integer coefficients and let l be a prime that divides neither leading
// coefficient. The image of gcd(p, q) modulo l divides both images and has the degree of gcd(p, q),
// as its leading coefficient divides those of p and q. So the gcd of the images has at least that
// degree: an image of degree 0 proves that p and q have no common root, and a common divisor of p
// and q with the degree of an image is the greatest one. Divisors are tested by exact division.

#include <cstdint>
#include <utility>
#include <vector>

#include "polhode/arithmetic/polynomial.hpp"

namespace polhode {
namespace {

using whole_coefficients = std::vector<integer>;  // of 1, x, x^2, ...; the last one is not 0
using residues = std::vector<std::uint64_t>;

mpz_srcptr of(const integer& n) { return n.backend().data(); }

std::uint64_t product_mod(std::uint64_t x, std::uint64_t y, std::uint64_t prime) {
  return x * y % prime;  // both are below 2^31
}

/// x^(prime - 2), the inverse of x (Fermat).
std::uint64_t inverse_mod(std::uint64_t x, std::uint64_t prime) {
  std::uint64_t result = 1;
  for (std::uint64_t n = prime - 2; n > 0; n /= 2) {
    if (n % 2 == 1) result = product_mod(result, x, prime);
    x = product_mod(x, x, prime);
  }
  return result;
}

residues image_of(const whole_coefficients& p, std::uint64_t prime) {
  residues result;
  result.reserve(p.size());
  for (const integer& c : p) result.push_back(mpz_fdiv_ui(of(c), prime));
  while (!result.empty() && result.back() == 0) result.pop_back();
  return result;
}

/// With leading coefficient 1. Euclid's algorithm; neither is 0.
residues gcd_of_images(residues a, residues b, std::uint64_t prime) {
  while (!b.empty()) {
    const std::uint64_t inverse = inverse_mod(b.back(), prime);
    while (a.size() >= b.size()) {
      const std::uint64_t quotient = prime - product_mod(a.back(), inverse, prime);
      const std::size_t first = a.size() - b.size();
      for (std::size_t k = 0; k < b.size(); ++k) {
        a[first + k] = (a[first + k] + quotient * b[k]) % prime;
      }
      while (!a.empty() && a.back() == 0) a.pop_back();
    }
    std::swap(a, b);
  }
  const std::uint64_t inverse = inverse_mod(a.back(), prime);
  for (std::uint64_t& c : a) c = product_mod(c, inverse, prime);
  return a;
}

/// The integer in (-m/2, m/2] that is r modulo m.
integer least_residue(const integer& r, const integer& m) { return 2 * r > m ? r - m : r; }

bool divides(const rational_polynomial& d, const rational_polynomial& p) {
  return divide(p, d).second.is_zero();
}

}  // namespace

std::vector<integer> primitive_coefficients(const rational_polynomial& p) {
  integer below = 1;
  for (const rational& c : p.coefficients()) below = lcm(below, denominator(c));
  std::vector<integer> result;
  result.reserve(p.coefficients().size());
  integer common = 0;
  for (const rational& c : p.coefficients()) {
    result.push_back(numerator(c) * (below / denominator(c)));
    mpz_gcd(common.backend().data(), of(common), of(result.back()));
  }
  if (common > 1) {
    for (integer& c : result) mpz_divexact(c.backend().data(), of(c), of(common));
  }
  return result;
}

rational_polynomial gcd(const rational_polynomial& p, const rational_polynomial& q) {
  const auto monic = [](const rational_polynomial& x) {
    return x.is_zero() ? x : x * rational_polynomial({rational(1) / x.leading()});
  };
  if (p.is_zero() || q.is_zero()) return monic(p.is_zero() ? q : p);
  rational_polynomial one({rational(1)});
  if (p.degree() == 0 || q.degree() == 0) return one;
  const whole_coefficients a = primitive_coefficients(p);
  const whole_coefficients b = primitive_coefficients(q);
  integer leading;  // a multiple of the leading coefficient of the primitive gcd
  mpz_gcd(leading.backend().data(), of(a.back()), of(b.back()));
  integer prime(1U << 30U);
  integer modulus = 1;
  std::vector<integer> found;  // modulo `modulus`, leading coefficient `leading`
  while (true) {
    mpz_nextprime(prime.backend().data(), of(prime));
    const auto l = prime.convert_to<std::uint64_t>();
    if (mpz_divisible_ui_p(of(a.back()), l) != 0 || mpz_divisible_ui_p(of(b.back()), l) != 0) {
      continue;
    }
    residues image = gcd_of_images(image_of(a, l), image_of(b, l), l);
    if (image.size() == 1) return one;
    if (!found.empty() && image.size() > found.size()) continue;  // l hides a factor
    if (image.size() != found.size()) {
      found.assign(image.size(), integer(0));
      modulus = 1;
    }
    const std::uint64_t scale = mpz_fdiv_ui(of(leading), l);
    const std::uint64_t step = inverse_mod(mpz_fdiv_ui(of(modulus), l), l);
    bool settled = modulus != 1;
    for (std::size_t k = 0; k < image.size(); ++k) {
      // The number that is found[k] modulo `modulus` and the image's coefficient modulo l.
      const std::uint64_t wanted = product_mod(image[k], scale, l);
      const std::uint64_t is = mpz_fdiv_ui(of(found[k]), l);
      const std::uint64_t more = product_mod((wanted + l - is) % l, step, l);
      settled = settled && (more == 0 || more == l - 1);
      found[k] += modulus * more;
    }
    const integer before = modulus;
    modulus *= prime;
    if (!settled && before != 1) continue;
    std::vector<rational> coefficients;
    coefficients.reserve(found.size());
    for (const integer& c : found) coefficients.emplace_back(least_residue(c, modulus));
    rational_polynomial candidate = monic(rational_polynomial(std::move(coefficients)));
    if (divides(candidate, p) && divides(candidate, q)) return candidate;
  }
}

}  // namespace polhode
