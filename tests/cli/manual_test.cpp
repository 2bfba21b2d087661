// What the manual and every --help show: each command runs, and what is printed beside it is what
// it prints.

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "program.hpp"
#include "refusal.hpp"

namespace polhode::test {
namespace manual_test {

namespace fs = std::filesystem;

const fs::path root_of_tree = fs::path(POLHODE_SCENES_DIR).parent_path();

/// A command of a page, and the lines that the page shows of its output.
struct shown_command {
  std::string where;
  std::string command;
  std::vector<std::string> lines;
};

/// Lines "$ polhode ..." that are indented as code or stand in a fence, and those beneath each, to
/// the next or the end of the block.
std::vector<shown_command> commands_of(const fs::path& page) {
  constexpr const char* indent = "    ";
  std::vector<shown_command> result;
  bool is_open = false;
  bool is_indented = false;
  std::size_t number = 0;
  for (const std::string& line : lines_of(contents(page.string()))) {
    ++number;
    const std::size_t start = line.find_first_not_of(' ');
    const bool begins = start != std::string::npos && line.compare(start, 2, "$ ") == 0;
    if (begins) {
      is_open = line.find("polhode ") != std::string::npos && start % 4 == 0;
      is_indented = start == 4;
      if (is_open) {
        const std::string where = page.filename().string() + ':' + std::to_string(number);
        result.push_back({where, line.substr(start + 2), {}});
      }
    } else if (is_open) {
      const bool goes_on = is_indented ? line.empty() || line.starts_with(indent) : line != "```";
      if (!goes_on) {
        is_open = false;
      } else if (!line.empty()) {
        result.back().lines.push_back(is_indented ? line.substr(4) : line);
      }
    }
  }
  return result;
}

bool is_there(const std::string& program) {
  return run_script("command -v " + program + " >&2").status == 0;
}

/// Whether this machine has what the command needs.
bool can_run(const std::string& command) {
  static const bool has_gnuplot = is_there("gnuplot");
  static const bool has_jq = is_there("jq");
  const auto has = [&](const char* words) { return command.find(words) != std::string::npos; };
  const bool draws = has("--plot") || has("--format svg") ||
                     (has("polhode figures") && !has("--list") && !has("--data-only"));
#ifdef POLHODE_HAVE_HDF5
  constexpr bool has_hdf5 = true;
#else
  constexpr bool has_hdf5 = false;
#endif
  return (has_gnuplot || !draws) && (has_jq || !has("jq ")) && (has_hdf5 || !has("hdf5")) &&
         (POLHODE_HAVE_PAGES != 0 || !has("--page"));
}

/// Measurements of minutes, or what a clock decides.
bool depends_on_time(const std::string& command) {
  return command.find("polhode cost") != std::string::npos ||
         command.find("--time-limit") != std::string::npos ||
         command.find("build/") != std::string::npos;
}

/// In a directory from which the tree's files have the names that the manual gives them.
void make_tree(const scratch_directory& directory) {
  for (const char* name : {"scenes", "proofs"})
    fs::create_directory_symlink(root_of_tree / name, directory.path(name));
}

/// Every line in its order; a line of dots stands for those that are left out.
void expect_shown(const shown_command& shown, const std::string& out) {
  std::vector<std::string> lines = lines_of(out);
  std::erase(lines, "");
  auto at = lines.begin();
  bool skips = false;
  for (const std::string& line : shown.lines) {
    const std::string text = line.substr(line.find_first_not_of(' '));
    if (text == "..." || text == "…") {
      skips = true;
      continue;
    }
    if (skips) at = std::find(at, lines.end(), line);
    skips = false;
    ASSERT_NE(at, lines.end()) << "not printed: " << line;
    EXPECT_EQ(*at, line);
    ++at;
  }
}

TEST(Manual, ShowsWhatTheCommandsPrint) {
  std::vector<fs::path> pages{root_of_tree / "README.md"};
  for (const char* directory : {"docs", "proofs"}) {
    for (const auto& entry : fs::directory_iterator(root_of_tree / directory)) {
      if (entry.path().extension() == ".md") pages.push_back(entry.path());
    }
  }
  std::size_t count = 0;
  for (const fs::path& page : pages) {
    const scratch_directory directory;
    make_tree(directory);
    for (const shown_command& shown : commands_of(page)) {
      if (depends_on_time(shown.command) || !can_run(shown.command)) continue;
      SCOPED_TRACE(shown.where + ": " + shown.command);
      const outcome ran = run_script(shown.command, directory.path(""));
      EXPECT_LE(ran.status, 1);  // a scene may be not certified, and its page says so
      EXPECT_EQ(ran.err, "");
      expect_shown(shown, ran.out);
      ++count;
    }
  }
  EXPECT_GE(count, 35U);
}

std::vector<std::string> subcommands() {
  std::vector<std::string> result;
  bool are_listed = false;
  for (const std::string& line : lines_of(certified({"--help"}))) {
    if (line.starts_with("Examples")) are_listed = false;
    const std::size_t end = line.find(' ', 2);
    if (are_listed && line.starts_with("  ") && line[2] != ' ')
      result.push_back(line.substr(2, end - 2));
    if (line.find("ubcommands") != std::string::npos) are_listed = true;
  }
  return result;
}

TEST(Manual, SchemaIsThatOfTheCertificates) {
  std::ifstream file(root_of_tree / "docs" / "certificate.schema.json");
  const nlohmann::json schema = nlohmann::json::parse(file);
  const outcome o = run({"certify", "physical", "--format", "json"});
  const nlohmann::json certificate = nlohmann::json::parse(o.out).at(0);
  EXPECT_EQ(schema.at("properties").at("version").at("const"), certificate.at("version"));
  for (const auto& key : schema.at("required")) EXPECT_TRUE(certificate.contains(key)) << key;
  for (const auto& [key, value] : certificate.items()) {
    EXPECT_TRUE(schema.at("properties").contains(key)) << key;
  }
}

TEST(Help, HasExamplesThatRun) {
  const std::vector<std::string> names = subcommands();
  EXPECT_GE(names.size(), 13U);
  // Not certified, as each should show: moments that may be of a non-physical body.
  const std::set<std::string> undecided{
      "polhode body --moments 3.01±0.1,2,1±0.05",
      "polhode scene scenes/*.toml --out results --page --plot svg"};
  const scratch_directory directory;
  make_tree(directory);
  std::set<std::string> done;
  for (const std::string& name : names) {
    std::size_t examples = 0;
    for (const std::string& line : lines_of(certified({name, "--help"}))) {
      if (!line.starts_with("  polhode ")) continue;
      ++examples;
      const std::string command = line.substr(2);
      if (depends_on_time(command) || !can_run(command) || !done.insert(command).second) continue;
      SCOPED_TRACE(command);
      const outcome ran = run_script(command, directory.path(""));
      EXPECT_EQ(ran.status, undecided.count(command)) << ran.err;
      EXPECT_EQ(ran.err, "");
    }
    EXPECT_GE(examples, 1U) << name;
  }
}

}  // namespace manual_test
}  // namespace polhode::test
