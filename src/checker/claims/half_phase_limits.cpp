// The limits of half the Montgomery phase.

#include "statements/half_phase_limits.hpp"
#include "checker/functions.hpp"
#include "list.hpp"
#include "shapes.hpp"

namespace polhode::checker {
namespace {

void check_half_phase_limits(examination& e) {
  const body rigid = check_body_and_steps(e);
  e.number("limit", [&](precision bits) { return pi(bits) * rigid.I(bits); });
  e.fact(statements::both_bounds_hold,
         [&](precision bits) { return half_phase_obeys_its_bounds(rigid, bits); });
}

}  // namespace

claim half_phase_limits_claim() {
  return {statements::half_phase_limits(), check_half_phase_limits};
}

}  // namespace polhode::checker
