#pragma once

// The coordinates of the solutions of a system of polynomials, by elimination.
//
// Where polynomials f and g in variables x, y have a common zero (x0, y0), their resultant in y,
// the determinant of Sylvester's matrix with the degrees m and n that f and g have in y, is 0 at
// x0: the column (y0^(m+n-1), ..., y0, 1) is in its kernel. So the resultants of one equation with
// each of the others in the last variable are one equation and one variable less, and are 0 at
// every solution. At the end there is a polynomial in the first variable alone. Unless it is 0, the
// first coordinates of all solutions are among its roots.

#include <optional>
#include <span>
#include <vector>

#include "polhode/arithmetic/polynomial.hpp"
#include "polhode/expression/expression.hpp"

namespace polhode::detail {

/// For each variable a polynomial, not 0, that is 0 at this coordinate of every complex solution.
/// None where a component is no polynomial with rational coefficients, where the elimination takes
/// many operations, or ends with 0. Hypothesis: there are as many components as variables.
[[nodiscard]] std::vector<std::optional<rational_polynomial>> eliminants(
    std::span<const expression> components);

/// A polynomial, not 0, that is 0 at g(x) for every x with p_i(x_i) = 0: the eliminant of t - g(x)
/// and the p_i. None as above. Hypothesis: no p_i is 0.
[[nodiscard]] std::optional<rational_polynomial> eliminant_of_values(
    const expression& g, std::span<const rational_polynomial> p);

/// The determinant of the derivatives of the components by the variables. None where one is no
/// polynomial with rational coefficients, and where it is long.
[[nodiscard]] std::optional<expression> jacobian_determinant(
    std::span<const expression> components);

}  // namespace polhode::detail
