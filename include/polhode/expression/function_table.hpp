#pragma once

// The table of the named functions of formulas: one row a function.
//
// The reader, `polhode eval --functions`, the check of docs/expressions.md, the texts of formulas,
// the cost of one, and the evaluation over every arithmetic are made of these rows. A row becomes
// an enumerator, a case of a switch and a call by that name found by its arguments; only the
// preprocessor makes all three of one word, so the table is a macro:
//
//   POLHODE_FUNCTION_TABLE(OF_ONE, OF_TWO, OF_EITHER, MADE)
//     OF_ONE(name, "x", what it is, where it is defined, kind, reader)      f(x), an operation
//     OF_TWO(name, "x, y", ..., kind, reader)                               f(x, y), an operation
//     OF_EITHER(name, "x, y", ..., kind, reader)
//       the same, with f(x, y) = f(y, x)
//     MADE(name, arguments, what it is, where it is defined, reader)
//       made of other operations when the formula is read
//
// A derivative is no column: no formula is differentiated as a text. Derivatives are values of the
// same call at a jet, and jet.hpp has for each function the recurrence of its Taylor coefficients,
// of every order, which a formula for f' could not give without making it grow; end_series.hpp and
// symmetry.hpp have rules that are none of derivatives. A T without such a rule answers for itself
// (value_over in evaluation.hpp), and functions beyond the table bring their gradient
// (further_function).
//
// The rows are in the order of the tables that people see. `reader` is a name in
// src/expression/functions.cpp: a domain, bool(const rational&), which refuses a number outside; or
// a function that makes the node of a call.

#include "polhode/language.hpp"

namespace polhode::detail {

/// What is known of a named function beside its values: how dear it is, and whether it is made of
/// several analytic functions.
enum class function_kind {
  algebraic,   // as dear as a product or a quotient
  piecewise,   // no dearer, and not analytic
  elementary,  // as exp
  special,     // as gamma
};

}  // namespace polhode::detail

