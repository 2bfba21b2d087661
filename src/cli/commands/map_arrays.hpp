#pragma once

// A map as arrays of doubles, for NumPy and HDF5. A double is not a decimal: what is printed of a
// number stays true of it, as its distance from the double is in the radius, and ends are rounded
// to the side where they stay bounds.

#include <string>
#include <vector>

#include "map_grid.hpp"

namespace polhode::cli {

/// Of a map of points: [quantity][0: value, 1: radius][a][b] and, for motions, [c].
[[nodiscard]] std::vector<double> map_numbers(const map_grid& g, const std::string& rows);

/// NumPy's format 1.0: that array; of a map of cells [cell][column], with the ends of a, b and c,
/// each rounded into the cell, and of each quantity the least value and the greatest, rounded
/// outwards.
[[nodiscard]] std::string map_npy(const map_grid& g, const std::string& rows);

/// A file of HDF5: of points a dataset of each quantity and of its radius, [a][b] and [c], with the
/// axes as doubles and exactly; of cells a dataset of each column. Throws usage_error where Polhode
/// was built without HDF5.
[[nodiscard]] std::string map_hdf5(const map_grid& g, const std::string& rows);

}  // namespace polhode::cli
