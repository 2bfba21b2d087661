#include "expression/exact/factors.hpp"

#include <cstddef>
#include <utility>
#include <vector>

#include "expression/exact/rationals.hpp"

namespace polhode::detail::exact_parts {
namespace {

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

}  // namespace

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

std::size_t cost_of_factors(const rational& c) { return 100 + bits_of(c) / 4; }

}  // namespace polhode::detail::exact_parts
