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
      .tier = with_words,
      .argument = {argued("The integral increases in its upper end, as its integrand is positive, "
                          "and decreases in c, as its integrand does: where c is greater the upper "
                          "end at which it is pi is greater."),
                   argued(
                       "Eq. (24): h_c = -(1-bX)/(2 sqrt(a+bX) (c+bX)^(3/2)) for the integrand h, "
                       "by the derivative of h^2; differentiation under the integral, which has no "
                       "singularity before the turning point, and the implicit function theorem "
                       "give d epsilon/dc = -(integral of |h_c|)/h(pi/2 - epsilon) < 0.")},
      .check = check_first_equation};
}

}  // namespace polhode::checker
