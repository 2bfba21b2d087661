// The greatest lower bounds over all physical bodies.

#include "statements/limit_minimum.hpp"
#include "brackets.hpp"
#include "checker/elliptic.hpp"
#include "checker/functions.hpp"
#include "constants.hpp"
#include "list.hpp"
#include "shapes.hpp"

namespace polhode::checker {
namespace {

void check_limit_minimum(examination& e) {
  const body rigid = check_body_and_steps(e);
  e.number("epsilon0_min", epsilon0_min);
  const range beta = e.root_number("beta", false, mean_equation);
  if (rigid.kind() < 0) {
    e.add_to_method(statements::bounds_are_for_physical_bodies);
    return;
  }
  if (!e.is_missing(statements::order_of_epsilon0_and_least)) {
    // epsilon0 is above epsilon0_min where F(0, sin^2) - 2 pi is still positive.
    e.fact(statements::fill(statements::epsilon0_is_above, {rigid.kind_in_words()}),
           [&](precision bits) {
             const sine_and_cosine at = sin_cos(epsilon0_min(bits));
             return below(pi(bits).scaled(1),
                          separatrix_phase(rigid.a, rigid.b, square(at.sine), square(at.cosine)));
           });
  }
  if (!rigid.is_above_J(2)) {
    e.add_to_method(statements::there_is_no_c0);
    return;
  }
  if (e.is_missing(statements::bracket_of_c0) ||
      e.is_missing(statements::bracket_of_c0_on_one_side)) {
    return;
  }
  const range c0 = examination::bracket(e.witness("c0_over_a"));
  e.fact(statements::fill(statements::c0_is_above, {in_decimals(c0, e.work())}),
         [&](precision bits) {
           return all_of({tri(rigid.a * c0.lower / rigid.b > beta.upper),
                          passes_rotating_phase(rigid, 2, c0, bits + size_of(c0))});
         });
}

}  // namespace

claim limit_minimum_claim() { return {statements::limit_minimum(), check_limit_minimum}; }

}  // namespace polhode::checker
