#pragma once

// 1/Gamma, and digamma/Gamma, which are entire: gamma and digamma beside their poles.

#include <functional>

#include "polhode/arithmetic/jet.hpp"

namespace polhode {

/// 1/Gamma(x) = x (x+1) ... (x+n-1)/Gamma(x+n) (DLMF 5.5.1), with n such that x + n > 0 on the
/// whole set. Undefined where that takes many factors: left of -1000.
[[nodiscard]] jet<ball, 1> reciprocal_gamma(const jet<ball, 1>& x);

/// digamma(x)/Gamma(x), likewise, given digamma' of positive sets. With P = x (x+1) ... (x+n-1)
/// digamma(x) is digamma(x+n) - P'/P (DLMF 5.5.2), so that it is (P digamma(x+n) - P')/Gamma(x+n).
[[nodiscard]] jet<ball, 1> digamma_over_gamma(const jet<ball, 1>& x,
                                              const std::function<ball(const ball&)>& trigamma);

}  // namespace polhode
