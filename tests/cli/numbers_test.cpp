// Every number that a command prints is one: a decimal, with an error that holds.

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/program.hpp"
#include "polhode/arithmetic/exact.hpp"

namespace polhode::test {
namespace numbers_test {

using nlohmann::json;

struct checked {
  long numbers = 0;
  long rounded = 0;
};

void check_number(const json& number, const std::string& where, checked& all) {
  SCOPED_TRACE(where + ": " + number.dump());
  ++all.numbers;
  const auto text = [&](const char* key) { return number.at(key).get<std::string>(); };
  ASSERT_TRUE(number.at("value").is_string());
  ASSERT_FALSE(text("value").empty());
  if (text("value") == "inf") return;
  const rational value = parse_rational(text("value"));
  const rational radius = parse_rational(text("radius"));
  const rational lower = parse_rational(text("lower"));
  const rational upper = parse_rational(text("upper"));
  EXPECT_GE(radius, 0);
  EXPECT_LE(lower, upper);
  if (number.contains("range")) return;  // of many bodies: two ends
  EXPECT_LE(rational(value - radius), lower);
  EXPECT_GE(rational(value + radius), upper);
  if (number.contains("rational")) {
    const rational exact = parse_rational(text("rational"));
    EXPECT_LE(lower, exact);
    EXPECT_GE(upper, exact);
  }
  all.rounded += number.contains("rounded") ? 1 : 0;
}

/// All objects in it that are numbers of a result.
void check_numbers(const json& x, const std::string& where, checked& all) {
  if (x.is_object()) {
    const bool is_number = x.contains("lower") && x.contains("upper") && x.contains("value");
    if (is_number && !x.contains("dyadic") && !x["lower"].is_null()) check_number(x, where, all);
    for (const auto& [key, value] : x.items()) check_numbers(value, where + '/' + key, all);
  } else if (x.is_array()) {
    for (std::size_t i = 0; i < x.size(); ++i)
      check_numbers(x[i], where + '/' + std::to_string(i), all);
  }
}

TEST(Numbers, EveryJsonNumberIsWithinItsRadius) {
  const std::vector<std::vector<std::string>> commands{
      {"constants", "--digits", "40"},
      {"eval", "exp(pi*sqrt(163))", "--digits", "60"},
      {"eval", "10^20*atan(1)-10^20*pi/4+1/3"},
      {"eval", "1/3"},
      {"integrate", "x", "--from", "0", "--to", "1"},
      {"integrate", "-2*x*exp(-x^2)", "--from", "0", "--to", "inf"},
      {"integrate", "exp(cos(x))-exp(-cos(x))", "--from", "0", "--to", "pi", "--digits", "12"},
      {"integrate", "2*x^3*exp(-x^2)", "--from", "0", "--to", "inf"},
      {"integrate", "abs(x-1/3)^(1/2)", "--from", "0", "--to", "1", "--digits", "20"},
      {"integrate", "1/x", "--circle", "0, 1"},
      {"roots", "x^3-2*x", "--in", "-2..2"},
      {"roots", "sin(x)", "--in", "-10..10", "--digits", "5"},
      {"body", "--moments", "3,2,1"},
      {"body", "--ab", "12.65,0.0629", "--digits", "1"},
      {"phase", "--ab", "12.65,0.0629", "--c", "-0.03", "--parts", "--excess"},
      {"phase", "--moments", "3,2,1", "--c", "1/2", "--digits", "100"},
      {"racket", "--ab", "12.65,0.0629"},
      {"curve", "--ab", "12.65,0.0629", "--points", "9"},
      {"table", "phase", "--ab", "12.65,0.0629", "--c", "-0.02..0.02/4"},
  };
  checked all;
  for (std::vector<std::string> command : commands) {
    command.insert(command.end(), {"--format", "json"});
    std::string where;
    for (const std::string& word : command) where += word + ' ';
    const outcome ran = run(command);
    ASSERT_EQ(ran.status, 0) << where << ran.err;
    const long before = all.numbers;
    check_numbers(json::parse(ran.out), where, all);
    EXPECT_GT(all.numbers, before) << where;
  }
  EXPECT_GE(all.rounded, 4) << "the case that this test is about";
}

std::vector<std::string> shipped_scenes() {
  std::vector<std::string> scenes;
  for (const auto& entry : std::filesystem::directory_iterator(POLHODE_SCENES_DIR)) {
    if (entry.path().extension() == ".toml") scenes.push_back(entry.path().string());
  }
  std::sort(scenes.begin(), scenes.end());
  return scenes;
}

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') quoted = !quoted;
    if (c == ',' && !quoted) {
      cells.emplace_back();
    } else {
      cells.back() += c;
    }
  }
  return cells;
}

