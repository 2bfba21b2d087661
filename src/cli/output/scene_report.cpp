#include "scene_report.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "exact_decimals.hpp"
#include "json_document.hpp"
#include "layout.hpp"
#include "polhode/arithmetic/boost_bridge.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/version.hpp"

namespace polhode::cli {
namespace {

constexpr long digits_of_arguments = 60;

json number_json(const effect_number& n, long digits) {
  json result;
  if (n.exact) {
    constexpr long least = 20;  // a count is whole, whatever the digits of the numbers
    const long shown = std::max(digits, least);
    result = exact_json(*n.exact, shown);
    if (!is_short(*n.exact, shown)) result.erase("rational");  // too long to be written out
  } else {
    result = to_json(n.enclosure, digits);
  }
  if (n.is_range) result["range"] = true;
  if (!n.unit.empty()) result["unit"] = n.unit;
  return result;
}

/// Of a number that is one.
double as_double(const ball& x) { return midpoint(x).convert_to<double>(); }

json table_json(const effect_table& table, table_rows rows) {
  json result{{"columns", table.columns}, {"certified", table.certified}};
  if (rows == table_rows::counted) {
    result["rows"] = table.rows.size();
    return result;
  }
  result["rows"] = json::array();
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    json row{{table.columns[0], number_json({"", {}, table.first[i], ""}, table.digits)}};
    for (std::size_t k = 0; k < table.rows[i].size(); ++k) {
      const ball& x = table.rows[i][k];
      const auto exact = table.exact.find({i, k});
      if (exact != table.exact.end()) {
        row[table.columns[k + 1]] = number_json({"", {}, exact->second, ""}, table.digits);
      } else {
        row[table.columns[k + 1]] = table.certified ? to_json(x, table.digits) : json(as_double(x));
      }
    }
    result["rows"].push_back(std::move(row));
  }
  return result;
}

json effect_json(const effect_result& effect, bool wanted, long digits, table_rows rows) {
  json result{{"wanted", wanted}, {"verdict", to_text(effect.verdict)}};
  if (!effect.why.empty()) result["why"] = effect.why;
  for (const auto& [key, word] : effect.words) result["words"][key] = word;
  for (const effect_number& n : effect.numbers) result["numbers"][n.name] = number_json(n, digits);
  if (effect.table) result["table"] = table_json(*effect.table, rows);
  if (!effect.remarks.empty()) result["remarks"] = effect.remarks;
  result["work"] = {{"integrals", effect.work.integrals},
                    {"agm_steps", effect.work.agm_steps},
                    {"newton_steps", effect.work.newton_steps}};
  return result;
}

json body_json(const scene_body& of, long digits) {
  json result;
  if (!of.name.empty()) result["name"] = of.name;
  if (!of.source.empty()) result["source"] = of.source;
  result["kind"] = to_text(of.kind);
  constexpr const char* names[] = {"x", "y", "z"};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto exact = [&](const rational& q) { return number_json({"", {}, q, ""}, digits); };
    const exact_real& moment = of.moments()[i];
    result["moments"][names[i]] = moment.is_rational()
                                      ? exact(moment.exact())
                                      : to_json(moment.at(bits_for_digits(digits) + 32), digits);
    if (!of.ranges) continue;
    const auto& [value, sigma] = of.uncertainties[i];
    result["ranges"][names[i]] = {{"from", exact(value - sigma)}, {"to", exact(value + sigma)}};
    result["sigma"][names[i]] = exact(sigma);
  }
  if (of.has_unit) {
    const precision p = bits_for_digits(digits) + 64;
    result["unit_in_kg_m2"] =
        of.size.power == 0 ? exact_json(of.size.factor, digits) : to_json(of.size.at(p), digits);
  }
  return result;
}

/// Quoted where it has to be.
std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + '"';
}

std::string text_or_empty(const json& from, const char* key) {
  return from.contains(key) && from[key].is_string() ? from[key].get<std::string>() : "";
}

/// 1.5...e-13.
std::string with_dots(const std::string& value) {
  const auto exponent = std::min(value.find('e'), value.size());
  return value.substr(0, exponent) + "..." + value.substr(exponent);
}

