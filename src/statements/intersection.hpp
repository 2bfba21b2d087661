#pragma once

#include "statements/shared.hpp"

namespace polhode::statements {

// Its facts.
inline constexpr const char* meets_or_not =
    "at the given a, b, exactly: I {} 2, and 4ab + 3b^2 + 2b - 1 is {}";

[[nodiscard]] inline claim_text intersection() {
  return {
      .name = "intersection",
      .reference = "lemma 2 and its remark",
      .statement =
          "The part of C given by the first implicit equation meets S in exactly one point with u "
          "in (0, 1) if I < 2 and in none otherwise; at I = 2 the point is the limit u = 1.",
      .technique = "one-to-one map onto (pi I, infinity), by exact signs; I < 2 decided exactly",
      .formula =
          "F(-bu,u) = 2 pi for some u in (0, 1)  <=>  I < 2; then u is the only one (u = 1 <=> I = "
          "2)",
      .method =
          "For all a > 0, 0 < b < 1: G(u) = F(-bu,u) maps (0, 1) one to one onto the values above "
          "pi I, decreasing, and tends to pi I at u = 1 (the steps are those of "
          "montgomery_oscillating). With u = 1 allowed, where F(-b,1) means this limit, the "
          "condition is the paper's I <= 2; u = 1 is the equilibrium c = -b, no motion. For a "
          "given body I < 2 is decided exactly.",
      .steps =
          with_more(half_phase_steps, {identity("4*b*(a+b) - (1-b)^2", "4*a*b + 3*b^2 + 2*b - 1",
                                                "I < 2 exactly where this is positive")}),
      .tier = by_kernel,
      .argument = {in_coq("MeetingPoint.lemma_2"), in_coq("Curve.first_meeting_iff"),
                   in_coq("Values.lemma_7_at_1"), bartky_transformation}};
}

}  // namespace polhode::statements
