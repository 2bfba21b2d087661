// Where epsilon(c) is pi/2.

#include "brackets.hpp"
#include "checker/facts.hpp"
#include "list.hpp"
#include "shapes.hpp"

namespace polhode::checker {
namespace {

void check_crossing(examination& e) {
  const body rigid = check_body_and_steps(e);
  check_I(e);
  const integer count = rigid.crossings();
  e.witness("crossings_count").expect_text(count.str());
  e.fact("at the given a, b, in rationals: k < 1/I for " + counted(count) + ", and the body is " +
             rigid.kind_in_words(),
         (count == 0 || rigid.is_above_I(rational(integer(1), count))) &&
             !rigid.is_above_I(rational(integer(1), count + 1)) &&
             (count > 0) == (rigid.kind() < 0));
  check_values_of_half_phase(
      e, count, [](int k) { return rational(1, k); }, "crossings");
}

}  // namespace

claim crossing_claim() {
  return {.name = "crossing",
          .reference = "lemma 3",
          .statement =
              "epsilon(c) takes the value pi/2 in (-b, 0) if and only if I < 1, that is, if the "
              "body is not physical: exactly ceil(1/I) - 1 times.",
          .formula =
              "epsilon(c*) = pi/2 for some c* in (-b, 0)  <=>  I < 1; it has ceil(1/I) - 1 such "
              "solutions",
          .method =
              "For all a > 0, 0 < b < 1: by the symmetries of the reduced system psi_c(phi + G) = "
              "-psi_c(phi), and psi_c(pi) = 0 exactly where pi = k G(u) for a whole k >= 1; G maps "
              "(0, 1) one to one onto the values above pi I, so that there is one solution for "
              "every k < 1/I. The first, G = pi, lies beyond the first intersection, G = 2 pi. "
              "Computed: the polynomial steps for G, and the count in rationals.",
          .steps = facts::with_more(facts::half_phase_steps),
          .tier = by_kernel,
          .argument = {in_coq("Curve.lemma_3_sharp"), facts::bartky_transformation},
          .check = check_crossing};
}

}  // namespace polhode::checker
