// The rational roots of a polynomial without multiple roots, by lifting its roots modulo a prime
// (R. Loos, Computing rational zeros of integral polynomials by p-adic expansion, 1983).
//
// Let p = a x^n + ... have integer coefficients and let l be a prime that does not divide a. A
// rational root x of p has a denominator that divides a, so its residue modulo l is a root of the
// image of p. If all roots of the image in the field of l elements are simple, each one lifts to
// exactly one root modulo l^k (Hensel's lemma), which is x's residue. The size of the integer a x
// is at most |a| times a bound of the roots, so its residue modulo an l^k above twice that is the
// number itself. Each candidate is tested by exact division.

#include "rational_roots.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

namespace polhode::detail {
namespace {

using residues = std::vector<std::uint64_t>;

mpz_srcptr of(const integer& n) { return n.backend().data(); }

std::uint64_t value_mod(const residues& p, std::uint64_t x, std::uint64_t prime) {
  std::uint64_t value = 0;
  for (std::size_t k = p.size(); k-- > 0;) value = (value * x + p[k]) % prime;
  return value;
}

/// The roots of the image of p modulo the prime; none where one of them is multiple, or the prime
/// divides the leading coefficient.
std::optional<std::vector<std::uint64_t>> simple_roots_mod(const std::vector<integer>& p,
                                                           std::uint64_t prime) {
  residues image;
  image.reserve(p.size());
  for (const integer& c : p) image.push_back(mpz_fdiv_ui(of(c), prime));
  if (image.back() == 0) return std::nullopt;
  residues slope;
  for (std::size_t k = 1; k < image.size(); ++k) slope.push_back(image[k] * (k % prime) % prime);
  std::vector<std::uint64_t> roots;
  for (std::uint64_t x = 0; x < prime; ++x) {
    if (value_mod(image, x, prime) != 0) continue;
    if (value_mod(slope, x, prime) == 0) return std::nullopt;
    roots.push_back(x);
  }
  return roots;
}

/// A polynomial modulo l^2, l^4, l^8, ..., made once for all roots.
class lifted_images {
 public:
  struct image {
    integer modulus;
    std::vector<integer> p;
    residues short_p;  // where the modulus has 31 bits at most: p

    /// {p(x), p'(x)} modulo the modulus, for x from 0 below it.
    [[nodiscard]] std::pair<integer, integer> values(const integer& x) const {
      if (!short_p.empty()) return values_of(short_p, mpz_get_ui(of(x)), mpz_get_ui(of(modulus)));
      return values_of(p, x, modulus);
    }

   private:
    template <class N>
    static std::pair<integer, integer> values_of(const std::vector<N>& p, const N& x, const N& m) {
      N value = 0;
      N slope = 0;
      for (std::size_t k = p.size(); k-- > 0;) {
        slope = (slope * x + value) % m;
        value = (value * x + p[k]) % m;
      }
      return {integer(value), integer(slope)};
    }
  };

  lifted_images(const std::vector<integer>& p, std::uint64_t prime) : p_(p), next_(prime) {}

  /// Modulo l to the power 2^(k + 1).
  const image& at(std::size_t k) {
    while (images_.size() <= k) {
      constexpr std::size_t most_short_bits = 31;
      next_ *= next_;
      images_.push_back({next_, {}, {}});
      image& made = images_.back();
      const bool is_short = mpz_sizeinbase(of(next_), 2) <= most_short_bits;
      integer rest;
      for (const integer& c : p_) {
        mpz_fdiv_r(rest.backend().data(), of(c), of(next_));
        if (is_short) {
          made.short_p.push_back(mpz_get_ui(of(rest)));
        } else {
          made.p.push_back(rest);
        }
      }
    }
    return images_[k];
  }

 private:
  const std::vector<integer>& p_;
  integer next_;
  std::vector<image> images_;
};

/// The one rational number with a x in the bound whose residue modulo the prime is the given one,
/// if it can be a root.
std::optional<rational> lifted(const std::vector<integer>& p, lifted_images& images,
                               std::uint64_t residue, std::uint64_t prime, const integer& bound) {
  integer x = residue;
  integer modulus = prime;
  for (std::size_t k = 0; modulus <= 2 * bound; ++k) {
    const lifted_images::image& image = images.at(k);
    modulus = image.modulus;
    const auto [value, slope] = image.values(x);
    integer inverse;
    if (mpz_invert(inverse.backend().data(), of(slope), of(modulus)) == 0) return std::nullopt;
    x = x - value * inverse;
    mpz_fdiv_r(x.backend().data(), of(x), of(modulus));
  }
  integer product = p.back() * x % modulus;
  if (product < 0) product += modulus;
  if (2 * product > modulus) product -= modulus;
  if (abs(product) > bound) return std::nullopt;
  const rational candidate(product, p.back());
  // The numerator divides p(0), the denominator p's leading coefficient.
  if (candidate == 0 || p.front() % numerator(candidate) != 0) return std::nullopt;
  return candidate;
}

/// p / (d x - n) for the root n/d; std::nullopt where the division leaves a rest.
std::optional<std::vector<integer>> quotient_by(const std::vector<integer>& p,
                                                const rational& root) {
  const integer n = numerator(root);
  const integer d = denominator(root);
  std::vector<integer> quotient(p.size() - 1);
  integer carry = 0;
  for (std::size_t k = p.size() - 1; k > 0; --k) {
    integer& c = quotient[k - 1];
    c = p[k] + carry;
    if (d != 1) {
      if (mpz_divisible_p(of(c), of(d)) == 0) return std::nullopt;
      c /= d;
    }
    carry = c * n;
  }
  if (p.front() + carry != 0) return std::nullopt;
  return quotient;
}

}  // namespace

rational_roots rational_roots_of(const rational_polynomial& given) {
  rational_roots result;
  std::vector<integer>& p = result.rest;
  p = primitive_coefficients(given);
  if (p.front() == 0) {
    result.roots.emplace_back(0);
    p.erase(p.begin());
  }
  if (p.size() == 1) return result;
  // Of a few primes, the one with the fewest roots: it has all rational roots and few others. Only
  // the primes that divide the leading coefficient or the discriminant, which is not 0, do not
  // serve.
  constexpr int enough = 6;
  std::optional<std::vector<std::uint64_t>> residues_of_roots;
  std::uint64_t prime = 0;
  int served = 0;
  integer next = 64;
  while (served < enough && !(residues_of_roots && residues_of_roots->empty())) {
    mpz_nextprime(next.backend().data(), of(next));
    const auto l = next.convert_to<std::uint64_t>();
    auto roots = simple_roots_mod(p, l);
    if (!roots) {
      // A cluster of whole numbers is told apart by primes above its width.
      if (served == 0) next += next / 8;
      continue;
    }
    ++served;
    if (!residues_of_roots || roots->size() < residues_of_roots->size()) {
      residues_of_roots = std::move(roots);
      prime = l;
    }
  }
  const rational greatest =
      abs(p.back()) * root_bound(rational_polynomial(std::vector<rational>(p.begin(), p.end())));
  const integer bound = numerator(greatest) / denominator(greatest);
  const std::vector<integer> whole = p;
  lifted_images images(whole, prime);
  for (const std::uint64_t residue : *residues_of_roots) {
    const std::optional<rational> candidate = lifted(whole, images, residue, prime, bound);
    if (!candidate) continue;
    if (auto quotient = quotient_by(p, *candidate)) {
      result.roots.push_back(*candidate);
      p = std::move(*quotient);
    }
  }
  std::sort(result.roots.begin(), result.roots.end());
  return result;
}

}  // namespace polhode::detail