std::string decimals_of(const json& number) {
  if (number.contains("range"))
    return fmt::format("from {} to {}", text_or_empty(number, "lower"),
                       text_or_empty(number, "upper"));
  std::string value = text_or_empty(number, "value");
  if (number.contains("exact")) {
    const std::string quotient = text_or_empty(number, "rational");
    constexpr std::size_t longest = 40;
    if (number.contains("lower") && number["lower"] == number["value"]) return value;
    return (quotient.empty() || quotient.size() > longest ? "" : quotient + " = ") +
           with_dots(value);
  }
  if (number.contains("rounded")) return value + " ± " + text_or_empty(number, "radius");
  return with_dots(value);
}

std::string point_text(const json& report) {
  std::string result;
  if (!report.contains("point")) return result;
  for (const auto& [key, number] : report["point"].items()) {
    const std::string quotient = text_or_empty(number, "rational");
    result += (result.empty() ? "" : "; ") + key + " = " +
              (quotient.empty() ? decimals_of(number) : quotient);
  }
  return result;
}

std::string paragraph(const std::string& text, std::size_t indent) {
  std::string result;
  for (const std::string& line : wrapped(text, terminal_columns - indent))
    result += std::string(indent, ' ') + line + '\n';
  return result;
}

/// In lines of at most the terminal's width, also where there is no space to break at: certain
/// digits are long words.
std::string named_number(const std::string& name, const std::string& digits,
                         const std::string& unit) {
  const bool range = digits.rfind("from ", 0) == 0;
  const std::string line =
      "  " + name + (range ? " " : " = ") + digits + (unit.empty() ? "" : ' ' + unit);
  if (line.size() <= terminal_columns) return line + '\n';
  std::string result = "  " + name + (unit.empty() ? "" : " (" + unit + ")") + " =\n";
  constexpr std::size_t width = terminal_columns - 4;
  for (std::size_t at = 0; at < digits.size(); at += width)
    result += "    " + digits.substr(at, width) + '\n';
  return result;
}

}  // namespace

json scene_json(const scene& what, const scene_report& report, const std::string& file,
                const sweep_point& point, const std::string& digest, table_rows rows) {
  json result = json_document("scene", {{"file", file}});
  if (!what.title.empty()) result["title"] = what.title;
  if (!what.source.empty()) result["source"] = what.source;
  result["verdict"] = to_text(report.verdict);
  result["digits"] = what.digits;
  for (const auto& [key, value] : point)
    result["point"][key] = number_json({"", {}, value, ""}, digits_of_arguments);
  result["body"] = body_json(what.body, what.digits);
  result["effects"] = json::object();
  for (const effect_result& effect : report.effects) {
    const bool wanted =
        std::find(report.wanted.begin(), report.wanted.end(), effect.name) != report.wanted.end();
    result["effects"][effect.name] = effect_json(effect, wanted, what.digits, rows);
  }
  if (!what.remarks.empty()) result["remarks"] = what.remarks;
  result["polhode"] = POLHODE_VERSION;
  result["digest"] = digest;
  return result;
}

std::string scene_text(const json& report) {
  std::string result = report["file"].get<std::string>();
  if (report.contains("title")) result += ": " + text_or_empty(report, "title");
  // Nothing that a terminal would obey.
  std::replace_if(
      result.begin(), result.end(),
      [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }, ' ');
  result = paragraph(result, 0);
  const std::string point = point_text(report);
  if (!point.empty()) result += paragraph("at " + point, 2);
  if (report.contains("remarks")) {
    for (const json& remark : report["remarks"]) result += paragraph(remark.get<std::string>(), 2);
  }
  for (const auto& [name, effect] : report["effects"].items()) {
    if (!effect["wanted"].get<bool>()) continue;
    const bool certified = effect["verdict"] == to_text(status::certified);
    result += name + (certified ? "" : ": not certified") + '\n';
    if (!certified) result += paragraph(text_or_empty(effect, "why"), 2);
    if (effect.contains("words")) {
      for (const auto& [key, word] : effect["words"].items())
        result += paragraph(key + ": " + word.get<std::string>(), 2);
    }
    if (effect.contains("numbers")) {
      for (const auto& [key, number] : effect["numbers"].items()) {
        result += named_number(key, decimals_of(number), text_or_empty(number, "unit"));
      }
    }
    if (effect.contains("table")) {
      const json& rows = effect["table"]["rows"];
      result += paragraph(fmt::format("{} rows of {} (--out DIR, --format json)",
                                      rows.is_array() ? rows.size() : rows.get<std::size_t>(),
                                      effect["table"]["columns"].dump()),
                          2);
    }
    if (effect.contains("remarks")) {
      for (const json& remark : effect["remarks"])
        result += paragraph(remark.get<std::string>(), 2);
    }
  }
  result += "work: integrals, AGM steps, Newton steps\n";
  for (const auto& [name, effect] : report["effects"].items()) {
    const json& work = effect["work"];
    result += fmt::format("  {:<18}{:>6}{:>6}{:>6}{}\n", name, work["integrals"].get<long>(),
                          work["agm_steps"].get<long>(), work["newton_steps"].get<long>(),
                          effect["wanted"].get<bool>() ? "" : "  (needed by another)");
  }
  return result;
}

