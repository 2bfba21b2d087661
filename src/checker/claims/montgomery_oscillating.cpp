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
  e.fact(
      "at the given a, b the phase by the AGM at u = 1/4, 1/2, 3/4 decreases, is above 2 pi I and "
      "4 I arsinh(pi/(2 sqrt(u))), and below 2 pi I g(u)/g(1)",
      [&](precision bits) { return half_phase_obeys_its_bounds(rigid, bits); });
  const bool below_one = rigid.is_above_I(1);
  e.fact("at the given a, b, in rationals: the body is " + rigid.kind_in_words() +
             ", and the greatest lower bound is " + (below_one ? "below 2 pi" : "2 pi or more"),
         below_one == (rigid.kind() < 0));
}

}  // namespace

claim montgomery_oscillating_claim() {
  return {statements::montgomery_oscillating(), check_montgomery_oscillating};
}

}  // namespace polhode::checker
