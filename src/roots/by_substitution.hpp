#pragma once

// Systems of which one equation says what a variable is.
//
// Theorem. Let f_i = c (v - g) with a rational number c, not 0, and a formula g of the other
// variables. The zeros of f in a box are the points with v = g, at which g is defined and lies in
// v's side, whose other coordinates are zeros of the other components with g in the place of v.
// Where f and g are continuously differentiable, a zero of f is simple exactly where that of the
// others is.
// Proof. f_i = 0 is v = g. With w = v - g in the place of v, a change of variables of determinant
// 1, f_i is c w, so that the determinant of f's derivatives is, but for the sign, c times that of
// the others' by the other variables at w = 0.
//
// A system of two such equations is one equation in one variable, whose search proves multiple
// roots, and goes to infinity and up to where it is not defined.

#include <optional>

#include "polhode/roots/systems.hpp"

namespace polhode::detail {

/// Whether an equation is such a one.
[[nodiscard]] bool has_explicit_equation(const real_system& f);

/// The zeros of the system in the box; nullopt where no equation is such a one, or where not all of
/// them are found so.
[[nodiscard]] std::optional<system_root_set> solved_by_substitution(const real_system& f,
                                                                    const system_box& box,
                                                                    const system_options& options);

}  // namespace polhode::detail
