#pragma once

// What each claim says: the checker's own copy, against which a certificate's words are compared. A certificate whose words are others
// proves something else.

#include <string_view>
#include <vector>

namespace polhode::checker {

enum class step_kind { identity, positive, not_negative, slope };

/// One step of a proof that is a question about polynomials: left = right; left = right > 0 or >= 0, by the signs of coefficients and
/// letters; or d/dvariable of left/over = right/over^2. What the letters stand for is put into `right`.
struct step_text {
  step_kind kind;
  std::string_view left;
  std::string_view over;      // of a slope
  std::string_view variable;  // of a slope
  std::string_view right;
  std::string_view letters;
  std::string_view meaning;
};

/// One step that no program decides.
struct stated_text {
  std::string_view kind;  // "argued in words" or "cited"
  std::string_view statement;
};

/// The tiers of proofs.
inline constexpr std::string_view by_machine = "by machine";
inline constexpr std::string_view with_words = "by machine, joined in words";
inline constexpr std::string_view by_argument = "by argument";

struct claim_text {
  std::string_view name;
  std::string_view reference;
  std::string_view statement;
  std::string_view formula;
  std::string_view method;
  std::vector<step_text> steps;
  std::string_view tier;  // how much of the proof a machine decides
  std::vector<stated_text> argument;
};

/// nullptr for a claim that this version does not know.
[[nodiscard]] const claim_text* find_claim_text(std::string_view name);

}  // namespace polhode::checker
