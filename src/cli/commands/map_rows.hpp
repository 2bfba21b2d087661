#pragma once

// The rows of a map: a point each, or cells.

#include <functional>
#include <string>
#include <vector>

#include "map_grid.hpp"
#include "map_picture.hpp"

namespace polhode::cli {

[[nodiscard]] std::string header_of(const map_grid& g);

/// A cell along the axes.
struct map_cell {
  rational_range x, y, c;
};
[[nodiscard]] map_cell cell_of(const map_grid& g, std::size_t index);

/// What is done with a cell that is not divided, and the two columns of each quantity; and with one
/// that is, before its halves: whether it is halved along the first axis, and where.
using leaf_visitor =
    std::function<void(const map_cell& cell, const std::vector<std::string>& columns)>;
using cut_visitor = std::function<void(bool in_first, const rational& at)>;

/// Visits a cell, or its halves, the lower first, where an integer is not decided or a range is too
/// wide: halved along the axes by turns.
void walk_cell(const map_grid& g, const map_cell& cell, const leaf_visitor& leaf,
               const cut_visitor& cut, long halvings = 0);

/// The row of a point, or the rows of a cell and what it was divided into.
[[nodiscard]] std::string row_of(const map_grid& g, std::size_t index);

/// Of each quantity that is an integer: on which share of the area it has which value. In doubles.
[[nodiscard]] std::string map_areas(const map_grid& g, const std::string& rows);

/// The cells of a map of one quantity, to be drawn. An integer is undecided where the cell has two
/// values of it; another quantity where it has no range.
[[nodiscard]] std::vector<map_tile> map_tiles(const map_grid& g, const std::string& rows);

}  // namespace polhode::cli
