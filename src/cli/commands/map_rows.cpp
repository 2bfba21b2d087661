#include "map_rows.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/output/errors.hpp"
#include "cli/output/exact_decimals.hpp"
#include "polhode/arithmetic/exact.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/rigid_body/twist_curve.hpp"

namespace polhode::cli {
namespace map_rows_impl {
namespace {

/// A value and its radius; "undecided" and nothing where it is not certified.
std::string cells_of(const certain_number& found, long digits) {
  if (found.verdict != status::certified) return "undecided,";
  const decimal_enclosure d = to_decimal_enclosure(found.enclosure, digits);
  return d.value + ',' + d.radius;
}
/// "none" and nothing where the quantity does not exist.
std::string cells_of(const quantity& q, const body& rigid, const std::optional<rational>& c,
                     long digits) {
  const rational at = q.of_motion ? *c : rational(0);
  try {
    if (q.of_motion) (void)regime_of(rigid, at);
    q.check(rigid, at);
  } catch (const input_error&) {
    return "none,";
  } catch (const usage_error&) {
    return "none,";
  }
  if (at == 0 && q.infinite_at_0) return "inf,0";
  return cells_of(q.compute(rigid, at, digits), digits);
}

// ---------------------------------------------------------------------------------------------
// Cells

/// Between the ends; of a logarithmic axis near the geometric mean.
rational middle_of(const rational_range& range, bool log) {
  if (log) {
    const double mean =
        std::sqrt(static_cast<double>(range.low)) * std::sqrt(static_cast<double>(range.high));
    rational near = parse_rational(fmt::format("{:.9e}", mean));
    if (range.low < near && near < range.high) return near;
  }
  return (range.low + range.high) / 2;
}

/// The two columns of a quantity over a cell, and whether they are what was asked for.
struct range_cells {
  std::string text;
  bool is_done = true;
};
range_cells range_of(const map_grid& g, const quantity& q, const map_cell& cell) {
  std::optional<ball> range;
  if (g.chi) {
    range = limit_defect_range(cell.x, cell.y, g.digits);
  } else {
    const std::optional<body_box> bodies = bodies_of_cell(g, cell.x, cell.y);
    if (!bodies) return {"undecided,", false};
    const bool has_motions = cell.c.high > -bodies->b().high && cell.c.low < bodies->a().high;
    if (!q.of_motion || has_motions) range = q.range(*bodies, cell.c, g.digits);
  }
  if (!range) return {"none,"};
  if (!range->is_bounded()) return {"undecided,", false};
  if (q.is_whole) {
    const integer low = -floor_of(rational(-lower_rational(*range)));
    const integer high = floor_of(upper_rational(*range));
    return {low.str() + ',' + high.str(), low == high};
  }
  const decimal_enclosure d = to_decimal_enclosure(*range, g.digits);
  return {d.lower + ',' + d.upper,
          !g.width || parse_rational(d.upper) - parse_rational(d.lower) <= *g.width};
}

/// The row of a cell with the columns of its quantities.
std::string row_of_cell(const map_grid& g, const map_cell& cell,
                        const std::vector<std::string>& columns) {
  std::string result;
  for (const rational_range* range : {&cell.x, &cell.y, &cell.c}) {
    if (range == &cell.c && !g.c) continue;
    result += csv_cells(range->low) + ',' + csv_cells(range->high) + ',';
  }
  return result + fmt::format("{}\n", fmt::join(columns, ","));
}

/// The columns of each row.
std::vector<std::vector<std::string>> columns_of(const std::string& rows) {
  std::vector<std::vector<std::string>> result;
  std::istringstream lines(rows);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream row(line + ',');
    result.emplace_back();
    for (std::string one; std::getline(row, one, ',');) result.back().push_back(one);
  }
  return result;
}

}  // namespace
}  // namespace map_rows_impl

std::string header_of(const map_grid& g) {
  if (g.cells) {
    std::string result;
    for (const map_axis* axis : {&g.first, &g.second}) {
      result += csv_header(axis->name + "_low") + ',' + csv_header(axis->name + "_high") + ',';
    }
    result.pop_back();
    if (g.c) result += ',' + csv_header("c_low") + ',' + csv_header("c_high");
    for (const std::string& name : g.quantities) {
      result += fmt::format(",{0}_lower,{0}_upper", name);
    }
    return result + '\n';
  }
  std::string result = csv_header(g.first.name) + ',' + csv_header(g.second.name);
  if (g.c) result += ',' + csv_header("c");
  for (const std::string& name : g.quantities) result += fmt::format(",{0},{0}_radius", name);
  return result + '\n';
}

map_cell cell_of(const map_grid& g, std::size_t index) {
  const auto along = [](const std::vector<rational>& values, std::size_t k) {
    return rational_range{values[k], values[std::min(k + 1, values.size() - 1)]};
  };
  const std::size_t place = index / g.motions();
  const std::size_t columns = g.count_along(g.second.values);
  map_cell cell{
      along(g.first.values, place / columns), along(g.second.values, place % columns), {}};
  if (g.c) cell.c = along(g.c_values, index % g.motions());
  return cell;
}

