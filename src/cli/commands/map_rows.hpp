#pragma once

// The rows of a map: a point each, or cells.

#include <string>
#include <vector>

#include "map_grid.hpp"
#include "map_picture.hpp"

namespace polhode::cli {

[[nodiscard]] std::string header_of(const map_grid& g);

/// The row of a point, or the rows of a cell and what it was divided into.
[[nodiscard]] std::string row_of(const map_grid& g, std::size_t index);

/// Of each quantity that is an integer: on which share of the area it has which value. In doubles.
[[nodiscard]] std::string map_areas(const map_grid& g, const std::string& rows);

/// The cells of a map of one quantity, to be drawn. An integer is undecided where the cell has two
/// values of it; another quantity where it has no range.
[[nodiscard]] std::vector<map_tile> map_tiles(const map_grid& g, const std::string& rows);

}  // namespace polhode::cli
