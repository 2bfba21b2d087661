// --time-limit and the time that is left. No test depends on how long anything takes: limits are
// far above or far below.

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "program.hpp"
#include "refusal.hpp"

namespace polhode::test {
namespace time_limit_test {

TEST(TimeLimit, IsRead) {
  for (const char* bad : {"x", "0", "-1", "inf", "", "90", "0s", "-1h", "s", "1w", "10 minutes"}) {
    expect_refused({"constants", "--time-limit", bad}, {"--time-limit", "90s, 10m, 2h or 1d"});
    expect_refused({"eval", "1/3", "--time-limit", bad}, {"--time-limit"});
    expect_refused({"roots", "x", "--in", "1..2", "--time-limit", bad}, {"--time-limit"});
    expect_refused({"integrate", "x", "--from", "0", "--to", "1", "--time-limit", bad},
                   {"--time-limit"});
    expect_refused({"scene", POLHODE_SCENES_DIR "/book.toml", "--time-limit", bad},
                   {"--time-limit"});
    expect_refused({"figures", "limit", "--time-limit", bad}, {"--time-limit"});
    expect_refused({"cost", "beta", "--time-limit", bad}, {"--time-limit"});
  }
}

TEST(TimeLimit, RefusesWhatIsEstimatedToTakeLonger) {
  // 86 ns
  const std::vector<std::string> limit{"--digits", "5000", "--time-limit", "1e-12d"};
  const std::vector<std::vector<std::string>> commands{
      {"constants", "beta"},
      {"certify", "epsilon0_min"},
      {"phase", "--ab", "12.65,0.0629", "--c", "0.01"},
      {"racket", "--ab", "12.65,0.0629"},
      {"curve", "--ab", "12.65,0.0629", "--points", "3"},
      {"table", "phase", "--ab", "12.65,0.0629", "--c", "0.01..0.02/3"},
      {"eval", "exp(sqrt(2))"},
      {"integrate", "exp(x)", "--from", "0", "--to", "1"}};
  for (std::vector<std::string> command : commands) {
    command.insert(command.end(), limit.begin(), limit.end());
    expect_refused(command, {"5000 digits", "estimated to take", "--time-limit raises it"});
  }
}

TEST(TimeLimit, RefusesScenesAndFigures) {
  const scratch_directory scratch;
  const std::string directory = scratch.path("out");
  expect_refused({"figures", "limit", "--data-only", "--digits", "5000", "--time-limit", "1e-12d",
                  "--out", directory},
                 {"5000 digits", "1 figure", "estimated to take", "--time-limit raises it"});
  const std::string file = scratch.path("s.toml");
  std::ofstream(file) << "digits = 5000\n[body]\nmoments = [3, 2, 1]\n[state]\nc = 0.1\n"
                         "[effects]\nwant = [\"period\"]\n";
  const outcome result = run({"scene", file, "--time-limit", "1e-12d"});
  // The limit may be reached before the estimate is made.
  EXPECT_TRUE(result.status == 1 || result.status == 2) << result.err;
  EXPECT_EQ(result.out, "");
  EXPECT_NE(result.err.find("--time-limit raises it"), std::string::npos) << result.err;
  EXPECT_FALSE(std::filesystem::exists(directory));
}

/// Measuring all quantities, and a scene of so many digits, take longer than this in any case.
TEST(TimeLimit, EndsScenesAndMeasurements) {
  const scratch_directory scratch;
  const std::string directory = scratch.path("out");
  const std::string file = scratch.path("s.toml");
  std::ofstream(file) << "digits = 2900\n[body]\nmoments = [3, 2, 1]\n[state]\n"
                         "omega = [0.1, 9, 0.2]\nunit = \"rad/s\"\n[time]\nto = 5\n"
                         "samples = 100000\n[effects]\nwant = [\"momentum\"]\n";
  for (const std::vector<std::string>& command :
       std::vector<std::vector<std::string>>{{"cost"}, {"scene", file, "--memory-limit", "100"}}) {
    std::vector<std::string> limited = command;
    limited.insert(limited.end(), {"--out", directory, "--time-limit", "0.01s"});
    const outcome result = run(limited);
    EXPECT_EQ(result.status, 1) << result.err;
    EXPECT_EQ(result.out, "");
    EXPECT_NE(result.err.find("the time limit of 0.01 s was reached"), std::string::npos)
        << result.err;
    EXPECT_TRUE(!std::filesystem::exists(directory) || names_in(directory).empty());
  }
}

/// What the search for roots takes is not estimated: it may end before the digits of what it finds
/// are, or after.
TEST(TimeLimit, EndsRootsInTheSearchOrRefusesTheirDigits) {
  const outcome result =
      run({"roots", "cos(x) - x", "--in", "0..1", "--digits", "5000", "--time-limit", "1e-12d"});
  const bool is_refused = result.status == 2 && result.err.find(
                                                    "5000 digits of 1 root are "
                                                    "estimated to take") != std::string::npos;
  const bool has_ended =
      result.status == 1 &&
      (result.err.find("was reached while looking for roots") != std::string::npos ||
       result.out.find("not certified: ") != std::string::npos);
  EXPECT_TRUE(is_refused || has_ended) << result.status << ": " << result.err << result.out;
}

TEST(TimeLimit, LetsFewDigitsAndShortWorkPass) {
  EXPECT_EQ(run({"constants", "beta", "--digits", "2999", "--time-limit", "1d"}).status, 0);
  EXPECT_EQ(run({"phase", "--ab", "12.65,0.0629", "--c", "0.01", "--digits", "5000"}).status, 0);
}

TEST(TimeLimit, LeavesNoFileBehind) {
  const scratch_directory scratch;
  const std::string directory = scratch.path("certificates");
  expect_refused(
      {"certify", "beta", "--digits", "5000", "--time-limit", "1e-12d", "--out", directory},
      {"--time-limit"});
  EXPECT_FALSE(std::filesystem::exists(directory));
}

/// What has not ended in time ends with one line, and nothing on standard output. None of these
/// ends by itself nearly so soon.
TEST(TimeLimit, EndsWhatTakesLonger) {
  for (const std::vector<std::string>& command : std::vector<std::vector<std::string>>{
           {"integrate", "sin(x^2+sin(x))", "0", "1e6", "--format", "json"},
           {"integrate", "cos(1e30*sqrt(2)*x+sin(x))", "0", "1"}}) {
    std::vector<std::string> limited = command;
    limited.insert(limited.end(), {"--time-limit", "1s"});
    const outcome result = run(limited);
    EXPECT_EQ(result.status, 1) << command[1];
    EXPECT_EQ(result.out, "") << command[1];
    EXPECT_EQ(result.err,
              "polhode: not certified: the time limit of 1 s was reached while integrating "
              "(--time-limit raises it, as in --time-limit 2h)\n");
  }
}

TEST(TimeLimit, LeavesNoTemporaryFileBehind) {
  const scratch_directory scratch;
  const outcome result = run({"integrate", "sin(x^2+sin(x))", "0", "1e6", "--certificate",
                              scratch.path("c.json"), "--time-limit", "0.5s"});
  EXPECT_EQ(result.status, 1);
  EXPECT_TRUE(names_in(scratch.path("")).empty());
}

/// The search for roots stops, and says what it has found.
TEST(TimeLimit, EndsASearchWithWhatItFound) {
  const outcome result = run({"roots", "sin(exp(x))", "0", "40", "--time-limit", "1s"});
  EXPECT_EQ(result.status, 1);
  EXPECT_NE(result.out.find("not certified: "), std::string::npos) << result.err;
}

TEST(Progress, IsWrittenIntoLogs) {
  const outcome result = run_script(
      "POLHODE_PROGRESS_SECONDS=0.2 polhode integrate 'sin(x^2+sin(x))' 0 1e6 --time-limit 1s");
  EXPECT_EQ(result.status, 1);
  const std::vector<std::string> lines = lines_of(result.err);
  ASSERT_GE(lines.size(), 2U) << result.err;
  EXPECT_EQ(lines.front().rfind("polhode: integrating", 0), 0U) << lines.front();
  EXPECT_NE(lines.front().find(" so far"), std::string::npos) << lines.front();
  EXPECT_EQ(result.err.find('\x1b'), std::string::npos);
}

// On a terminal, which script makes.
TEST(TimeLeft, IsShownOnTerminals) {
  const outcome result = run_script(
      "command -v script >/dev/null || exit 77; TERM=xterm script --quiet --return --command "
      "'polhode constants beta --digits 1000000 2>&1 >/dev/null' /dev/null");
  if (result.status == 77) GTEST_SKIP() << "there is no script";
  ASSERT_EQ(result.status, 0) << result.out << result.err;
  EXPECT_NE(result.out.find("computing beta (1/1), about "), std::string::npos) << result.out;
  EXPECT_NE(result.out.find(" left..."), std::string::npos) << result.out;
}

TEST(Table, IsTheSameOnAnyNumberOfThreads) {
  const auto table = [](const char* threads) {
    return run({"table", "phase", "--ab", "12.65,0.0629", "--c", "0.01..0.02/99", "--digits", "20",
                "--threads", threads});
  };
  const outcome one = table("1");
  ASSERT_EQ(one.status, 0) << one.err;
  EXPECT_EQ(lines_of(one.out).size(), 101U);
  EXPECT_EQ(table("2").out, one.out);
  EXPECT_EQ(table("0").out, one.out);
  expect_refused({"table", "c0", "--ab", "12.65,0.0629", "--threads", "-1"}, {"--threads"});
}

}  // namespace time_limit_test
}  // namespace polhode::test
