#pragma once

// A formula as an integrand: in every arithmetic that quadrature asks for.

#include "polhode/expression/expression.hpp"
#include "polhode/quadrature/contour.hpp"
#include "polhode/quadrature/integrate.hpp"
#include "polhode/quadrature/integrate_box.hpp"

namespace polhode {

/// f must have one variable, or none.
[[nodiscard]] detail::integrand integrand_of(const expression& f);

/// A formula without variables as a limit; exactly, where it is found to be q + r pi with rational q and r.
[[nodiscard]] limit limit_of(const expression& f);
/// f must have two variables: the argument and the imaginary unit.
[[nodiscard]] detail::complex_integrand complex_integrand_of(const expression& f);

/// f's first variable is the argument, the others are the parameters.
[[nodiscard]] detail::parametric_integrand parametric_integrand_of(const expression& f);

}  // namespace polhode
