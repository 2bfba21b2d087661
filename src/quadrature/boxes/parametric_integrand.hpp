#pragma once

// A function with parameters, in the arithmetics of quadrature.

#include <cstddef>
#include <functional>
#include <vector>

#include "polhode/quadrature/integrate_box.hpp"
#include "quadrature/formula/integrand.hpp"

namespace polhode {

namespace detail {

using parameter_box = std::vector<parameter_range>;

/// A function of x and of parameters, in the arithmetics that the library needs.
struct parametric_integrand {
  /// With the parameters as sets: x -> f(x, P).
  std::function<integrand(const parameter_box& box)> over_box;
  /// x -> df/dp_i(x, P), not analytic or undefined where f is.
  std::function<integrand(const parameter_box& box, std::size_t i)> derivative;
};

[[nodiscard]] box_integral integrate_function_over_box(const parametric_integrand& f,
                                                       const end_point& a, const end_point& b,
                                                       const parameter_box& box,
                                                       const box_options& options);

}  // namespace detail

/// f's first variable is the argument, the others are the parameters.
[[nodiscard]] detail::parametric_integrand parametric_integrand_of(const expression& f);

}  // namespace polhode
