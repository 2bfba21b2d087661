#pragma once

// A figure: curves through certified points, drawn by gnuplot and written as CSV.

#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "polhode/arithmetic/exact.hpp"

namespace polhode::cli {

/// A number known exactly, or by an enclosure.
using coordinate = std::variant<rational, ball>;

struct figure_point {
  coordinate x;
  coordinate y;
};

struct figure_curve {
  /// How gnuplot draws the points, and what the legend says; a title of "" has no entry there.
  struct drawing {
    std::string style;  // "lines lw 2 lc rgb 'black'"
    std::string title;
  };

  std::string name;  // in the CSV file
  std::vector<drawing> drawings;
  /// Each part is joined in its order, and to no other part.
  std::vector<std::vector<figure_point>> parts;
};

struct figure_content {
  std::string settings;  // gnuplot's: ranges, tics, labels of the axes
  std::vector<figure_curve> curves;
};

/// A figure of the paper.
struct figure {
  std::string name;   // of its files
  std::string place;  // "figure 3 (a)"
  std::string shows;  // one line
  std::string note;   // where it differs from the print, and why; "" where it does not
  std::string x;      // the coordinates' names in the CSV file
  std::string y;
  /// Every number to so many certain digits; throws not_certified_error where that fails.
  std::function<figure_content(long digits)> compute;
};

/// All figures of the paper, in its order.
[[nodiscard]] const std::vector<figure>& all_figures();

/// A curve's name and part, both coordinates: the certain digits and the ends of the enclosure,
/// rounded outward.
[[nodiscard]] std::string csv_of(const figure& f, const figure_content& content, long digits);

/// The greatest difference of two ends in that CSV, to two significant digits, rounded up:
/// "1.3e-15".
[[nodiscard]] std::string greatest_width(const figure_content& content, long digits);

enum class picture_format { svg, png };

/// Its picture, with a line in its title that says how wide the enclosures are. Throws output_error
/// as run_gnuplot does.
[[nodiscard]] std::string draw(const figure& f, const figure_content& content,
                               const std::string& width, picture_format format);

}  // namespace polhode::cli
