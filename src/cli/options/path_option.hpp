#pragma once

// A path in the complex plane, given by formulas in which i is the imaginary unit.

#include <string>

#include "formula.hpp"
#include "polhode/quadrature/contour.hpp"

namespace polhode::cli {

inline constexpr const char* imaginary_unit = "i";

/// "0, 1, 1+i": straight lines from point to point. Throws usage_error for anything else.
[[nodiscard]] path read_polygon(const std::string& text, const let_option& let);

/// "CENTRE, RADIUS": once around, counterclockwise. Throws usage_error for anything else.
[[nodiscard]] path read_circle(const std::string& text, const let_option& let);

}  // namespace polhode::cli
