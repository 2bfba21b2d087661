#pragma once

// The paper's constants, and the equations whose roots they are.

#include <functional>

#include "checker/body.hpp"
#include "checker/interval.hpp"

namespace polhode::checker {

[[nodiscard]] interval epsilon0_min(precision bits);
[[nodiscard]] interval delta_psi_max(precision bits);
/// 2 agm(sqrt(1+x), sqrt(x)) - 1, which increases in x > 0 and is 0 at beta.
[[nodiscard]] interval mean_equation(const rational& x, precision bits);
/// F(0, sin^2 epsilon) - 2 pi, which decreases in 0 < epsilon < pi/2 and is 0 at epsilon0.
[[nodiscard]] std::function<interval(const rational& x, precision bits)> separatrix_equation(
    const body& rigid);

}  // namespace polhode::checker
