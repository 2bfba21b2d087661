#pragma once

// Checks that several claims share.

#include <optional>

#include "checker/body.hpp"
#include "checker/examination.hpp"

namespace polhode::checker {

[[nodiscard]] inline body body_of(const examination& e) { return {e.a(), e.b()}; }

/// A claim about all bodies, shown by its steps alone.
void check_steps_only(examination& e);
/// The number I, or J; a fact where it is rational.
void check_I(examination& e);
void check_J(examination& e);
/// At u = 1/4, 1/2, 3/4 G decreases and keeps within its bounds.
[[nodiscard]] std::optional<bool> half_phase_obeys_its_bounds(const body& rigid, precision bits);

}  // namespace polhode::checker
