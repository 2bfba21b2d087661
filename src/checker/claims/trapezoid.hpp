#pragma once

// Integrals over a period by the trapezoidal rule.

#include <functional>

#include "checker/examination.hpp"

namespace polhode::checker {

struct periodic_integrand {
  std::function<interval(const interval& cosine)> value;
  /// A bound of its modulus on the strip; throws undecided where it proves none.
  std::function<interval(const rational& half_width, precision bits)> supremum;
};

/// Repeats the integral that a witness describes by "nodes", "half_width", "supremum" and
/// "truncation_error", with `extra` bits for what inputs of so many bits cancel.
[[nodiscard]] interval check_quadrature(const place& where, const periodic_integrand& f,
                                        long extra);
/// cosh H.
[[nodiscard]] interval cosh_of(const rational& half_width, precision bits);

}  // namespace polhode::checker
