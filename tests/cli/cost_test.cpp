// polhode cost: what it measures, its files, refusals. No test depends on how long anything takes.

#include <algorithm>
#include <filesystem>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "program.hpp"
#include "refusal.hpp"
#include "support/scratch_directory.hpp"

namespace polhode::test {
namespace cost_test {

TEST(CostCommand, ListsQuantitiesWithTheirMethods) {
  const outcome result = run({"cost", "--list"});
  EXPECT_EQ(result.status, 0);
  for (const char* word : {"beta", "half_phase", "boost tanh-sinh", "agm-bartky, certified"}) {
    EXPECT_NE(result.out.find(word), std::string::npos) << word;
  }
}

TEST(CostCommand, MeasuresEveryMethodThatIsQuickEnough) {
  const outcome result =
      run({"cost", "epsilon0_min", "--max-digits", "50", "--seconds", "1000", "--format", "json"});
  ASSERT_EQ(result.status, 0) << result.err;
  const auto report = nlohmann::json::parse(result.out);
  ASSERT_EQ(report["quantities"].size(), 1U);
  const auto& methods = report["quantities"][0]["methods"];
  ASSERT_EQ(methods.size(), 3U);
  EXPECT_TRUE(methods[0]["certified"]);
  EXPECT_EQ(methods[0]["points"].size(), 3U);  // 16, 30, 50
  EXPECT_EQ(methods[2]["points"].size(), 1U);  // double has 16 digits
  for (const auto& point : methods[0]["points"]) {
    EXPECT_TRUE(point["has_digits"]);
    EXPECT_GT(point["seconds"], 0);
    EXPECT_GT(point["cold_seconds"], 0);
    EXPECT_LE(point["log10_error"].get<double>(), -point["digits"].get<double>());
  }
  // pi - 2 arctan(e^pi) as written cancels: in double a digit or two are gone.
  EXPECT_FALSE(methods[2]["points"][0]["has_digits"]);
  EXPECT_TRUE(report["hard"].empty());
}

/// So little time that nothing but the first point of each method is measured, whatever the
/// machine.
TEST(CostCommand, NamesWhatWasLeftOutForWantOfTime) {
  const std::vector<std::string> command{"cost", "beta", "--max-digits", "50", "--seconds", "1e-9"};
  const outcome text = run(command);
  ASSERT_EQ(text.status, 0) << text.err;
  EXPECT_NE(text.out.find("Left out for want of time (--seconds): "), std::string::npos)
      << text.out;
  EXPECT_NE(text.out.find("from 30 digits on"), std::string::npos) << text.out;

  std::vector<std::string> as = command;
  as.insert(as.end(), {"--format", "json"});
  const outcome json = run(as);
  ASSERT_EQ(json.status, 0) << json.err;
  const auto methods = nlohmann::json::parse(json.out)["quantities"][0]["methods"];
  EXPECT_EQ(methods[0]["points"].size(), 1U);
  EXPECT_EQ(methods[0]["left_out"], (std::vector<long>{30, 50}));
  EXPECT_TRUE(methods.back()["left_out"].empty());  // double has no more than 16 digits

  as.back() = "csv";
  const outcome csv = run(as);
  ASSERT_EQ(csv.status, 0) << csv.err;
  std::istringstream lines(csv.out);
  std::string line;
  std::getline(lines, line);
  const auto commas = [](const std::string& row) {  // outside of quotes
    bool quoted = false;
    return std::count_if(row.begin(), row.end(), [&](char c) {
      if (c == '"') quoted = !quoted;
      return c == ',' && !quoted;
    });
  };
  const auto columns = commas(line);
  int left_out = 0;
  while (std::getline(lines, line)) {
    if (line.find("left out for want of time") == std::string::npos) continue;
    ++left_out;
    EXPECT_EQ(commas(line), columns) << line;
  }
  EXPECT_EQ(left_out, 4);  // two methods, each to 30 and 50 digits
}

TEST(CostCommand, WritesTheFilesTogether) {
  const support::scratch_directory scratch;
  const std::string directory = scratch.path("costs");
  const outcome result = run({"cost", "beta", "--max-digits", "30", "--seconds", "100000", "--out",
                              directory, "--data-only", "--format", "csv"});
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_TRUE(std::filesystem::exists(directory + "/cost.csv"));
  EXPECT_TRUE(std::filesystem::exists(directory + "/cost.json"));
  std::istringstream lines(result.out);
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line.rfind("quantity,method,certified,k,digits,seconds", 0), 0U);
  int rows = 0;
  while (std::getline(lines, line)) ++rows;
  EXPECT_EQ(rows, 5);  // two methods to 16 and 30 digits, double to 16
}

TEST(CostCommand, SaysWhereAnEstimateIsBeyondWhatIsMeasured) {
  const outcome result = run({"cost", "beta", "c0", "--estimate", "50000"});
  ASSERT_EQ(result.status, 0) << result.err;
  std::istringstream lines(result.out);
  std::string line;
  std::getline(lines, line);
  EXPECT_NE(line.find("50000 digits by interval newton: about "), std::string::npos) << line;
  EXPECT_EQ(line.find("at most"), std::string::npos) << line;
  std::getline(lines, line);
  EXPECT_NE(line.find("to 30000 at most"), std::string::npos) << line;
}

TEST(CostCommand, Refusals) {
  expect_refused({"cost", "bta"}, {"beta"});
  expect_refused({"cost", "--max-digits", "3"}, {"from 16"});
  expect_refused({"cost", "--seconds", "0"}, {"above 0"});
  expect_refused({"cost", "--seconds", "x"}, {"above 0"});
  expect_refused({"cost", "--data-only"}, {"--out"});
  expect_refused({"cost", "--estimate", "-1"}, {"from 0"});
  expect_refused({"cost", "beta", "--estimate", "100", "--format", "json"}, {"--format"});
  expect_refused({"cost", "--list", "--out", "x"}, {"--out"});
}

}  // namespace cost_test
}  // namespace polhode::test
