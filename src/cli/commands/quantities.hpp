#pragma once

// The quantities of free rotations that `table` and `map` have.

#include <optional>
#include <string>
#include <vector>

#include "polhode/rigid_body/body_box.hpp"
#include "polhode/rigid_body/montgomery_phase.hpp"

namespace polhode::cli {

struct quantity {
  std::string name;
  std::string description;
  std::string unit;
  bool of_motion;  // of a body and c, or of a body alone
  certain_number (*compute)(const body&, const rational& c, long digits);
  /// Throws usage_error where there is none.
  void (*check)(const body&, const rational& c);
  /// The range of it over all bodies of a box, and motions of them with c in a range, if there are
  /// any; nothing where it exists for none, undefined where it is not enclosed.
  std::optional<ball> (*range)(const body_box&, const rational_range& c, long digits);
  bool is_whole = false;       // an integer
  bool infinite_at_0 = false;  // on the separatrix, c = 0
  double microseconds = 100;   // of one number to 15 digits, about, where this was measured
};

[[nodiscard]] const std::vector<quantity>& all_quantities();

}  // namespace polhode::cli