/// Words, and exact quotients; the other columns are numbers.
bool is_of_words(const std::string& column) {
  static const std::set<std::string> words{"scene",   "effect",    "quantity",  "unit",   "word",
                                           "verdict", "name",      "exact",     "remark", "curve",
                                           "method",  "certified", "has_digits"};
  return column.ends_with("_exact") || words.count(column) != 0;
}

/// Every cell of every column but those of words is a decimal, inf, or empty, where the line says
/// why.
void check_csv(const std::string& text, const std::string& where) {
  SCOPED_TRACE(where);
  static const std::regex decimal("-?[0-9]+(\\.[0-9]+)?(e[-+]?[0-9]+)?|inf|-inf");
  const std::vector<std::string> lines = lines_of(text);
  ASSERT_GE(lines.size(), 2U);
  const std::vector<std::string> header = cells_of(lines.front());
  std::set<std::string> names(header.begin(), header.end());
  EXPECT_EQ(names.size(), header.size()) << "a column is twice in " << lines.front();
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const std::vector<std::string> cells = cells_of(lines[i]);
    ASSERT_EQ(cells.size(), header.size()) << lines[i];
    bool has_words = false;
    for (std::size_t k = 0; k < cells.size(); ++k) {
      const bool explains = header[k] == "remark" || header[k] == "word";
      has_words = has_words || (explains && cells[k].size() > (cells[k].starts_with('"') ? 2 : 0));
    }
    for (std::size_t k = 0; k < cells.size(); ++k) {
      if (is_of_words(header[k])) continue;
      // A parameter of another scene's sweep.
      const bool is_parameter = k + 1 < header.size() && header[k + 1] == header[k] + "_exact" &&
                                header[k].find('.') != std::string::npos;
      if (cells[k].empty()) {
        ASSERT_TRUE(has_words || is_parameter)
            << header[k] << " is empty in line " << i + 1 << " without a reason: " << lines[i];
      } else {
        ASSERT_TRUE(std::regex_match(cells[k], decimal))
            << header[k] << " is " << cells[k] << " in line " << i + 1;
      }
    }
  }
}

/// Two ends that enclose a value: wherever a CSV has all three, by name.
void check_values(const std::string& text, const std::string& where) {
  SCOPED_TRACE(where);
  const std::vector<std::string> lines = lines_of(text);
  const std::vector<std::string> header = cells_of(lines.front());
  const auto column = [&](const std::string& name) {
    return static_cast<std::size_t>(std::find(header.begin(), header.end(), name) - header.begin());
  };
  for (std::size_t k = 0; k < header.size(); ++k) {
    const std::string name = header[k].substr(0, header[k].find(" ["));
    const std::size_t lower = column(name + "_lower");
    const std::size_t upper = column(name + "_upper");
    if (lower == header.size() || upper == header.size()) continue;
    for (std::size_t i = 1; i < lines.size(); ++i) {
      const std::vector<std::string> cells = cells_of(lines[i]);
      if (cells[lower].empty()) continue;
      const rational value = parse_rational(cells[k]);
      const rational width = parse_rational(cells[upper]) - parse_rational(cells[lower]);
      // A value cut off is off by less than a unit of its last digit.
      const auto e = cells[k].find('e');
      const auto point = cells[k].find('.');
      const std::size_t places =
          point == std::string::npos ? 0 : std::min(e, cells[k].size()) - point - 1;
      const rational unit = parse_rational(
          (e == std::string::npos ? "1e" : "1" + cells[k].substr(e) + "/1e") +
          (e == std::string::npos ? "-" + std::to_string(places) : std::to_string(places)));
      const rational off = abs(rational(value - parse_rational(cells[lower])));
      ASSERT_LE(off, rational(width + unit)) << name << " in line " << i + 1 << ": " << cells[k];
    }
  }
}

TEST(Numbers, EveryCellOfACsvIsADecimal) {
  const std::vector<std::vector<std::string>> commands{
      {"constants", "--format", "csv"},
      {"roots", "(x^2-2)*(x-1/3)", "--in", "-2..2", "--format", "csv"},
      {"curve", "--ab", "12.65,0.0629", "--points", "12"},
      {"curve", "--moments", "1/3,2/7,1/9", "--points", "7"},
      {"table", "phase", "--ab", "12.65,0.0629", "--c", "-0.02..0.02/4"},
      {"table", "epsilon0", "--ab", "9/7,1/3"},
      {"curve", "--moments", "3,2,1", "--c", "0.1..0.2", "--points", "3"},
      {"roots", "(x-1/3)*sin(x)/x", "-4..4", "--format", "csv"},
      {"cost", "beta", "--max-digits", "16", "--format", "csv"},
      {"scene", std::string(POLHODE_SCENES_DIR) + "/t_handle.toml", "--format", "csv"},
  };
  for (const std::vector<std::string>& command : commands) {
    const outcome ran = run(command);
    ASSERT_LE(ran.status, 1) << command.front() << ": " << ran.err;
    check_csv(ran.out, command.front());
  }
}

