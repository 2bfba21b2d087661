#pragma once

// Checks that several claims share.

#include <functional>
#include <optional>

#include "checker/body.hpp"
#include "checker/examination.hpp"
#include "checker/interval.hpp"

namespace polhode::checker {

[[nodiscard]] inline const body& body_of(const examination& e) { return e.rigid(); }

/// The beginning of a claim about a body: its inputs, and the steps, which are for all bodies.
[[nodiscard]] body check_body_and_steps(examination& e);
/// A claim about all bodies, shown by its steps alone.
void check_steps_only(examination& e);
/// The number I, or J; a fact where it is rational.
void check_I(examination& e);
void check_J(examination& e);
/// A value of a phase, and the bounds of it at that place; the limit is below it everywhere.
struct bounded_phase {
  interval value;
  interval least;
  interval most;
};
/// At 1/4, 1/2, 3/4 of the range the phase decreases and keeps within its bounds and above the
/// limit.
[[nodiscard]] std::optional<bool> phase_obeys_its_bounds(
    const interval& limit, const std::function<bounded_phase(int quarter)>& at);
/// At u = 1/4, 1/2, 3/4 G decreases and keeps within its bounds.
[[nodiscard]] std::optional<bool> half_phase_obeys_its_bounds(const body& rigid, precision bits);

}  // namespace polhode::checker
