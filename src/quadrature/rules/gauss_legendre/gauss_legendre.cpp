// How the nodes and weights are found and proved.
//
// Write P_n(x) = x^e q(x^2), e = 0 for even n and 1 for odd n, where q has degree m = floor(n/2).
// The m zeros of q lie in (0, 1): they are the squares y of the positive nodes. Everything is done
// in y.
//   1. Search, in floating point: y_0 = Y/2^64 near each zero (starts.cpp).
//   2. q(y_0) and q'(y_0), from the coefficients (polynomial.cpp), in fixed point: y_0 is one limb,
//      so that a step of Horner's scheme is one pass over the limbs (fixed_point_values.cpp).
//   3. The Taylor coefficients of q at y_0, from Legendre's differential equation, in balls
//      (taylor_polynomial.cpp); a bound of the remainder, by Cauchy (taylor_remainder.cpp).
//   4. Newton's method on the Taylor polynomial, and in its last step the interval Newton operator,
//      which proves that there is one zero and encloses it (proved_zero.cpp).
//   5. From the zeros the nodes and weights (nodes_and_weights.cpp), which are kept
//      (node_cache.cpp).
// As the m enclosures are disjoint and q has no more than m zeros, each of them holds one, in
// order. With few limbs steps 2 to 4 are those of few_limbs/few_limbed_zeros.cpp, in integers
// alone; what is said here is how it is done with many, and where a start is so bad that they fail.

#include "polhode/quadrature/gauss_legendre.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <stdexcept>
#include <string>
#include <utility>

#include "quadrature/rules/gauss_legendre/few_limbs/few_limbed_zeros.hpp"
#include "quadrature/rules/gauss_legendre/nodes_and_weights.hpp"
#include "quadrature/rules/gauss_legendre/starts.hpp"

namespace polhode {

gauss_legendre_rule make_gauss_legendre(long n, precision bits) {
  return detail::make_gauss_legendre_from(n, bits, [bits](long degree) {
    // A start of 60 bits, for less terms of the series, is worth its time where they have many
    // limbs.
    const bool few = degree <= detail::few_limbed_zeros::greatest_n &&
                     bits < detail::few_limbed_zeros::most_bits / 2;
    const detail::legendre_shape s(degree);
    return few ? detail::legendre::roughly_estimated_squares(s)
               : detail::legendre::estimated_squares(s);
  });
}

gauss_legendre_rule detail::make_gauss_legendre_from(
    long n, precision bits, const std::function<std::vector<std::uint64_t>(long n)>& estimates) {
  if (n < 1 || n > greatest_gauss_legendre_degree) {
    throw std::invalid_argument("a Gauss and Legendre rule of degree " + std::to_string(n) +
                                "; degrees are 1 ... " +
                                std::to_string(greatest_gauss_legendre_degree));
  }
  if (bits < 64 || bits % 64 != 0) {
    throw std::invalid_argument("a Gauss and Legendre rule of " + std::to_string(bits) +
                                " bits; they are a multiple of 64");
  }
  const std::vector<std::uint64_t> starts = estimates(n);
  if (starts.size() != static_cast<std::size_t>(n / 2)) {
    throw std::invalid_argument("estimates of " + std::to_string(starts.size()) +
                                " nodes; the rule has " + std::to_string(n / 2) + " above 0");
  }
  // Near 0 and 1 the zeros are 1/n^2 apart, and an error in y counts n and n^2 times in node and
  // weight.
  const precision loss = 3 * static_cast<precision>(std::bit_width(static_cast<unsigned long>(n)));
  for (const precision more : {16, 80, 300, 2000}) {
    auto rule = legendre::rule_with(n, bits, bits + loss + more, starts);
    if (rule) return std::move(*rule);
  }
  throw std::runtime_error("the Gauss and Legendre rule of degree " + std::to_string(n) + " with " +
                           std::to_string(bits) + " bits was not proved at any working precision");
}

precision gauss_legendre_precision_at_least(precision p) {
  checked_precision(p);
  precision step = 64;
  while (step * 32 <= p) step *= 2;
  return (p + 2 + step - 1) / step * step;
}

long gauss_legendre_degree_at_least(long n) {
  if (n < 1 || n > greatest_gauss_legendre_degree) {
    throw std::invalid_argument("a Gauss and Legendre rule of degree at least " +
                                std::to_string(n));
  }
  if (n <= 16) return n;
  // 16 * 2^(i/6), rounded.
  constexpr std::array<long, 7> steps = {16, 18, 20, 23, 26, 29, 32};
  long octave = 1;
  while (32 * octave < n) octave *= 2;
  const auto* const found =
      std::find_if(steps.begin(), steps.end(), [&](long step) { return step * octave >= n; });
  const long degree = *found * octave;
  return std::min(degree, greatest_gauss_legendre_degree);
}

std::shared_ptr<const gauss_legendre_rule> gauss_legendre(long n, precision p, node_cache& cache) {
  return cache.get(n, gauss_legendre_precision_at_least(p));
}

}  // namespace polhode