// ---------------------------------------------------------------------------------------------
// Other programs

/// A CSV of each command that writes one, with default options but for what keeps it short; by
/// their names in the directory.
std::vector<std::string> write_all_csvs(const scratch_directory& directory) {
  const outcome made = run_script(
      "polhode constants --format csv > constants.csv;"
      "polhode roots '(x^2-2)*(x-1/3)' -2..2 --format csv > roots.csv;"
      "polhode curve --ab 12.65,0.0629 --points 12 > curve.csv;"
      "polhode table phase --ab 12.65,0.0629 --c -0.02..0.02/4 > table.csv;"
      "polhode cost beta --max-digits 16 --format csv > cost.csv;"
      "polhode figures --data-only > /dev/null && mv figures/*.csv .;"
      "polhode scene \"" POLHODE_SCENES_DIR "\"/*.toml --out scenes > /dev/null; mv scenes/*.csv .",
      directory.path(""));
  EXPECT_EQ(made.err, "");
  std::vector<std::string> names;
  for (const std::string& name : names_in(directory.path(""))) {
    if (name.ends_with(".csv")) names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  EXPECT_GE(names.size(), 25U);
  return names;
}

struct numeric_column {
  std::size_t place = 0;  // from 1
  std::string name;
  std::vector<double> finite;
  std::size_t infinite = 0;
};

std::vector<numeric_column> numeric_columns(const std::string& text) {
  const std::vector<std::string> lines = lines_of(text);
  const std::vector<std::string> header = cells_of(lines.front());
  std::vector<numeric_column> result;
  for (std::size_t k = 0; k < header.size(); ++k) {
    if (is_of_words(header[k])) continue;
    numeric_column one{k + 1, header[k], {}, 0};
    for (std::size_t i = 1; i < lines.size(); ++i) {
      const std::string cell = cells_of(lines[i])[k];
      if (cell.find("inf") != std::string::npos) {
        ++one.infinite;
      } else if (!cell.empty()) {
        one.finite.push_back(std::strtod(cell.c_str(), nullptr));
      }
    }
    result.push_back(std::move(one));
  }
  return result;
}

/// gnuplot finds as many numbers in each column, with the same ends.
TEST(Numbers, GnuplotReadsEveryCsv) {
  if (run_script("command -v gnuplot >&2").status != 0) GTEST_SKIP() << "no gnuplot";
  const scratch_directory directory;
  for (const std::string& name : write_all_csvs(directory)) {
    SCOPED_TRACE(name);
    const auto columns = numeric_columns(contents(directory.path(name)));
    std::string program = "set datafile separator ','\nset print '-'\n";
    for (const numeric_column& one : columns) {
      if (one.finite.empty()) continue;
      program += "stats '" + name + "' using " + std::to_string(one.place) +
                 " skip 1 nooutput\nprint sprintf('%d %.15g %.15g', STATS_records, STATS_min, "
                 "STATS_max)\n";
    }
    std::ofstream(directory.path("program")) << program;
    const outcome shown = run_script("gnuplot program", directory.path(""));
    ASSERT_EQ(shown.status, 0) << shown.err;
    const std::vector<std::string> lines = lines_of(shown.out);
    std::size_t line = 0;
    for (const numeric_column& one : columns) {
      if (one.finite.empty()) continue;
      SCOPED_TRACE(one.name);
      ASSERT_LT(line, lines.size());
      std::istringstream words(lines[line++]);
      std::size_t records = 0;
      std::string least;
      std::string greatest;
      words >> records >> least >> greatest;
      EXPECT_EQ(records, one.finite.size() + one.infinite);
      const auto [low, high] = std::minmax_element(one.finite.begin(), one.finite.end());
      EXPECT_NEAR(std::strtod(least.c_str(), nullptr), *low, 1e-13 * std::abs(*low));
      if (one.infinite > 0) {
        EXPECT_EQ(greatest, "inf");
      } else {
        EXPECT_NEAR(std::strtod(greatest.c_str(), nullptr), *high, 1e-13 * std::abs(*high));
      }
    }
  }
}

/// Has Python check every CSV: check(name, columns) is called with the place of each column of
/// numbers, its name and how many it has.
void expect_python_reads_every_csv(std::string program) {
  const scratch_directory directory;
  for (const std::string& name : write_all_csvs(directory)) {
    program += "check('" + name + "', [";
    for (const numeric_column& one : numeric_columns(contents(directory.path(name)))) {
      program += "(" + std::to_string(one.place) + ", '" + one.name + "', " +
                 std::to_string(one.finite.size() + one.infinite) + "), ";
    }
    program += "])\n";
  }
  std::ofstream(directory.path("read.py")) << program;
  const outcome read = run_script("python3 read.py", directory.path(""));
  EXPECT_EQ(read.status, 0) << read.err;
}

TEST(Numbers, PythonReadsEveryCsv) {
  if (run_script("command -v python3 >&2").status != 0) GTEST_SKIP() << "no python3";
  expect_python_reads_every_csv(R"(
import csv
def check(name, columns):
    with open(name, newline='') as file:
        rows = list(csv.reader(file, strict=True))
    for place, heading, count in columns:
        assert rows[0][place - 1] == heading, (name, place, rows[0])
        numbers = [float(row[place - 1]) for row in rows[1:] if row[place - 1] != '']
        assert len(numbers) == count, (name, place, len(numbers), count)
)");
}

/// pandas, with its default options, finds the columns by their names, each of numbers with the
/// type of numbers and no number lost.
TEST(Numbers, PandasReadsEveryCsv) {
  if (run_script("python3 -c 'import pandas'").status != 0) {
    GTEST_SKIP() << "no pandas (Debian's package python3-pandas)";
  }
  expect_python_reads_every_csv(R"(
import pandas
def check(name, columns):
    table = pandas.read_csv(name)
    assert not isinstance(table.index, pandas.MultiIndex) and table.index.equals(pandas.RangeIndex(len(table))), name
    for place, heading, count in columns:
        assert table.columns[place - 1] == heading, (name, table.columns)
        column = table[heading]
        assert count == 0 or pandas.api.types.is_numeric_dtype(column), (name, column)
        assert column.count() == count, (name, column)
)");
}

TEST(Numbers, TheTablesOfTheShippedScenes) {
  long tables = 0;
  for (const std::string& scene : shipped_scenes()) {
    const scratch_directory scratch;
    const outcome ran = run({"scene", scene, "--out", scratch.path("out")});
    ASSERT_LE(ran.status, 1) << scene << ": " << ran.err;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(scratch.path("out"))) {
      if (entry.path().extension() != ".csv") continue;
      const std::string text = contents(entry.path().string());
      const std::string where = scene + ": " + entry.path().filename().string();
      check_csv(text, where);
      check_values(text, where);
      ++tables;
    }
  }
  EXPECT_GE(tables, 5);
}

