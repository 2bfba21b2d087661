#pragma once

// A map over the plane of bodies as a picture.

#include <optional>
#include <string>
#include <vector>

namespace polhode::cli {

/// A rectangle of the plane and what the quantity is in it: a number on all of it (of a range the
/// middle), nothing where it does not exist, or undecided.
struct map_tile {
  double a_low = 0, a_high = 0, b_low = 0, b_high = 0;
  std::optional<double> value;
  bool is_undecided = false;
};

/// The values of one quantity, at the points [a][b], or on tiles that cover the rectangle of these
/// axes. Values that are no numbers stay empty in the picture.
struct map_values {
  std::string quantity;
  std::vector<double> a, b;
  std::vector<double> values;
  std::vector<map_tile> tiles;
  bool log = false;  // the axes
};

/// Drawn by gnuplot as "svg" or "png": the values as colours, undecided tiles in grey; over them
/// the curves I = 1, I = 2/(2n+1) and J = 1, 2 where they cross the map. Throws output_error as
/// run_gnuplot does.
[[nodiscard]] std::string map_picture(const map_values& map, const std::string& format);

}  // namespace polhode::cli
