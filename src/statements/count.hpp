#pragma once

#include "statements/shared.hpp"

namespace polhode::statements {

// Its facts.
inline constexpr const char* number_of_meetings = "at the given a, b, exactly: I < 2/(2k-1) for {}";
inline constexpr const char* slopes_at_meeting =
    "at the given a, b, exactly: where they meet for k = {}, C and S have the same slope, "
    "dc/d(epsilon) = {}2 b sqrt(u (1-u)), with 2 b sqrt(u (1-u)) between {}";

[[nodiscard]] inline claim_text count() {
  return {
      .name = "count",
      .reference = "theorem 4",
      .statement =
          "C and S meet exactly N = ceil(1/I + 1/2) - 1 times: n + 1 times for 2/(2n+3) <= I < "
          "2/(2n+1), where the paper says at least. At each of these points C is tangent to S.",
      .technique = "symmetries of the motion; one-to-one map, by exact signs; the exact count",
      .formula =
          "C meets S in exactly N = ceil(1/I + 1/2) - 1 points with -b < c < 0, G(u_k) = 2 "
          "pi/(2k-1)",
      .method =
          "For all a > 0, 0 < b < 1: by the symmetries of the reduced system psi_c(pi) is a "
          "turning point, which is where C meets S, exactly where pi = (k - 1/2) G(u) for a whole "
          "k >= 1; G maps (0, 1) one to one onto the values above pi I, so that there is one for "
          "every k < 1/I + 1/2. I < 2/(2n+1) is n + 1 < 1/I + 1/2: N >= n + 1, the paper's "
          "theorem. By eq. (20) c + b sin^2 epsilon = (a+bX) cos^2 theta at phi = pi, which is of "
          "the order of (c - c_k)^2 near a turning point; its slope there is that of c = -b sin^2 "
          "epsilon, with epsilon = arcsin sqrt(u_k) for k odd, pi - arcsin sqrt(u_k) for k even. "
          "Computed: the polynomial steps for G, the exact count, brackets of the first u_k, and "
          "the slopes there.",
      .steps = with_more(
          half_phase_steps,
          {identity(
               "2*k - (2*k-1)", "1",
               "2 pi/(2k-1) > pi/k: the k-th crossing of pi/2 comes after the k-th intersection"),
           identity("(2*k+1) - 2*k", "1", "pi/k > 2 pi/(2k+1): and before the next")}),
      .tier = by_kernel,
      .argument = {in_coq("Curve.theorem_4_sharp"),
                   in_coq("Tangency.tangent_at_every_meeting_point"), bartky_transformation}};
}

}  // namespace polhode::statements
