#pragma once

// The rows of a map: a point each, or cells.

#include <string>

#include "map_grid.hpp"

namespace polhode::cli {

[[nodiscard]] std::string header_of(const map_grid& g);

/// The row of a point, or the rows of a cell and what it was divided into.
[[nodiscard]] std::string row_of(const map_grid& g, std::size_t index);

/// Of each quantity that is an integer: on which share of the area it has which value. In doubles.
[[nodiscard]] std::string map_areas(const map_grid& g, const std::string& rows);

}  // namespace polhode::cli
