#pragma once

// erf by its series, for real and for complex balls:
//
//   erf(z) = (2 z/sqrt(pi)) e^(-z^2) sum over k >= 0 of t_k,  t_0 = 1, t_(k+1) = t_k 2 z^2/(2k + 3)
//
// (DLMF 7.6.2). Where |2 z^2/(2k + 3)| <= 1/2 for k = n, and so for all later k, what follows t_n
// is at most |t_n| (1/2 + 1/4 + ...) = |t_n| in size.

#include <cstdint>
#include <optional>

#include "polhode/arithmetic/complex_ball.hpp"

namespace polhode::detail {

/// The sum of all t_k for w = 2 z^2, with so many bits; it ends where a term is below 2^-small of
/// the greatest one, and holds the rest.
[[nodiscard]] ball sum_of_erf(const ball& w, precision bits, std::int64_t small);
[[nodiscard]] complex_ball sum_of_erf(const complex_ball& w, precision bits, std::int64_t small);

/// erf of a narrow set, to about its precision. Nothing for a set, size or precision for which
/// another way is better.
[[nodiscard]] std::optional<ball> erf_by_series(const ball& x);
/// erf for |z| up to 32; undefined beyond, where the terms cancel in more than 2,900 bits.
[[nodiscard]] complex_ball erf_by_series(const complex_ball& z);

}  // namespace polhode::detail
