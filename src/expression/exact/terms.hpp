#pragma once

// The terms of an exact_sum, which are rational multiples of products of powers: taken apart and
// multiplied. Nothing here depends on the numbers that the generators stand for.

#include <optional>

#include "expression/exact_number.hpp"

namespace polhode::detail::exact_parts {

/// The greatest rational number c > 0 with x / c of coprime integer coefficients. Hypothesis: x is
/// not 0.
[[nodiscard]] rational content(const exact_sum& x);
/// The product of x and y.
[[nodiscard]] monomial merged(const monomial& x, const monomial& y);
/// x, where it has no generators.
[[nodiscard]] std::optional<rational> plain_number(const exact_sum& x);
/// 0 where g is not in m.
[[nodiscard]] rational exponent_in(const monomial& m, generator_id g);
[[nodiscard]] monomial without(monomial m, generator_id g);

}  // namespace polhode::detail::exact_parts
