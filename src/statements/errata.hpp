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
      .steps = {identity("2*f + 2*(g-f)", "2*g",
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
      .argument = {argued("A statement that is not right in general is refuted by one body; what "
                          "the facts say of all bodies is that of the claims that they name."),
                   bartky_transformation}};
}

}  // namespace polhode::statements
