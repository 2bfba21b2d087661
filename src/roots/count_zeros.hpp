#pragma once

// How many complex zeros a real function has in a disc.

#include <optional>

#include "polhode/roots/real_function.hpp"

namespace polhode {

struct counted_zeros {
  long count = 0;   // with their multiplicities
  rational radius;  // of the disc
  long evaluations = 0;
};

/// The number of zeros of f in the open disc around c whose radius is a little more than
/// least_radius; std::nullopt where none of several radii gives a proof.
///
/// Theorem (Rouche; for polynomials A. E. Pellet, 1881). Let f be analytic on |z - c| <= R with |f|
/// <= B there and Taylor coefficients f_k at c, and 0 < r < R. If for an m < n
///   |f_m| r^m > sum over k < n, k != m, of |f_k| r^k + B (r/R)^n / (1 - r/R),
/// then f has exactly m zeros in |z - c| < r, counted with their multiplicities. Proof. By Cauchy
/// |f_k| <= B/R^k, so that the sum from n on is at most the last term. On |z - c| = r thus
/// |f - f_m (z-c)^m| < |f_m (z-c)^m|, and by Rouche's theorem f has as many zeros inside as f_m
/// (z-c)^m.
[[nodiscard]] std::optional<counted_zeros> count_zeros(const real_function& f, const rational& c,
                                                       const rational& least_radius, precision p);

}  // namespace polhode
