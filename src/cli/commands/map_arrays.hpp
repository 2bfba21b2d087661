#pragma once

// A map as arrays of doubles, for NumPy and HDF5. The rounding to a double keeps them true: the
// radius holds the distance of the number from its double, and bounds are rounded to the side where
// they stay bounds.

#include <string>
#include <vector>

#include "map_grid.hpp"

namespace polhode::cli {

/// Of a map of points: [quantity][0: value, 1: radius][a][b] and, for motions, [c].
[[nodiscard]] std::vector<double> map_numbers(const map_grid& g, const std::string& rows);

/// NumPy's format 1.0. A map of points is the array above. A map of cells is [cell][column]: the
/// ends of a, b and c, rounded into the cell, and the least and the greatest value of each
/// quantity, rounded outwards.
[[nodiscard]] std::string map_npy(const map_grid& g, const std::string& rows);

/// A file of HDF5. A map of points has a dataset for each quantity and one for its radius, [a][b]
/// and [c], and the axes as doubles and exactly; a map of cells has a dataset for each column.
/// Throws usage_error where Polhode was built without HDF5.
[[nodiscard]] std::string map_hdf5(const map_grid& g, const std::string& rows);

}  // namespace polhode::cli
