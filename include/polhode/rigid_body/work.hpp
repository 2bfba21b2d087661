#pragma once

#include "polhode/language.hpp"

namespace polhode {

/// What a computation has cost, whatever the machine. It is a value, passed along: nothing counts
/// behind the caller's back.
struct work_count {
  long integrals = 0;     // elliptic integrals, or pairs of them from one sequence of steps
  long agm_steps = 0;     // steps of arithmetic-geometric means
  long newton_steps = 0;  // evaluations of a derivative for a step of Newton's method

  work_count& operator+=(const work_count& other) {
    integrals += other.integrals;
    agm_steps += other.agm_steps;
    newton_steps += other.newton_steps;
    return *this;
  }
  friend bool operator==(const work_count&, const work_count&) = default;
};

}  // namespace polhode
