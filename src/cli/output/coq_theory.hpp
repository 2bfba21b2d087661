#pragma once

#include <string>

#include "polhode/rigid_body/body.hpp"

namespace polhode::cli {

/// What a theory of Coq says of a body, and the theory.
struct coq_theory {
  std::string text;
  long defect_digits = 0;
  long twist_digits = 0;    // 0: there is no perfect twist, which the theory proves
  integer meetings;         // how often C meets S
  long meeting_digits = 0;  // 0: it does not, which the theory proves
};

/// The theory for rational a > 0 and 0 < b < 1: whether the body is physical, epsilon0 to so many
/// digits, and to at most 12 the perfect twist c0 and u = -c/b at the first three points where C
/// meets S, each between two numbers, and how often C meets S. Coq proves them by the
/// theorems of proofs/coq/paper/Brackets.v and by coq-interval; the digits that were computed here
/// only say what is to be proved. Throws not_certified_error where there are none.
[[nodiscard]] coq_theory coq_theory_of(const rational& a, const rational& b, long digits);

}  // namespace polhode::cli
