// The perfect twist decreases in a.

#include "brackets.hpp"
#include "checker/facts.hpp"
#include "list.hpp"
#include "shapes.hpp"

namespace polhode::checker {
namespace {

void check_c0_decreases(examination& e) {
  const body rigid = check_body_and_steps(e);
  const body other{2 * e.a(), e.b()};
  if (!rigid.is_above_J(2)) {
    e.add_to_method(facts::there_is_no_c0);
    return;
  }
  if (e.is_missing(facts::bracket_of_c0)) return;
  const range first = examination::bracket(e.witness("c0_over_a"));
  const range second = examination::bracket(e.witness("c0_over_a_for_2a"));
  e.fact("at the given b, by the AGM: c0 for 2a is below c0 for the given a, c0/a lying between " +
             in_decimals(first, e.work()),
         [&](precision bits) {
           return all_of({passes_rotating_phase(rigid, 2, first, bits + size_of(first)),
                          passes_rotating_phase(other, 2, second, bits + size_of(second)),
                          tri(other.a * second.upper < rigid.a * first.lower)});
         });
}

}  // namespace

claim c0_decreases_claim() {
  return {
      .name = "c0_decreases",
      .reference = "lemma 4",
      .statement = "The perfect twist c0(a, b) decreases as a increases.",
      .formula = "a < a'  =>  c0(a', b) < c0(a, b), where c0(a, b) exists",
      .method =
          "For all a > 0, 0 < b < 1 with J < 2: the integrand of F(c,0) decreases strictly in a "
          "and in c. At c0(a) the integral for a' > a is below 2 pi, so its root c0(a') is "
          "smaller; it exists, as J decreases in a. Computed: the polynomial steps.",
      .steps = {facts::integrand_decreases_in_a, facts::integrand_is_positive,
                facts::integrand_decreases_in_c,
                slope("(a+1)^2", "a*(a+b)", "a", "-(a+1)*(a*(2-b)+b)",
                      "the derivative in a of (J+1)^2"),
                positive("a*(2-b)+b", "a + a*q + b", "a > 0, b > 0, q = 1-b > 0",
                         "so J decreases in a")},
      .tier = by_kernel,
      .argument = {in_coq("DecreaseInA.lemma_4"), facts::bartky_transformation},
      .check = check_c0_decreases};
}

}  // namespace polhode::checker
