#pragma once

// What every subcommand promises: output and status 0, or one line of error and status 2.

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "program.hpp"

namespace polhode::test {

inline std::string certified(const std::vector<std::string>& arguments) {
  const outcome result = run(arguments);
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.err, "");
  return result.out;
}

inline void expect_refused(const std::vector<std::string>& arguments,
                           const std::vector<std::string>& words) {
  const outcome result = run(arguments);
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(result.err.rfind("polhode: ", 0), 0U) << result.err;
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
  for (const std::string& word : words) {
    EXPECT_NE(result.err.find(word), std::string::npos) << word << " in " << result.err;
  }
}

}  // namespace polhode::test
