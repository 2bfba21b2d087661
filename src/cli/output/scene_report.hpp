#pragma once

// What a scene has come to, as JSON, text and tables.

#include <string>
#include <vector>

#include "polhode/scene/effects.hpp"

namespace polhode::cli {

/// A point of a sweep: the numbers that stand in the place of the file's. Empty where the scene has
/// none.
using sweep_point = std::vector<std::pair<std::string, rational>>;

/// Whether a report has the rows of curves and series, of which there may be millions, or their
/// number.
enum class table_rows { kept, counted };

/// The whole report. `digest` is that of everything it was computed from.
[[nodiscard]] json scene_json(const scene& what, const scene_report& report,
                              const std::string& file, const sweep_point& point,
                              const std::string& digest, table_rows rows);

/// For a terminal, made from the JSON.
[[nodiscard]] std::string scene_text(const json& report);

/// One line a number, of any scenes: the scene, two columns for each parameter of a sweep (a
/// decimal and the quotient), effect, quantity, unit, value, radius, lower, upper, digits, word,
/// verdict. What is no number is a word.
[[nodiscard]] std::string results_csv(const std::vector<json>& reports);

/// An effect's series: its columns with their ends, and units in the header.
[[nodiscard]] std::string table_csv(const effect_table& table);

}  // namespace polhode::cli
