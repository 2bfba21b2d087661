#pragma once

// The sweep of sign_dF_du: a lower bound of W, the integral over (0, pi/2) of cos^2 t (sigma^(-1/2)
// + r u sigma^(-3/2)) dt, sigma = u + p (1-u) cos^2 t, over boxes that cover [0,1]^3.

#include <cstddef>

#include "checker/examination.hpp"
#include "checker/real.hpp"

namespace polhode::checker {

/// Bits that the bounds on boxes are computed with.
inline constexpr long sweep_bits = 96;

/// That W > 3/4 on every box, and that the boxes cover [0,1]^3: no two have an inner point in
/// common, and their volumes add up to 1. Returns how many they are.
[[nodiscard]] std::size_t check_sweep(const place& sweep);
/// An enclosure of W at a point with u > 0.
[[nodiscard]] interval enclosure_at(const real& p, const real& r, const rational& u,
                                    precision bits);

}  // namespace polhode::checker
