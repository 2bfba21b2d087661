// The first implicit equation.

#include "statements/first_equation.hpp"
#include "checker/examination.hpp"
#include "list.hpp"

namespace polhode::checker {
namespace {

/// The integrals are compared by their integrands and ranges: the integrand is positive, and at
/// every x smaller for the greater c (the claim's steps), and the range u < x < 1 is smaller for
/// the greater u. All five comparisons are of one of these two kinds.
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

claim first_equation_claim() { return {statements::first_equation(), check_first_equation}; }

}  // namespace polhode::checker
