// Every number that a command prints is one: a decimal, with an error that holds.

#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/program.hpp"
#include "polhode/arithmetic/exact.hpp"

namespace polhode::test {
namespace {

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
      {"integrate", "sin(x)", "--from", "0", "--to", "pi"},
      {"integrate", "cos(x)", "--from", "0", "--to", "pi", "--digits", "12"},
      {"integrate", "exp(-x)", "--from", "0", "--to", "inf"},
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

/// Every cell of every column but those of words and of exact quotients is a decimal, inf, or empty.
void check_csv(const std::string& text, const std::string& where) {
  SCOPED_TRACE(where);
  static const std::set<std::string> words{"scene",   "effect", "quantity", "unit",  "word",
                                           "verdict", "name",   "exact",    "remark"};
  static const std::regex decimal("-?[0-9]+(\\.[0-9]+)?(e-?[0-9]+)?|inf|-inf|");
  const std::vector<std::string> lines = lines_of(text);
  ASSERT_GE(lines.size(), 2U);
  const std::vector<std::string> header = cells_of(lines.front());
  std::set<std::string> names(header.begin(), header.end());
  EXPECT_EQ(names.size(), header.size()) << "a column is twice in " << lines.front();
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const std::vector<std::string> cells = cells_of(lines[i]);
    ASSERT_EQ(cells.size(), header.size()) << lines[i];
    for (std::size_t k = 0; k < cells.size(); ++k) {
      const bool is_exact =
          header[k].size() > 6 && header[k].substr(header[k].size() - 6) == "_exact";
      if (is_exact || words.count(header[k]) != 0) continue;
      ASSERT_TRUE(std::regex_match(cells[k], decimal))
          << header[k] << " is " << cells[k] << " in line " << i + 1;
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
  };
  for (const std::vector<std::string>& command : commands) {
    const outcome ran = run(command);
    ASSERT_EQ(ran.status, 0) << command.front() << ": " << ran.err;
    check_csv(ran.out, command.front());
  }
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
  EXPECT_EQ(series, 1);
}

}  // namespace
}  // namespace polhode::test
