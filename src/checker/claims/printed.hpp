#pragma once

// Numbers that the paper prints, compared with their formulas.

#include <functional>
#include <string>
#include <vector>

#include "answers.hpp"
#include "checker/body.hpp"
#include "checker/examination.hpp"

namespace polhode::checker {

struct printed_number {
  const char* where;
  const char* what;
  const char* printed;
  const char* as_read;   // with the decimals that are meant
  int places;            // of them
  const char* in_short;  // the value to ten digits
  std::function<interval(precision bits)> value;
};

/// The decimal, exactly.
[[nodiscard]] rational number_in(const char* text);
[[nodiscard]] body with_ab(const char* a, const char* b);
/// From rotational constants C < B < A: a = B^-1/A^-1 - 1, b = 1 - B^-1/C^-1.
[[nodiscard]] body with_constants(const char* C, const char* B, const char* A);
[[nodiscard]] body water_at_equilibrium();
[[nodiscard]] std::function<interval(precision bits)> I_of(const body& rigid);

/// |value - printed| <= half a unit of the last place.
[[nodiscard]] tri is_right(const interval& value, const char* printed, int places);
[[nodiscard]] tri is_wrong(const interval& value, const char* printed, int places);

/// The numbers, and a fact of each: that it is right to the last digit printed, or wrong. One
/// without a value is beta.
void check_printed(examination& e, const std::vector<printed_number>& numbers, bool right);

}  // namespace polhode::checker
