#pragma once

// q near a start as a Taylor polynomial in balls, by Legendre's differential equation. Each term
// has as many bits as matter where it will be evaluated.

#include <cstdint>
#include <optional>
#include <vector>

#include "polhode/arithmetic/ball.hpp"
#include "quadrature/rules/gauss_legendre/fixed_point_values.hpp"
#include "quadrature/rules/gauss_legendre/polynomial.hpp"

namespace polhode::detail::legendre {

constexpr precision least_bits = 64;

/// p, rounded up to whole limbs: the same work.
[[nodiscard]] precision whole_limbs(double p);

/// q near y_0 in terms of g = (y - y_0) / scale, scale = 4 y_0 (1 - y_0): q = sum of d_k g^k, k = 0
/// ... last, and a remainder.
struct local_series {
  ball centre;  // y_0
  ball scale;
  std::vector<ball> coefficients;
  std::vector<precision> bits;  // of the coefficients: not increasing
  long last = 0;
};

/// The coefficients of q at y_0 by its differential equation. From (1 - x^2) P'' - 2x P' + n(n+1) P
/// = 0,
///   4y(1-y) q'' + (2 + 4e - (6 + 4e) y) q' + (n(n+1) - 2e) q = 0,
///     e = 0 or 1 as n is even or odd.
/// For q = sum of c_k (y - y_0)^k that is
///   4 y_0 (1-y_0) (k+1)(k+2) c_(k+2) + (k+1) (4 (1 - 2 y_0) k + 2 + 4e - (6 + 4e) y_0) c_(k+1)
///     + (n(n+1) - 2e - 4k(k-1) - (6 + 4e) k) c_k = 0,
/// and d_k = c_k scale^k needs a division by (k+1)(k+2) only.
///
/// `reach` is about the greatest |y - y_0| that will be asked for: it decides how many terms there
/// are and how many bits they have (a term of order k matters only down to 2^-bits reach^-(k-1)),
/// not what is true. Nothing where reach is too great.
std::optional<local_series> make_series(const legendre_shape& s, std::uint64_t argument,
                                        const fixed_point_polynomial::values& start,
                                        double log2_reach, precision bits);

/// The sum of d_k g^k, or of k d_k g^(k-1), for k <= last, with about `fewer` bits less than the
/// series has.
template <bool derivative>
[[nodiscard]] ball sum_of(const local_series& series, const ball& g, precision fewer, long last);

}  // namespace polhode::detail::legendre
