#pragma once

// What is counted of each family, the seeds of its cases, and what is written of them.
//
//   POLHODE_TEST_EFFORT    a factor on the number of cases (tests/support/random.hpp)
//   POLHODE_TEST_SEED      other cases than those of seed 1
//   POLHODE_TEST_FIRST     each family begins with this case in place of case 0
//   POLHODE_TEST_TABLE     a file into which the counts are written, as a table of Markdown; they
//                          are added to those that are in it. (For one process at a time.)
//   POLHODE_TEST_PROGRESS  a file that has the case under way as its last line, and the slow ones
//   before it

#include <cstdint>
#include <functional>
#include <string>

namespace polhode::differential {

struct counts {
  long cases = 0;
  long certified = 0;  // of the cases, by the first route
  long refused = 0;    // the others
  long computed = 0;   // results in all, by every route
  long checks =
      0;  // pairs of enclosures that were held against each other, and refusals that had to be
  long wrong = 0;
};

/// A family's cases at this effort: runs one(seed) for each, until too many are wrong, and writes
/// down the counts. A case's seed is made from POLHODE_TEST_SEED, the family's name and the case's
/// number.
void run_cases(const std::string& room, const std::string& family, long at_effort_one,
               const std::function<void(std::uint64_t seed, counts& c)>& one);

/// Says which case is under way, for a person who watches.
void under_way(const std::string& command);

}  // namespace polhode::differential
