// The Montgomery phase of oscillating motion.

#include "statements/montgomery_oscillating.hpp"
#include "checker/functions.hpp"
#include "list.hpp"
#include "shapes.hpp"

namespace polhode::checker {
namespace {

void check_montgomery_oscillating(examination& e) {
  const body rigid = check_body_and_steps(e);
  e.number("greatest_lower_bound",
           [&](precision bits) { return (pi(bits) * rigid.I(bits)).scaled(1); });
  e.fact(statements::phase_keeps_its_bounds,
         [&](precision bits) { return half_phase_obeys_its_bounds(rigid, bits); });
  const bool below_one = rigid.is_above_I(1);
  e.fact(statements::fill(statements::bound_of_body,
                          {rigid.kind_in_words(), (below_one ? "below 2 pi" : "2 pi or more")}),
         below_one == (rigid.kind() < 0));
}

}  // namespace

claim montgomery_oscillating_claim() {
  return {statements::montgomery_oscillating(), check_montgomery_oscillating};
}

}  // namespace polhode::checker
