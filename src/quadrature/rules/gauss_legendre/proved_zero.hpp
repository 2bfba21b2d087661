#pragma once

// One zero of q by its Taylor polynomial, searched for with Newton's method and proved with the
// interval Newton operator.

#include <optional>

#include "polhode/arithmetic/ball.hpp"
#include "quadrature/rules/gauss_legendre/taylor_polynomial.hpp"
#include "quadrature/rules/gauss_legendre/zero.hpp"

namespace polhode::detail::legendre {

/// The zero of q near the centre of the series, proved. Let f(g) = q(y_0 + scale g). If J is an
/// interval around g, if 0 is not in f'(J), and if N = g - f(g)/f'(J) is a part of J, then f has
/// exactly one zero in J, and it is in N (Moore; it follows from the mean value theorem). Nothing
/// where that does not come out so.
[[nodiscard]] std::optional<legendre_zero> proved_zero(const legendre_shape& s,
                                                       const local_series& series, precision bits);

}  // namespace polhode::detail::legendre