void walk_cell(const map_grid& g, const map_cell& cell, const leaf_visitor& leaf,
               const cut_visitor& cut, long halvings) {
  std::vector<std::string> columns;
  columns.reserve(g.chosen.size());
  bool is_done = true;
  for (const quantity* q : g.chosen) {
    const map_rows_impl::range_cells one = map_rows_impl::range_of(g, *q, cell);
    columns.push_back(one.text);
    is_done = is_done && one.is_done;
  }
  const bool x_is_thin = cell.x.low == cell.x.high;
  const bool y_is_thin = cell.y.low == cell.y.high;
  if (is_done || halvings == g.refine || (x_is_thin && y_is_thin)) return leaf(cell, columns);
  const bool in_x = y_is_thin || (!x_is_thin && halvings % 2 == 0);
  map_cell low = cell;
  map_cell high = cell;
  rational_range map_cell::*const halved = in_x ? &map_cell::x : &map_cell::y;
  const rational middle = map_rows_impl::middle_of(cell.*halved, g.log);
  cut(in_x, middle);
  (low.*halved).high = (high.*halved).low = middle;
  walk_cell(g, low, leaf, cut, halvings + 1);
  walk_cell(g, high, leaf, cut, halvings + 1);
}

std::string row_of(const map_grid& g, std::size_t index) {
  const std::size_t motions = g.motions();
  if (g.cells) {
    std::string rows;
    walk_cell(
        g, cell_of(g, index),
        [&](const map_cell& cell, const std::vector<std::string>& columns) {
          rows += map_rows_impl::row_of_cell(g, cell, columns);
        },
        [](bool, const rational&) {});
    return rows;
  }
  const rational& x = g.first.values[index / motions / g.second.values.size()];
  const rational& y = g.second.values[index / motions % g.second.values.size()];
  std::optional<rational> c;
  if (g.c) c = g.c_values[index % motions];
  std::string result = csv_cells(x) + ',' + csv_cells(y);
  if (g.chi) {
    return result + ',' +
           map_rows_impl::cells_of(limit_defect_to_digits(x, y, g.digits), g.digits) + '\n';
  }
  const std::optional<body> rigid = body_at(g, x, y);
  if (c) result += ',' + csv_cells(*c);
  for (const quantity* q : g.chosen) {
    result += rigid ? ',' + map_rows_impl::cells_of(*q, *rigid, c, g.digits) : ",none,";
  }
  return result + '\n';
}

std::string map_areas(const map_grid& g, const std::string& rows) {
  const auto size = [&](const std::string& low, const std::string& high) {
    const auto x = static_cast<double>(parse_rational(low));
    const auto y = static_cast<double>(parse_rational(high));
    if (x == y) return 1.0;
    return g.log ? std::log(y) - std::log(x) : y - x;
  };
  const std::size_t first = g.c ? 12 : 8;  // two columns for each end
  double all = 0;
  std::vector<std::map<integer, double>> decided(g.chosen.size());
  for (const std::vector<std::string>& columns : map_rows_impl::columns_of(rows)) {
    const double area = size(columns.at(0), columns.at(2)) * size(columns.at(4), columns.at(6));
    all += area;
    for (std::size_t k = 0; k < decided.size(); ++k) {
      const std::string& low = columns.at(first + 2 * k);
      if (g.chosen[k]->is_whole && low == columns.at(first + 2 * k + 1)) {
        decided[k][integer(low)] += area;
      }
    }
  }
  std::string result = "quantity,value,percent_of_area\n";
  for (std::size_t k = 0; k < decided.size(); ++k) {
    if (!g.chosen[k]->is_whole) continue;
    double rest = all;
    for (const auto& [value, area] : decided[k]) {
      rest -= area;
      result += fmt::format("{},{},{:.2f}\n", g.quantities[k], value.str(), 100 * area / all);
    }
    result +=
        fmt::format("{},undecided,{:.2f}\n", g.quantities[k], 100 * std::max(rest, 0.0) / all);
  }
  return result;
}

std::vector<map_tile> map_tiles(const map_grid& g, const std::string& rows) {
  const auto number = [](const std::string& text) {
    return static_cast<double>(parse_rational(text));
  };
  constexpr std::size_t first = 8;
  std::vector<map_tile> result;
  for (const std::vector<std::string>& columns : map_rows_impl::columns_of(rows)) {
    map_tile tile;
    tile.x_low = number(columns.at(0));
    tile.x_high = number(columns.at(2));
    tile.y_low = number(columns.at(4));
    tile.y_high = number(columns.at(6));
    const std::string& low = columns.at(first);
    const std::string& high = columns.at(first + 1);
    if (low == "undecided" || (low != "none" && g.chosen.front()->is_whole && low != high)) {
      tile.is_undecided = true;
    } else if (low != "none") {
      tile.value = (number(low) + number(high)) / 2;
    }
    result.push_back(tile);
  }
  return result;
}

}  // namespace polhode::cli
