#pragma once

// A map over the plane of bodies as a picture.

#include <string>
#include <vector>

namespace polhode::cli {

/// The values of one quantity, [a][b]; those that are no numbers stay empty in the picture.
struct map_values {
  std::string quantity;
  std::vector<double> a, b;
  std::vector<double> values;
  bool log = false;  // the axes
};

/// Drawn by gnuplot as "svg" or "png": the values as colours, over them the curves I = 1, I =
/// 2/(2n+1) and J = 1, 2 where they cross the map. Throws output_error as run_gnuplot does.
[[nodiscard]] std::string map_picture(const map_values& map, const std::string& format);

}  // namespace polhode::cli