// clang-format off
#define POLHODE_FUNCTION_TABLE(OF_ONE, OF_TWO, OF_EITHER, MADE) \
  OF_ONE(sqrt, "x", "square root", "x >= 0", algebraic, not_negative) \
  MADE(cbrt, "x", "real cube root", "all x", cube_root_of) \
  MADE(root, "x, n", "real n-th root, n a whole number from 1", "x >= 0; all x where n is odd", root_of) \
  MADE(pow, "x, y", "x^y", "as x^y", power_of) \
  OF_ONE(exp, "x", "e^x", "all x", elementary, everywhere) \
  OF_ONE(expm1, "x", "e^x - 1", "all x", elementary, everywhere) \
  OF_ONE(log, "x", "natural logarithm", "x > 0", elementary, positive) \
  MADE(ln, "x", "natural logarithm, the same as log", "x > 0", natural_logarithm) \
  OF_ONE(log1p, "x", "log(1 + x)", "x > -1", elementary, above_minus_one) \
  MADE(log2, "x", "logarithm to the base 2", "x > 0", binary_logarithm) \
  MADE(log10, "x", "logarithm to the base 10", "x > 0", decimal_logarithm) \
  OF_ONE(sin, "x", "sine", "all x", elementary, everywhere) \
  OF_ONE(cos, "x", "cosine", "all x", elementary, everywhere) \
  OF_ONE(tan, "x", "tangent", "no odd multiple of pi/2", elementary, everywhere) \
  MADE(sec, "x", "1/cos(x)", "no odd multiple of pi/2", secant) \
  MADE(csc, "x", "1/sin(x)", "no multiple of pi", cosecant) \
  MADE(cot, "x", "cos(x)/sin(x)", "no multiple of pi", cotangent) \
  OF_ONE(sinpi, "x", "sin(pi x)", "all x", elementary, everywhere) \
  OF_ONE(cospi, "x", "cos(pi x)", "all x", elementary, everywhere) \
  OF_ONE(asin, "x", "arc sine, in [-pi/2, pi/2]", "-1 <= x <= 1", elementary, in_closed_unit) \
  OF_ONE(acos, "x", "arc cosine, in [0, pi]", "-1 <= x <= 1", elementary, in_closed_unit) \
  OF_ONE(atan, "x", "arc tangent, in (-pi/2, pi/2)", "all x", elementary, everywhere) \
  OF_TWO(atan2, "y, x", "angle of the point (x, y), in (-pi, pi]", "not x = y = 0", elementary, atan2_of) \
  MADE(acot, "x", "inverse of cot, in (0, pi): pi/2 - atan(x)", "all x", inverse_cotangent) \
  MADE(asec, "x", "inverse of sec, in [0, pi]: acos(1/x)", "x <= -1 or x >= 1", inverse_secant) \
  MADE(acsc, "x", "inverse of csc, in [-pi/2, pi/2]: asin(1/x)", "x <= -1 or x >= 1", inverse_cosecant) \
  OF_ONE(sinh, "x", "hyperbolic sine", "all x", elementary, everywhere) \
  OF_ONE(cosh, "x", "hyperbolic cosine", "all x", elementary, everywhere) \
  OF_ONE(tanh, "x", "hyperbolic tangent", "all x", elementary, everywhere) \
  MADE(sech, "x", "1/cosh(x)", "all x", hyperbolic_secant) \
  MADE(csch, "x", "1/sinh(x)", "x != 0", hyperbolic_cosecant) \
  MADE(coth, "x", "1/tanh(x)", "x != 0", hyperbolic_cotangent) \
  OF_ONE(asinh, "x", "inverse of sinh", "all x", elementary, everywhere) \
  OF_ONE(acosh, "x", "inverse of cosh, >= 0", "x >= 1", elementary, from_one) \
  OF_ONE(atanh, "x", "inverse of tanh", "-1 < x < 1", elementary, in_open_unit) \
  MADE(asech, "x", "inverse of sech, >= 0: acosh(1/x)", "0 < x <= 1", inverse_hyperbolic_secant) \
  MADE(acsch, "x", "inverse of csch: asinh(1/x)", "x != 0", inverse_hyperbolic_cosecant) \
  MADE(acoth, "x", "inverse of coth: atanh(1/x)", "x < -1 or x > 1", inverse_hyperbolic_cotangent) \
  OF_ONE(abs, "x", "|x|", "all x", piecewise, everywhere) \
  MADE(sign, "x", "-1, 0 or 1 as x < 0, x = 0 or x > 0", "all x", sign_of) \
  OF_EITHER(min, "x, y", "the smaller of both; of several: min(x, y, z)", "all x and y", piecewise, smaller_of) \
  OF_EITHER(max, "x, y", "the greater of both; of several: max(x, y, z)", "all x and y", piecewise, greater_of) \
  OF_ONE(floor, "x", "greatest integer <= x", "all x", piecewise, everywhere) \
  OF_ONE(ceil, "x", "least integer >= x", "all x", piecewise, everywhere) \
  MADE(trunc, "x", "whole part, towards 0", "all x", truncated) \
  MADE(round, "x", "nearest integer, floor(x + 1/2)", "all x", rounded) \
  MADE(frac, "x", "x - floor(x), in [0, 1)", "all x", fractional_part) \
  MADE(mod, "x, y", "x - y floor(x/y), of the sign of y", "y != 0", remainder_of) \
  MADE(heaviside, "x", "0, 1/2 or 1 as x < 0, x = 0 or x > 0", "all x", unit_step) \
  OF_EITHER(hypot, "x, y", "sqrt(x^2 + y^2); of several: hypot(x, y, z)", "all x and y", algebraic, hypot_of) \
  OF_EITHER(agm, "x, y", "arithmetic-geometric mean", "x >= 0 and y >= 0", elementary, agm_of) \
  OF_ONE(gamma, "x", "Euler's gamma function", "no whole number <= 0", special, gamma_of) \
  OF_ONE(log_gamma, "x", "log |gamma(x)|", "no whole number <= 0", special, log_gamma_of) \
  MADE(lgamma, "x", "log |gamma(x)|, the same as log_gamma", "no whole number <= 0", log_gamma_of) \
  OF_ONE(erf, "x", "error function", "all x", special, everywhere) \
  OF_ONE(erfc, "x", "1 - erf(x)", "all x", special, everywhere) \
  MADE(sinc, "x", "sin(x)/x; 1 at the number 0", "x != 0; x = 0 as a number", cardinal_sine) \
  MADE(factorial, "x", "gamma(x + 1)", "no whole number < 0", factorial_of) \
  MADE(binomial, "x, k", "x(x - 1)...(x - k + 1)/k!", "k a whole number from 0 to 1000", binomial_of) \
  MADE(euler_beta, "x, y", "gamma(x) gamma(y)/gamma(x + y)", "x, y, x + y no whole number <= 0", euler_beta_of) \
  MADE(chebyshevT, "n, x", "Chebyshev polynomial, first kind", "n a whole number from 0 to 1000", chebyshev_t) \
  MADE(chebyshevU, "n, x", "Chebyshev polynomial, second kind", "n a whole number from 0 to 1000", chebyshev_u) \
  MADE(legendreP, "n, x", "Legendre polynomial", "n a whole number from 0 to 1000", legendre_p) \
  MADE(hermiteH, "n, x", "Hermite polynomial, of weight exp(-x^2)", "n a whole number from 0 to 1000", hermite_h) \
  MADE(laguerreL, "n, x", "Laguerre polynomial", "n a whole number from 0 to 1000", laguerre_l) \
  MADE(zeta, "n", "Riemann's zeta function", "n a whole number from 2", zeta_of)
// clang-format on

/// For the rows that a use of the table has nothing to make of.
#define POLHODE_NO_ROW(...)
