#pragma once

// A claim as the checker has it: its text, and what checks its certificates. Each claim is a file
// in claims/.

#include <string_view>

#include "statements/claim_text.hpp"

namespace polhode::checker {

using statements::stated_text;

class examination;

struct claim : statements::claim_text {
  /// Checks the inputs, steps, facts, numbers and witness of a certificate of this claim, in its
  /// order; throws refusal.
  void (*check)(examination&);
};

/// nullptr for a claim that this version does not know.
[[nodiscard]] const claim* find_claim(std::string_view name);

}  // namespace polhode::checker
