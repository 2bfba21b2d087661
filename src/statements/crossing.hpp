#pragma once

#include "statements/shared.hpp"

namespace polhode::statements {

// Its facts.
inline constexpr const char* number_of_crossings =
    "at the given a, b, exactly: k < 1/I for {}, and the body is {}";

[[nodiscard]] inline claim_text crossing() {
  return {.name = "crossing",
          .reference = "lemma 3",
          .statement =
              "epsilon(c) takes the value pi/2 in (-b, 0) if and only if I < 1, that is, if the "
              "body is not physical: exactly ceil(1/I) - 1 times.",
          .technique = "symmetries of the motion; one-to-one map, by exact signs; the exact count",
          .formula =
              "epsilon(c*) = pi/2 for some c* in (-b, 0)  <=>  I < 1; it has ceil(1/I) - 1 such "
              "solutions",
          .method =
              "For all a > 0, 0 < b < 1: by the symmetries of the reduced system psi_c(phi + G) = "
              "-psi_c(phi), and psi_c(pi) = 0 exactly where pi = k G(u) for a whole k >= 1; G maps "
              "(0, 1) one to one onto the values above pi I, so that there is one solution for "
              "every k < 1/I. The first, G = pi, lies beyond the first intersection, G = 2 pi. "
              "Computed: the polynomial steps for G, and the exact count.",
          .steps = with_more(half_phase_steps),
          .tier = by_kernel,
          .argument = {in_coq("Curve.lemma_3_sharp"), bartky_transformation}};
}

}  // namespace polhode::statements
