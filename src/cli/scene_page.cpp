#include "scene_page.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "exact_decimals.hpp"
#include "gnuplot.hpp"
#include "polhode/arithmetic/boost_bridge.hpp"
#include "polhode/arithmetic/text.hpp"
#include "scene_page_template.hpp"  // made from scene_page.html

namespace polhode::cli {
namespace {

/// Near enough to draw with.
double drawn(const ball& x) { return midpoint(x).convert_to<double>(); }

const effect_table* table_of(const scene_report& results, const std::string& name) {
  const effect_result* found = results.find(name);
  return found && found->table ? &*found->table : nullptr;
}

json columns(const effect_table& table, std::size_t first, std::size_t count) {
  json result = json::array();
  for (const auto& row : table.rows) {
    json one = json::array();
    for (std::size_t k = 0; k < count; ++k) one.push_back(drawn(row[first + k]));
    result.push_back(std::move(one));
  }
  return result;
}

/// The half sides of a box with these moments, the longest 1: side i^2 is as I_j + I_k - I_i. A non-physical body has none: its least
/// side is drawn thin.
std::array<double, 3> half_sides(const scene_body& of) {
  std::array<double, 3> m{};
  for (std::size_t i = 0; i < 3; ++i)
    m[i] = static_cast<double>(rational((*of.moments)[i] / (*of.moments)[0]));
  std::array<double, 3> side{};
  for (std::size_t i = 0; i < 3; ++i)
    side[i] = std::sqrt(std::max(m[(i + 1) % 3] + m[(i + 2) % 3] - m[i], 1e-3));
  const double longest = *std::max_element(side.begin(), side.end());
  for (double& s : side) s = std::max(s / longest, 0.02);
  return side;
}

json axes_of(const scene_body& of) {
  json result = json::array();
  for (const principal_axis& axis : of.axes) {
    const double length = std::sqrt(static_cast<double>(axis.square));
    json one = json::array();
    for (const rational& x : axis.direction) one.push_back(static_cast<double>(x) / length);
    result.push_back(std::move(one));
  }
  return result;
}

/// As it may stand in a script of a page: no "</script>" and no comment can begin in it.
std::string embedded(const json& data) {
  std::string result;
  for (const char c : data.dump()) result += c == '<' ? std::string("\\u003c") : std::string(1, c);
  return result;
}

}  // namespace

std::string scene_page(const scene& what, const scene_report& results, const json& report) {
  json data{{"title", what.title.empty() ? report["file"].get<std::string>() : what.title},
            {"source", what.source},
            {"unit", what.time_unit.name},
            {"report", report}};
  for (auto& [name, effect] : data["report"]["effects"].items()) {
    if (effect.contains("table")) effect["table"] = effect["table"]["rows"].size();
  }
  const effect_table* attitude = table_of(results, "attitude");
  const effect_table* momentum = table_of(results, "momentum");
  if (attitude || momentum) {
    const effect_table& any = attitude ? *attitude : *momentum;
    data["t"] = json::array();
    for (const rational& t : any.first) data["t"].push_back(static_cast<double>(t));
    data["axes"] = axes_of(what.body);
    data["half"] = half_sides(what.body);
    if (attitude) data["q"] = columns(*attitude, 0, 4);
    if (momentum) {
      data["j"] = columns(*momentum, 0, 3);
      data["omega"] = columns(*momentum, 3, 3);
    }
  }
  const std::string page(page_template);
  const std::string mark = "%DATA%";
  const std::size_t place = page.find(mark);
  return page.substr(0, place) + embedded(data) + page.substr(place + mark.size());
}

std::string scene_plot(const std::string& name, const effect_table& table,
                       const std::string& format) {
  constexpr long digits = 12;
  std::string program =
      format == "png" ? "set terminal pngcairo size 900,600 font 'Helvetica,12'\n"
                      : "set terminal svg size 900,600 font 'Helvetica,15' background 'white'\n";
  program += "set grid lc rgb '#dddddd'\nset key outside top right\n";
  program += fmt::format("set title '{}' noenhanced\nset xlabel '{}' noenhanced\n", name,
                         table.columns[0]);
  program += "$data << EOD\n";
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    program += leading_digits_of(table.first[i], digits).value;
    for (const ball& x : table.rows[i]) program += fmt::format(" {:.12g}", drawn(x));
    program += '\n';
  }
  program += "EOD\nplot ";
  for (std::size_t k = 1; k < table.columns.size(); ++k) {
    program += fmt::format("{}$data using 1:{} with lines lw 2 title '{}' noenhanced",
                           k == 1 ? "" : ", ", k + 1, table.columns[k]);
  }
  return run_gnuplot(program + '\n');
}

}  // namespace polhode::cli
