#include "tally.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support/random.hpp"

namespace polhode::differential {
namespace {

long number_in(const char* variable, long otherwise) {
  const char* text = std::getenv(variable);
  return text == nullptr ? otherwise : std::strtol(text, nullptr, 10);
}

/// FNV-1a, then the mixing of splitmix64: the same on every machine.
std::uint64_t seed_of(const std::string& family, long number) {
  std::uint64_t h = 14695981039346656037ULL;
  for (const char c : family) h = (h ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  h ^= static_cast<std::uint64_t>(number_in("POLHODE_TEST_SEED", 1)) * 0x9e3779b97f4a7c15ULL;
  h += static_cast<std::uint64_t>(number) * 0xd1342543de82ef95ULL;
  h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9ULL;
  h = (h ^ (h >> 27)) * 0x94d049bb133111ebULL;
  return h ^ (h >> 31);
}

constexpr const char* every_family = "**all**";

using table = std::map<std::pair<std::string, std::string>, counts>;

/// The counts in the file of POLHODE_TEST_TABLE, as write_table wrote them; none where there is
/// none.
table counts_so_far() {
  table result;
  const char* name = std::getenv("POLHODE_TEST_TABLE");
  if (name == nullptr) return result;
  std::ifstream file(name);
  for (std::string line; std::getline(file, line);) {
    std::vector<std::string> cells;
    std::istringstream rest(line);
    for (std::string cell; std::getline(rest, cell, '|');) {
      const auto first = cell.find_first_not_of(' ');
      if (first == std::string::npos) continue;
      cells.push_back(cell.substr(first, cell.find_last_not_of(' ') - first + 1));
    }
    const bool is_row =
        cells.size() == 8 && cells[2].find_first_not_of("0123456789") == std::string::npos;
    if (!is_row || cells[1] == every_family) continue;
    result[{cells[0], cells[1]}] = {std::stol(cells[2]), std::stol(cells[3]), std::stol(cells[4]),
                                    std::stol(cells[5]), std::stol(cells[6]), std::stol(cells[7])};
  }
  return result;
}

table& all_counts() {
  static table result = counts_so_far();
  return result;
}

void add(counts& sum, const counts& c) {
  sum.cases += c.cases;
  sum.certified += c.certified;
  sum.refused += c.refused;
  sum.computed += c.computed;
  sum.checks += c.checks;
  sum.wrong += c.wrong;
}

std::string row(const std::string& room, const std::string& family, const counts& c) {
  return fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} |\n", room, family, c.cases,
                     c.certified, c.refused, c.computed, c.checks, c.wrong);
}

void write_table() {
  const char* name = std::getenv("POLHODE_TEST_TABLE");
  if (name == nullptr) return;
  std::string text =
      "| what | family | cases | certified | refused | results | checks | wrong |\n"
      "|---|---|---:|---:|---:|---:|---:|---:|\n";
  std::map<std::string, counts> sums;
  for (const auto& [key, c] : all_counts()) {
    text += row(key.first, key.second, c);
    add(sums[key.first], c);
  }
  for (const auto& [room, c] : sums) text += row(room, every_family, c);
  if (std::FILE* file = std::fopen(name, "w")) {
    std::fputs(text.c_str(), file);
    std::fclose(file);
  }
}

/// The case under way and when it began. (The clock is for a person to read; no outcome depends on
/// it.)
struct current_case {
  std::string where;
  std::string command;
  std::chrono::steady_clock::time_point start;
};
current_case& current() {
  static current_case result;
  return result;
}

void finish_case() {
  constexpr double slow = 10;
  const char* name = std::getenv("POLHODE_TEST_PROGRESS");
  if (name == nullptr) return;
  current_case& c = current();
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - c.start).count();
  if (seconds < slow) return;
  if (std::FILE* file = std::fopen((std::string(name) + ".slow").c_str(), "a")) {
    std::fprintf(file, "%.0f s: %s %s\n", seconds, c.where.c_str(), c.command.c_str());
    std::fclose(file);
  }
}

}  // namespace

void under_way(const std::string& command) {
  current().command = command;
  const char* name = std::getenv("POLHODE_TEST_PROGRESS");
  if (name == nullptr) return;
  if (std::FILE* file = std::fopen(name, "w")) {
    std::fprintf(file, "%s %s\n", current().where.c_str(), command.c_str());
    std::fclose(file);
  }
}

void run_cases(const std::string& room, const std::string& family, long at_effort_one,
               const std::function<void(std::uint64_t seed, counts& c)>& one) {
  constexpr long most_wrong = 20;
  const long first = number_in("POLHODE_TEST_FIRST", 0);
  const long number =
      std::max(1L, static_cast<long>(static_cast<double>(at_effort_one) * support::effort()));
  counts& c = all_counts()[{room, family}];
  const long wrong_before = c.wrong;
  for (long k = first; k < first + number && c.wrong - wrong_before < most_wrong; ++k) {
    current().where = fmt::format("{}/{} case {}:", room, family, k);
    current().command.clear();
    current().start = std::chrono::steady_clock::now();
    one(seed_of(room + '/' + family, k), c);
    finish_case();
    if (k % 200 == 199) write_table();
  }
  write_table();
  EXPECT_EQ(c.wrong, wrong_before) << room << '/' << family;
}

}  // namespace polhode::differential
