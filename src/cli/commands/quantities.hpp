#pragma once

// The quantities of free rotations that `table` and `map` have.

#include <string>
#include <vector>

#include "polhode/rigid_body/body.hpp"
#include "polhode/rigid_body/montgomery_phase.hpp"

namespace polhode::cli {

struct quantity {
  std::string name;
  std::string description;
  bool of_motion;  // of a body and c, or of a body alone
  certain_number (*compute)(const body&, const rational& c, long digits);
  /// Throws usage_error where there is none.
  void (*check)(const body&, const rational& c);
  bool infinite_at_0 = false;  // on the separatrix, c = 0
};

[[nodiscard]] const std::vector<quantity>& all_quantities();

}  // namespace polhode::cli
