#pragma once

// A map over the plane of bodies as a picture.

#include <optional>
#include <string>
#include <vector>

namespace polhode::cli {

/// A rectangle of the plane and what the quantity is in it: a number on all of it (of a range the
/// middle), nothing where it does not exist, or undecided.
struct map_tile {
  double x_low = 0, x_high = 0, y_low = 0, y_high = 0;
  std::optional<double> value;
  bool is_undecided = false;
};

/// The axes: a and b, two moments, or chi and beta in the limit of slender bodies.
enum class map_plane { bodies, moments, limit };

/// The values of one quantity, at the points [x][y], or on tiles that cover the rectangle of these
/// axes. Values that are no numbers stay empty in the picture.
struct map_values {
  std::string quantity;
  std::string x_title, y_title;
  std::vector<double> x, y;
  map_plane plane = map_plane::bodies;
  double third_moment = 0;  // beside two on the axes
  std::vector<double> values;
  std::vector<map_tile> tiles;
  bool log = false;  // the axes
};

/// Drawn by gnuplot as "svg" or "png": the values as colours, undecided tiles in grey; over them
/// the curves I = 1, I = 2/(2n+1) and J = 1, 2 where they cross the map; over moments the planar
/// bodies. Throws output_error as run_gnuplot does.
[[nodiscard]] std::string map_picture(const map_values& map, const std::string& format);

}  // namespace polhode::cli
