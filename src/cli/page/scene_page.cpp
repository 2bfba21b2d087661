#include "scene_page.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "cli/output/errors.hpp"
#include "cli/output/exact_decimals.hpp"
#include "cli/output/gnuplot.hpp"
#include "polhode/arithmetic/boost_bridge.hpp"
#include "polhode/arithmetic/double_interval.hpp"
#include "polhode/arithmetic/text.hpp"
#include "scene_page_template.hpp"

namespace polhode::cli {
namespace {

/// Near enough to draw with.
double drawn(const ball& x) { return midpoint(x).convert_to<double>(); }

const effect_table* table_of(const scene_report& results, const std::string& name) {
  const effect_result* found = results.find(name);
  return found && found->table ? &*found->table : nullptr;
}

/// So many of the columns, of every stride-th row.
json columns(const effect_table& table, std::size_t first, std::size_t count, std::size_t stride) {
  json result = json::array();
  for (std::size_t i = 0; i < table.rows.size(); i += stride) {
    json one = json::array();
    for (std::size_t k = 0; k < count; ++k) one.push_back(drawn(table.rows[i][first + k]));
    result.push_back(std::move(one));
  }
  return result;
}

json first_column(const effect_table& table, std::size_t stride) {
  json result = json::array();
  for (std::size_t i = 0; i < table.first.size(); i += stride)
    result.push_back(static_cast<double>(table.first[i]));
  return result;
}

/// The moments, the greatest 1.
std::array<double, 3> relative_moments(const scene_body& of) {
  std::array<double, 3> result{};
  for (std::size_t i = 0; i < 3; ++i) result[i] = drawn((of.moments()[i] / of.moments()[0]).at(64));
  return result;
}

/// The half sides of a box with these moments, the longest 1: side i^2 is as I_j + I_k - I_i. A
/// non-physical body has none: its least side is drawn thin.
std::array<double, 3> half_sides(const scene_body& of) {
  const std::array<double, 3> m = relative_moments(of);
  std::array<double, 3> side{};
  for (std::size_t i = 0; i < 3; ++i)
    side[i] = std::sqrt(std::max(m[(i + 1) % 3] + m[(i + 2) % 3] - m[i], 1e-3));
  const double longest = *std::max_element(side.begin(), side.end());
  for (double& s : side) s = std::max(s / longest, 0.02);
  return side;
}

json axes_of(const scene_body& of) {
  json result = json::array();
  for (std::size_t i = 0; i < 3; ++i) {
    json one = json::array();
    for (const ball& x : of.principal_axis(i, 64)) one.push_back(drawn(x));
    result.push_back(std::move(one));
  }
  return result;
}

/// The solids of which the body is composed, so large that none reaches farther from the centre of
/// mass than 1 along an axis.
json solids_of(const scene_body& of) {
  rational reach = 0;
  for (const body_solid& one : of.solids) {
    for (std::size_t i = 0; i < 3; ++i)
      reach = std::max(reach, rational(abs(one.position[i]) + one.half[i]));
  }
  const auto scaled = [&](const rational_vector& v) {
    json result = json::array();
    for (const rational& x : v) result.push_back(static_cast<double>(rational(x / reach)));
    return result;
  };
  json result = json::array();
  for (const body_solid& one : of.solids) {
    result.push_back({{"shape", one.shape},
                      {"half", scaled(one.half)},
                      {"axis", one.axis},
                      {"position", scaled(one.position)}});
  }
  return result;
}

/// What is drawn of a series in time.
void add_series(json& data, const scene& what, const effect_table* attitude,
                const effect_table* momentum) {
  constexpr std::size_t most_drawn = 20'000;
  const effect_table& any = attitude ? *attitude : *momentum;
  const std::size_t stride = (any.rows.size() + most_drawn - 1) / most_drawn;
  data["stride"] = stride;
  data["t"] = first_column(any, stride);
  data["axes"] = axes_of(what.body);
  data["moments"] = relative_moments(what.body);
  data["half"] = half_sides(what.body);
  if (!what.body.solids.empty()) data["solids"] = solids_of(what.body);
  if (attitude) data["q"] = columns(*attitude, 0, 4, stride);
  if (momentum) {
    data["j"] = columns(*momentum, 0, 3, stride);
    data["omega"] = columns(*momentum, 3, 3, stride);
  }
}

/// The symbol of a column's quantity, with gnuplot's sign for what is set lower: "ω_1", "J_1/|J|".
std::string symbol_of(const std::string& column) {
  const auto end = std::min(column.find('_'), column.size());
  const std::string name = column.substr(0, end);
  const std::string index = column.substr(end);
  if (name == "j") return 'J' + index + "/|J|";
  for (const auto& [word, symbol] : {std::pair("omega", "ω"), std::pair("phi", "φ"),
                                     std::pair("epsilon", "ε"), std::pair("phase", "Δφ")}) {
    if (name == word) return symbol + index;
  }
  return column;
}

/// The symbol of a quantity, with the unit of a column: "ω [rad/day]".
std::string axis_label(const effect_table& table, std::size_t column, const std::string& name) {
  const bool has_unit = column < table.units.size() && !table.units[column].empty();
  return symbol_of(name) + (has_unit ? " [" + table.units[column] + ']' : "");
}

/// Of the Montgomery phase over c, which is infinite at c = 0: no line is drawn from one side to
/// the other.
bool is_apart(const effect_table& table, std::size_t row) {
  return row > 0 && table.columns[1] == "phase" && table.first[row - 1] < 0 && table.first[row] > 0;
}

/// As it may stand in a script of a page: no "</script>" and no comment can begin in it.
std::string embedded(const json& data) {
  std::string result;
  for (const char c : data.dump(-1, ' ', false, json::error_handler_t::replace))
    result += c == '<' ? std::string("\\u003c") : std::string(1, c);
  return result;
}

}  // namespace

void require_pages() {
  if (!page_template.empty()) return;
  throw output_error(
      "--page: this polhode was built without pages, which npm bundles: install Debian's nodejs "
      "and npm, configure and build it again; or leave out --page");
}

std::string scene_page(const scene& what, const scene_report& results, const json& report) {
  json data{{"title", what.title.empty() ? report["file"].get<std::string>() : what.title},
            {"source", what.source},
            {"unit", what.time_unit.name},
            {"report", report}};
  for (auto& [name, effect] : data["report"]["effects"].items()) effect.erase("table");
  for (const char* name : {"montgomery_curve", "twist_curve"}) {
    const effect_table* curve = table_of(results, name);
    if (!curve) continue;
    json points = json::array();
    for (std::size_t i = 0; i < curve->rows.size(); ++i)
      points.push_back({static_cast<double>(curve->first[i]), drawn(curve->rows[i][0])});
    data["curves"][name] = {
        {"columns",
         {axis_label(*curve, 0, curve->columns[0]), axis_label(*curve, 1, curve->columns[1])}},
        {"rows", std::move(points)}};
  }
  const effect_table* attitude = table_of(results, "attitude");
  const effect_table* momentum = table_of(results, "momentum");
  if (attitude || momentum) add_series(data, what, attitude, momentum);
  const std::string page(page_template);
  const std::string mark = "%DATA%";
  const std::size_t place = page.find(mark);
  return page.substr(0, place) + embedded(data) + page.substr(place + mark.size());
}

namespace {

/// Between single quotes for gnuplot, which reads them as they are, but for a quote (doubled) and
/// the end of a line.
std::string for_gnuplot(const std::string& text) {
  std::string result = "'";
  for (const char c : text) {
    const bool is_control = static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
    result += is_control ? ' ' : c;
    if (c == '\'') result += '\'';
  }
  return result + '\'';
}

/// The columns by what stands before "_" in their names: x, y, z of a vector in one group. The
/// first column is in none.
std::vector<std::pair<std::string, std::vector<std::size_t>>> groups_of(const effect_table& table) {
  std::vector<std::pair<std::string, std::vector<std::size_t>>> groups;
  for (std::size_t k = 1; k < table.columns.size(); ++k) {
    const std::string& column = table.columns[k];
    const std::string name = column.substr(0, column.find('_'));
    if (groups.empty() || groups.back().first != name) groups.push_back({name, {}});
    groups.back().second.push_back(k);
  }
  return groups;
}

/// A column of ranges over all bodies, beside that of the middle values.
bool is_range(const effect_table& table, std::size_t column) {
  return table.columns[column].ends_with("_range");
}

/// A table's numbers as they are drawn, and behind them the ends of each range.
std::vector<std::vector<double>> drawn_rows(const effect_table& table) {
  std::vector<std::vector<double>> rows;
  for (const std::vector<ball>& row : table.rows) {
    std::vector<double> numbers;
    numbers.reserve(row.size());
    for (const ball& x : row) numbers.push_back(drawn(x));
    for (std::size_t k = 0; k < row.size(); ++k) {
      if (!is_range(table, k + 1)) continue;
      const double_interval ends = double_interval::from_ball(row[k]);
      const bool is_bounded = row[k].is_bounded();
      numbers.push_back(is_bounded ? ends.lower() : std::nan(""));
      numbers.push_back(is_bounded ? ends.upper() : std::nan(""));
    }
    rows.push_back(std::move(numbers));
  }
  return rows;
}

}  // namespace

std::string scene_plot(const std::string& title, const effect_table& table,
                       const std::string& format) {
  constexpr long digits = 12;
  constexpr std::size_t panel_height = 320;
  const auto groups = groups_of(table);
  const std::size_t height = std::max<std::size_t>(2, groups.size()) * panel_height;
  std::string program = "set encoding utf8\n";
  if (format == "png") {
    program += fmt::format("set terminal pngcairo size 1000,{} font 'Sans,12'\n", height);
  } else if (format == "pdf") {
    constexpr double points_per_inch = 100;
    program += fmt::format("set terminal pdfcairo size 10in,{:.2f}in font 'Sans,14'\n",
                           static_cast<double>(height) / points_per_inch);
  } else {
    program += fmt::format("set terminal svg size 1000,{} font 'Helvetica,15' background 'white'\n",
                           height);
  }
  program +=
      "set grid lc rgb '#dddddd'\nset key outside top right\nset lmargin 10\nset rmargin 16\n";
  program += "set datafile missing 'nan'\n$data << EOD\n";
  const std::vector<std::vector<double>> rows = drawn_rows(table);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (is_apart(table, i)) program += '\n';
    program += leading_digits_of(table.first[i], digits).value;
    for (const double x : rows[i]) program += fmt::format(" {:.12g}", x);
    program += '\n';
  }
  program += fmt::format("EOD\nset multiplot layout {},1 title {} noenhanced\n", groups.size(),
                         for_gnuplot(title));
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const auto& [name, columns] = groups[g];
    program += fmt::format("set ylabel '{}'\n", axis_label(table, columns.front(), name));
    if (g + 1 == groups.size()) {
      program += fmt::format("set xlabel '{}'\n", axis_label(table, 0, table.columns[0]));
    }
    std::string plots;
    // A mark now and then, of one shape for each curve: colours alone do not tell them apart in
    // print, or for everyone.
    constexpr std::array marks{7, 5, 9, 13};  // disc, square, triangle, diamond
    constexpr std::size_t marks_of_curve = 20;
    const std::size_t interval = std::max<std::size_t>(1, rows.size() / marks_of_curve);
    for (std::size_t i = 0; i < columns.size(); ++i) {
      if (is_range(table, columns[i])) {
        // There is one such column, the last, and its ends follow.
        const std::size_t ends = table.columns.size() + 1;
        plots = fmt::format(
            "plot $data using 1:{}:{} with filledcurves fc rgb '#56b4e9' fs transparent solid 0.4 "
            "title 'all bodies', {}",
            ends, ends + 1, plots.substr(std::string("plot ").size()));
        continue;
      }
      plots += fmt::format("{}$data using 1:{} with linespoints lw 2 pt {} ps 0.8 pi {} title '{}'",
                           plots.empty() ? "plot " : ", ", columns[i] + 1, marks[i % marks.size()],
                           interval, symbol_of(table.columns[columns[i]]));
    }
    program += plots + '\n';
  }
  return run_gnuplot(program + "unset multiplot\n", "leave out --plot");
}

}  // namespace polhode::cli
