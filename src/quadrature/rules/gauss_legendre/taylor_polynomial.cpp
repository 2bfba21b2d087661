#include "quadrature/rules/gauss_legendre/taylor_polynomial.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gmp.h>

#include "polhode/arithmetic/elementary.hpp"

namespace polhode::detail::legendre {

precision whole_limbs(double p) {
  const auto limbs = static_cast<precision>(std::max(p, 0.0) / GMP_NUMB_BITS) + 1;
  return limbs * GMP_NUMB_BITS;
}

std::optional<local_series> make_series(const legendre_shape& s, std::uint64_t argument,
                                        const fixed_point_polynomial::values& start,
                                        double log2_reach, precision bits) {
  constexpr precision bits_of_constants = 192;  // enough to have them exactly, for all n allowed
  local_series series;
  // Bits of the k-th term, by the bound of detail::legendre_taylor_remainder; its slope's, in fact,
  // which needs one reach less.
  const auto log2_term = [&](long k) {
    const double base = std::numbers::e * static_cast<double>(s.n) / static_cast<double>(2 * k);
    return static_cast<double>(2 * k) * std::log2(base) + static_cast<double>(k - 1) * log2_reach +
           (s.odd != 0 ? std::log2(static_cast<double>(s.n)) : 0.0);
  };
  series.bits = {bits, bits};
  const double wanted = -static_cast<double>(bits) - 4;
  for (series.last = 1; series.last < s.degree; ++series.last) {
    const double next = log2_term(series.last + 1);
    if (next < wanted) break;
    if (next > 0 && series.last > 64) return std::nullopt;
    const double needed = static_cast<double>(bits) + next + 12;
    series.bits.push_back(std::min(whole_limbs(needed), series.bits.back()));
  }

  const ball two_to_64 = scale(ball(1, bits_of_constants), 64);
  const ball units = ball(argument, bits_of_constants);
  series.centre = scale(units, -64);
  series.scale = scale(units * (two_to_64 - units), 2 - 128);
  auto& d = series.coefficients;
  d.reserve(static_cast<std::size_t>(series.last) + 1);
  d.push_back(start.value);
  d.push_back(start.slope * series.scale);
  const ball step = 4 * (1 - scale(series.centre, 1));
  ball drift = 2 + 4 * s.odd - (6 + 4 * s.odd) * series.centre;
  ball factor;
  ball next;
  ball product;
  for (long k = 0; k + 2 <= series.last; ++k) {
    const auto at = static_cast<std::size_t>(k);
    multiply(factor, drift, k + 1);
    multiply(next, factor, d[at + 1]);
    multiply(factor, series.scale,
             s.n * (s.n + 1) - 2 * s.odd - 4 * k * (k - 1) - (6 + 4 * s.odd) * k);
    multiply(product, factor, d[at]);
    add(next, next, product);
    divide(next, next, -(k + 1) * (k + 2));
    d.push_back(next.with_precision(series.bits[at + 2]));
    drift += step;
  }
  return series;
}

template <bool derivative>
ball sum_of(const local_series& series, const ball& g, precision fewer, long last) {
  const auto bits = [&](long k) {
    return std::max(least_bits, series.bits[static_cast<std::size_t>(k)] - fewer);
  };
  precision p = bits(last);
  ball short_g = g.precision() > p ? g.with_precision(p) : g;
  ball sum(0, p);
  ball term;
  for (long k = last; k >= (derivative ? 1 : 0); --k) {
    if (bits(k) != p) {
      p = bits(k);
      short_g = g.precision() > p ? g.with_precision(p) : g;
    }
    if (k < last) multiply(sum, sum, short_g);
    const ball& d = series.coefficients[static_cast<std::size_t>(k)];
    if (d.precision() > p) {
      term = d.with_precision(p);
      if constexpr (derivative) multiply(term, term, k);
      add(sum, sum, term);
    } else if constexpr (derivative) {
      multiply(term, d, k);
      add(sum, sum, term);
    } else {
      add(sum, sum, d);
    }
  }
  return sum;
}

template ball sum_of<false>(const local_series& series, const ball& g, precision fewer, long last);
template ball sum_of<true>(const local_series& series, const ball& g, precision fewer, long last);

}  // namespace polhode::detail::legendre
