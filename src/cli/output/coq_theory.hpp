#pragma once

#include <string>

#include "polhode/rigid_body/body.hpp"

namespace polhode::cli {

/// What a theory of Coq says of a body, and the theory.
struct coq_theory {
  std::string text;
  long defect_digits = 0;
  long twist_digits = 0;             // 0: there is no perfect twist, which the theory proves
  long meeting_digits = 0;           // 0: C does not meet S, which the theory proves
  bool are_meetings_counted = true;  // how often C meets S is a theorem
};

/// The theory of a body with rational a and b: whether it is physical, and, to so many digits,
/// epsilon0, the perfect twist c0 and u = -c/b at the first three points where C meets S, each
/// between two numbers, and how often C meets S, where that is at most 100 times. Coq proves them
/// by the theorems of proofs/coq/paper/Brackets.v, by coq-interval (epsilon0) and by integers (c0
/// and u, proofs/coq/paper/BracketTests.v); the digits that were computed here only say what is to
/// be proved. Throws not_certified_error where there are none.
[[nodiscard]] coq_theory coq_theory_of(const body& rigid, long digits);

}  // namespace polhode::cli