TEST(Numbers, TwelveIsWrittenAsTwelve) {
  const scratch_directory scratch;
  const outcome ran = run({"scene", std::string(POLHODE_SCENES_DIR) + "/book.toml", "--out",
                           scratch.path("out"), "--format", "json"});
  ASSERT_EQ(ran.status, 0) << ran.err;
  long twelves = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(scratch.path("out"))) {
    if (entry.path().extension() != ".csv") continue;
    const std::vector<std::string> lines = lines_of(contents(entry.path().string()));
    if (lines.front().find("omega_1") == std::string::npos) continue;
    const std::vector<std::string> header = cells_of(lines.front());
    for (std::size_t k = 0; k < header.size(); ++k) {
      if (header[k].rfind("omega_1 [", 0) == 0 && cells_of(lines[1])[k] == "12") ++twelves;
    }
  }
  EXPECT_EQ(twelves, 1);
}

/// The signs of the quaternions of a series do not jump.
TEST(Numbers, QuaternionsAreContinuousInSign) {
  const scratch_directory scratch;
  const outcome ran = run(
      {"scene", std::string(POLHODE_SCENES_DIR) + "/t_handle.toml", "--out", scratch.path("out")});
  ASSERT_EQ(ran.status, 0) << ran.err;
  long series = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(scratch.path("out"))) {
    if (entry.path().extension() != ".csv") continue;
    const std::vector<std::string> lines = lines_of(contents(entry.path().string()));
    const std::vector<std::string> header = cells_of(lines.front());
    const auto first = std::find(header.begin(), header.end(), "q_w");
    if (first == header.end()) continue;
    ++series;
    std::vector<double> before;
    for (std::size_t i = 1; i < lines.size(); ++i) {
      const std::vector<std::string> cells = cells_of(lines[i]);
      std::vector<double> q;
      for (const char* name : {"q_w", "q_x", "q_y", "q_z"}) {
        const auto at = std::find(header.begin(), header.end(), name) - header.begin();
        q.push_back(std::stod(cells[static_cast<std::size_t>(at)]));
      }
      double product = 0;
      for (std::size_t k = 0; k < before.size(); ++k) product += before[k] * q[k];
      ASSERT_TRUE(before.empty() || product > 0) << "row " << i;
      before = std::move(q);
    }
  }
  EXPECT_EQ(series, 2);  // a sweep of two points
}

}  // namespace numbers_test
}  // namespace polhode::test
