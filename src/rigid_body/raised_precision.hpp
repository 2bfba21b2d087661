#pragma once

// Numbers of a rigid body to a given number of digits: the precision is raised until they are
// certain.

#include "polhode/arithmetic/certain_digits.hpp"
#include "polhode/arithmetic/text.hpp"
#include "polhode/rigid_body/montgomery_phase.hpp"

namespace polhode::detail {

[[nodiscard]] inline bool has_digits(const ball& x, long digits) {
  if (!x.is_bounded()) return false;
  return to_decimal_enclosure(x, digits).has(digits);
}

/// enclose_to_digits with a verdict.
[[nodiscard]] inline certain_number number_to_digits(const enclosing_function& f, long digits,
                                                     precision most_guard) {
  certain_number result;
  result.enclosure = enclose_to_digits(f, digits, most_guard);
  if (result.enclosure.is_undefined()) return result;
  result.verdict = status::certified;
  result.why = reason::none;
  return result;
}

}  // namespace polhode::detail
