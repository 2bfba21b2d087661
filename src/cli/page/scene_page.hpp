#pragma once

#include <string>

#include "polhode/scene/effects.hpp"

namespace polhode::cli {

/// Throws output_error where the program was built without pages.
void require_pages();

/// One HTML page without any other file: the body turning in three dimensions where the scene wants
/// its attitude, with polhode and herpolhode where it wants its momentum, and the effects with
/// their certified values. `report` is that of scene_json.
[[nodiscard]] std::string scene_page(const scene& what, const scene_report& results,
                                     const json& report);

/// A picture of an effect's table by gnuplot, vectors in panels of their own: "svg", "png" or
/// "pdf". Throws output_error where there is no gnuplot.
[[nodiscard]] std::string scene_plot(const std::string& title, const effect_table& table,
                                     const std::string& format);

}  // namespace polhode::cli
