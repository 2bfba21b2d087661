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

/// With X = u + (1-u) y^2, the integrand of eq. (43) is (2/sqrt(ab)) h with
///   h^2 = a (1 - bX)^2 / ((1 - y^2) X (a + bX)),
/// and eq. (44) says that its derivative in u is (2/sqrt(ab)) g with
///   g = -(1/2) (1 - y^2) a^(1/2) (a + (a+2) b X) / ((1 - y^2)^(1/2) (X (a + bX))^(3/2)).
/// Since h > 0 where 1 - bX > 0, g = dh/du exactly when d(h^2)/du = 2 h g, that is, when
///   d(h^2)/du = -a (1 - bX) (a + (a+2) b X) / (X (a + bX))^2,
/// an identity of rational functions: no root is left in it.
///
/// With n = a (1 - bX)^2 and d = (1 - y^2) X (a + bX), multiplying by d^2 gives the identity of
/// polynomials
///   n_u d - n d_u = -a (1 - bX) (a + (a+2) b X) (1 - y^2)^2.
/// Degrees of the two sides: X has degree 1 in u, 2 in y. n: 1 in a, 2 in b, 2 in u, 4 in y; n_u: 1
/// in u. d: 1 in a, 1 in b, 2 in u, 6 in y; d_u: 1 in u. So the left side has at most degree 2 in
/// a, 3 in b, 3 in u, 10 in y, and the right side 2, 2, 2, 8. A polynomial of degree at most D_i in
/// the i-th variable that vanishes on a product grid of D_i + 1 points in each is zero (induction
/// on the variables): equality on a grid of 3 x 4 x 4 x 11 points proves the identity. The left
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
