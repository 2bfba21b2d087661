#pragma once

// Formulas as they are typeset, x² − 2π, in the characters of the grammar.

#include <string>
#include <string_view>
#include <vector>

namespace polhode::detail {

/// A formula in ASCII, with the column of each character, and of the end, in the text given.
struct plain_formula {
  std::string text;
  std::vector<std::size_t> columns;
};

/// What is said of a character that is none of these.
inline constexpr const char* foreign_character =
    "a character that no formula has; expected letters, digits and + - * / ^ ! ( ) ,";

/// Replaces − × · ÷ π √( and superscripts: x² is x^(2). Throws expression_error for other
/// characters, and for a power or a factorial behind a superscript, which can be read in two ways.
[[nodiscard]] plain_formula in_plain_characters(std::string_view formula);

}  // namespace polhode::detail
