#pragma once

#include "statements/shared.hpp"

namespace polhode::statements {

[[nodiscard]] inline claim_text errata() {
  return {
      .name = "errata",
      .reference = "sections 1 to 8, figure 7",
      .statement =
          "Each printed number that is wrong, beside the certified one, and statements that are "
          "not right as printed.",
      .technique = "enclosures against the printed decimals; exact counterexamples",
      .formula = "|printed - value| > half a unit of the last place printed",
      .method =
          "The numbers as in the claim printed_numbers; statements by an exact counterexample in "
          "rationals, by enclosures, or by polynomial steps. The numbers of figure 7, but for "
          "1.045, are those of b = 0.0629 in place of 0.06, and 0.872 is cut off where 0.873 would "
          "be rounded.",
      .steps = {identity(
                    "(b*p*s*k)^2*(a+b*k^2)", "b^2*(a-(a-p^2*(a+b*k^2)))*s^2*k^2",
                    "eq. (8) has both signs: p = sin theta = sqrt((a-c)/(a+b cos^2 psi)) is "
                    "positive for 0 < theta < pi, so that the sign is +, that of eq. (19); only "
                    "cos theta in eq. (9) has two"),
                identity("2*f + 2*(g-f)", "2*g",
                         "lemma 1, where C meets S, at G = 2 pi: from -pi/2 + epsilon to pi/2 - "
                         "epsilon it takes F, from there to the turning point and back (G - F)/2 "
                         "twice, G in all for every epsilon"),
                identity("0 - (2*e-p)", "2*(p-e) - p",
                         "lemma 1, at every c: the mirror motion, psi -> -psi and cos theta -> "
                         "-cos theta, goes in the same time from -psi_i = -pi/2 + (pi - epsilon) "
                         "to -psi_f, so that pi - epsilon belongs to c as well (here epsilon is "
                         "that of the motion with cos theta > 0 at psi = 0 and half of the time)"),
                positive("1-b*x", "q + b*y", "b > 0, q = 1-b > 0, y = 1-x >= 0",
                         "proposition 2 says that d epsilon/dc <= 0 with a discrete set of zeros: "
                         "the integrand of its numerator has the sign of 1 - bX, is positive, and "
                         "the range 0 < psi < pi/2 - epsilon is not empty, as the integral over it "
                         "is pi: d epsilon/dc < 0 throughout")},
      .tier = with_words,
      .argument = {
          argued("Lemma 6 says that F(-bu,u) decreases on [0, 1]: it is defined on (0, 1], "
                 "and has no bound as u -> 0, by lemma 7 (the claim half_phase_limits)."),
          argued("Section 1 says that neither property holds where a body is not physical: "
                 "the phase is monotone for every body (the claim "
                 "montgomery_oscillating); what fails is its bound 2 pi, and that "
                 "epsilon is injective (the claim injectivity)."),
          argued("Lemmas 4 and 5 write the points of C where it meets the axes as (0, c0) "
                 "and (epsilon0, 0), theorem 4 as (c, epsilon): they are (c0, 0) and "
                 "(0, epsilon0)."),
          argued("The induction of theorem 4 begins at n = 1, and its step is stated for "
                 "n > 1: it is needed, and holds, for n >= 1."),
          argued("A statement that is not right in general is refuted by one body; what "
                 "the facts say of all bodies is that of the claims that they name."),
          bartky_transformation}};
}

}  // namespace polhode::statements
