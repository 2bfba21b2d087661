#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace polhode {

/// The least number of letters to insert, delete or replace that turns one text into the other.
/// (V. I. Levenshtein, 1966; the table of Wagner and Fischer, 1974, of which one row is kept.)
[[nodiscard]] std::size_t edit_distance(std::string_view x, std::string_view y);

/// The known name nearest to the given one; the first of several. Hypothesis: there is one.
[[nodiscard]] std::string nearest_name(std::string_view given,
                                       const std::vector<std::string>& known);

/// The known name nearest to the given one, if it is near: equal but for the case of letters or for
/// two neighbours that are exchanged; or one letter off where the shorter of both has three, two
/// off where it has four, three off where it has eight. None where none is.
[[nodiscard]] std::optional<std::string> near_name(std::string_view given,
                                                   const std::vector<std::string>& known);

}  // namespace polhode
