#pragma once

// The exact identity behind the paper's formula for the derivative of F(-bu, u) in u (appendix A,
// eq. (44)).

#include <functional>
#include <string>

#include "polhode/arithmetic/exact.hpp"

namespace polhode::proofs {

struct identity_check {
  bool holds = false;
  long points = 0;        // points of the grid at which both sides were compared, in rationals
  std::string statement;  // what was checked
  std::string degrees;    // why the grid suffices
};

/// The derivative of the integrand of eq. (43) is that of eq. (44), with X = u + (1-u) y^2:
///   d(h^2)/du = -a (1 - bX) (a + (a+2) b X) / (X (a + bX))^2,
/// on a grid that proves it everywhere: proofs/arguments/sign_dF_du.md has the argument. The left
/// side is not taken from its expansion: d(h^2)/du is computed from the definition of h^2 by exact
/// differentiation (numbers p + q e with e^2 = 0) at grid points where the denominators are not 0.
///
/// The polynomial a + (a+2) b X is a parameter, so that tests can see a wrong one fail. Hypothesis:
/// it is a polynomial of degree at most 1 in each of a, b and X.
using numerator_polynomial =
    std::function<rational(const rational& a, const rational& b, const rational& x)>;
/// a + (a+2) b X.
[[nodiscard]] rational derivative_numerator(const rational& a, const rational& b,
                                            const rational& x);
[[nodiscard]] identity_check check_derivative_identity(
    const numerator_polynomial& numerator = derivative_numerator);

/// Whether the numerator a + (a+2) b X of eq. (44) is a polynomial in a, b, X with no negative
/// coefficient and not all of them 0: then it is positive for a, b, X > 0. It is of degree 1 in
/// each variable, so its coefficients are the alternating sums of its values at {0,1}^3, in exact
/// rationals.
[[nodiscard]] bool numerator_is_positive(
    const numerator_polynomial& numerator = derivative_numerator);

}  // namespace polhode::proofs
