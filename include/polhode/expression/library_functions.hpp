#pragma once

// The functions of other rooms and libraries, under the names that formulas call them by.

#include <memory>

#include "polhode/expression/functions.hpp"

namespace polhode {

/// Elliptic integrals and functions (docs/elliptic.md).
[[nodiscard]] std::shared_ptr<const further_functions> elliptic_functions();

/// Bessel's and Airy's functions, exponential integrals, error functions, incomplete gamma and
/// polygamma functions, polylogarithms, zeta and Lambert's W, as Arb has them (F. Johansson, Arb:
/// efficient arbitrary-precision midpoint-radius interval arithmetic, 2017). None where the library
/// was built without Arb.
[[nodiscard]] std::shared_ptr<const further_functions> arb_functions();

/// All of these: those that parse() and formula_of() know.
[[nodiscard]] std::shared_ptr<const further_functions> library_functions();

}  // namespace polhode
