// What cannot be used: one line on standard error, status 2, nothing on standard output, no file.

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "program.hpp"

namespace polhode::test {
namespace bad_input_test {

void expect_one_error_line(const outcome& result) {
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(result.err.rfind("polhode: ", 0), 0U) << result.err;
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
  EXPECT_EQ(result.err.back(), '\n');
}

/// The arguments are refused, and the line says each of the words.
void expect_refused(const std::vector<std::string>& arguments,
                    const std::vector<std::string>& words = {}) {
  std::string command = "polhode";
  for (const std::string& a : arguments) command += " '" + a + "'";
  SCOPED_TRACE(command);
  const outcome result = run(arguments);
  expect_one_error_line(result);
  for (const std::string& word : words) {
    EXPECT_NE(result.err.find(word), std::string::npos) << word << " in " << result.err;
  }
}

TEST(BadInput, DigitCounts) {
  for (const char* digits : {"-1", "0", "abc", "1e3", "1e3?", "1.5", "", "99999999999999999999",
                             "+5", " 5", "5 ", "5\n6", "0x10", "1000000001"}) {
    expect_refused({"constants", "--digits", digits}, {"--digits", "whole number"});
    expect_refused({"certify", "--digits", digits}, {"--digits", "whole number"});
  }
  expect_refused({"constants", "--digits"}, {"--digits"});
  expect_refused({"constants", "--digits="}, {"--digits"});
  expect_refused({"constants", "--digits", "5", "--digits", "6"}, {"--digits"});
}

TEST(BadInput, NamesGetTheNearestKnownOne) {
  expect_refused({"certify", "betta"}, {"betta", " beta ", "polhode certify --list"});
  expect_refused({"certify", "beta", "epsilon_min"}, {"epsilon_min", " epsilon0_min "});
  expect_refused({"certify", "constants"}, {"\"constants\""});
  expect_refused({"constants", "delta_phi_max"}, {" delta_psi_max ", "polhode constants"});
  for (const char* name : {"", " ", "beta\n", "[]", "[,]", "[beta]", "{}"}) {
    expect_refused({"certify", name});
    expect_refused({"constants", name});
  }
  expect_refused({"constants", std::string(100'000, 'x')}, {"xxx ... xxx"});
}

TEST(BadInput, OptionsAndSubcommands) {
  expect_refused({"certify", "--digitz", "5"}, {"--digitz", "--digits"});
  expect_refused({"certify", "--formt=json"}, {"--formt", "--format"});
  expect_refused({"constants", "-x"}, {"-x", "polhode constants --help"});
  expect_refused({"constants", "--ab", "1,2"}, {"--ab"});
  expect_refused({"--verson"}, {"--verson", "--version"});
  expect_refused({"constant"}, {"constant", "constants", "polhode --help"});
  expect_refused({""}, {"subcommand"});
  expect_refused({"nothing", "certify"}, {"nothing"});
}

TEST(BadInput, NoSubcommandPrintsTheHelpAsAnError) {
  const outcome result = run({});
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.out, "");
  EXPECT_NE(result.err.find("Usage: polhode"), std::string::npos);
}

TEST(BadInput, Formats) {
  expect_refused({"certify", "--format", "xml"}, {"xml", "text, json"});
  expect_refused({"certify", "--format", "csv"}, {"csv", "text, json"});
  expect_refused({"constants", "--format", "xml"}, {"xml", "text, csv, json, cpp"});
  expect_refused({"constants", "--format", ""}, {"text, csv, json, cpp"});
}

TEST(BadInput, BodiesAndMotions) {
  for (const char* ab : {"1", "1,2,3", "", ",", "1,", ",0.5", "nan", "1e", "nan,0.5", "1,1e",
                         "1,0x1", "1,1/0", "inf,0.5", "1e999999999,0.5"}) {
    expect_refused({"certify", "sign_dF_du", "--ab", ab}, {"--ab"});
  }
  expect_refused({"certify", "sign_dF_du", "--ab", "0,0.5"}, {"a = 0", "positive"});
  expect_refused({"certify", "sign_dF_du", "--ab", "-1,0.5"}, {"a = -1"});
  expect_refused({"certify", "sign_dF_du", "--ab", "1,0"}, {"b = 0", "between 0 and 1"});
  expect_refused({"certify", "sign_dF_du", "--ab", "1,1"}, {"b = 1"});
  expect_refused({"certify", "sign_dF_du", "--ab", "1,-1/3"}, {"b = -1/3"});
  expect_refused({"certify", "sign_dF_du", "--ab", "1,1." + std::string(50'000, '1')},
                 {"b = ", "between 0 and 1"});
  for (const char* u : {"0", "-1", "1.0001", "nan", "", "1e", "1/0"}) {
    expect_refused({"certify", "sign_dF_du", "--u", u}, {"--u"});
  }
  expect_refused({"certify", "beta", "--ab", "1,0.5"}, {"--ab", "sign_dF_du"});
  expect_refused({"certify", "beta", "--u", "0.5"}, {"--u", "sign_dF_du"});
}

TEST(BadInput, WhatNeedsTooMuchMemoryIsRefusedBeforeWork) {
  expect_refused({"constants", "beta", "--digits", "1000000000"},
                 {"1000000000 digits of beta need about", "GiB; the limit is", "--memory-limit"});
  expect_refused({"constants", "--digits", "1000000000", "--format", "json"}, {"GiB"});
  expect_refused({"certify", "--digits", "1000000000"}, {"GiB"});
  expect_refused({"constants", "--digits", "100000", "--memory-limit", "1/1000000"}, {"GiB"});
  for (const char* limit : {"0", "-1", "x", "", "nan"}) {
    expect_refused({"constants", "--memory-limit", limit}, {"--memory-limit", "positive number"});
  }
}

TEST(BadInput, DirectoriesThatCannotBeWritten) {
  const scratch_directory scratch;
  const std::string file = scratch.path("file");
  std::ofstream(file) << "mine";
  for (const std::string& directory :
       {file, file + "/below", std::string("/proc/polhode"), std::string("/dev/full"),
        std::string("/dev/null/below"), std::string()}) {
    expect_refused({"certify", "beta", "--out", directory}, {"directory"});
  }
  EXPECT_EQ(contents(file), "mine");
  const std::string taken = scratch.path("taken");
  std::filesystem::create_directories(taken + "/beta.json");
  expect_refused({"certify", "beta", "--out", taken}, {"beta.json"});
  EXPECT_EQ(names_in(taken), std::vector<std::string>{"beta.json"});
}

TEST(BadInput, NothingIsCreatedForWhatIsRefused) {
  const scratch_directory scratch;
  expect_refused({"certify", "betta", "--out", scratch.path("new")});
  expect_refused({"certify", "--digits", "0", "--out", scratch.path("new")});
  expect_refused({"certify", "--format", "xml", "--out", scratch.path("new")});
  EXPECT_TRUE(names_in(scratch.path()).empty());
}

TEST(BadInput, OutputThatHasNoRoom) {
  for (const char* arguments :
       {"constants", "certify beta", "--help", "--version", "certify --list"}) {
    SCOPED_TRACE(arguments);
    const std::string command = std::string("polhode ") + arguments;
    expect_one_error_line(run_script(command + " > /dev/full"));
    expect_one_error_line(run_script(command + " >&-"));
    expect_one_error_line(run_script(command + " 1< /dev/null"));
  }
}

TEST(BadInput, AFileThatMayNotGrowIsTakenBack) {
  const scratch_directory scratch;
  const outcome result =
      run_script("ulimit -f 1; polhode certify --out a/b 2>&1 | cat", scratch.path());
  EXPECT_NE(result.out.find("cannot be written"), std::string::npos) << result.out;
  EXPECT_EQ(std::count(result.out.begin(), result.out.end(), '\n'), 1) << result.out;
  EXPECT_TRUE(names_in(scratch.path()).empty());
}

TEST(BadInput, WantOfMemoryIsOneLine) {
  if (sanitized) GTEST_SKIP() << "the address space of sanitized programs cannot be limited";
  expect_one_error_line(
      run_script("ulimit -v 60000; exec polhode constants epsilon0_min --digits 20000000"));
}

}  // namespace bad_input_test
}  // namespace polhode::test
