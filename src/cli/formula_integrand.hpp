#pragma once

// A formula as an integrand: in every arithmetic that quadrature asks for.

#include "polhode/expression/expression.hpp"
#include "polhode/quadrature/integrate.hpp"

namespace polhode::cli {

/// f must have one variable, or none.
[[nodiscard]] detail::integrand integrand_of(const expression& f);

/// A formula without variables as a limit; exactly, where it is found to be q + r pi with rational q and r.
[[nodiscard]] limit limit_of(const expression& f);

}  // namespace polhode::cli
