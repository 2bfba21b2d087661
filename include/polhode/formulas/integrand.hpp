#pragma once

// Integrals of formulas, as `polhode integrate` finds them.
//
//   const integral i = integrate(parse("exp(-x^2)"), -end_point::infinity(), end_point::infinity(), {.digits = 50});
//   const integral j = integrate(parse("sin(x)"), 0, end_point_of(parse("pi/2", {})));
//   const contour_integral k = integrate_along(parse("exp(z)/z^3", {"z"}), path::circle(0, 1));
//
// A formula is a function object, but these overloads know more of it than a template can: its constants are converted once for each
// precision, and it is evaluated in every arithmetic that quadrature asks for.

#include <vector>

#include "polhode/expression/expression.hpp"
#include "polhode/formulas/end_point.hpp"
#include "polhode/quadrature/contour.hpp"
#include "polhode/quadrature/integrate.hpp"
#include "polhode/quadrature/integrate_box.hpp"

namespace polhode {

/// f in the arithmetics of quadrature. f must have one variable, or none; else input_error is thrown.
[[nodiscard]] detail::integrand integrand_of(const expression& f);

/// An integral of f that is not certified for want of digits, because it is 0: where f is 0 wherever it is defined
/// (is_formally_zero), and the enclosure, which is bounded, shows that it is defined almost everywhere, the integral is 0 exactly.
[[nodiscard]] integral settled_zero(const expression& f, integral found);

/// f in the arithmetics of integrals along paths. Its first variable is the argument; where it has a second one, that is the
/// imaginary unit. Throws input_error where it has more.
[[nodiscard]] detail::complex_integrand complex_integrand_of(const expression& f);

/// f's first variable is the argument, the others are the parameters.
[[nodiscard]] detail::parametric_integrand parametric_integrand_of(const expression& f);

/// The integral of f from a to b, as integrate of a generic function (integrate.hpp). Throws input_error where f has more than one
/// variable.
[[nodiscard]] integral integrate(const expression& f, const end_point& a, const end_point& b,
                                 const integrate_options& options = {});

/// The integral of f along a path, as integrate_along of a generic function (contour.hpp); variables as complex_integrand_of has them. A
/// formula with abs, min, max, floor or ceil of a variable is refused by the verdict: not_analytic, with the function's name.
[[nodiscard]] contour_integral integrate_along(const expression& f, const path& along,
                                               const integrate_options& options = {});

/// The range of the integral of f from a to b for all parameters in the box, which are f's variables behind the first, as
/// integrate_box of a generic function (integrate_box.hpp). Throws input_error where the box has another number of sides.
[[nodiscard]] box_integral integrate_box(const expression& f, const end_point& a,
                                         const end_point& b,
                                         const std::vector<parameter_range>& box,
                                         const box_options& options = {});

}  // namespace polhode
