// Random integrals, family by family: every rule against every other, additivity, substitutions,
// closed forms.

#include <algorithm>
#include <cctype>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "integrals.hpp"

namespace polhode::differential {
namespace integrals_test {

std::vector<integral_family> every_family() {
  std::vector<integral_family> result;
  for (const auto& group : {steep_families(), end_families(), shape_families(), known_families(),
                            oscillation_families()}) {
    result.insert(result.end(), group.begin(), group.end());
  }
  return result;
}

std::string test_name(std::string name) {
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

class integrals : public ::testing::TestWithParam<integral_family> {};

TEST_P(integrals, agree_by_every_route) {
  const integral_family& family = GetParam();
  run_cases("integrals", family.name, family.at_effort_one, [&](std::uint64_t seed, counts& c) {
    maker m(seed);
    examine(family.make(m), seed, c);
  });
}

INSTANTIATE_TEST_SUITE_P(family, integrals, ::testing::ValuesIn(every_family()),
                         [](const auto& drawn) { return test_name(drawn.param.name); });

}  // namespace integrals_test
}  // namespace polhode::differential
