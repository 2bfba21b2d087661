// Random values, family by family: equal formulas, other precisions, other arithmetics, the printed
// decimals.

#include <algorithm>
#include <cctype>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "values.hpp"

namespace polhode::differential {
namespace values_test {

std::vector<value_family> every_family() {
  std::vector<value_family> result = formula_families();
  for (const value_family& f : elliptic_families()) result.push_back(f);
  return result;
}

class values : public ::testing::TestWithParam<value_family> {};

TEST_P(values, agree_by_every_route) {
  const value_family& family = GetParam();
  run_cases("values", family.name, family.at_effort_one, [&](std::uint64_t seed, counts& c) {
    maker m(seed);
    examine(family.make(m), seed, c);
  });
}

INSTANTIATE_TEST_SUITE_P(family, values, ::testing::ValuesIn(every_family()),
                         [](const auto& drawn) {
                           std::string name = drawn.param.name;
                           std::replace_if(
                               name.begin(), name.end(),
                               [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
                           return name;
                         });

}  // namespace values_test
}  // namespace polhode::differential
