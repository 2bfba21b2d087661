#pragma once

// The text of a claim: its words, its polynomial steps, and what else it rests on. It is data, and
// decides nothing: the prover writes it into certificates, the checker compares certificates with
// it, and each decides the steps by itself. A certificate whose words are others proves something
// else. Each claim is a header here, and a row of list.hpp.

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace polhode::statements {

enum class step_form { identity, positive, not_negative, slope };

/// One step of a proof that is a question about polynomials: left = right; left = right > 0 or
/// >= 0, by the signs of coefficients and letters; or d/dvariable of left/over = right/over^2. What
/// the letters stand for is put into `right`. It refers to its texts and does not own them.
struct polynomial_step {
  step_form form;
  std::string_view left;
  std::string_view over;      // of a slope
  std::string_view variable;  // of a slope
  std::string_view right;
  std::string_view letters;
  std::string_view meaning;
};

[[nodiscard]] constexpr polynomial_step identity(std::string_view left, std::string_view right,
                                                 std::string_view meaning) {
  return {step_form::identity, left, "", "", right, "", meaning};
}
[[nodiscard]] constexpr polynomial_step positive(std::string_view left, std::string_view right,
                                                 std::string_view letters,
                                                 std::string_view meaning) {
  return {step_form::positive, left, "", "", right, letters, meaning};
}
[[nodiscard]] constexpr polynomial_step not_negative(std::string_view left, std::string_view right,
                                                     std::string_view letters,
                                                     std::string_view meaning) {
  return {step_form::not_negative, left, "", "", right, letters, meaning};
}
[[nodiscard]] constexpr polynomial_step slope(std::string_view left, std::string_view over,
                                              std::string_view variable, std::string_view right,
                                              std::string_view meaning) {
  return {step_form::slope, left, over, variable, right, "", meaning};
}

/// Whether the step is about a sign.
[[nodiscard]] constexpr bool is_sign(const polynomial_step& step) {
  return step.form == step_form::positive || step.form == step_form::not_negative;
}
/// The form as a certificate names it.
[[nodiscard]] constexpr std::string_view form_in_words(const polynomial_step& step) {
  if (is_sign(step)) return "sign by coefficients";
  return step.form == step_form::identity ? "identity" : "derivative of a quotient";
}
[[nodiscard]] constexpr std::string_view conclusion_of(const polynomial_step& step) {
  return step.form == step_form::positive ? "> 0" : ">= 0";
}
/// "(1-b)^2 - b*(a+b) = 1 - 2*b - a*b, expanded over Q: what it says in the proof"
[[nodiscard]] inline std::string sentence_of(const polynomial_step& step);

/// The kinds of steps that no program here decides, as a certificate shows them.
inline constexpr std::string_view proved_in_coq = "proved in Coq";
inline constexpr std::string_view argued_in_words = "argued in words";
inline constexpr std::string_view only_cited = "cited";

/// One step that neither prover nor checker decides.
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

/// The sentence with these texts in place of its {}, one after the other.
[[nodiscard]] inline std::string fill(std::string_view sentence,
                                      std::initializer_list<std::string> texts) {
  std::string result;
  for (const std::string& text : texts) {
    const auto gap = sentence.find("{}");
    result += sentence.substr(0, gap);
    result += text;
    sentence.remove_prefix(gap + 2);
  }
  return result.append(sentence);
}

struct claim_text {
  std::string_view name;
  std::string_view reference;  // where the paper says it
  std::string_view statement;
  std::string_view technique;  // one line, for tables
  std::string_view formula;    // what is enclosed, or the identity or inequality
  std::string_view method;     // the argument, in words
  std::vector<polynomial_step> steps;
  std::string_view tier;  // how much of the proof a machine decides
  std::vector<stated_text> argument;
};

inline std::string sentence_of(const polynomial_step& step) {
  const auto text = [](std::string_view part) { return std::string(part); };
  const std::string equation = step.form == step_form::slope
                                   ? fill("d/d{} of ({})/({}) = ({})/({})^2",
                                          {text(step.variable), text(step.left), text(step.over),
                                           text(step.right), text(step.over)})
                                   : fill("{} = {}", {text(step.left), text(step.right)});
  if (!is_sign(step)) return fill("{}, expanded over Q: {}", {equation, text(step.meaning)});
  return fill("{} {} for {}, expanded over Q, no coefficient of the right side being negative: {}",
              {equation, text(conclusion_of(step)), text(step.letters), text(step.meaning)});
}

}  // namespace polhode::statements