std::string results_csv(const std::vector<json>& reports) {
  std::vector<std::string> parameters;  // those of the points of a sweep
  for (const json& report : reports) {
    if (!report.contains("point")) continue;
    for (const auto& [key, number] : report["point"].items()) {
      if (std::find(parameters.begin(), parameters.end(), key) == parameters.end())
        parameters.push_back(key);
    }
  }
  std::string result = "scene,";
  for (const std::string& key : parameters)
    result += csv_field(key) + ',' + csv_field(key + "_exact") + ',';
  result += "effect,quantity,unit,value,radius,lower,upper,digits,word,verdict\n";
  for (const json& report : reports) {
    std::string head = csv_field(text_or_empty(report, "file")) + ',';
    for (const std::string& key : parameters) {
      const bool is_given = report.contains("point") && report["point"].contains(key);
      const json number = is_given ? report["point"][key] : json::object();
      head += text_or_empty(number, "value") + ',' + text_or_empty(number, "rational") + ',';
    }
    for (const auto& [name, effect] : report["effects"].items()) {
      if (!effect["wanted"].get<bool>()) continue;
      const std::string verdict = text_or_empty(effect, "verdict");
      if (effect.contains("words")) {
        for (const auto& [key, word] : effect["words"].items()) {
          result += head + fmt::format("{},{},,,,,,,{},{}\n", name, key,
                                       csv_field(word.get<std::string>()), verdict);
        }
      }
      if (!effect.contains("numbers")) continue;
      for (const auto& [key, number] : effect["numbers"].items()) {
        result +=
            head + fmt::format("{},{},{},{},{},{},{},{},,{}\n", name, key,
                               csv_field(text_or_empty(number, "unit")),
                               text_or_empty(number, "value"), text_or_empty(number, "radius"),
                               text_or_empty(number, "lower"), text_or_empty(number, "upper"),
                               number["digits"].is_null() ? 0L : number["digits"].get<long>(),
                               verdict);
      }
    }
  }
  return result;
}

std::string with_unit(const effect_table& table, std::size_t column, const std::string& of_column) {
  const std::string name = table.columns[column] + of_column;
  return column < table.units.size() && !table.units[column].empty()
             ? name + " [" + table.units[column] + ']'
             : name;
}

/// All decimals of a cell that is known exactly, where they end soon; else its enclosure.
decimal_enclosure decimals_of_cell(const effect_table& table, std::size_t row, std::size_t column) {
  const auto exact = table.exact.find({row, column});
  if (exact != table.exact.end()) {
    const leading_digits d =
        leading_digits_of(exact->second, std::max(table.digits, digits_of_arguments));
    if (d.all) return exact_decimals(d);
  }
  return to_decimal_enclosure(table.rows[row][column], table.digits);
}

std::string table_csv(const effect_table& table) {
  // The unit stands with the number; the exact quotient is the same in the same unit.
  std::string result = with_unit(table, 0, "") + ',' + table.columns[0] + "_exact";
  for (std::size_t k = 1; k < table.columns.size(); ++k) {
    result += ',' + with_unit(table, k, "");
    if (table.certified) result += ',' + table.columns[k] + "_lower," + table.columns[k] + "_upper";
  }
  result += '\n';
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    result += csv_cells(table.first[i]);
    for (std::size_t k = 0; k < table.rows[i].size(); ++k) {
      const ball& x = table.rows[i][k];
      if (!table.certified) {
        result += fmt::format(",{}", as_double(x));
        continue;
      }
      if (!x.is_bounded()) {
        result += ",,,";
        continue;
      }
      const decimal_enclosure d = decimals_of_cell(table, i, k);
      result += fmt::format(",{},{},{}", d.value, d.lower, d.upper);
    }
    result += '\n';
  }
  return result;
}

}  // namespace polhode::cli
