#pragma once

// --c: which motion of the body, or which motions.

#include <optional>
#include <string>
#include <vector>

#include "polhode/rigid_body/montgomery_phase.hpp"

namespace polhode::cli {

/// The number that --c gives, for a body whose range it is in; throws usage_error.
[[nodiscard]] rational read_motion(const std::string& text, const body& rigid);

/// LO..HI/N, which is N equal steps and so N + 1 numbers; or one number, or a range without steps.
struct motion_range {
  rational low;
  rational high;
  std::optional<long> steps;

  /// low + k (high - low)/steps, exactly.
  [[nodiscard]] std::vector<rational> values() const;
};
/// Reads LO..HI/N, LO..HI or one number, that the option gives. Throws usage_error for anything
/// else, for LO not below HI, and for N not from 1 to most_steps.
[[nodiscard]] motion_range read_motions(const std::string& text, const std::string& option = "--c");
/// Reads LO..HI, both ends in the body's range; throws usage_error.
[[nodiscard]] motion_range read_motion_range(const std::string& text, const body& rigid);
inline constexpr long most_steps = 1'000'000;

/// The enclosure, where it is certified; else throws not_certified_error, which says what was not,
/// and why.
[[nodiscard]] ball certain(const certain_number& n, const std::string& what, long digits);

/// Throws usage_error unless the angular momentum moves in the body at c, with a `name` that there
/// is then.
void refuse_equilibrium(const body& rigid, const rational& c, const std::string& name);

}  // namespace polhode::cli
