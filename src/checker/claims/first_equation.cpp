// The first implicit equation.

#include "checker/examination.hpp"
#include "checker/facts.hpp"
#include "list.hpp"

namespace polhode::checker {
namespace {

/// The integrals are compared by their integrands and ranges: the integrand is positive, and at every x smaller for the greater c (the
/// claim's steps), and the range u < x < 1 is smaller for the greater u. All five comparisons are of one of these two kinds.
void check_first_equation(examination& e) {
  e.read_body();
  e.steps();
  if (e.is_missing("the order of some values of F(c,u)")) return;
  e.fact(
      "at the given a, b, by Carlson's integrals: F(c,u) decreases from c = -b/8 to 0 to a/2 to a "
      "at u = 1/2, and from u = 1/4 to 1/2 to 3/4 at c = a/2",
      // They are defined: c + b u >= 0 for c = -b/8, u = 1/2.
      -e.b() / 8 + e.b() / 2 > 0 && e.a() / 2 > 0, enclosed);
}

}  // namespace

claim first_equation_claim() {
  return {
      .name = "first_equation",
      .reference = "proposition 2, eqs. (21)-(24)",
      .statement =
          "The twist defect given by the first implicit equation decreases strictly in c, and so "
          "is injective there.",
      .formula =
          "integral over (0, pi/2 - epsilon) of (1-bX)/sqrt((a+bX)(c+bX)) dpsi = pi, X = cos^2 "
          "psi: epsilon decreases in c",
      .method =
          "For all a > 0, 0 < b < 1: the integrand is positive and decreases strictly in c, so the "
          "integral increases strictly in its upper end and decreases strictly in c; where it is "
          "pi for c and for c' > c, the upper end for c' is the greater one. Computed: the "
          "polynomial steps.",
      .steps = {facts::integrand_decreases_in_c, facts::integrand_is_positive},
      .tier = by_kernel,
      .argument = {in_coq("FirstEquation.proposition_2"), in_coq("DefectFunction.equation_24"),
                   in_coq("DefectFunction.equation_24_negative")},
      .check = check_first_equation};
}

}  // namespace polhode::checker
