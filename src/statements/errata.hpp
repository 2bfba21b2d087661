#pragma once

#include "statements/shared.hpp"

namespace polhode::statements {

// Its facts.
inline constexpr const char* meant_by_figure_7 =
    "figure 7 with b = 0.0629 in place of 0.06: {} for a = {} would be {}, I = {}";
inline constexpr const char* a_above_1 =
    "section 2 says \"by definition, a > 1\": a > 0 is right; the water molecule of section 8 has "
    "a = {} and I > 1";
inline constexpr const char* phase_is_said_to_decrease =
    "section 1 says that the phase of oscillating motion is a decreasing function of c: it "
    "increases, for a = 12.65, b = 0.0629 from c = -3b/4 to -b/4 (for all bodies: the claim "
    "montgomery_oscillating)";
inline constexpr const char* range_of_c0 =
    "proposition 3 seeks c0 in (-b, a): it lies in (0, a), for a = 12.65, b = 0.0629 at c0/a "
    "between {}";
inline constexpr const char* planar_body =
    "section 8 says \"if and only if I > 1\": theorem 3 has I >= 1; the planar body a = 1, b = 1/3 "
    "has I = 1, is physical, and epsilon(c) never crosses pi/2";
inline constexpr const char* one_meeting =
    "section 6.2 says that for non-physical bodies C and S intersect several times: for 2/3 <= I < "
    "1 exactly once, as for a = 18.27, b = 0.0629";
inline constexpr const char* exactly_n_plus_1 =
    "theorem 4 says at least n, and one more beyond the n-th, for I < 2/(2n+1): there are exactly "
    "n + 1 for 2/(2n+3) <= I < 2/(2n+1); for a = 39.95, b = 0.0629, where n = 1, there are 2";
inline constexpr const char* no_meeting_at_2 =
    "lemma 2 says that C and S intersect if and only if I <= 2: at I = 2 the point u = 1 is only a "
    "limit, as for a = 77/40, b = 1/10, where there is no intersection";
inline constexpr const char* many_epsilon_for_one_c =
    "lemma 1 says that there is one epsilon for each c: at a = 12.65, b = 0.0629 G(u) passes 2 pi "
    "between u = 0.053943792 and 0.053943793, at c between -0.0033930646 and -0.0033930645, where "
    "C meets S; there psi(phi + 2 pi) = -psi(phi) on the whole orbit, so that each epsilon from "
    "epsilon* to pi - epsilon* belongs to this one c, such as 0.4, 0.9 and 1.4, as sin^2 0.4 > u";
inline constexpr const char* period_is_said_to_decrease =
    "appendix B says that the period T_phi(c) is a decreasing function: by lemma 6 T_phi = 2 "
    "F(-bu,u) decreases in u = -c/b and so increases in c, for a = 12.65, b = 0.0629 from c = -b/2 "
    "to -b/8";
inline constexpr const char* epsilon0_across_b =
    "section 7 says that by lemma 5, which is for one b, epsilon0 is smallest as a -> infinity: "
    "for one b bodies are physical up to a = 1/b - 2 only, and between physical bodies of "
    "different b a greater a may have a greater epsilon0: for a = 2, b = 1/4 it is below 1/2, for "
    "a = 4, b = 1/100 above (what follows is so: the claim limit_minimum)";

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
