#pragma once

// Numbers of a rigid body to a given number of digits: the precision is raised until they are
// certain.

#include "polhode/arithmetic/certain_digits.hpp"
#include "polhode/arithmetic/certified_answer.hpp"
#include "polhode/rigid_body/work.hpp"

namespace polhode {

/// A number to a given number of digits. Certified: all of them are certain. Else the enclosure is
/// undefined.
struct certain_number : certified_answer<ball> {
  work_count work;
};

/// That number, as enclose_to_digits encloses it; not certified, precision_limit, where its digits
/// need more than most_guard bits beside their own.
[[nodiscard]] certain_number number_to_digits(const enclosing_function& f, long digits,
                                              precision most_guard);

}  // namespace polhode
