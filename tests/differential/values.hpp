#pragma once

// One number by many routes: two formulas that are equal, at several precisions, in several
// arithmetics.

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "maker.hpp"
#include "tally.hpp"
#include "term.hpp"

namespace polhode::differential {

/// Two formulas without variables that have the same value wherever both are defined. They may be
/// the same formula.
struct value_case {
  term left = 0;
  term right = 0;
  /// Half of the values have 400 bits and more where these are more than the usual.
  precision most_bits = usual_most_bits;

  static constexpr precision usual_most_bits = 1500;
};

struct value_family {
  std::string name;
  long at_effort_one;
  std::function<value_case(maker&)> make;
};

[[nodiscard]] std::vector<value_family> formula_families();
[[nodiscard]] std::vector<value_family> elliptic_families();

/// Encloses both and holds the enclosures against each other; reports a contradiction as a failure
/// of the running test.
void examine(const value_case& given, std::uint64_t seed, counts& c);

}  // namespace polhode::differential
