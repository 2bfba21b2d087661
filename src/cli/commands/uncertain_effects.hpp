#pragma once

// What commands about one body print where its moments have uncertainties: effects of a scene, with
// their ranges.

#include <array>
#include <optional>
#include <string>

#include "cli/output/errors.hpp"
#include "polhode/rigid_body/body.hpp"

namespace polhode::cli {

struct uncertain_effects {
  std::array<uncertain_moment, 3> moments;
  std::optional<rational> c;  // the motion
  std::string want;           // as a scene lists them: "period", "montgomery_phase"
  long listed = 20;           // meetings
  long digits = 30;
  double seconds = 0;  // the time limit
};

/// Prints them as text or JSON, as `polhode scene` does. Throws usage_error for what a scene
/// refuses.
exit_status print_effects(const uncertain_effects& of, bool as_json);

}  // namespace polhode::cli
