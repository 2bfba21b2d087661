#pragma once

// Factors of natural numbers. A power or a logarithm of a natural number is that of its factors, so
// that log 6 = log 2 + log 3 and sqrt 12 = 2 sqrt 3 show themselves. Factors of numbers with great
// prime factors are not looked for: what is left is taken as it is.

#include <cstddef>
#include <vector>

#include "polhode/arithmetic/exact.hpp"

namespace polhode::detail::exact_parts {

struct factor {
  integer base;
  long multiplicity;
  bool is_prime;  // as far as is known
};

/// n > 0 as a product of powers: of small primes, and of what is left of n, which is no power
/// itself.
[[nodiscard]] std::vector<factor> factors_of(integer n);

/// Of finding the factors of c, in steps, of which one takes about a microsecond.
[[nodiscard]] std::size_t cost_of_factors(const rational& c);

}  // namespace polhode::detail::exact_parts
