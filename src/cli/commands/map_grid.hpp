#pragma once

// The grid of a map: which bodies and motions, and what is computed of them.

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "polhode/rigid_body/body_box.hpp"
#include "quantities.hpp"

namespace polhode::cli {

/// One of the two axes of the plane of bodies.
struct map_axis {
  std::string name;   // of columns
  std::string title;  // of pictures
  std::vector<rational> values;
};

/// The same numbers as `polhode map` was given, and what is computed at each point.
struct map_grid {
  std::vector<std::string> quantities;
  // The bodies: by a and b, or by moments of which one is a number; or the limit of slender ones,
  // a -> infinity and b -> 0, by chi = a b and beta = c/b.
  std::optional<std::string> a, b;
  std::optional<std::string> moments;
  std::optional<std::string> chi, beta;
  std::optional<std::string> c;
  bool log = false;
  long digits = 15;
  bool cells = false;             // ranges over the cells between the values, in place of points
  long refine = 0;                // how often a cell is halved at most
  std::optional<rational> width;  // of a range that is narrow enough
  static constexpr long most_points_of_block = 1'000'000;
  std::size_t points_of_block = 0;  // 0: by what they cost
  // Made of these:
  map_axis first, second;
  std::vector<rational> c_values;
  /// Of moments: the one that is a number, and its place among the three; the others are on the
  /// axes, in their order.
  rational fixed;
  std::size_t place_of_fixed = 0;
  std::vector<const quantity*> chosen;

  [[nodiscard]] std::size_t points() const {
    return count_along(first.values) * count_along(second.values) * motions();
  }
  [[nodiscard]] std::size_t motions() const { return c_values.empty() ? 1 : count_along(c_values); }
  /// Points, or cells, along an axis with these values; a single value is a cell.
  [[nodiscard]] std::size_t count_along(const std::vector<rational>& values) const {
    return cells ? std::max<std::size_t>(values.size() - 1, 1) : values.size();
  }
  [[nodiscard]] std::size_t blocks() const {
    return (points() + points_of_block - 1) / points_of_block;
  }
};

/// The body at a point of the axes, which are not chi and beta; nothing where two moments are
/// equal.
[[nodiscard]] std::optional<body> body_at(const map_grid& g, const rational& x, const rational& y);
/// A box that holds all bodies of a cell; nothing where the order of the moments is not one.
[[nodiscard]] std::optional<body_box> bodies_of_cell(const map_grid& g, const rational_range& x,
                                                     const rational_range& y);

/// Fills in what is made of the options; throws usage_error.
[[nodiscard]] map_grid completed(map_grid g);

/// What map.json has in a directory of blocks: of what map they are.
[[nodiscard]] std::string head_of(const map_grid& g);
/// The grid in such a text; nothing where it is not as this version writes it.
[[nodiscard]] std::optional<map_grid> read_head(const std::string& text);

}  // namespace polhode::cli
