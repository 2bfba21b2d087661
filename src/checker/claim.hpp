#pragma once

// What a claim says and what its certificate is checked by: the checker's own copy, against which a certificate's words are compared. A
// certificate whose words are others proves something else. Each claim is a file in claims/, and a row of claims/list.hpp.

#include <string_view>
#include <vector>

namespace polhode::checker {

class examination;

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

[[nodiscard]] constexpr step_text identity(std::string_view left, std::string_view right,
                                           std::string_view meaning) {
  return {step_kind::identity, left, "", "", right, "", meaning};
}
[[nodiscard]] constexpr step_text positive(std::string_view left, std::string_view right,
                                           std::string_view letters, std::string_view meaning) {
  return {step_kind::positive, left, "", "", right, letters, meaning};
}
[[nodiscard]] constexpr step_text not_negative(std::string_view left, std::string_view right,
                                               std::string_view letters, std::string_view meaning) {
  return {step_kind::not_negative, left, "", "", right, letters, meaning};
}
[[nodiscard]] constexpr step_text slope(std::string_view left, std::string_view over,
                                        std::string_view variable, std::string_view right,
                                        std::string_view meaning) {
  return {step_kind::slope, left, over, variable, right, "", meaning};
}

/// How a step that this program does not decide is shown: the kinds of a certificate's argument.
inline constexpr std::string_view proved_in_coq = "proved in Coq";
inline constexpr std::string_view argued_in_words = "argued in words";
inline constexpr std::string_view only_cited = "cited";

/// One step that this program does not decide.
struct stated_text {
  std::string_view kind;       // proved_in_coq, argued_in_words or only_cited
  std::string_view statement;  // the name of the theorem in proofs/coq, or a sentence
};

/// A theorem of proofs/coq, as STATEMENTS.md there has it.
[[nodiscard]] constexpr stated_text in_coq(std::string_view theorem) {
  return {proved_in_coq, theorem};
}

[[nodiscard]] constexpr stated_text argued(std::string_view statement) {
  return {argued_in_words, statement};
}
[[nodiscard]] constexpr stated_text cited(std::string_view statement) {
  return {only_cited, statement};
}

/// The tiers of proofs.
inline constexpr std::string_view by_kernel = "by Coq's kernel";
inline constexpr std::string_view by_machine = "by machine";
inline constexpr std::string_view with_words = "by machine, joined in words";
inline constexpr std::string_view by_argument = "by argument";

struct claim {
  std::string_view name;
  std::string_view reference;
  std::string_view statement;
  std::string_view formula;
  std::string_view method;
  std::vector<step_text> steps;
  std::string_view tier;  // how much of the proof a machine decides
  std::vector<stated_text> argument;
  /// Checks the inputs, steps, facts, numbers and witness of a certificate of this claim, in its order; throws refusal.
  void (*check)(examination&);
};

/// nullptr for a claim that this version does not know.
[[nodiscard]] const claim* find_claim(std::string_view name);

}  // namespace polhode::checker
