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
  if (e.is_missing(statements::order_of_values)) return;
  e.fact(statements::decrease_at_given_body,
         // They are defined: c + b u >= 0 for c = -b/8, u = 1/2.
         -e.rigid().b / 8 + e.rigid().b / 2 > 0 && e.rigid().a / 2 > 0, enclosed);
}

}  // namespace

claim first_equation_claim() { return {statements::first_equation(), check_first_equation}; }

}  // namespace polhode::checker
